/* Texels of one level, of every format, as floats over lanes. They are loaded as 32-bit words: by
 * gathers if all indices fit 32 bits, otherwise one by one. */
#ifndef GN_TEXTURE_TEXEL_H
#define GN_TEXTURE_TEXEL_H

#include "../formats/decode.h"
#include "extent.h"

/* Where the texels of a level lie, in bytes from the first one. */
typedef struct texel_layout {
    const unsigned char *texels;
    ptrdiff_t row_stride, layer_stride;
    bool has_layers;
    bool has_word_index; /* every texel is a whole number of words away, which fits 31 bits */
} texel_layout;

/* The strides of a checked texture do not overflow, because the whole level fits memory. */
static inline texel_layout texel_layout_of(const gn_texture *texture, uint32_t level,
                                           uint32_t texel_size)
{
    const gn_texture_level *const l = &texture->level[level];
    const texel_extent extent = extent_of_level(texture, level);
    const size_t row = l->row_stride < 0 ? 0 - (size_t)l->row_stride : (size_t)l->row_stride;
    const size_t layer =
        l->layer_stride < 0 ? 0 - (size_t)l->layer_stride : (size_t)l->layer_stride;
    texel_layout out;

    out.texels = l->texels;
    out.row_stride = extent.height > 1 ? l->row_stride : 0;
    out.has_layers = extent.layers > 1;
    out.layer_stride = out.has_layers ? l->layer_stride : 0;
    out.has_word_index = (extent.height > 1 ? row * (extent.height - 1) : 0) / 4 +
                             (out.has_layers ? layer * (extent.layers - 1) : 0) / 4 +
                             (size_t)extent.width * texel_size / 4 <=
                         INT32_MAX;
    return out;
}

/* Gathers words 0 to count - 1 (count is 1 or 4) of texels that are `step` words long. */
static inline void gather_texel_words(const texel_layout *layout, const lanes_i *column,
                                      const lanes_i *row, const lanes_i *layer, int32_t step,
                                      int count, lanes_i word[4])
{
    const stored_word *const words = (const stored_word *)(const void *)layout->texels;
    lanes_i index = lanes_i_add(lanes_i_mul(*row, lanes_i_splat((int32_t)(layout->row_stride / 4))),
                                lanes_i_mul(*column, lanes_i_splat(step)));

    if (layout->has_layers)
        index = lanes_i_add(
            index, lanes_i_mul(*layer, lanes_i_splat((int32_t)(layout->layer_stride / 4))));
    for (int n = 0; n < count; ++n)
        word[n] = lanes_i_gather(words + n, index);
}

/* Finds where the lanes' rows begin. */
static inline void find_rows(const texel_layout *layout, const lanes_i *row, const lanes_i *layer,
                             const unsigned char *line[GN_LANES])
{
    int32_t y[GN_LANES], z[GN_LANES];

    lanes_i_store(y, *row);
    GN_EACH_LANE (l)
        line[l] = layout->texels + (ptrdiff_t)y[l] * layout->row_stride;
    if (!layout->has_layers)
        return;
    lanes_i_store(z, *layer);
    GN_EACH_LANE (l)
        line[l] += (ptrdiff_t)z[l] * layout->layer_stride;
}

/* Does what gather_texel_words does, texel by texel. */
static inline void load_texel_words(const texel_layout *layout, const lanes_i *column,
                                    const lanes_i *row, const lanes_i *layer, int32_t step,
                                    int count, lanes_i word[4])
{
    const unsigned char *line[GN_LANES];
    int32_t x[GN_LANES], texel[GN_LANES], loaded[4];

    lanes_i_store(x, *column);
    find_rows(layout, row, layer, line);
    for (int n = 0; n < count; ++n) {
        GN_EACH_LANE (l) {
            load_pixel(line[l], step * x[l] + n, GN_LAYOUT(4, 4), loaded);
            texel[l] = loaded[0];
        }
        word[n] = lanes_i_load(texel);
    }
}

/* Texels that are no words, in the low bits of one or two (../formats/pixel_memory.h). */
static inline void load_small_texels(const texel_layout *layout, const lanes_i *column,
                                     const lanes_i *row, const lanes_i *layer, pixel_layout pixels,
                                     lanes_i word[4])
{
    const unsigned char *line[GN_LANES];
    int32_t x[GN_LANES], texel[2][GN_LANES];

    lanes_i_store(x, *column);
    find_rows(layout, row, layer, line);
    GN_EACH_LANE (l) {
        int32_t loaded[4];

        for (int i = 0; i < 4; ++i) /* compilers make no call of memset of this */
            loaded[i] = 0;
        load_pixel(line[l], x[l], pixels, loaded);
        texel[0][l] = loaded[0];
        texel[1][l] = loaded[1];
    }
    word[0] = lanes_i_load(texel[0]);
    word[1] = lanes_i_load(texel[1]);
}

/* Fetches texels of a level of a checked texture by number. Precondition: the texels lie in the
 * level. The layer, or the face of a cube, is read only if the level has more than one, and may be
 * null otherwise. Channels that the format lacks are 0, alpha 1; depth formats have only red. */
GN_OUT_OF_LINE void fetch_texels(const gn_texture *texture, uint32_t level, const lanes_i *column,
                                 const lanes_i *row, const lanes_i *layer, lanes_f texel[4])
{
    const uint32_t size = format_size(texture->format);
    const texel_layout layout = texel_layout_of(texture, level, size);
    const bool in_words = format_element(texture->format) == 4;
    const int32_t step = (int32_t)size / 4;
    const int count = size == 16 ? 4 : 1;
    lanes_i word[4];

    if (!in_words)
        load_small_texels(&layout, column, row, layer, format_layout(texture->format), word);
    else if (layout.has_word_index)
        gather_texel_words(&layout, column, row, layer, step, count, word);
    else
        load_texel_words(&layout, column, row, layer, step, count, word);

    decode_channels(texture->format, word, texel);
}

#endif
