/* Every function of the mathematics: the properties of tests/property, with arguments out of the
 * input. tests/coverage/functions.sh sees to it that every function has one. */
#include "property_input.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const suite *const suites[] = {
        &properties_scalar,      &properties_vectors,    &properties_matrices,
        &properties_transforms,  &properties_quaternion, &properties_models,
        &properties_projections, &properties_geometry,   &properties_rays};
    fuzz_input in = fuzz_begin(bytes, size);

    property_run_input(&in, suites, sizeof suites / sizeof suites[0]);
    return 0;
}
