/* The filters within a level of a 2D texture of RGBA8 without a border, whose texels are words that
 * are gathered and mixed channel by channel: the same texels as filter.h's, in less time. */
#ifndef GN_TEXTURE_WORDS_H
#define GN_TEXTURE_WORDS_H

#include "filter.h"

static inline bool level_has_words(const lookup_state *state, uint32_t level)
{
    return state->texture->target == GN_TEXTURE_2D && !state->has_border &&
           has_word_texels(state->texture, level);
}

/* Word indices of a row's first texels. */
static inline lanes_i row_of_words(const lookup_state *state, uint32_t level, lanes_i row)
{
    const int32_t stride = (int32_t)(state->texture->level[level].row_stride / 4);

    return lanes_i_mul(row, lanes_i_splat(stride));
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

/* Columns of a row; where the second follows the first in every lane, both at once. */
static inline void gather_columns(const stored_word *words, lanes_i row, const lanes_i column[2],
                                  bool are_neighbours, lanes_i word[2])
{
    const lanes_i index = lanes_i_add(row, column[0]);

    if (are_neighbours) {
        lanes_i_gather_pairs(words, index, &word[0], &word[1]);
    } else {
        word[0] = lanes_i_gather(words, index);
        word[1] = lanes_i_gather(words, lanes_i_add(row, column[1]));
    }
}

GN_OUT_OF_LINE void filter_words_linear(const lookup_state *state, const lookup_place *place,
                                        uint32_t level, uint32_t linear, lanes_f texel[4])
{
    const stored_word *const words = state->texture->level[level].texels;
    lanes_i column[2], row[2], corner[CORNER_COUNT];
    lanes_f weight[2];

    weight[0] =
        weights_of(linear, wrap_linear_any(state->wrap[0], state->masked[0], place->coordinate[0],
                                           size_along(state, level, 0), column));
    weight[1] =
        weights_of(linear, wrap_linear_any(state->wrap[1], state->masked[1], place->coordinate[1],
                                           size_along(state, level, 1), row));

    const lanes_m follows = lanes_i_equal(column[1], lanes_i_add(column[0], lanes_i_splat(1)));
    const bool are_neighbours = lanes_bits(follows) == GN_ALL_LANES;
    gather_columns(words, row_of_words(state, level, row[0]), column, are_neighbours,
                   &corner[CORNER_00]);
    gather_columns(words, row_of_words(state, level, row[1]), column, are_neighbours,
                   &corner[CORNER_01]);
    texel[0] = mix_corners(corner, 0, weight[0], weight[1]);
    texel[1] = mix_corners(corner, 1, weight[0], weight[1]);
    texel[2] = mix_corners(corner, 2, weight[0], weight[1]);
    texel[3] = mix_corners(corner, 3, weight[0], weight[1]);
}

#endif
