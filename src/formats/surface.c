/* Surfaces and targets: construction and validation. */
#include "surface_faults.h"

size_t gn_format_size(gn_format format)
{
    return format_size(format);
}

gn_surface gn_surface_bottom_up(void *memory, gn_format format, uint32_t width, uint32_t height)
{
    gn_surface s;

    s.pixels = memory;
    s.row_stride = (ptrdiff_t)(width * gn_format_size(format));
    s.width = width;
    s.height = height;
    s.format = format;
    s.samples = 0;
    s.sample_stride = 0;
    return s;
}

gn_surface gn_surface_top_down(void *memory, gn_format format, uint32_t width, uint32_t height)
{
    gn_surface s = gn_surface_bottom_up(memory, format, width, height);

    if (memory && height > 0 && height <= GN_MAX_SIZE && width <= GN_MAX_SIZE)
        s.pixels = address_of(memory, height - 1, s.row_stride);
    s.row_stride = -s.row_stride;
    return s;
}

gn_surface gn_surface_rows(const gn_surface *surface, uint32_t first, uint32_t count)
{
    gn_surface s = gn_surface_bottom_up(0, GN_FORMAT_NONE, 0, 0);

    if (surface && surface->pixels && count > 0 && first < surface->height &&
        count <= surface->height - first) {
        s = *surface;
        s.pixels = surface_row(surface, first);
        s.height = count;
    }
    return s;
}

gn_surface gn_surface_multisampled(const gn_surface *image)
{
    gn_surface s = gn_surface_bottom_up(0, GN_FORMAT_NONE, 0, 0);

    if (image) {
        s = *image;

        /* The stride of a single row does not matter, and may be shorter than the row. */
        const size_t row = (size_t)image->width * format_size(image->format);
        const size_t given = stride_length(image->row_stride);
        const size_t stride = image->height == 1 && given < row ? row : given;
        const bool fits = image->height > 0 && stride <= (size_t)PTRDIFF_MAX / image->height;

        /* If the images do not fit memory, gn_target_check finds the fault. */
        s.samples = GN_SAMPLES;
        s.sample_stride = fits ? (ptrdiff_t)(stride * image->height) : PTRDIFF_MAX - 15;
    }
    return s;
}

gn_surface gn_surface_sample(const gn_surface *surface, uint32_t sample)
{
    gn_surface s = gn_surface_bottom_up(0, GN_FORMAT_NONE, 0, 0);

    if (surface && surface->pixels && sample < samples_of(surface)) {
        s = *surface;
        s.pixels = sample_memory(surface, sample);
        s.samples = 0;
        s.sample_stride = 0;
    }
    return s;
}

gn_status gni_check_any_surface(const gn_surface *surface)
{
    return fault_of_surface(surface, gn_format_size(surface->format) > 0, 0);
}

gn_status gn_target_check(const gn_target *target)
{
    return fault_of_target(target);
}
