/* glTF and binary glTF: any bytes are a sound model, or a fault in words. */
#include <string.h>

#include "fuzz.h"
#include "model_input.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const bool is_binary = size >= 4 && memcmp(bytes, "glTF", 4) == 0;

    fuzz_read_model(is_binary ? MODEL_GLB : MODEL_GLTF, bytes, size);
    return 0;
}
