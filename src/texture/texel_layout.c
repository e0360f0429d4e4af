/* The layout of texels, which is worked out by one function for all back ends. */
#include "texel_layout.h"

#include "../config/features.h"
#include "../formats/properties.h"
#include "extent.h"

/* Returns the last index, in bytes, from which a level has eight bytes. Where strides are negative
 * the first row or layer is the last one in memory. */
static int32_t last_eight(const texel_layout *layout, const texel_extent *extent)
{
    ptrdiff_t end = (ptrdiff_t)(extent->width * format_size(layout->format));

    if (layout->row_stride > 0)
        end += layout->row_stride * (ptrdiff_t)(extent->height - 1);
    if (layout->layer_stride > 0)
        end += layout->layer_stride * (ptrdiff_t)(extent->layers - 1);
    return (int32_t)(end - 8);
}

/* Whether texels of a layout may be loaded by indices: one to three bytes, or whole words. Where
 * the first element in memory is the high one, elements of less than a word are loaded one by one.
 */
static bool has_indices(pixel_layout layout)
{
    if (layout_bytes(layout) > 4 && layout_bytes(layout) % 4 != 0)
        return false;
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    return GN_SPECIALISED && layout != LAYOUT_SHORT_HIGH_FIRST;
#else
    return GN_SPECIALISED && layout_element(layout) == 4;
#endif
}

/* The strides of a checked texture do not overflow, because the whole level fits memory. Indices
 * count words if texels are whole words, otherwise bytes. Small builds load texels one by one. */
void gni_lay_out_texels(const gn_texture *texture, uint32_t level, texel_layout *out)
{
    const gn_texture_level *const l = &texture->level[level];
    const pixel_layout layout = format_layout(texture->format);
    const uint32_t size = layout_bytes(layout);
    const texel_extent extent = extent_of_level(texture, level);
    const size_t rows = l->row_stride < 0 ? 0 - (size_t)l->row_stride : (size_t)l->row_stride;
    const int shift = size % 4 == 0 ? 2 : 0;
    size_t layers = 0;

    out->texels = (const unsigned char *)l->texels;
    out->has_layers = extent.layers > 1;
    out->row_stride = l->row_stride;
    out->layer_stride = 0;
    if (out->has_layers) {
        out->layer_stride = l->layer_stride;
        layers = l->layer_stride < 0 ? 0 - (size_t)l->layer_stride : (size_t)l->layer_stride;
    }
    out->format = texture->format;

    const size_t bytes =
        rows * (extent.height - 1) + layers * (extent.layers - 1) + (size_t)extent.width * size;
    const bool is_aligned = ((uintptr_t)l->texels | rows | layers) % ((size_t)1 << shift) == 0;
    if (has_indices(layout) && is_aligned && bytes >> shift <= INT32_MAX) {
        out->indexed = layout;
        out->unit[0] = (int32_t)(size >> shift);
        out->unit[1] = (int32_t)(out->row_stride >> shift);
        out->unit[2] = (int32_t)(out->layer_stride >> shift);
        if (layout == LAYOUT_THREE_BYTES)
            out->last_eight = last_eight(out, &extent);
    } else {
        out->indexed = LAYOUT_NONE;
        out->unit[0] = out->unit[1] = out->unit[2] = 1;
    }
}
