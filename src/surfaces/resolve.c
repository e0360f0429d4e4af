/* Resolving several samples per pixel to one. */
#include "../backends/entry_points.h"
#include "../formats/properties.h"
#include "../formats/surface_memory.h"
#include "memory.h"

#if GN_HAVE_SAMPLES

/* Copies sample 0 unchanged. */
static void copy_rows(const gn_surface *to, const gn_surface *from)
{
    const size_t size = (size_t)to->width * format_size(to->format);

    for (uint32_t y = 0; y < to->height; ++y)
        copy_bytes(surface_row(to, y), surface_row(from, y), size);
}

/* Writes the means of the samples. */
static void average_rows(const gn_surface *to, const gn_surface *from)
{
    const gn_backend backend = backend_of_rows((size_t)GN_SAMPLES * to->width * to->height);
    row_work work;

    work.kind = ROW_AVERAGES;
    work.read = from->format;
    work.written = to->format;
    work.count = to->width;
    work.sample_stride = from->sample_stride;
    for (uint32_t y = 0; y < to->height; ++y) {
        work.from = surface_row(from, y);
        work.to = surface_row(to, y);
        rows_on(backend, &work);
    }
}

gn_status gn_resolve(const gn_surface *to, const gn_surface *from)
{
    gn_status status;

    if (!to || !from)
        return GN_NULL_POINTER;
    status = gni_check_any_surface(to);
    if (!status)
        status = gni_check_any_surface(from);
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
    average_rows(to, from);
    return GN_OK;
}

#else

gn_status gn_resolve(const gn_surface *to, const gn_surface *from)
{
    return !to || !from ? GN_NULL_POINTER : GN_NOT_COMPILED;
}

#endif
