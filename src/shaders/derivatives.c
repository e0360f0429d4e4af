/* Derivatives in quads of 2x2 fragments, for users' shaders. */
#include <gnomon/derivatives.h>

#include "../scalars/bits.h"
#include "derivative.h"

void gn_derivative_x(const float value[GN_LANES], float out[GN_LANES])
{
    derivative_x(value, out);
}

void gn_derivative_y(const float value[GN_LANES], float out[GN_LANES])
{
    derivative_y(value, out);
}

void gn_derivative_width(const float value[GN_LANES], float out[GN_LANES])
{
    float x[GN_LANES], y[GN_LANES];

    derivative_x(value, x);
    derivative_y(value, y);
    for (int l = 0; l < GN_LANES; ++l)
        out[l] = gn_magnitude(x[l]) + gn_magnitude(y[l]);
}
