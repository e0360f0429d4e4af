/* The properties of drawing of tests/property: edges, memory, hostile state, scenes, textures,
 * members. */
#include "property_input.h"

#include "../property/properties_draw.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static property_suite *const suites[] = {properties_draw};
    fuzz_input in = fuzz_begin(bytes, size);

    property_run_input(&in, suites, 1);
    return 0;
}
