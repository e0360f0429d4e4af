/* Sampling a 2D texture at the 16 fragments of a block: level-of-detail decision,
 * wrapping, fetch and filter (OpenGL 4.5 sections 8.14 and 8.15), in the order of
 * operations of the reference rasterizer. */
#ifndef GN_TEXTURE_SAMPLE_H
#define GN_TEXTURE_SAMPLE_H

#include <stdbool.h>

#include "gnomon/texture.h"

#include "../lanes/lanes.h"

/* Texel numbers along one dimension and the weight of the second. */
typedef struct tap_pair {
    lanes_i first, second;
    lanes_f weight;
} tap_pair;

static bool is_power_of_two(uint32_t n)
{
    return (n & (n - 1)) == 0;
}

/* floor as a float, for any value. From 2^23 up a float is an integer. */
static lanes_f floor_of(lanes_f a)
{
    const lanes_f limit = lanes_splat(8388608.0f);
    const lanes_m small =
        lanes_and(lanes_greater(limit, a), lanes_greater(a, lanes_sub(lanes_splat(0.0f), limit)));

    return lanes_select(small, lanes_to_float(lanes_floor(a)), a);
}

static lanes_f fraction_of(lanes_f a)
{
    return lanes_sub(a, floor_of(a));
}

/* Into 0..n-1, whatever came before. */
static lanes_i clamp_texel(lanes_i i, uint32_t n)
{
    return lanes_i_clamp(i, lanes_i_splat(0), lanes_i_splat((int32_t)n - 1));
}

static lanes_i wrap_nearest(gn_wrap wrap, lanes_f coordinate, uint32_t n)
{
    const lanes_f size = lanes_splat((float)n);

    if (wrap == GN_WRAP_REPEAT && is_power_of_two(n))
        return lanes_i_and(lanes_floor(lanes_mul(coordinate, size)), lanes_i_splat((int32_t)n - 1));
    if (wrap == GN_WRAP_REPEAT) {
        /* The largest float below 1 keeps the product below n. */
        const lanes_f fraction =
            lanes_min(fraction_of(coordinate), lanes_splat(1.0f - 1.0f / 16777216.0f));
        return clamp_texel(lanes_truncate(lanes_mul(fraction, size)), n);
    }
    return clamp_texel(lanes_truncate(lanes_mul(coordinate, size)), n);
}

static tap_pair wrap_linear(gn_wrap wrap, lanes_f coordinate, uint32_t n)
{
    const lanes_f half = lanes_splat(0.5f);
    const lanes_f size = lanes_splat((float)n);
    const lanes_i last = lanes_i_splat((int32_t)n - 1);
    tap_pair t;

    if (wrap == GN_WRAP_REPEAT && is_power_of_two(n)) {
        const lanes_f c = lanes_sub(lanes_mul(coordinate, size), half);

        t.weight = fraction_of(c);
        t.first = lanes_i_and(lanes_floor(c), last);
        t.second = lanes_i_and(lanes_i_add(t.first, lanes_i_splat(1)), last);
    } else if (wrap == GN_WRAP_REPEAT) {
        const lanes_f c = lanes_sub(lanes_mul(fraction_of(coordinate), size), half);
        const lanes_i below = lanes_floor(c);

        t.weight = fraction_of(c);
        t.first =
            clamp_texel(lanes_i_select(lanes_i_greater(lanes_i_splat(0), below), last, below), n);
        t.second = lanes_i_add(t.first, lanes_i_splat(1));
        t.second = lanes_i_select(lanes_i_greater(t.second, last), lanes_i_splat(0), t.second);
    } else {
        const lanes_f c = lanes_max(lanes_sub(lanes_min(lanes_mul(coordinate, size), size), half),
                                    lanes_splat(0.0f));

        t.weight = fraction_of(c);
        t.first = clamp_texel(lanes_floor(c), n);
        t.second = clamp_texel(lanes_i_add(t.first, lanes_i_splat(1)), n);
    }
    return t;
}

static void fetch(const gn_texture *texture, lanes_i column, lanes_i row, lanes_f texel[4])
{
    const unsigned char *const texels = texture->texels;
    int32_t s[GN_LANES], t[GN_LANES];
    float channel[4][GN_LANES];

    lanes_i_store(s, column);
    lanes_i_store(t, row);
    GN_EACH_LANE (l) {
        const void *const line = texels + (ptrdiff_t)t[l] * texture->row_stride;

        if (texture->format == GN_FORMAT_RGBA8) {
            const uint32_t packed = ((const uint32_t *)line)[s[l]];
            for (int c = 0; c < 4; ++c)
                channel[c][l] = (float)(packed >> 8 * c & 0xFF) * (float)(1.0 / 255.0);
        } else {
            const float *const in = (const float *)line + 4 * s[l];
            for (int c = 0; c < 4; ++c)
                channel[c][l] = in[c];
        }
    }
    for (int c = 0; c < 4; ++c)
        texel[c] = lanes_load(channel[c]);
}

static void sample_nearest(const gn_texture *texture, const gn_sampler *sampler, lanes_f s,
                           lanes_f t, lanes_f texel[4])
{
    fetch(texture, wrap_nearest(sampler->wrap_s, s, texture->width),
          wrap_nearest(sampler->wrap_t, t, texture->height), texel);
}

static lanes_f mix(lanes_f weight, lanes_f a, lanes_f b)
{
    return lanes_add(a, lanes_mul(weight, lanes_sub(b, a)));
}

static void sample_linear(const gn_texture *texture, const gn_sampler *sampler, lanes_f s,
                          lanes_f t, lanes_f texel[4])
{
    const tap_pair u = wrap_linear(sampler->wrap_s, s, texture->width);
    const tap_pair v = wrap_linear(sampler->wrap_t, t, texture->height);
    lanes_f corner[4][4];

    fetch(texture, u.first, v.first, corner[0]);
    fetch(texture, u.second, v.first, corner[1]);
    fetch(texture, u.first, v.second, corner[2]);
    fetch(texture, u.second, v.second, corner[3]);
    for (int c = 0; c < 4; ++c)
        texel[c] = mix(v.weight, mix(u.weight, corner[0][c], corner[1][c]),
                       mix(u.weight, corner[2][c], corner[3][c]));
}

/* Where the texture is minified: the squared length of a quad's longer derivative,
 * in texels, is above 1, or NaN. All four fragments of a quad decide as its first does. */
static lanes_m minified(const gn_texture *texture, const float *s, const float *t)
{
    const float width = (float)texture->width;
    const float height = (float)texture->height;
    uint32_t bits = 0;

    for (int quad = 0; quad < 4; ++quad) {
        const int first = quad / 2 * 8 + quad % 2 * 2;
        const float dsdx = (s[first + 1] - s[first]) * width;
        const float dtdx = (t[first + 1] - t[first]) * height;
        const float dsdy = (s[first + 4] - s[first]) * width;
        const float dtdy = (t[first + 4] - t[first]) * height;
        const float along_x = dsdx * dsdx + dtdx * dtdx;
        const float along_y = dsdy * dsdy + dtdy * dtdy;

        if (!(along_x <= 1.0f && along_y <= 1.0f))
            bits |= 0x33u << first;
    }
    return lanes_from_bits(bits);
}

static inline void sample_2d(const gn_texture *texture, const gn_sampler *sampler,
                             const float s[GN_LANES], const float t[GN_LANES],
                             float texel[4][GN_LANES])
{
    const bool magnify_linear = sampler->magnify == GN_MAGNIFY_LINEAR;
    const bool minify_linear = sampler->minify == GN_MINIFY_LINEAR;
    const lanes_f u = lanes_load(s);
    const lanes_f v = lanes_load(t);
    lanes_f linear[4], nearest[4];

    if (magnify_linear || minify_linear)
        sample_linear(texture, sampler, u, v, linear);
    if (!magnify_linear || !minify_linear)
        sample_nearest(texture, sampler, u, v, nearest);

    if (magnify_linear == minify_linear) {
        for (int c = 0; c < 4; ++c)
            lanes_store(texel[c], magnify_linear ? linear[c] : nearest[c]);
        return;
    }
    lanes_m use_linear = minified(texture, s, t);
    if (magnify_linear)
        use_linear = lanes_not(use_linear);
    for (int c = 0; c < 4; ++c)
        lanes_store(texel[c], lanes_select(use_linear, linear[c], nearest[c]));
}

#endif
