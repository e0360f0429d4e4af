/* Whole draws in any state, of any vertices, into any target, in any workspace. */
#include "draw_input.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_input in = fuzz_begin(bytes, size);
    static draw_input d;

    if (!draw_make(&in, &d))
        return -1;
    draw_everywhere(&in, &d);
    draw_free(&d);
    return 0;
}
