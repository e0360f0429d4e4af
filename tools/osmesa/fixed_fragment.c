/* The fragments of the fixed function, over lanes. The order of operations is the reference's. */
#include <string.h>

#include "fixed_function.h"

void fixed_fragment(const void *uniforms, const gn_fragment_input *input,
                    gn_fragment_output *output)
{
    const fixed_function *const fixed = uniforms;

    if (fixed->color_varying >= 0) {
        memcpy(output->color, input->varying[fixed->color_varying], sizeof(float[4][GN_LANES]));
        return;
    }
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            output->color[c][l] = fixed->current[COLOR][c];
}
