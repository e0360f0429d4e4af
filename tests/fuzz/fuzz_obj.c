/* OBJ files with their material files: any text is a sound model, or a fault in words. */
#include "fuzz.h"
#include "model_input.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_read_model(MODEL_OBJ, bytes, size);
    return 0;
}
