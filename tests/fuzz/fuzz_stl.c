/* STL files: any bytes are a sound model, or a fault in words. */
#include "fuzz.h"
#include "model_input.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_read_model(MODEL_STL, bytes, size);
    return 0;
}
