/* More gathers from memory than the words and pairs of lanes.h:
 *
 *   gather_bytes   one, two or four bytes at any address, little-endian
 *   gather_eight   eight bytes at any address, as two numbers of four bytes
 *   gather_fours   four neighbouring words */
#ifndef GN_LANES_GATHER_H
#define GN_LANES_GATHER_H

#include "lanes.h"

/* Returns the little-endian number in the `count` bytes at p; count is 1, 2 or 4. */
static inline int32_t number_of_bytes(const unsigned char *p, int count)
{
#if GN_IS_LITTLE_ENDIAN
    if (count == 4)
        return *(const any_word *)(const void *)p;
    if (count == 2)
        return *(const any_short *)(const void *)p;
    return p[0];
#else
    uint32_t number = p[0];

    for (int n = 1; n < count; ++n)
        number |= (uint32_t)p[n] << 8 * n;
    return (int32_t)number;
#endif
}

#if defined(LANES_REGISTERS)

#define LANES_NUMBER(l) number_of_bytes(base + at[l], count)

GN_INLINE register_i register_gather_bytes(const unsigned char *base, const int32_t *at, int count)
{
    return register_i_set(LANES_NUMBER);
}

/* Returns the numbers in the `count` bytes at base + offset. `count` must be a constant. */
GN_INLINE lanes_i lanes_i_gather_bytes(const unsigned char *base, lanes_i offset, int count)
{
    int32_t at[LANES];

    lanes_indices(offset, at);
    LANES_EACH_REGISTER(lanes_i, register_gather_bytes(base, at + REGISTER_LANES * n, count));
}

#define LANES_FOUR(r) (base + at[LANES_LANE(l, r)])

/* Writes base[index + c] to out[c]. */
GN_INLINE void lanes_i_gather_fours(const stored_word *base, lanes_i index, lanes_i out[4])
{
    int32_t at[LANES];

    lanes_indices(index, at);
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        register_i r[4];

        GN_UNROLLED
        for (int l = 0; l < 4; ++l)
            r[l] = register_i_load_rows(LANES_FOUR);
        lanes_from_rows(r, n, out);
    }
}

#else

static inline lanes_i lanes_i_gather_bytes(const unsigned char *base, lanes_i offset, int count)
{
    int32_t at[LANES];

    lanes_i_store(at, offset);
    GN_EACH_LANE (l)
        at[l] = number_of_bytes(base + at[l], count);
    return lanes_i_load(at);
}

static inline void lanes_i_gather_fours(const stored_word *base, lanes_i index, lanes_i out[4])
{
    lanes_i_gather_pairs(base, index, &out[0], &out[1]);
    lanes_i_gather_pairs(base + 2, index, &out[2], &out[3]);
}

#endif

/* Writes the two numbers in the eight bytes at base + offset. */
GN_INLINE void lanes_i_gather_eight(const unsigned char *base, lanes_i offset, lanes_i *low,
                                    lanes_i *high)
{
#if defined(LANES_REGISTERS) && GN_IS_LITTLE_ENDIAN
    int32_t at[LANES];

    lanes_indices(offset, at);
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n)
        register_gather_pairs(base, at + REGISTER_LANES * n, 1, &low->q[n], &high->q[n]);
#else
    *low = lanes_i_gather_bytes(base, offset, 4);
    *high = lanes_i_gather_bytes(base + 4, offset, 4);
#endif
}

#endif
