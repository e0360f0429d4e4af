/* Derivatives in quads of 2x2 fragments, for users' shaders. */
#include <gnomon/derivatives.h>

#include "../lanes/derivative.h"

void gn_derivative_x(const float value[GN_LANES], float out[GN_LANES])
{
    lanes_store(out, derivative_x(lanes_load(value)));
}

void gn_derivative_y(const float value[GN_LANES], float out[GN_LANES])
{
    lanes_store(out, derivative_y(lanes_load(value)));
}

void gn_derivative_width(const float value[GN_LANES], float out[GN_LANES])
{
    const lanes_f at = lanes_load(value);

    lanes_store(out,
                lanes_add(lanes_magnitude(derivative_x(at)), lanes_magnitude(derivative_y(at))));
}
