/* Resolving several samples per pixel to one. */
#include "../formats/pixel_rows.h"
#include "check.h"

#if GN_HAVE_SAMPLES

/* Writes the means of the samples of sixteen pixels from x on. Beyond the end of the row a lane
 * repeats pixel x. */
static void average_row(const gn_surface *from, uint32_t x, uint32_t y, lanes_f color[4])
{
    const unsigned char *row[GN_LANES];
    int32_t column[GN_LANES];
    lanes_f one[4];

    for (int c = 0; c < 4; ++c)
        color[c] = lanes_splat(0.0f);
    GN_EACH_LANE (l)
        column[l] = (int32_t)(x + (uint32_t)l < from->width ? x + (uint32_t)l : x);
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        GN_EACH_LANE (l)
            row[l] = sample_memory(from, s) + (ptrdiff_t)y * from->row_stride;
        load_colors(from->format, row, column, one);
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_add(color[c], one[c]);
    }
    for (int c = 0; c < 4; ++c)
        color[c] = lanes_mul(color[c], lanes_splat(0.25f));
}

/* Copies sample 0 unchanged. */
static void copy_rows(const gn_surface *to, const gn_surface *from)
{
    const uint32_t size = to->width * format_size(to->format);

    for (uint32_t y = 0; y < to->height; ++y) {
        unsigned char *const out = surface_row(to, y);
        const unsigned char *const in = surface_row(from, y);

        for (uint32_t i = 0; i < size; ++i)
            out[i] = in[i];
    }
}

gn_status gn_resolve(const gn_surface *to, const gn_surface *from)
{
    lanes_f color[4];
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
    for (uint32_t y = 0; y < to->height; ++y) {
        for (uint32_t x = 0; x < to->width; x += GN_LANES) {
            average_row(from, x, y, color);
            store_colors(to, (int32_t)x, (int32_t)y,
                         to->width - x < GN_LANES ? to->width - x : GN_LANES, color);
        }
    }
    return GN_OK;
}

#else

gn_status gn_resolve(const gn_surface *to, const gn_surface *from)
{
    return !to || !from ? GN_NULL_POINTER : GN_NOT_COMPILED;
}

#endif
