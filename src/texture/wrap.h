/* Texture coordinates to texel numbers and weights, over lanes (OpenGL 4.5 section
 * 8.14.2), in the order of operations of the reference rasterizer. */
#ifndef GN_TEXTURE_WRAP_H
#define GN_TEXTURE_WRAP_H

#include <stdbool.h>

#include "gnomon/sampling.h"

#include "../lanes/lanes.h"

/* The two texels along one dimension that a linear filter mixes: `first` and the next one,
 * of which `weight` is taken. */
typedef struct texel_pair {
    lanes_i first; /* 0 to size - 1 */
    lanes_f weight;
    lanes_m at_end; /* first is the last texel */
} texel_pair;

static inline bool is_power_of_two(uint32_t n)
{
    return (n & (n - 1)) == 0;
}

static inline lanes_f fraction_of(lanes_f a)
{
    return lanes_sub(a, lanes_floor(a));
}

static inline lanes_i wrap_nearest(gn_wrap wrap, lanes_f coordinate, uint32_t size)
{
    const lanes_f n = lanes_splat((float)size);
    const lanes_i last = lanes_i_splat((int32_t)size - 1);

    if (wrap == GN_WRAP_REPEAT && is_power_of_two(size))
        return lanes_i_and(lanes_truncate(lanes_floor(lanes_mul(coordinate, n))), last);
    if (wrap == GN_WRAP_REPEAT) {
        /* The largest float below 1 keeps the product below n. */
        coordinate = lanes_min(fraction_of(coordinate), lanes_splat(1.0f - 1.0f / 16777216.0f));
    }
    return lanes_i_clamp(lanes_truncate(lanes_mul(coordinate, n)), lanes_i_splat(0), last);
}

/* Numbers beyond the integers are converted to INT32_MIN: texel 0 of a power of two, which
 * a mask takes it to, and otherwise, as all that is negative, the last. */
static inline texel_pair wrap_linear(gn_wrap wrap, lanes_f coordinate, uint32_t size)
{
    const lanes_f n = lanes_splat((float)size);
    const lanes_f half = lanes_splat(0.5f);
    const lanes_i last = lanes_i_splat((int32_t)size - 1);
    const bool masked = wrap == GN_WRAP_REPEAT && is_power_of_two(size);
    texel_pair t;
    lanes_f c;

    if (wrap != GN_WRAP_REPEAT)
        c = lanes_max(lanes_sub(lanes_min(lanes_mul(coordinate, n), n), half), lanes_splat(0.0f));
    else if (masked)
        c = lanes_sub(lanes_mul(coordinate, n), half);
    else
        c = lanes_sub(lanes_mul(fraction_of(coordinate), n), half);

    const lanes_f whole = lanes_floor(c);
    const lanes_i texel = lanes_truncate(whole);
    t.weight = lanes_sub(c, whole);
    const lanes_i first =
        masked ? lanes_i_and(texel, last)
               : lanes_i_select(lanes_i_greater(lanes_i_splat(0), texel), last, texel);
    t.first = first;
    t.at_end = lanes_i_equal(first, last);
    return t;
}

/* The texel after the first. */
static inline lanes_i second_texel(gn_wrap wrap, const texel_pair *t)
{
    const lanes_i beyond = wrap == GN_WRAP_REPEAT ? lanes_i_splat(0) : t->first;

    return lanes_i_select(t->at_end, beyond, lanes_i_add(t->first, lanes_i_splat(1)));
}

#endif
