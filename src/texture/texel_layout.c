/* The layout of texels and the texel of a border, which are there once for all back ends. */
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

/* The strides of a checked texture do not overflow, because the whole level fits memory. Small
 * builds load all texels one by one. */
void gni_lay_out_texels(const gn_texture *texture, uint32_t level, texel_layout *out)
{
    const gn_texture_level *const l = &texture->level[level];
    const texel_format *const format = &gni_texel_formats[texture->format];
    const texel_extent extent = extent_of_level(texture, level);
    const size_t rows = l->row_stride < 0 ? 0 - (size_t)l->row_stride : (size_t)l->row_stride;
    const int shift = format->index_shift;
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
        rows * (extent.height - 1) + layers * (extent.layers - 1) + extent.width * format->size;
    const bool is_aligned = ((uintptr_t)l->texels | rows | layers) % ((size_t)1 << shift) == 0;
    if (GN_SPECIALISED && is_aligned && bytes >> shift <= INT32_MAX &&
        format->access != ACCESS_ONE_BY_ONE) {
        out->access = (texel_access)format->access;
        out->unit[0] = format->size >> shift;
        out->unit[1] = (int32_t)(out->row_stride >> shift);
        out->unit[2] = (int32_t)(out->layer_stride >> shift);
        if (format->access == ACCESS_THREE_BYTES)
            out->last_eight = last_eight(out, &extent);
    } else {
        out->access = ACCESS_ONE_BY_ONE;
        out->unit[0] = out->unit[1] = out->unit[2] = 1;
    }
}

void gni_border_texel(const gn_sampler *sampler, gn_format format, float border[4])
{
    const texel_channel *const first = &gni_texel_formats[format].channel[0];
    const bool has_range = first->kind == CHANNEL_FRACTION || first->kind == CHANNEL_SRGB;
    const bool has_sign = !has_range && first->width >= 16;

    for (int c = 0; c < 4; ++c) {
        float value = sampler->border[c];

        if (has_range)
            value = value > 0.0f ? value < 1.0f ? value : 1.0f : 0.0f;
        else if (!has_sign)
            value = value > 0.0f ? value : 0.0f;
        border[c] = value;
    }
}
