/* Texels of one level, of every format, as floats over lanes. The texels of most levels are found
 * by 32-bit indices and loaded a few at a time; those of all others are loaded one by one. */
#ifndef GN_KERNEL_TEXTURE_TEXEL_INL
#define GN_KERNEL_TEXTURE_TEXEL_INL

#include "../../formats/decode.h"
#include "../../formats/pixel_memory.h"
#include "../../lanes/gather.h"
#include "../../texture/texel_layout.h"

/* Columns, rows and layers of texels that are loaded one by one. The last is null if the level has
 * one layer. */
typedef struct texel_numbers {
    const lanes_i *along[3];
} texel_numbers;

/* Finds where the lanes' rows begin. */
static inline void find_rows(const texel_layout *layout, const texel_numbers *numbers,
                             const unsigned char *line[LANES])
{
    int32_t y[LANES], z[LANES];

    lanes_i_store(y, *numbers->along[1]);
    GN_EACH_LANE (l)
        line[l] = layout->texels + (ptrdiff_t)y[l] * layout->row_stride;
    if (!layout->has_layers)
        return;
    lanes_i_store(z, *numbers->along[2]);
    GN_EACH_LANE (l)
        line[l] += (ptrdiff_t)z[l] * layout->layer_stride;
}

/* Loads texels as words (../../formats/pixel_layout.h). */
GN_OUT_OF_LINE void load_one_by_one(const texel_layout *layout, const texel_numbers *numbers,
                                    lanes_i word[4])
{
    const pixel_layout pixels = format_layout(layout->format);
    const unsigned char *line[LANES];
    int32_t x[LANES], texel[4][LANES];

    lanes_i_store(x, *numbers->along[0]);
    find_rows(layout, numbers, line);
    GN_EACH_LANE (l) {
        int32_t loaded[4];

        for (int i = 0; i < 4; ++i) /* compilers make no call of memset of this */
            loaded[i] = 0;
        load_pixel(line[l], x[l], pixels, loaded);
        for (int i = 0; i < 4; ++i)
            texel[i][l] = loaded[i];
    }
    for (int i = 0; i < 4; ++i)
        word[i] = lanes_i_load(texel[i]);
}

/* Loads two bytes at any address. Out of line, since it is long and texels are loaded in several
 * places. */
GN_OUT_OF_LINE void load_shorts(const unsigned char *texels, const lanes_i *offset, lanes_i *word)
{
    *word = lanes_i_gather_bytes(texels, *offset, 2);
}

GN_OUT_OF_LINE void load_four_words(const stored_word *words, const lanes_i *index, lanes_i word[4])
{
    lanes_i_gather_fours(words, *index, word);
}

/* Loads texels of any number of words. */
GN_OUT_OF_LINE void load_words(const stored_word *words, const lanes_i *index, int count,
                               lanes_i word[4])
{
    for (int i = 0; i < count; ++i)
        word[i] = lanes_i_gather(words + i, *index);
}

/* Loads texels by indices. Bits above the texels of less than a word are those of any memory of the
 * level. */
GN_OUT_OF_LINE void load_by_index(const texel_layout *layout, const lanes_i *index, lanes_i word[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;

    switch (layout->indexed) {
    case LAYOUT_BYTE:
        word[0] = lanes_i_gather_bytes(layout->texels, *index, 1);
        break;
    case LAYOUT_SHORT:
        load_shorts(layout->texels, index, word);
        break;
    case LAYOUT_THREE_BYTES:
        load_shorts(layout->texels, index, word);
        word[0] = lanes_i_or(
            word[0], lanes_i_shift_left(lanes_i_gather_bytes(layout->texels + 2, *index, 1), 16));
        break;
    case LAYOUT_FOUR_WORDS:
        load_four_words(words, index, word);
        break;
    case LAYOUT_FOUR_SHORTS:
    case LAYOUT_TWO_WORDS:
        lanes_i_gather_pairs(words, *index, &word[0], &word[1]);
        break;
    case LAYOUT_WORD:
        word[0] = lanes_i_gather(words, *index);
        break;
    default:
        load_words(words, index, layout_words(layout->indexed), word);
        break;
    }
}

/* Loads texels of three bytes and their right neighbours. Eight bytes hold both, but eight bytes
 * from the last texels of a level on would reach beyond it. */
GN_OUT_OF_LINE void load_three_byte_neighbours(const texel_layout *layout, const lanes_i *index,
                                               lanes_i *first, lanes_i *second)
{
    lanes_i low, high;

    if (lanes_bits(lanes_i_greater(*index, lanes_i_splat(layout->last_eight))) != 0) {
        *first = lanes_i_gather_bytes(layout->texels, *index, 4);
        *second = lanes_i_shift_right(lanes_i_gather_bytes(layout->texels + 2, *index, 4), 8);
        return;
    }
    lanes_i_gather_eight(layout->texels, *index, &low, &high);
    *first = low;
    *second = lanes_i_or(lanes_i_and(lanes_i_shift_right(low, 24), lanes_i_splat(255)),
                         lanes_i_shift_left(high, 8));
}

/* Loads texels and their right neighbours by the indices of the former, as load_by_index does.
 * `indexed` is the layout's, as a constant where that saves time. */
GN_INLINE void load_neighbours(pixel_layout indexed, const texel_layout *layout, lanes_i index,
                               lanes_i first[4], lanes_i second[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;
    lanes_i called_for, four[4];

    switch (indexed) {
    case LAYOUT_BYTE:
        first[0] = lanes_i_gather_bytes(layout->texels, index, 2);
        second[0] = lanes_i_shift_right(first[0], 8);
        break;
    case LAYOUT_SHORT:
        first[0] = lanes_i_gather_bytes(layout->texels, index, 4);
        second[0] = lanes_i_shift_right(first[0], 16);
        break;
    case LAYOUT_THREE_BYTES:
        called_for = index;
        load_three_byte_neighbours(layout, &called_for, first, second);
        break;
    case LAYOUT_WORD:
        lanes_i_gather_pairs(words, index, &first[0], &second[0]);
        break;
    case LAYOUT_FOUR_SHORTS:
    case LAYOUT_TWO_WORDS:
        lanes_i_gather_fours(words, index, four);
        first[0] = four[0];
        first[1] = four[1];
        second[0] = four[2];
        second[1] = four[3];
        break;
    case LAYOUT_THREE_WORDS:
        lanes_i_gather_fours(words, index, first);
        lanes_i_gather_fours(words + 2, index, four);
        for (int i = 0; i < 3; ++i)
            second[i] = four[i + 1];
        break;
    default: /* LAYOUT_FOUR_WORDS */
        lanes_i_gather_fours(words, index, first);
        lanes_i_gather_fours(words + 4, index, second);
        break;
    }
}

/* Does the same for any layout. */
GN_OUT_OF_LINE void load_any_neighbours(const texel_layout *layout, const lanes_i *index,
                                        lanes_i first[4], lanes_i second[4])
{
    load_neighbours(layout->indexed, layout, *index, first, second);
}

/* Fetches texels by indices. Only the rarer loads are calls. */
static inline void fetch_by_index(const texel_layout *layout, lanes_i index, lanes_f texel[4])
{
    lanes_i word[4];

    if (layout->indexed == LAYOUT_WORD) {
        word[0] = lanes_i_gather((const stored_word *)(const void *)layout->texels, index);
        if (layout->format == GN_FORMAT_RGBA8) {
            for (int c = 0; c < 4; ++c)
                texel[c] = lanes_unpack_unorm8(word[0], c);
            return;
        }
    } else {
        const lanes_i called_for = index;

        load_by_index(layout, &called_for, word);
    }
    decode_colors(layout->format, word, texel);
}

/* Returns numbers times the unit of a dimension. */
static inline lanes_i in_units(const texel_layout *layout, int dimension, lanes_i number)
{
    const int32_t unit = layout->unit[dimension];

    if (unit == 1)
        return number;
    return unit == (int16_t)unit ? lanes_i_mul_short(number, unit)
                                 : lanes_i_mul(number, lanes_i_splat(unit));
}

/* Fetches texels of a level of a checked texture by number. Precondition: the texels lie in the
 * level. The layer, or the face of a cube, is read only if the level has more than one, and may be
 * null otherwise. */
GN_OUT_OF_LINE void fetch_texels(const texel_layout *layout, const lanes_i *column,
                                 const lanes_i *row, const lanes_i *layer, lanes_f texel[4])
{
    if (layout->indexed == LAYOUT_NONE) {
        const texel_numbers numbers = {{column, row, layout->has_layers ? layer : 0}};
        lanes_i word[4];

        load_one_by_one(layout, &numbers, word);
        decode_colors(layout->format, word, texel);
        return;
    }

    const lanes_i index = lanes_i_add(in_units(layout, 0, *column), in_units(layout, 1, *row));
    fetch_by_index(layout,
                   layout->has_layers ? lanes_i_add(index, in_units(layout, 2, *layer)) : index,
                   texel);
}

#endif
