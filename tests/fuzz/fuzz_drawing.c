/* The properties of drawing of tests/property. */
#include "property_input.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const suite *const suites[] = {&properties_edges,  &properties_memory,
                                          &properties_scenes, &properties_textures,
                                          &properties_lookup, &properties_indices};
    fuzz_input in = fuzz_begin(bytes, size);

    property_run_input(&in, suites, sizeof suites / sizeof suites[0]);
    return 0;
}
