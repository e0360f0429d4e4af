/* Texels of one level, of every format, as floats over lanes. The texels of most levels are found
 * by 32-bit indices and loaded a few at a time; those of all others are loaded one by one. */
#ifndef GN_KERNEL_TEXTURE_TEXEL_INL
#define GN_KERNEL_TEXTURE_TEXEL_INL

#include "../../formats/decode.h"
#include "../../lanes/gather.h"
#include "../../texture/texel_layout.h"

/* Columns, rows and layers of texels, or for other accesses than ACCESS_ONE_BY_ONE these times
 * their units. The last is null if the level has one layer. */
typedef struct texel_numbers {
    const lanes_i *along[3];
} texel_numbers;

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

/* Loads two bytes at any address. Out of line, since it is long and texels are loaded in several
 * places. */
GN_OUT_OF_LINE void load_half_words(const unsigned char *texels, const lanes_i *offset,
                                    lanes_i *word)
{
    *word = lanes_i_gather_bytes(texels, *offset, 2);
}

GN_OUT_OF_LINE void load_quads(const stored_word *words, const lanes_i *index, lanes_i word[4])
{
    lanes_i_gather_quads(words, *index, word);
}

/* Loads texels by indices. Bits above the texels of less than a word are those of any memory of the
 * level. */
GN_OUT_OF_LINE void load_by_index(const texel_layout *layout, const lanes_i *index, lanes_i word[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;

    switch (layout->access) {
    case ACCESS_BYTE:
        word[0] = lanes_i_gather_bytes(layout->texels, *index, 1);
        break;
    case ACCESS_TWO_BYTES:
        load_half_words(layout->texels, index, word);
        break;
    case ACCESS_THREE_BYTES:
        load_half_words(layout->texels, index, word);
        word[0] = lanes_i_or(
            word[0], lanes_i_shift_left(lanes_i_gather_bytes(layout->texels + 2, *index, 1), 16));
        break;
    case ACCESS_FOUR_WORDS:
        load_quads(words, index, word);
        break;
    case ACCESS_TWO_WORDS:
        lanes_i_gather_pairs(words, *index, &word[0], &word[1]);
        break;
    default:
        word[0] = lanes_i_gather(words, *index);
        break;
    }
}

/* Loads texels of three bytes and their right neighbours. Eight bytes hold both, but eight bytes
 * from the last texels of a level on would reach beyond it. */
GN_OUT_OF_LINE void load_triples(const texel_layout *layout, const lanes_i *index, lanes_i *first,
                                 lanes_i *second)
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

/* Loads texels and their right neighbours by the indices of the former, as load_by_index does. Only
 * the rarer loads are calls, which take the indices from memory. */
static inline void load_neighbours(const texel_layout *layout, lanes_i index, lanes_i first[4],
                                   lanes_i second[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;
    lanes_i called_for, quad[4];

    switch (layout->access) {
    case ACCESS_BYTE:
        first[0] = lanes_i_gather_bytes(layout->texels, index, 2);
        second[0] = lanes_i_shift_right(first[0], 8);
        break;
    case ACCESS_TWO_BYTES:
        first[0] = lanes_i_gather_bytes(layout->texels, index, 4);
        second[0] = lanes_i_shift_right(first[0], 16);
        break;
    case ACCESS_THREE_BYTES:
        called_for = index;
        load_triples(layout, &called_for, first, second);
        break;
    case ACCESS_FOUR_WORDS:
        called_for = index;
        load_quads(words, &called_for, first);
        load_quads(words + 4, &called_for, second);
        break;
    case ACCESS_TWO_WORDS:
        called_for = index;
        load_quads(words, &called_for, quad);
        first[0] = quad[0];
        first[1] = quad[1];
        second[0] = quad[2];
        second[1] = quad[3];
        break;
    default:
        lanes_i_gather_pairs(words, index, &first[0], &second[0]);
        break;
    }
}

/* Returns a channel that is a fraction, from words that are moved down if is_high is set. */
GN_INLINE lanes_f masked_fraction(const texel_channel *channel, lanes_i word)
{
    return lanes_mul(lanes_to_float(lanes_i_and(word, lanes_i_splat(channel->mask))),
                     lanes_splat(channel->scale));
}

static inline lanes_f fraction_in(const texel_channel *channel, lanes_i word)
{
    return masked_fraction(channel, channel->is_high ? lanes_i_shift_right(word, 16) : word);
}

/* Decodes a channel of `count` texels of up to four words. If the count is above 1, the values are
 * for arithmetic. */
GN_OUT_OF_LINE void decode_channel(const texel_channel *channel, const lanes_i texel[][4],
                                   int count, lanes_f *value)
{
    const int word = channel->word;
    const int top = 32 - channel->shift - channel->width; /* bits above the channel */
    const int down = channel->width == 16 ? 16 : 17;      /* other floats have no sign */
    const lanes_i mask = lanes_i_splat(channel->mask);

    switch (channel->kind) {
    case CHANNEL_WORD:
        for (int i = 0; i < count; ++i)
            value[i] = lanes_as_float(texel[i][word]);
        break;
    case CHANNEL_FLOAT:
        for (int i = 0; i < count; ++i) {
            const lanes_i half = lanes_i_and(
                lanes_i_shift_right(lanes_i_shift_left(texel[i][word], top), down), mask);

            value[i] = count == 1 ? half_value(half) : half_operand(half);
        }
        break;
    case CHANNEL_SRGB:
        for (int i = 0; i < count; ++i)
            value[i] = srgb_value(texel[i][word], channel->shift);
        break;
    default:
        for (int i = 0; i < count; ++i)
            value[i] = fraction_in(channel, texel[i][word]);
        break;
    }
}

/* Decodes texels. Channels that the format lacks become 0, alpha 1; depth formats have only red. */
GN_OUT_OF_LINE void decode_texels(gn_format format, const lanes_i word[4], lanes_f texel[4])
{
    const texel_format *const f = &gni_texel_formats[format];

    for (int c = 0; c < 4; ++c) {
        const texel_channel *const channel = &f->channel[c];

        if (c >= f->channels)
            texel[c] = lanes_splat(c == 3 ? 1.0f : 0.0f);
        else if (channel->kind == CHANNEL_FRACTION)
            texel[c] = fraction_in(channel, word[channel->word]);
        else
            decode_channel(channel, (const lanes_i(*)[4])word, 1, &texel[c]);
    }
}

/* Fetches texels by indices. Only the rarer loads are calls. */
static inline void fetch_by_index(const texel_layout *layout, lanes_i index, lanes_f texel[4])
{
    lanes_i word[4];

    if (layout->access == ACCESS_WORD) {
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
    decode_texels(layout->format, word, texel);
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
GN_OUT_OF_LINE void fetch_texels(const gn_texture *texture, uint32_t level, const lanes_i *column,
                                 const lanes_i *row, const lanes_i *layer, lanes_f texel[4])
{
    texel_layout layout;

    gni_lay_out_texels(texture, level, &layout);
    if (layout.access == ACCESS_ONE_BY_ONE) {
        const texel_numbers numbers = {{column, row, layout.has_layers ? layer : 0}};
        lanes_i word[4];

        load_one_by_one(&layout, &numbers, word);
        decode_texels(layout.format, word, texel);
        return;
    }

    const lanes_i index = lanes_i_add(in_units(&layout, 0, *column), in_units(&layout, 1, *row));
    fetch_by_index(&layout,
                   layout.has_layers ? lanes_i_add(index, in_units(&layout, 2, *layer)) : index,
                   texel);
}

#endif
