/* Differences within quads of 2x2 fragments. One lane has no differences. */
#ifndef GN_KERNEL_SHADERS_DERIVATIVE_INL
#define GN_KERNEL_SHADERS_DERIVATIVE_INL

#include "../../lanes/lanes.h"

static inline lanes_f derivative_x(lanes_f value)
{
    return GN_LANES == 1 ? lanes_splat(0.0f)
                         : lanes_sub(lanes_quad_right(value), lanes_quad_left(value));
}

static inline lanes_f derivative_y(lanes_f value)
{
    return GN_LANES == 1 ? lanes_splat(0.0f)
                         : lanes_sub(lanes_quad_upper(value), lanes_quad_lower(value));
}

#endif
