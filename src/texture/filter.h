/* The filters within one level, for all 16 lanes (OpenGL 4.5 section 8.14.3): which texels a place
 * needs, with the border in place of texels outside, and how they are mixed. */
#ifndef GN_TEXTURE_FILTER_H
#define GN_TEXTURE_FILTER_H

#include "compare.h"
#include "cube.h"
#include "sample.h"
#include "texel.h"

/* Values that are constant for all lanes and levels of a lookup. */
typedef struct lookup_state {
    const gn_texture *texture;
    gn_texture_target target; /* the texture's target */
    int channels;             /* how many channels the format has, from the first */
    int dimensions;           /* 1 to 3: the dimensions that are filtered */
    gn_wrap wrap[3];
    bool masked[3];
    bool has_border;
    float border[4];
    gn_compare compare; /* GN_COMPARE_DEFAULT for colours too */
} lookup_state;

/* The place that each lane looks up. */
typedef struct lookup_place {
    lanes_f coordinate[3];
    lanes_i layer;          /* the layer of an array; not filtered */
    lanes_f reference;      /* for compared depths */
    const cube_place *cube; /* for cubes, instead of coordinate and layer */
} lookup_place;

/* Returns how many channels a format has, from the first of a texel. */
static inline int texel_channels(gn_format format)
{
    return format_is_color(format) ? format_channels(format) : 1;
}

/* Returns the columns, rows or layers of a level. */
static inline uint32_t size_along(const lookup_state *state, uint32_t level, int dimension)
{
    const gn_texture *const t = state->texture;

    return size_of_level(dimension == 0 ? t->width : dimension == 1 ? t->height : t->depth, level);
}

/* Fetches the texels of a level by their numbers along the dimensions; texels outside are the
 * border. */
GN_OUT_OF_LINE void fetch_place(const lookup_state *state, const lookup_place *place,
                                uint32_t level, const lanes_i *const number[3], lanes_f texel[4])
{
    const lanes_i zero = lanes_i_splat(0);
    lanes_i outside = zero;
    lanes_i inner[3];

    inner[1] = zero;
    inner[2] = place->layer;
    for (int n = 0; n < state->dimensions; ++n) {
        inner[n] = *number[n];
        if (state->wrap[n] == GN_WRAP_CLAMP_TO_BORDER) {
            const lanes_i last = lanes_i_splat((int32_t)size_along(state, level, n) - 1);

            inner[n] = lanes_i_clamp(*number[n], zero, last);
            outside = lanes_i_or(outside, lanes_i_sub(last, *number[n]));
            outside = lanes_i_or(outside, *number[n]);
        }
    }
    fetch_texels(state->texture, level, &inner[0], &inner[1], &inner[2], texel);
    if (state->has_border) {
        const lanes_m is_border = lanes_i_greater(zero, outside);

        for (int c = 0; c < 4; ++c)
            texel[c] = lanes_select(is_border, lanes_splat(state->border[c]), texel[c]);
    }
    if (state->compare != GN_COMPARE_DEFAULT)
        texel[0] = compared(state->compare, place->reference, texel[0]);
}

/* Mixes one channel of two texels along the first dimension; the results of comparisons are mixed
 * differently from colours. */
static inline lanes_f mix_along_s(const lookup_state *state, int channel, lanes_f weight,
                                  lanes_f first, lanes_f second)
{
    return state->compare != GN_COMPARE_DEFAULT && channel == 0
               ? mix_compared(weight, first, second)
               : mix(weight, first, second);
}

GN_OUT_OF_LINE void filter_nearest(const lookup_state *state, const lookup_place *place,
                                   uint32_t level, lanes_f texel[4])
{
    lanes_i number[3];
    const lanes_i *const numbers[3] = {&number[0], &number[1], &number[2]};

    for (int n = 0; n < state->dimensions; ++n)
        number[n] = wrap_nearest(state->wrap[n], state->masked[n], place->coordinate[n],
                                 size_along(state, level, n));
    fetch_place(state, place, level, numbers, texel);
}

/* The two texels that the linear filter mixes along each dimension, and the weight of the
 * second. */
typedef struct linear_texels {
    lanes_i number[3][2];
    lanes_f weight[3];
} linear_texels;

static inline void find_linear_texels(const lookup_state *state, const lookup_place *place,
                                      uint32_t level, linear_texels *out)
{
    for (int n = 0; n < state->dimensions; ++n)
        out->weight[n] = wrap_linear_any(state->wrap[n], state->masked[n], place->coordinate[n],
                                         size_along(state, level, n), out->number[n]);
}

/* Fetches the 2^dimensions texels and mixes them. Texel i is the second one along dimension n if
 * bit n of i is set. */
static inline void fetch_and_mix(const lookup_state *state, const lookup_place *place,
                                 uint32_t level, const linear_texels *texels, lanes_f texel[4])
{
    const int count = 1 << state->dimensions;
    lanes_f corner[8][4];

    for (int i = 0; i < count; ++i) {
        const lanes_i *const number[3] = {&texels->number[0][i & 1], &texels->number[1][i >> 1 & 1],
                                          &texels->number[2][i >> 2]};

        fetch_place(state, place, level, number, corner[i]);
    }
    for (int n = 0; n < state->dimensions; ++n) {
        for (int i = 0; i < count >> (n + 1); ++i) {
            for (int c = 0; c < 4; ++c)
                corner[i][c] = n == 0
                                   ? mix_along_s(state, c, texels->weight[n], corner[2 * i][c],
                                                 corner[2 * i + 1][c])
                                   : mix(texels->weight[n], corner[2 * i][c], corner[2 * i + 1][c]);
        }
    }
    for (int c = 0; c < 4; ++c)
        texel[c] = corner[0][c];
}

/* Returns the weights of a linear filter. In lanes whose bit is not set in `linear`, only the
 * nearer texel counts, with weight 0 or 1. */
static inline lanes_f weights_of(uint32_t linear, lanes_f weight)
{
    const lanes_m is_near = lanes_less_equal(weight, lanes_splat(0.5f));

    if (linear == GN_ALL_LANES)
        return weight;
    return lanes_select(lanes_from_bits(linear), weight,
                        lanes_select(is_near, lanes_splat(0.0f), lanes_splat(1.0f)));
}

GN_OUT_OF_LINE void filter_linear(const lookup_state *state, const lookup_place *place,
                                  uint32_t level, uint32_t linear, lanes_f texel[4])
{
    linear_texels texels;

    find_linear_texels(state, place, level, &texels);
    for (int n = 0; n < state->dimensions; ++n)
        texels.weight[n] = weights_of(linear, texels.weight[n]);
    fetch_and_mix(state, place, level, &texels, texel);
}

#endif
