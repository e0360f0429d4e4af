/* Blits: checks of the arguments, the choice of each pixel's texel, and the conversion of formats,
 * sixteen pixels of a row at a time. */
#include <gnomon/blit.h>

#include "../formats/pixel_rows.h"
#include "../raster/scissor.h"
#include "blit_cut.h"
#include "blit_quad.h"
#include "check.h"
#include "reduce.h"

typedef struct blit {
    const gn_surface *destination, *source;
    int dimensions;         /* in which texels are mixed: 1 to 3 */
    const gn_surface *next; /* with 3 dimensions, a second source; see between */
    float between;
    bool mixes;          /* the filter is linear */
    bool copies;         /* pixels keep their bits */
    uint32_t written[2]; /* bits that are copied of a pixel's words (32-bit formats and depth) */
} blit;

/* The texels of sixteen pixels: columns and rows, two of each if texels are mixed. */
typedef struct blit_texels {
    int32_t column[2][GN_LANES], row[2][GN_LANES];
    float weight[2][GN_LANES];
} blit_texels;

static bool is_in_range(const gn_rectangle *r)
{
    const int32_t limit = GN_MAX_SIZE;

    return r->x0 >= -limit && r->x0 <= limit && r->y0 >= -limit && r->y0 <= limit &&
           r->x1 >= -limit && r->x1 <= limit && r->y1 >= -limit && r->y1 <= limit;
}

static gn_rectangle whole(const gn_surface *surface)
{
    gn_rectangle r;

    r.x0 = 0;
    r.y0 = 0;
    r.x1 = (int32_t)surface->width;
    r.y1 = (int32_t)surface->height;
    return r;
}

/* Returns the rectangle with corner 0 below and left of corner 1. */
static gn_rectangle upright(const gn_rectangle *r)
{
    gn_rectangle u;

    u.x0 = r->x0 < r->x1 ? r->x0 : r->x1;
    u.y0 = r->y0 < r->y1 ? r->y0 : r->y1;
    u.x1 = r->x0 < r->x1 ? r->x1 : r->x0;
    u.y1 = r->y0 < r->y1 ? r->y1 : r->y0;
    return u;
}

/* Returns the intersection of two upright rectangles. If it is empty, corner 1 is not above and
 * right of corner 0. */
static gn_rectangle intersection(const gn_rectangle *a, const gn_rectangle *b)
{
    gn_rectangle r;

    r.x0 = a->x0 > b->x0 ? a->x0 : b->x0;
    r.y0 = a->y0 > b->y0 ? a->y0 : b->y0;
    r.x1 = a->x1 < b->x1 ? a->x1 : b->x1;
    r.y1 = a->y1 < b->y1 ? a->y1 : b->y1;
    return r;
}

static bool is_empty(const gn_rectangle *r)
{
    return r->x0 >= r->x1 || r->y0 >= r->y1;
}

/* Returns the part of the destination that the scissor leaves. */
static gn_rectangle scissored(const gn_surface *destination, const gn_scissor *scissor)
{
    const pixel_rectangle part = scissored_target(scissor, destination->width, destination->height);
    gn_rectangle r;

    r.x0 = part.min_x;
    r.y0 = part.min_y;
    r.x1 = part.max_x + 1;
    r.y1 = part.max_y + 1;
    return r;
}

/* Writes the first and the last byte's address of a rectangle's pixels. Precondition: the rectangle
 * is not empty. */
static void address_range(const gn_surface *surface, const gn_rectangle *r, uintptr_t range[2])
{
    const uint32_t size = format_size(surface->format);
    const bool down = surface->row_stride < 0;
    const uint32_t lowest = (uint32_t)(down ? r->y1 - 1 : r->y0);
    const uint32_t highest = (uint32_t)(down ? r->y0 : r->y1 - 1);

    range[0] = (uintptr_t)surface_row(surface, lowest) + (uintptr_t)r->x0 * size;
    range[1] = (uintptr_t)surface_row(surface, highest) + (uintptr_t)r->x1 * size - 1;
}

/* Returns whether a pixel that is read may be a pixel that is written. */
static bool overlap(const blit *b, const gn_rectangle *to, const gn_rectangle *from)
{
    const gn_rectangle destination = whole(b->destination);
    const gn_rectangle source = whole(b->source);
    gn_rectangle read = upright(from);
    gn_rectangle written = upright(to);
    uintptr_t reads[2], writes[2];

    if (b->mixes) {
        --read.x0;
        --read.y0;
        ++read.x1;
        ++read.y1;
    }
    read = intersection(&read, &source);
    written = intersection(&written, &destination);
    if (is_empty(&read) || is_empty(&written))
        return false;
    if (b->destination->pixels == b->source->pixels &&
        b->destination->row_stride == b->source->row_stride &&
        b->destination->format == b->source->format) {
        const gn_rectangle both = intersection(&read, &written);
        return !is_empty(&both);
    }
    address_range(b->source, &read, reads);
    address_range(b->destination, &written, writes);
    return reads[0] <= writes[1] && writes[0] <= reads[1];
}

static void copy_word(stored_word *to, int32_t from, uint32_t bits)
{
    *to = (int32_t)(((uint32_t)*to & ~bits) | ((uint32_t)from & bits));
}

/* Copies one pixel's bits from a row to another. */
static void copy_pixel(const blit *b, unsigned char *to, int32_t x, const unsigned char *from,
                       int32_t column)
{
    stored_half *const halves = (stored_half *)(void *)to;
    const stored_half *const from_halves = (const stored_half *)(const void *)from;
    stored_word *const words = (stored_word *)(void *)to;
    const stored_word *const from_words = (const stored_word *)(const void *)from;
    const pixel_layout layout = format_layout(b->source->format);
    const int size = (int)format_size(b->source->format);

    switch (layout) {
    case GN_LAYOUT(2, 2):
        halves[x] = from_halves[column];
        break;
    case GN_LAYOUT(4, 4):
        copy_word(&words[x], from_words[column], b->written[0]);
        break;
    case GN_LAYOUT(8, 2):
        for (int c = 0; c < 4; ++c)
            halves[4 * x + c] = from_halves[4 * column + c];
        break;
    case GN_LAYOUT(8, 4):
        copy_word(&words[2 * x], from_words[2 * column], b->written[0]);
        copy_word(&words[2 * x + 1], from_words[2 * column + 1], b->written[1]);
        break;
    case GN_LAYOUT(16, 4):
        for (int c = 0; c < 4; ++c)
            words[4 * x + c] = from_words[4 * column + c];
        break;
    default:
        for (int c = 0; c < size; ++c)
            to[size * x + c] = from[size * column + c];
        break;
    }
}

/* Loads the texels at each lane's first or second column (`right`) and row (`above`). */
static void fetch_texels(const gn_surface *source, const blit_texels *t, int right, int above,
                         lanes_f color[4])
{
    const unsigned char *row[GN_LANES];

    GN_EACH_LANE (l)
        row[l] = surface_row(source, (uint32_t)t->row[above][l]);
    load_colors(source->format, row, t->column[right], color);
}

static lanes_f mix_texels(lanes_f weight, lanes_f a, lanes_f b)
{
    return lanes_add(a, lanes_mul(weight, lanes_sub(b, a)));
}

/* Mixes the texels of two columns and, in more than one dimension, of two rows. */
static void mix_source(const gn_surface *source, int dimensions, const blit_texels *t,
                       lanes_f color[4])
{
    const lanes_f along_x = lanes_load(t->weight[0]);
    const lanes_f along_y = lanes_load(t->weight[1]);
    lanes_f right[4], above[4];

    fetch_texels(source, t, 0, 0, color);
    fetch_texels(source, t, 1, 0, right);
    for (int c = 0; c < 4; ++c)
        color[c] = mix_texels(along_x, color[c], right[c]);
    if (dimensions == 1)
        return;
    fetch_texels(source, t, 0, 1, above);
    fetch_texels(source, t, 1, 1, right);
    for (int c = 0; c < 4; ++c)
        color[c] = mix_texels(along_y, color[c], mix_texels(along_x, above[c], right[c]));
}

/* Mixes everything that contributes to a pixel. */
static void mix_sources(const blit *b, const blit_texels *t, lanes_f color[4])
{
    lanes_f second[4];

    mix_source(b->source, b->dimensions, t, color);
    if (b->dimensions == 3) {
        mix_source(b->next, b->dimensions, t, second);
        for (int c = 0; c < 4; ++c)
            color[c] = mix_texels(lanes_splat(b->between), color[c], second[c]);
    }
}

/* Writes pixels x to x + count - 1 of row y. */
static void write_run(const blit *b, int32_t x, int32_t y, uint32_t count, const blit_texels *t)
{
    lanes_f color[4];

    if (b->copies) {
        for (uint32_t l = 0; l < count; ++l)
            copy_pixel(b, surface_row(b->destination, (uint32_t)y), x + (int32_t)l,
                       surface_row(b->source, (uint32_t)t->row[0][l]), t->column[0][l]);
        return;
    }
    if (b->mixes)
        mix_sources(b, t, color);
    else
        fetch_texels(b->source, t, 0, 0, color);
    store_colors(b->destination, x, y, count, color);
}

/* Finds the texels of a lane along a dimension, from a coordinate from 0 to 1. */
static void find_texel(float coordinate, uint32_t size, bool mixes, int l,
                       int32_t texel[2][GN_LANES], float weight[GN_LANES])
{
    const float n = (float)size;
    const int32_t last = (int32_t)size - 1;
    float c = coordinate * n;

    c = c < n ? c : n;
    if (mixes)
        c -= 0.5f;
    c = c > 0.0f ? c : 0.0f;

    const int32_t whole = (int32_t)c;
    texel[0][l] = whole < last ? whole : last;
    texel[1][l] = whole < last ? whole + 1 : last;
    weight[l] = c - (float)whole;
}

static void blit_piece_row(const blit *b, const blit_piece *p, int32_t y, int32_t first,
                           int32_t end)
{
    const uint32_t size[2] = {b->source->width, b->source->height};
    blit_texels t;

    for (int32_t x = first; x < end; x += GN_LANES) {
        GN_EACH_LANE (l) {
            for (int n = 0; n < 2; ++n) {
                const float coordinate = p->plane[n].per_y * (float)y +
                                         (p->plane[n].per_x * (float)(x + l) + p->plane[n].origin);

                find_texel(coordinate, size[n], b->mixes, l, n == 0 ? t.column : t.row,
                           t.weight[n]);
            }
        }
        write_run(b, x, y, (uint32_t)(end - x < GN_LANES ? end - x : GN_LANES), &t);
    }
}

static void blit_scaled(const blit *b, const gn_rectangle *to, const gn_rectangle *from,
                        const gn_rectangle *drawn)
{
    blit_quad quad;

    set_blit_quad(&quad, b->destination, to, b->source, from);
    for (uint32_t n = 0; n < quad.count; ++n) {
        for (int32_t y = drawn->y0; y < drawn->y1; ++y) {
            int32_t first = drawn->x0;
            int32_t end = drawn->x1;

            blit_columns(&quad.piece[n], y, &first, &end);
            blit_piece_row(b, &quad.piece[n], y, first, end);
        }
    }
}

/* Returns the texel of a pixel along one dimension, for rectangles of equal size of which `to` is
 * not mirrored. For lanes beyond the surface it is clamped to the surface. */
static int32_t moved_texel(int32_t pixel, int32_t to, int32_t from0, int32_t from1, uint32_t size)
{
    const int32_t texel = from0 <= from1 ? from0 + (pixel - to) : from0 - 1 - (pixel - to);

    return texel < 0 ? 0 : texel >= (int32_t)size ? (int32_t)size - 1 : texel;
}

static void blit_moved(const blit *b, const gn_rectangle *to, const gn_rectangle *from,
                       const gn_rectangle *drawn)
{
    blit_texels t;

    for (int32_t y = drawn->y0; y < drawn->y1; ++y) {
        const int32_t row = moved_texel(y, to->y0, from->y0, from->y1, b->source->height);

        for (int32_t x = drawn->x0; x < drawn->x1; x += GN_LANES) {
            GN_EACH_LANE (l) {
                t.column[0][l] = moved_texel(x + l, to->x0, from->x0, from->x1, b->source->width);
                t.row[0][l] = row;
            }
            write_run(b, x, y, (uint32_t)(drawn->x1 - x < GN_LANES ? drawn->x1 - x : GN_LANES), &t);
        }
    }
}

static int32_t length_of(int32_t first, int32_t last)
{
    return first < last ? last - first : first - last;
}

/* Cuts the rectangles, exchanges corners so that `to` is not mirrored, and blits. */
static void blit_checked(blit *b, gn_rectangle to, gn_rectangle from, const gn_scissor *scissor)
{
    const gn_rectangle bounds = scissored(b->destination, scissor);
    blit_range x = {to.x0, to.x1}, y = {to.y0, to.y1};
    blit_range from_x = {from.x0, from.x1}, from_y = {from.y0, from.y1};
    gn_rectangle drawn;

    if (!cut_ranges(&x, &from_x, bounds.x0, bounds.x1, (int32_t)b->source->width) ||
        !cut_ranges(&y, &from_y, bounds.y0, bounds.y1, (int32_t)b->source->height))
        return;
    drawn.x0 = x.first;
    drawn.y0 = y.first;
    drawn.x1 = x.last;
    drawn.y1 = y.last;
    drawn = upright(&drawn);

    if (to.x0 > to.x1) {
        const int32_t swap = from.x0;
        from.x0 = from.x1;
        from.x1 = swap;
    }
    if (to.y0 > to.y1) {
        const int32_t swap = from.y0;
        from.y0 = from.y1;
        from.y1 = swap;
    }
    to = upright(&to);

    const bool is_scaled = to.x1 - to.x0 != length_of(from.x0, from.x1) ||
                           to.y1 - to.y0 != length_of(from.y0, from.y1);
    b->mixes = b->mixes && is_scaled;
    b->copies = b->destination->format == b->source->format && !b->mixes;
    if (is_scaled)
        blit_scaled(b, &to, &from, &drawn);
    else
        blit_moved(b, &to, &from, &drawn);
}

/* Sets the bits of depth and stencil that are written. */
static void set_written(blit *b, const gn_blit_options *options)
{
    const gn_format format = b->source->format;

    b->written[0] = 0xFFFFFFFFu;
    b->written[1] = 255u;
    if (format == GN_FORMAT_D24S8)
        b->written[0] =
            (options->keeps_depth ? 0 : 0x00FFFFFFu) | (options->keeps_stencil ? 0 : 0xFF000000u);
    else if (format == GN_FORMAT_D32FS8 && options->keeps_depth)
        b->written[0] = 0;
    if (options->keeps_stencil)
        b->written[1] = 0;
}

/* Returns whether the destination keeps everything that the format has. */
static bool keeps_all(gn_format format, const gn_blit_options *options)
{
    if (format_is_color(format))
        return false;
    return (options->keeps_depth || !format_has_depth(format)) &&
           (options->keeps_stencil || !format_has_stencil(format));
}

void gn_reduce(const gn_surface *destination, int dimensions, const gn_surface *source,
               const gn_surface *next, float between)
{
    const gn_rectangle to = whole(destination);
    const gn_rectangle from = whole(source);
    blit b;

    b.destination = destination;
    b.source = source;
    b.dimensions = dimensions;
    b.next = next;
    b.between = between;
    b.mixes = true;
    b.copies = false;
    b.written[0] = 0;
    b.written[1] = 0;
    blit_scaled(&b, &to, &from, &to);
}

gn_status gn_blit(const gn_surface *destination, const gn_rectangle *to, const gn_surface *source,
                  const gn_rectangle *from, const gn_blit_options *options)
{
    gn_blit_options defaults;
    gn_rectangle to_all, from_all;
    gn_status status;
    blit b;

    if (!destination || !source)
        return GN_NULL_POINTER;
    defaults.filter = GN_BLIT_NEAREST;
    defaults.scissor.set = false;
    defaults.keeps_depth = false;
    defaults.keeps_stencil = false;
    if (!options)
        options = &defaults;
    if ((unsigned)options->filter > GN_BLIT_LINEAR)
        return GN_INVALID_ENUM;
    status = gn_check_any_surface(destination);
    if (status)
        return status;
    status = gn_check_any_surface(source);
    if (status)
        return status;
    if (samples_of(destination) > 1 || samples_of(source) > 1)
        return GN_INVALID_SAMPLES;

    const bool colors = format_is_color(source->format);
    if (colors ? !format_is_color(destination->format)
               : destination->format != source->format || options->filter == GN_BLIT_LINEAR)
        return GN_INVALID_FORMAT;

    to_all = whole(destination);
    from_all = whole(source);
    if (!to)
        to = &to_all;
    if (!from)
        from = &from_all;
    if (!is_in_range(to) || !is_in_range(from))
        return GN_OUT_OF_RANGE;

    b.destination = destination;
    b.source = source;
    b.dimensions = 2;
    b.next = 0;
    b.between = 0.0f;
    b.mixes = options->filter == GN_BLIT_LINEAR;
    b.copies = false;
    if (overlap(&b, to, from))
        return GN_OVERLAP;
    set_written(&b, options);
    if (!keeps_all(source->format, options))
        blit_checked(&b, *to, *from, &options->scissor);
    return GN_OK;
}
