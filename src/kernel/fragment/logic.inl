/* Logical operations on the bits of colours (OpenGL 4.5 section 17.3.9). */
#ifndef GN_KERNEL_FRAGMENT_LOGIC_INL
#define GN_KERNEL_FRAGMENT_LOGIC_INL

#include "fragment.h"

static inline void set_logic_state(color_state *s, gn_logic_operation operation)
{
    /* Bit 2 * source + destination of an operation's table is the result. */
    static const uint8_t truth[GN_LOGIC_SET + 1] = {0xC, 0x0, 0x8, 0x4, 0x2, 0xA, 0x6, 0xE,
                                                    0x1, 0x9, 0x5, 0xD, 0x3, 0xB, 0x7, 0xF};

    const uint32_t t = truth[operation];
    const uint32_t term[4] = {t, t ^ t >> 1, t ^ t >> 2, t ^ t >> 1 ^ t >> 2 ^ t >> 3};

    for (int i = 0; i < 4; ++i)
        s->logic[i] = -(int32_t)(term[i] & 1u);
}

/* Whether the results of the operation depend on the source. */
static inline bool reads_source(const color_state *s)
{
    return (s->logic[2] | s->logic[3]) != 0;
}

/* Applies the operation to pixels: four constants and no branch. Every operation on two bits is a
 * sum modulo 2 of some of 1, either bit, and their product. */
GN_STEP lanes_i operate_on_bits(const color_state *state, lanes_i source, lanes_i destination)
{
    const lanes_i both =
        lanes_i_and(lanes_i_and(source, destination), lanes_i_splat(state->logic[3]));
    const lanes_i one = lanes_i_xor(lanes_i_and(source, lanes_i_splat(state->logic[2])),
                                    lanes_i_and(destination, lanes_i_splat(state->logic[1])));

    return lanes_i_xor(lanes_i_xor(both, one), lanes_i_splat(state->logic[0]));
}

#endif
