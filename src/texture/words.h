/* The filters within a level of a 2D texture of RGBA8 without a border, whose texels are words that
 * are gathered and mixed channel by channel. The results equal those of filter.h, in less time. */
#ifndef GN_TEXTURE_WORDS_H
#define GN_TEXTURE_WORDS_H

#include "filter.h"

static inline bool level_has_words(const lookup_state *state, uint32_t level)
{
    return state->target == GN_TEXTURE_2D && !state->has_border &&
           has_word_texels(state->texture, level);
}

/* Returns whether a level of a cube has word texels and an index reaches all faces. */
static inline bool cube_has_words(const lookup_state *state, uint32_t level)
{
    const ptrdiff_t stride = state->texture->level[level].layer_stride;

    return has_word_texels(state->texture, level) && stride >= -(1 << 28) && stride <= 1 << 28;
}

static inline int32_t words_per_row(const lookup_state *state, uint32_t level)
{
    return (int32_t)(state->texture->level[level].row_stride / 4);
}

/* Returns the word indices of the first texels of rows. */
static inline lanes_i row_of_words(const lookup_state *state, uint32_t level, lanes_i row)
{
    return lanes_i_mul(row, lanes_i_splat(words_per_row(state, level)));
}

GN_OUT_OF_LINE void filter_words_nearest(const lookup_state *state, const lookup_place *place,
                                         uint32_t level, lanes_f texel[4])
{
    const lanes_i column = wrap_nearest(state->wrap[0], state->masked[0], place->coordinate[0],
                                        size_along(state, level, 0));
    const lanes_i row = wrap_nearest(state->wrap[1], state->masked[1], place->coordinate[1],
                                     size_along(state, level, 1));
    const lanes_i word = lanes_i_gather(state->texture->level[level].texels,
                                        lanes_i_add(row_of_words(state, level, row), column));

    texel[0] = lanes_unpack_unorm8(word, 0);
    texel[1] = lanes_unpack_unorm8(word, 1);
    texel[2] = lanes_unpack_unorm8(word, 2);
    texel[3] = lanes_unpack_unorm8(word, 3);
}

/* Writes the four texels, mixed. */
static inline void mix_words(const lanes_i corner[CORNER_COUNT], lanes_f weight_s, lanes_f weight_t,
                             lanes_f texel[4])
{
    texel[0] = mix_corners(corner, 0, weight_s, weight_t);
    texel[1] = mix_corners(corner, 1, weight_s, weight_t);
    texel[2] = mix_corners(corner, 2, weight_s, weight_t);
    texel[3] = mix_corners(corner, 3, weight_s, weight_t);
}

/* Finds the two texels that the linear filter mixes along a dimension; neighbours are `unit` words
 * apart. Writes the number of the first texel and the words from it to the second; returns the
 * weight of the second. */
static inline lanes_f find_words(gn_wrap wrap, bool masked, lanes_f coordinate, uint32_t size,
                                 int32_t unit, lanes_i *first, lanes_i *step)
{
    lanes_i texel[2];

    if (wrap == GN_WRAP_REPEAT || wrap == GN_WRAP_CLAMP_TO_EDGE) {
        const texel_pair pair = wrap_linear(wrap, masked, coordinate, size);
        const int32_t back = wrap == GN_WRAP_REPEAT ? unit * (1 - (int32_t)size) : 0;

        *first = pair.first;
        *step = lanes_i_select(pair.at_end, lanes_i_splat(back), lanes_i_splat(unit));
        return pair.weight;
    }

    const lanes_f weight = wrap_linear_any(wrap, masked, coordinate, size, texel);
    *first = texel[0];
    *step = lanes_i_mul(lanes_i_sub(texel[1], texel[0]), lanes_i_splat(unit));
    return weight;
}

/* Gathers two texels of a row; both at once if they are neighbours in every lane. */
static inline void gather_columns(const stored_word *words, lanes_i index, lanes_i step,
                                  bool are_neighbours, lanes_i word[2])
{
    if (are_neighbours) {
        lanes_i_gather_pairs(words, index, &word[0], &word[1]);
    } else {
        word[0] = lanes_i_gather(words, index);
        word[1] = lanes_i_gather(words, lanes_i_add(index, step));
    }
}

/* The words that the linear filter mixes in a level, and their weights along s and t. */
typedef struct word_corners {
    lanes_i corner[CORNER_COUNT];
    lanes_f weight_s, weight_t;
} word_corners;

static inline void find_corners(const lookup_state *state, const lookup_place *place,
                                uint32_t level, word_corners *out)
{
    const stored_word *const words = state->texture->level[level].texels;
    lanes_i column, row, right, up;

    out->weight_s = find_words(state->wrap[0], state->masked[0], place->coordinate[0],
                               size_along(state, level, 0), 1, &column, &right);
    out->weight_t = find_words(state->wrap[1], state->masked[1], place->coordinate[1],
                               size_along(state, level, 1), words_per_row(state, level), &row, &up);

    const lanes_i index = lanes_i_add(row_of_words(state, level, row), column);
    const bool are_neighbours = lanes_bits(lanes_i_equal(right, lanes_i_splat(1))) == GN_ALL_LANES;
    gather_columns(words, index, right, are_neighbours, &out->corner[CORNER_00]);
    gather_columns(words, lanes_i_add(index, up), right, are_neighbours, &out->corner[CORNER_01]);
}

GN_OUT_OF_LINE void filter_words_linear(const lookup_state *state, const lookup_place *place,
                                        uint32_t level, uint32_t linear, lanes_f texel[4])
{
    word_corners w;

    find_corners(state, place, level, &w);
    mix_words(w.corner, weights_of(linear, w.weight_s), weights_of(linear, w.weight_t), texel);
}

/* Returns one channel of two levels, mixed. The channel must be a constant. */
GN_INLINE lanes_f mix_word_levels(const word_corners *first, const word_corners *next, int channel,
                                  lanes_f weight)
{
    return mix(weight, mix_corners(first->corner, channel, first->weight_s, first->weight_t),
               mix_corners(next->corner, channel, next->weight_s, next->weight_t));
}

/* Filters two levels linearly in all lanes and mixes them by the weight of the second. */
GN_OUT_OF_LINE void filter_words_between(const lookup_state *state, const lookup_place *place,
                                         uint32_t level, uint32_t next, const lanes_f *weight,
                                         lanes_f texel[4])
{
    word_corners w[2];

    find_corners(state, place, level, &w[0]);
    find_corners(state, place, next, &w[1]);
    texel[0] = mix_word_levels(&w[0], &w[1], 0, *weight);
    texel[1] = mix_word_levels(&w[0], &w[1], 1, *weight);
    texel[2] = mix_word_levels(&w[0], &w[1], 2, *weight);
    texel[3] = mix_word_levels(&w[0], &w[1], 3, *weight);
}

#endif
