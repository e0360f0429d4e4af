/* Logical operations on the bits of colours (OpenGL 4.5 section 17.3.9). */
#ifndef GN_FRAGMENT_LOGIC_H
#define GN_FRAGMENT_LOGIC_H

#include "types.h"

static inline void set_logic_state(color_state *s, gn_logic_operation operation)
{
    /* Bit 2 * source + destination is the result. */
    static const uint8_t truth[GN_LOGIC_SET + 1] = {0xC, 0x0, 0x8, 0x4, 0x2, 0xA, 0x6, 0xE,
                                                    0x1, 0x9, 0x5, 0xD, 0x3, 0xB, 0x7, 0xF};

    for (int i = 0; i < 4; ++i)
        s->logic[i] = -(int32_t)(truth[operation] >> i & 1);
}

/* Applies the operation to pixels: four constants and no branch. */
GN_STEP lanes_i operate_on_bits(const color_state *state, lanes_i source, lanes_i destination)
{
    const lanes_i ones = lanes_i_splat(-1);
    const lanes_i no_source = lanes_i_sub(ones, source);
    const lanes_i no_destination = lanes_i_sub(ones, destination);
    const lanes_i if_set = lanes_i_or(lanes_i_and(destination, lanes_i_splat(state->logic[3])),
                                      lanes_i_and(no_destination, lanes_i_splat(state->logic[2])));
    const lanes_i if_not = lanes_i_or(lanes_i_and(destination, lanes_i_splat(state->logic[1])),
                                      lanes_i_and(no_destination, lanes_i_splat(state->logic[0])));

    return lanes_i_or(lanes_i_and(source, if_set), lanes_i_and(no_source, if_not));
}

#endif
