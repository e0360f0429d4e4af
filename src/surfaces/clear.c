/* Clears. */
#include <gnomon/surface.h>

#include "../formats/cleared.h"
#include "../formats/surface_faults.h"
#include "memory.h"

/* A surface's memory in pieces without gaps: one piece from the lowest address on if rows are
 * tightly packed, otherwise one piece per row. */
typedef struct surface_pieces {
    unsigned char *first;
    ptrdiff_t stride;
    uint32_t count;
    size_t size; /* bytes */
} surface_pieces;

static surface_pieces pieces_of(const gn_surface *surface)
{
    const size_t row = surface->width * gn_format_size(surface->format);
    const bool down = surface->row_stride < 0;
    surface_pieces s;

    s.first = surface_row(surface, 0);
    s.stride = surface->row_stride;
    s.count = surface->height;
    s.size = row;
    if (s.stride == (ptrdiff_t)row || s.stride == -(ptrdiff_t)row) {
        s.first = surface_row(surface, down ? surface->height - 1 : 0);
        s.count = 1;
        s.size = row * surface->height;
    }
    return s;
}

/* Fills one sample of a surface with a pixel. */
static void fill_surface(const gn_surface *surface, const int32_t word[4])
{
    const pixel_layout layout = format_layout(surface->format);
    const surface_pieces pieces = pieces_of(surface);
    pixel_bytes pixel;

    store_pixel(pixel.byte, 0, layout, word);
    for (uint32_t i = 0; i < pieces.count; ++i)
        fill_pixels(pieces.first + (ptrdiff_t)i * pieces.stride, pieces.size, &pixel,
                    layout_bytes(layout));
}

/* Fills one sample of a surface whose pixels are words, in the bits of a mask. Pixels of one, two
 * or four words repeat every four words: compilers make one vector of these. */
static void fill_bits(const gn_surface *surface, const int32_t word[4], const int32_t written[4])
{
    const surface_pieces pieces = pieces_of(surface);
    const size_t count = format_size(surface->format) / 4;
    const size_t words = pieces.size / 4;
    int32_t set[4], kept[4];

    for (size_t n = 0; n < 4; ++n) {
        set[n] = word[n % count] & written[n % count];
        kept[n] = ~written[n % count];
    }
    for (uint32_t i = 0; i < pieces.count; ++i) {
        stored_word *const to =
            (stored_word *)(void *)(pieces.first + (ptrdiff_t)i * pieces.stride);
        size_t n = 0;

        for (; n + 4 <= words; n += 4)
            for (size_t c = 0; c < 4; ++c)
                to[n + c] = (to[n + c] & kept[c]) | set[c];
        for (; n < words; ++n)
            to[n] = (to[n] & kept[n % 4]) | set[n % 4];
    }
}

gn_status gn_clear_color(const gn_surface *surface, float red, float green, float blue, float alpha)
{
    const float channel[4] = {red, green, blue, alpha};
    int32_t word[4];

    if (!surface)
        return GN_NULL_POINTER;

    const gn_status status = fault_of_surface(surface, format_is_color(surface->format), 0);
    if (status)
        return status;
    if (!GN_HAVE_FORMATS && !format_is_basic(surface->format))
        return GN_NOT_COMPILED;
    encode_cleared_color(surface->format, channel, word);
    for (uint32_t n = 0; n < (GN_HAVE_SAMPLES ? samples_of(surface) : 1); ++n) {
        const gn_surface sample = gn_surface_sample(surface, n);

        fill_surface(&sample, word);
    }
    return GN_OK;
}

/* Clears depth, stencil or both, of which the surface must have one. Where both share no word, the
 * bits beside stencil become 0. */
static gn_status clear_depth_stencil(const gn_surface *surface, bool clears_depth, float depth,
                                     bool clears_stencil, uint8_t stencil)
{
    int32_t word[4], written[4];

    if (!surface)
        return GN_NULL_POINTER;

    const gn_format format = surface->format;
    const bool has_depth = format_has_depth(format), has_stencil = format_has_stencil(format);
    const gn_status status = fault_of_surface(
        surface, (clears_depth && has_depth) || (clears_stencil && has_stencil), 0);
    if (status)
        return status;
    if (!GN_HAVE_STENCIL && has_stencil)
        return GN_NOT_COMPILED;
    encode_cleared_depth(format, depth, stencil, word);
    written[0] = written[1] = written[2] = written[3] = 0;
    if (format == GN_FORMAT_D24S8)
        add_channel_bits(format, clears_depth ? 0 : 1, written);
    else
        written[clears_depth ? 0 : 1] = -1;

    const bool clears_all = (clears_depth || !has_depth) && (clears_stencil || !has_stencil);
    for (uint32_t n = 0; n < (GN_HAVE_SAMPLES ? samples_of(surface) : 1); ++n) {
        const gn_surface sample = gn_surface_sample(surface, n);

        if (!GN_HAVE_STENCIL || clears_all)
            fill_surface(&sample, word);
        else
            fill_bits(&sample, word, written);
    }
    return GN_OK;
}

gn_status gn_clear_depth(const gn_surface *surface, float depth)
{
    return clear_depth_stencil(surface, true, depth, false, 0);
}

gn_status gn_clear_stencil(const gn_surface *surface, uint8_t stencil)
{
    return clear_depth_stencil(surface, false, 0.0f, true, stencil);
}

gn_status gn_clear_depth_stencil(const gn_surface *surface, float depth, uint8_t stencil)
{
    return clear_depth_stencil(surface, true, depth, true, stencil);
}
