/* Texture coordinates to texel numbers and weights, over lanes (OpenGL 4.5 section 8.14.2), in the
 * order of operations of the reference rasterizer. For every coordinate, including NaN, texel
 * numbers lie within the texture. The exception is GN_WRAP_CLAMP_TO_BORDER, where numbers outside
 * mean the border. */
#ifndef GN_KERNEL_TEXTURE_WRAP_INL
#define GN_KERNEL_TEXTURE_WRAP_INL

#include <stdbool.h>

#include <gnomon/lookup.h>

#include "../../lanes/lanes.h"
#include "../../texture/wraps.h"

/* The two texels along one dimension that a linear filter mixes: `first` and the next one. `weight`
 * is the weight of the next one. */
typedef struct texel_pair {
    lanes_i first; /* 0 to size - 1 */
    lanes_f weight;
    lanes_m at_end; /* first is the last texel */
} texel_pair;

static inline lanes_f fraction_of(lanes_f a)
{
    return lanes_sub(a, lanes_floor(a));
}

/* Returns the nearest integer, halves to even. Floats from 2^23 on are integers. */
static inline lanes_f nearest_integer(lanes_f a)
{
    return lanes_select(lanes_greater(lanes_splat(8388608.0f), lanes_magnitude(a)),
                        lanes_to_float(lanes_round(a)), a);
}

/* Returns the coordinate minus the nearest even number, from -1 to 1. Its magnitude is the mirrored
 * coordinate. */
static inline lanes_f minus_even(lanes_f coordinate)
{
    const lanes_f halved = lanes_mul(coordinate, lanes_splat(0.5f));
    const lanes_f f = lanes_sub(halved, nearest_integer(halved));

    return lanes_add(f, f);
}

/* Returns the number of the nearest texel. `size` is that of the level. */
static inline lanes_i wrap_nearest(gn_wrap wrap, bool masked, lanes_f coordinate, uint32_t size)
{
    const lanes_f n = lanes_splat((float)size);
    const lanes_i last = lanes_i_splat((int32_t)size - 1);

    if (masked)
        return lanes_i_and(lanes_floor_to_int(lanes_mul(coordinate, n)), last);
    if (GN_HAVE_TEXTURES && wrap == GN_WRAP_CLAMP_TO_BORDER)
        return lanes_truncate(lanes_floor(lanes_mul(coordinate, n)));
    if (GN_HAVE_TEXTURES && wrap == GN_WRAP_MIRROR_CLAMP_TO_EDGE) /* NaN reads the last texel */
        return lanes_i_min(lanes_truncate(lanes_min(lanes_mul(lanes_magnitude(coordinate), n), n)),
                           last);
    if (GN_HAVE_TEXTURES && wrap == GN_WRAP_MIRRORED_REPEAT)
        coordinate = lanes_magnitude(minus_even(coordinate));
    else if (wrap == GN_WRAP_REPEAT) /* the largest float below 1 keeps the product below n */
        coordinate = lanes_min(fraction_of(coordinate), lanes_splat(1.0f - 1.0f / 16777216.0f));
    return lanes_i_clamp(lanes_truncate(lanes_mul(coordinate, n)), lanes_i_splat(0), last);
}

/* Returns the clamped coordinate, 0 to size - 0.5, in texels from the centre of the first. */
static inline lanes_f clamped_texels(lanes_f coordinate, lanes_f n)
{
    return lanes_max(lanes_sub(lanes_min(lanes_mul(coordinate, n), n), lanes_splat(0.5f)),
                     lanes_splat(0.0f));
}

/* For GN_WRAP_REPEAT and GN_WRAP_CLAMP_TO_EDGE. Numbers outside int32_t are converted to
 * INT32_MIN. With a mask this becomes texel 0; without a mask it becomes the last texel, as every
 * negative number does. */
GN_WIDE_INLINE texel_pair wrap_linear(gn_wrap wrap, bool masked, lanes_f coordinate, uint32_t size)
{
    const lanes_f n = lanes_splat((float)size);
    const lanes_f half = lanes_splat(0.5f);
    const lanes_i last = lanes_i_splat((int32_t)size - 1);
    texel_pair t;
    lanes_f c;

    if (wrap != GN_WRAP_REPEAT)
        c = clamped_texels(coordinate, n);
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

/* Returns the number of the texel after the first. */
static inline lanes_i second_texel(gn_wrap wrap, const texel_pair *t)
{
    const lanes_i beyond = wrap == GN_WRAP_REPEAT ? lanes_i_splat(0) : t->first;

    return lanes_i_select(t->at_end, beyond, lanes_i_add(t->first, lanes_i_splat(1)));
}

/* For every wrap: writes both texels and returns the weight of the second. */
static inline lanes_f wrap_linear_any(gn_wrap wrap, bool masked, lanes_f coordinate, uint32_t size,
                                      lanes_i texel[2])
{
    const lanes_f n = lanes_splat((float)size);
    const lanes_f half = lanes_splat(0.5f);
    const lanes_i zero = lanes_i_splat(0), last = lanes_i_splat((int32_t)size - 1);
    lanes_f c;

    if (wrap == GN_WRAP_REPEAT || wrap == GN_WRAP_CLAMP_TO_EDGE) {
        const texel_pair pair = wrap_linear(wrap, masked, coordinate, size);

        texel[0] = pair.first;
        texel[1] = second_texel(wrap, &pair);
        return pair.weight;
    }
    if (wrap == GN_WRAP_MIRROR_CLAMP_TO_EDGE)
        c = clamped_texels(lanes_magnitude(coordinate), n);
    else if (wrap == GN_WRAP_MIRRORED_REPEAT)
        c = lanes_sub(
            lanes_mul(lanes_max(lanes_magnitude(minus_even(coordinate)), lanes_splat(0.0f)), n),
            half);
    else
        c = lanes_sub(lanes_mul(coordinate, n), half);

    const lanes_f whole = lanes_floor(c);
    texel[0] = lanes_truncate(whole);
    texel[1] = lanes_i_add(texel[0], lanes_i_splat(1));
    if (wrap != GN_WRAP_CLAMP_TO_BORDER) {
        texel[0] = lanes_i_clamp(texel[0], zero, last);
        texel[1] = lanes_i_clamp(texel[1], zero, last);
    }
    return lanes_sub(c, whole);
}

/* Writes the two texels that a gather reads along a dimension: those of wrap_linear_any, except
 * that each is clamped or mirrored by itself. */
static inline void wrap_gathered(gn_wrap wrap, bool masked, lanes_f coordinate, uint32_t size,
                                 lanes_i texel[2])
{
    const lanes_f n = lanes_splat((float)size);
    const lanes_f half = lanes_splat(0.5f);
    const lanes_i one = lanes_i_splat(1);
    const lanes_i zero = lanes_i_splat(0), last = lanes_i_splat((int32_t)size - 1);

    if (wrap == GN_WRAP_REPEAT || wrap == GN_WRAP_CLAMP_TO_BORDER) {
        wrap_linear_any(wrap, masked, coordinate, size, texel);
        return;
    }
    if (wrap == GN_WRAP_CLAMP_TO_EDGE) {
        const lanes_f c = lanes_add(lanes_min(lanes_mul(coordinate, n), n), half);

        texel[1] = lanes_truncate(lanes_max(c, lanes_splat(0.0f)));
        texel[0] = lanes_i_max(lanes_i_sub(texel[1], one), zero);
        texel[1] = lanes_i_min(texel[1], last);
        return;
    }
    if (wrap == GN_WRAP_MIRRORED_REPEAT)
        coordinate = minus_even(coordinate);
    texel[0] = lanes_truncate(lanes_floor(lanes_sub(lanes_mul(coordinate, n), half)));
    texel[1] = lanes_i_add(texel[0], one);
    for (int i = 0; i < 2; ++i) {
        const lanes_i mirror = lanes_i_sub(lanes_i_splat(-1), texel[i]);

        texel[i] = lanes_i_select(lanes_i_greater(zero, texel[i]), mirror, texel[i]);
        texel[i] = lanes_i_min(texel[i], last);
    }
}

#endif
