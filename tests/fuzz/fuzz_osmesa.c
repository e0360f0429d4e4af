/* Random calls of libOSMesa with random arguments, a scene and reads of pixels. The input says
 * which. */
#include <string.h>

#include "../osmesa/play.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_input in = fuzz_begin(bytes, size);
    const uint32_t class = fuzz_below(&in, scene_class_count);
    library gl;

    memset(&gl, 0, sizeof gl);
    set_own_functions(&gl);
    fuzz_feed_random(&in);
    FUZZ_REQUIRE(play(&gl, &scene_classes[class], 0));
    return 0;
}
