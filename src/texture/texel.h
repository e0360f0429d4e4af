/* Texels of one level, of every format, as floats over lanes. The texels of most levels are found
 * by 32-bit indices and loaded a few at a time; those of all others are loaded one by one. */
#ifndef GN_TEXTURE_TEXEL_H
#define GN_TEXTURE_TEXEL_H

#include "../formats/decode.h"
#include "extent.h"

/* How the texels of a level are loaded: the name says what indices count and how much is loaded. */
typedef enum texel_access {
    ACCESS_ONE_BY_ONE, /* no indices, but columns, rows and layers */
    ACCESS_BYTE,
    ACCESS_HALF,
    ACCESS_WORD,
    ACCESS_TWO_WORDS,
    ACCESS_FOUR_WORDS
} texel_access;

/* Where the texels of a level lie, in bytes from the first one. An index is the sum of a column, a
 * row and a layer, each times its unit. For ACCESS_ONE_BY_ONE the units are 1. */
typedef struct texel_layout {
    const unsigned char *texels;
    ptrdiff_t row_stride, layer_stride;
    bool has_layers;
    gn_format format;
    texel_access access;
    int32_t unit[3];
} texel_layout;

/* Columns, rows and layers of texels, or for other accesses than ACCESS_ONE_BY_ONE these times
 * their units. The last is null if the level has one layer. */
typedef struct texel_numbers {
    const lanes_i *along[3];
} texel_numbers;

/* Writes how texels of a format are loaded, and returns n if their indices count 2^n bytes. Pixels
 * of four halves are two words in memory if the first element is the low half. */
static inline int index_shift(gn_format format, texel_access *access)
{
    switch (format_layout(format)) {
    case GN_LAYOUT(1, 1):
        *access = ACCESS_BYTE;
        return 0;
    case GN_LAYOUT(2, 2):
        *access = ACCESS_HALF;
        return 1;
    case GN_LAYOUT(4, 4):
    case GN_LAYOUT(8, 4): /* the depth of D32FS8 */
        *access = ACCESS_WORD;
        return 2;
    case GN_LAYOUT(16, 4):
        *access = ACCESS_FOUR_WORDS;
        return 2;
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    case GN_LAYOUT(8, 2):
        *access = ACCESS_TWO_WORDS;
        return 2;
#endif
    default:
        *access = ACCESS_ONE_BY_ONE;
        return 0;
    }
}

/* The strides of a checked texture do not overflow, because the whole level fits memory. Small
 * builds load all texels one by one. */
static inline void set_texel_layout(texel_layout *out, const gn_texture *texture, uint32_t level)
{
    const gn_texture_level *const l = &texture->level[level];
    const texel_extent extent = extent_of_level(texture, level);
    const size_t size = format_size(texture->format);
    const size_t row = l->row_stride < 0 ? 0 - (size_t)l->row_stride : (size_t)l->row_stride;
    const size_t layer =
        l->layer_stride < 0 ? 0 - (size_t)l->layer_stride : (size_t)l->layer_stride;
    texel_access access;
    const int shift = index_shift(texture->format, &access);

    out->texels = l->texels;
    out->has_layers = extent.layers > 1;
    out->row_stride = extent.height > 1 ? l->row_stride : 0;
    out->layer_stride = out->has_layers ? l->layer_stride : 0;
    out->format = texture->format;
    out->access = ACCESS_ONE_BY_ONE;
    out->unit[0] = out->unit[1] = out->unit[2] = 1;
    if (!GN_SPECIALISED || access == ACCESS_ONE_BY_ONE)
        return;

    const size_t rows = extent.height > 1 ? row : 0;
    const size_t layers = out->has_layers ? layer : 0;
    const size_t bytes =
        rows * (extent.height - 1) + layers * (extent.layers - 1) + extent.width * size;
    const bool is_aligned = ((uintptr_t)l->texels | rows | layers) % ((size_t)1 << shift) == 0;
    if (!is_aligned || bytes >> shift > INT32_MAX)
        return;

    const int32_t rows_apart = (int32_t)(rows >> shift), layers_apart = (int32_t)(layers >> shift);
    out->access = access;
    out->unit[0] = (int32_t)(size >> shift);
    out->unit[1] = l->row_stride < 0 ? -rows_apart : rows_apart;
    out->unit[2] = l->layer_stride < 0 ? -layers_apart : layers_apart;
}

/* Finds where the lanes' rows begin. */
static inline void find_rows(const texel_layout *layout, const texel_numbers *numbers,
                             const unsigned char *line[GN_LANES])
{
    int32_t y[GN_LANES], z[GN_LANES];

    lanes_i_store(y, *numbers->along[1]);
    GN_EACH_LANE (l)
        line[l] = layout->texels + (ptrdiff_t)y[l] * layout->row_stride;
    if (!layout->has_layers)
        return;
    lanes_i_store(z, *numbers->along[2]);
    GN_EACH_LANE (l)
        line[l] += (ptrdiff_t)z[l] * layout->layer_stride;
}

/* Loads texels as words, or in the low bits of one or two (../formats/pixel_memory.h). */
GN_OUT_OF_LINE void load_one_by_one(const texel_layout *layout, const texel_numbers *numbers,
                                    lanes_i word[4])
{
    const pixel_layout pixels = format_layout(layout->format);
    const int32_t step = (int32_t)format_size(layout->format) / 4;
    const bool in_words = format_element(layout->format) == 4;
    const int count = !in_words || step != 4 ? 1 : 4;
    const unsigned char *line[GN_LANES];
    int32_t x[GN_LANES], texel[2][GN_LANES];

    lanes_i_store(x, *numbers->along[0]);
    find_rows(layout, numbers, line);
    for (int n = 0; n < count; ++n) {
        GN_EACH_LANE (l) {
            int32_t loaded[4];

            for (int i = 0; i < 4; ++i) /* compilers make no call of memset of this */
                loaded[i] = 0;
            if (in_words)
                load_pixel(line[l], step * x[l] + n, GN_LAYOUT(4, 4), loaded);
            else
                load_pixel(line[l], x[l], pixels, loaded);
            texel[0][l] = loaded[0];
            texel[1][l] = loaded[1];
        }
        word[n] = lanes_i_load(texel[0]);
    }
    if (!in_words)
        word[1] = lanes_i_load(texel[1]);
}

/* Returns the index of each lane's texel. */
static inline lanes_i texel_index(const texel_numbers *numbers)
{
    const lanes_i in_layer = lanes_i_add(*numbers->along[0], *numbers->along[1]);

    return numbers->along[2] ? lanes_i_add(in_layer, *numbers->along[2]) : in_layer;
}

/* Loads `count` neighbouring bytes, the first one lowest. */
static inline lanes_i load_bytes(const unsigned char *texels, lanes_i index, int count)
{
    int32_t at[GN_LANES], texel[GN_LANES];

    lanes_i_store(at, index);
    if (count == 1)
        GN_EACH_LANE (l)
            texel[l] = texels[at[l]];
    else
        GN_EACH_LANE (l)
            texel[l] = texels[at[l]] | texels[at[l] + 1] << 8;
    return lanes_i_load(texel);
}

/* Loads `count` neighbouring halves, the first one lowest. */
static inline lanes_i load_halves(const unsigned char *texels, lanes_i index, int count)
{
    const stored_half *const halves = (const stored_half *)(const void *)texels;
    int32_t at[GN_LANES], texel[GN_LANES];

    lanes_i_store(at, index);
    if (count == 1)
        GN_EACH_LANE (l)
            texel[l] = halves[at[l]];
    else
        GN_EACH_LANE (l)
            texel[l] = (int32_t)(halves[at[l]] | (uint32_t)halves[at[l] + 1] << 16);
    return lanes_i_load(texel);
}

/* Loads two neighbouring words. Out of line, since callers load several pairs. */
GN_OUT_OF_LINE void load_pairs(const stored_word *words, const lanes_i *index, lanes_i word[2])
{
    lanes_i_gather_pairs(words, *index, &word[0], &word[1]);
}

/* Loads words. Out of line, for loads that are rare or one of many. */
GN_OUT_OF_LINE void load_words(const stored_word *words, const lanes_i *index, lanes_i *word)
{
    *word = lanes_i_gather(words, *index);
}

/* Loads texels by indices. */
GN_OUT_OF_LINE void load_by_index(const texel_layout *layout, const lanes_i *index, lanes_i word[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;

    switch (layout->access) {
    case ACCESS_BYTE:
        word[0] = load_bytes(layout->texels, *index, 1);
        break;
    case ACCESS_HALF:
        word[0] = load_halves(layout->texels, *index, 1);
        break;
    case ACCESS_FOUR_WORDS:
        load_pairs(words + 2, index, word + 2);
        load_pairs(words, index, word);
        break;
    case ACCESS_TWO_WORDS:
        load_pairs(words, index, word);
        break;
    default:
        word[0] = lanes_i_gather(words, *index);
        break;
    }
}

/* Loads texels and their right neighbours by the indices of the former. */
GN_OUT_OF_LINE void load_neighbours(const texel_layout *layout, const lanes_i *index,
                                    lanes_i first[4], lanes_i second[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;
    lanes_i both, pair[2];

    switch (layout->access) {
    case ACCESS_BYTE:
        both = load_bytes(layout->texels, *index, 2);
        first[0] = lanes_i_and(both, lanes_i_splat(0xFF));
        second[0] = lanes_i_shift_right(both, 8);
        break;
    case ACCESS_HALF:
        both = load_halves(layout->texels, *index, 2);
        first[0] = lanes_i_and(both, lanes_i_splat(0xFFFF));
        second[0] = lanes_i_and(lanes_i_shift_right(both, 16), lanes_i_splat(0xFFFF));
        break;
    case ACCESS_FOUR_WORDS:
        load_pairs(words, index, first);
        load_pairs(words + 2, index, first + 2);
        load_pairs(words + 4, index, second);
        load_pairs(words + 6, index, second + 2);
        break;
    case ACCESS_TWO_WORDS:
        load_pairs(words, index, first);
        load_pairs(words + 2, index, second);
        break;
    default:
        if (layout->unit[0] == 1) {
            load_pairs(words, index, pair);
            first[0] = pair[0];
            second[0] = pair[1];
        } else {
            load_words(words, index, first);
            load_words(words + layout->unit[0], index, second);
        }
        break;
    }
}

/* Decodes texels; out of line, because there is a case for each format. */
GN_OUT_OF_LINE void decode_texels(gn_format format, const lanes_i word[4], lanes_f texel[4])
{
    decode_channels(format, word, texel);
}

/* Decodes texels of GN_FORMAT_RGBA8. */
static inline void unpack_texels(lanes_i word, lanes_f texel[4])
{
    texel[0] = lanes_unpack_unorm8(word, 0);
    texel[1] = lanes_unpack_unorm8(word, 1);
    texel[2] = lanes_unpack_unorm8(word, 2);
    texel[3] = lanes_unpack_unorm8(word, 3);
}

/* Fetches texels. Channels that the format lacks are 0, alpha 1; depth formats have only red. */
static inline void load_texels(const texel_layout *layout, const texel_numbers *numbers,
                               lanes_f texel[4])
{
    lanes_i word[4], index;

    if (layout->access == ACCESS_ONE_BY_ONE) {
        load_one_by_one(layout, numbers, word);
    } else {
        index = texel_index(numbers);
        if (layout->format == GN_FORMAT_RGBA8) {
            unpack_texels(lanes_i_gather((const stored_word *)(const void *)layout->texels, index),
                          texel);
            return;
        }
        load_by_index(layout, &index, word);
    }
    decode_texels(layout->format, word, texel);
}

/* Returns numbers times the unit of a dimension. */
static inline lanes_i in_units(const texel_layout *layout, int dimension, lanes_i number)
{
    const int32_t unit = layout->unit[dimension];

    return unit == 1 ? number : lanes_i_mul(number, lanes_i_splat(unit));
}

/* Fetches texels of a level of a checked texture by number. Precondition: the texels lie in the
 * level. The layer, or the face of a cube, is read only if the level has more than one, and may be
 * null otherwise. */
GN_OUT_OF_LINE void fetch_texels(const gn_texture *texture, uint32_t level, const lanes_i *column,
                                 const lanes_i *row, const lanes_i *layer, lanes_f texel[4])
{
    texel_layout layout;
    texel_numbers numbers;
    lanes_i along[3];

    set_texel_layout(&layout, texture, level);
    along[0] = in_units(&layout, 0, *column);
    along[1] = in_units(&layout, 1, *row);
    numbers.along[0] = &along[0];
    numbers.along[1] = &along[1];
    numbers.along[2] = 0;
    if (layout.has_layers) {
        along[2] = in_units(&layout, 2, *layer);
        numbers.along[2] = &along[2];
    }
    load_texels(&layout, &numbers, texel);
}

#endif
