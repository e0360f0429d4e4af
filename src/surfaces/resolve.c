/* Resolving several samples per pixel to one. */
#include "../formats/pixel_rows.h"
#include "../formats/surface_memory.h"
#include "check.h"
#include "copy.h"

#if GN_HAVE_SAMPLES

/* Writes the means of the samples of `count` pixels from x on, at most GN_LANES. */
static void average(const gn_surface *to, const gn_surface *from, uint32_t x, uint32_t y,
                    uint32_t count)
{
    const size_t offset = (size_t)x * format_size(from->format);
    lanes_f color[4], one[4];

    for (int c = 0; c < 4; ++c)
        color[c] = lanes_splat(0.0f);
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        const unsigned char *const row = sample_memory(from, s) + (ptrdiff_t)y * from->row_stride;

        gn_load_colors(from->format, row + offset, count, one);
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_add(color[c], one[c]);
    }
    for (int c = 0; c < 4; ++c)
        color[c] = lanes_mul(color[c], lanes_splat(0.25f));
    gn_store_colors(to->format, surface_row(to, y) + offset, count, color);
}

/* Copies sample 0 unchanged. */
static void copy_rows(const gn_surface *to, const gn_surface *from)
{
    const size_t size = (size_t)to->width * format_size(to->format);

    for (uint32_t y = 0; y < to->height; ++y)
        copy_bytes(surface_row(to, y), surface_row(from, y), size);
}

gn_status gn_resolve(const gn_surface *to, const gn_surface *from)
{
    gn_status status;

    if (!to || !from)
        return GN_NULL_POINTER;
    status = gn_check_any_surface(to);
    if (!status)
        status = gn_check_any_surface(from);
    if (status)
        return status;
    if (samples_of(to) > 1)
        return GN_INVALID_SAMPLES;
    if (to->format != from->format)
        return GN_INVALID_FORMAT;
    if (to->width != from->width || to->height != from->height)
        return GN_SIZE_MISMATCH;
    if (samples_of(from) == 1 || !format_is_color(to->format)) {
        copy_rows(to, from);
        return GN_OK;
    }
    for (uint32_t y = 0; y < to->height; ++y)
        for (uint32_t x = 0; x < to->width; x += GN_LANES)
            average(to, from, x, y, to->width - x < GN_LANES ? to->width - x : GN_LANES);
    return GN_OK;
}

#else

gn_status gn_resolve(const gn_surface *to, const gn_surface *from)
{
    return !to || !from ? GN_NULL_POINTER : GN_NOT_COMPILED;
}

#endif
