/* Quads of 2x2 fragments: differences within them, which one lane does not have, and all lanes of a
 * quad together. */
#ifndef GN_LANES_DERIVATIVE_H
#define GN_LANES_DERIVATIVE_H

#include "lanes.h"

static inline lanes_f derivative_x(lanes_f value)
{
    return LANES == 1 ? lanes_splat(0.0f)
                      : lanes_sub(lanes_quad_right(value), lanes_quad_left(value));
}

static inline lanes_f derivative_y(lanes_f value)
{
    return LANES == 1 ? lanes_splat(0.0f)
                      : lanes_sub(lanes_quad_upper(value), lanes_quad_lower(value));
}

/* Returns in every lane the value of its quad's lower left lane. */
static inline lanes_f of_first_in_quad(lanes_f a)
{
    return lanes_quad_lower(lanes_quad_left(a));
}

/* Returns the lanes, as bits, of all quads that contain one of `lanes`; usually all or none. */
static inline uint32_t quads_of(uint32_t lanes)
{
    if (lanes == 0 || lanes == GN_ALL_LANES)
        return lanes;
    lanes |= (lanes & 0x5555u) << 1 | (lanes & 0xAAAAu) >> 1;
    return lanes | (lanes & 0x0F0Fu) << 4 | (lanes & 0xF0F0u) >> 4;
}

#endif
