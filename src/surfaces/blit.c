/* Blits: checks of the arguments, the choice of each pixel's texel, and the conversion of formats,
 * GN_LANES pixels of a row at a time. */
#include <gnomon/blit.h>

#include "../backends/entry_points.h"
#include "../formats/pixel_rows.h"
#include "../formats/surface_memory.h"
#include "../kernel/raster/scissor.h"
#include "blit_cut.h"
#include "blit_layer.h"
#include "blit_triangles.h"
#include "memory.h"

typedef struct blit {
    const gn_surface *destination, *source;
    int dimensions;         /* that texels are mixed in: 1 to 3 */
    const gn_surface *next; /* with 3 dimensions, a second source, and its weight */
    float next_weight;
    bool is_linear;      /* the filter */
    gn_backend backend;  /* see backend_of_rows */
    bool keeps_bits;     /* pixels are copied, not converted */
    bool has_mask;       /* only the bits `written` of depth and stencil are copied */
    uint32_t written[2]; /* the bits of even and of odd words */
} blit;

static bool is_in_range(const gn_rectangle *r)
{
    const int32_t limit = GN_MAX_SIZE;

    return r->x0 >= -limit && r->x0 <= limit && r->y0 >= -limit && r->y0 <= limit &&
           r->x1 >= -limit && r->x1 <= limit && r->y1 >= -limit && r->y1 <= limit;
}

static gn_rectangle whole_surface(const gn_surface *surface)
{
    const gn_rectangle r = {0, 0, (int32_t)surface->width, (int32_t)surface->height};

    return r;
}

/* Returns the rectangle with corner 0 below and left of corner 1. */
static gn_rectangle upright(const gn_rectangle *r)
{
    const gn_rectangle u = {r->x0 < r->x1 ? r->x0 : r->x1, r->y0 < r->y1 ? r->y0 : r->y1,
                            r->x0 < r->x1 ? r->x1 : r->x0, r->y0 < r->y1 ? r->y1 : r->y0};

    return u;
}

/* Returns the intersection of two upright rectangles. If it is empty, corner 1 is not above and
 * right of corner 0. */
static gn_rectangle intersection(const gn_rectangle *a, const gn_rectangle *b)
{
    const gn_rectangle r = {a->x0 > b->x0 ? a->x0 : b->x0, a->y0 > b->y0 ? a->y0 : b->y0,
                            a->x1 < b->x1 ? a->x1 : b->x1, a->y1 < b->y1 ? a->y1 : b->y1};

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
    const gn_rectangle r = {part.min_x, part.min_y, part.max_x + 1, part.max_y + 1};

    return r;
}

/* Writes the addresses of the first and the last byte of a rectangle's pixels. Precondition: the
 * rectangle is not empty. */
static void rectangle_addresses(const gn_surface *surface, const gn_rectangle *r,
                                uintptr_t range[2])
{
    const uint32_t size = format_size(surface->format);
    const bool down = surface->row_stride < 0;
    const uint32_t lowest = (uint32_t)(down ? r->y1 - 1 : r->y0);
    const uint32_t highest = (uint32_t)(down ? r->y0 : r->y1 - 1);

    range[0] = (uintptr_t)surface_row(surface, lowest) + (uintptr_t)r->x0 * size;
    range[1] = (uintptr_t)surface_row(surface, highest) + (uintptr_t)r->x1 * size - 1;
}

/* Returns whether the stride is at least a row. The stride of a single row may be anything. */
static bool stride_holds_row(const gn_surface *surface)
{
    return stride_length(surface->row_stride) >=
           (size_t)surface->width * format_size(surface->format);
}

static int32_t length_of(int32_t first, int32_t last)
{
    return first < last ? last - first : first - last;
}

/* Returns whether `from` is narrower or lower than `to`. */
static bool enlarges(const gn_rectangle *to, const gn_rectangle *from)
{
    return length_of(to->x0, to->x1) > length_of(from->x0, from->x1) ||
           length_of(to->y0, to->y1) > length_of(from->y0, from->y1);
}

/* Returns whether a pixel that is read may be a pixel that is written. */
static bool overlap(const blit *b, const gn_rectangle *to, const gn_rectangle *from)
{
    const gn_rectangle destination = whole_surface(b->destination);
    const gn_rectangle source = whole_surface(b->source);
    gn_rectangle read = upright(from);
    gn_rectangle written = upright(to);
    uintptr_t reads[2], writes[2];

    if (is_empty(&read))
        return false;
    /* Texels beside the rectangle are mixed in. Without a filter the coordinate of a pixel near the
     * side of a much enlarged texel may round to the next texel. */
    if (b->is_linear || enlarges(to, from)) {
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
        b->destination->format == b->source->format && stride_holds_row(b->destination) &&
        stride_holds_row(b->source)) {
        const gn_rectangle both = intersection(&read, &written);
        return !is_empty(&both);
    }
    rectangle_addresses(b->source, &read, reads);
    rectangle_addresses(b->destination, &written, writes);
    return reads[0] <= writes[1] && writes[0] <= reads[1];
}

static void copy_word(stored_word *to, int32_t from, uint32_t bits)
{
    *to = (int32_t)(((uint32_t)*to & ~bits) | ((uint32_t)from & bits));
}

/* Copies `count` pixels, each from a row and column of its own. */
static void copy_texels(const blit *b, unsigned char *to, uint32_t count,
                        const ptrdiff_t row[GN_LANES], const int32_t column[GN_LANES])
{
    const unsigned char *const pixels = (const unsigned char *)b->source->pixels;
    const pixel_layout layout = format_layout(b->source->format);

#define COPY(constant)                                                                             \
    for (uint32_t l = 0; l < count; ++l) {                                                         \
        int32_t pixel[4];                                                                          \
                                                                                                   \
        load_pixel(pixels + row[l] + column[l], 0, constant, pixel);                               \
        store_pixel(to, (int32_t)l, constant, pixel);                                              \
    }
    if (b->has_mask) {
        const uint32_t words = format_size(b->source->format) / 4;

        for (uint32_t i = 0; i < count * words; ++i) {
            const unsigned char *const from = pixels + row[i / words] + column[i / words];

            copy_word((stored_word *)(void *)to + i,
                      ((const stored_word *)(const void *)from)[i % words], b->written[i % 2]);
        }
        return;
    }
    GN_EACH_COLOR_LAYOUT(layout, COPY)
#undef COPY
}

/* Copies `count` pixels of a row. */
static void copy_row(const blit *b, unsigned char *to, const unsigned char *from, uint32_t count)
{
    const uint32_t size = count * format_size(b->source->format);

    if (!b->has_mask) {
        copy_bytes(to, from, size);
        return;
    }
    for (uint32_t i = 0; i < size / 4; ++i)
        copy_word((stored_word *)(void *)to + i, ((const stored_word *)(const void *)from)[i],
                  b->written[i % 2]);
}

/* Fills in what all rows of a blit share. */
static void set_row_work(const blit *b, row_work *w)
{
    w->kind = b->is_linear ? ROW_MIXES : ROW_GATHERS;
    w->read = b->source->format;
    w->written = b->destination->format;
    w->from = (const unsigned char *)b->source->pixels;
    w->dimensions = b->dimensions;
    w->next = b->next ? (const unsigned char *)b->next->pixels : 0;
    w->next_weight = b->next_weight;
}

/* Writes `count` pixels from the texels in `columns` and `rows`: at most GN_LANES, unless all
 * texels are in one row. `first` is the first pixel's index in `columns`. */
static void write_texels(const blit *b, unsigned char *to, uint32_t count,
                         const texel_columns *columns, uint32_t first, const texel_rows *rows)
{
    row_work w;

    if (b->keeps_bits) {
        for (uint32_t x = 0; x < count; x += GN_LANES)
            copy_texels(b, to + x * format_size(b->destination->format),
                        count - x < GN_LANES ? count - x : GN_LANES, rows->offset[0],
                        columns->offset[0] + first + x);
        return;
    }
    set_row_work(b, &w);
    w.to = to;
    w.count = count;
    w.columns = columns;
    w.first = first;
    w.rows = rows;
    rows_on(b->backend, &w);
}

/* Returns texture coordinate `n`, from 0 to 1, of the pixels from (x, y) on. */
static lanes_f coordinates(const blit_triangle *p, int n, int32_t x, int32_t y)
{
    int32_t column[GN_LANES];

    GN_EACH_LANE (l)
        column[l] = x + l;
    return lanes_add(
        lanes_splat(p->plane[n].per_y * (float)y),
        lanes_add(lanes_mul(lanes_splat(p->plane[n].per_x), lanes_to_float(lanes_i_load(column))),
                  lanes_splat(p->plane[n].origin)));
}

/* Finds the texels along a dimension of `size` texels. Returns the weight of the second. */
static lanes_f find_texels(const blit *b, lanes_f coordinate, uint32_t size, lanes_i texel[2])
{
    const lanes_f n = lanes_splat((float)size);
    const lanes_f zero = lanes_splat(0.0f);
    const lanes_i last = lanes_i_splat((int32_t)size - 1);
    lanes_f c = lanes_mul(coordinate, n);

    c = lanes_select(lanes_greater(n, c), c, n);
    if (b->is_linear)
        c = lanes_sub(c, lanes_splat(0.5f));
    c = lanes_select(lanes_greater(c, zero), c, zero);

    const lanes_i whole = lanes_truncate(c);
    texel[0] = lanes_i_min(whole, last);
    texel[1] = lanes_i_min(lanes_i_add(whole, lanes_i_splat(1)), last);
    return lanes_sub(c, lanes_to_float(whole));
}

/* Finds the texels of `count` columns from x on. */
static void find_columns(const blit *b, const blit_triangle *p, int32_t x, int32_t y,
                         uint32_t count, texel_columns *columns)
{
    const int32_t bytes = (int32_t)format_size(b->source->format);
    const lanes_i size = lanes_i_splat(bytes);
    lanes_i texel[2];

    for (int32_t i = 0; i < (int32_t)count + GN_LANES; i += GN_LANES) {
        lanes_store(columns->weight + i,
                    find_texels(b, coordinates(p, 0, x + i, y), b->source->width, texel));
        for (int n = 0; n < 2; ++n)
            lanes_i_store(columns->offset[n] + i, lanes_i_mul(texel[n], size));
    }
    columns->side_by_side = count;
    for (uint32_t i = 0; i < count; ++i)
        if (columns->offset[0][i] != columns->offset[0][0] + 2 * (int32_t)i * bytes ||
            columns->offset[1][i] != columns->offset[0][i] + bytes)
            columns->side_by_side = 0;
}

/* Finds the rows of the texels of the pixels from (x, y) on. */
static void find_rows(const blit *b, const blit_triangle *p, int32_t x, int32_t y, texel_rows *rows)
{
    lanes_i texel[2];
    int32_t row[GN_LANES];

    rows->is_one = p->plane[1].per_x == 0.0f;
    lanes_store(rows->weight, find_texels(b, coordinates(p, 1, x, y), b->source->height, texel));
    for (int n = 0; n < 2; ++n) {
        lanes_i_store(row, texel[n]);
        GN_EACH_LANE (l)
            rows->offset[n][l] = row[l] * b->source->row_stride;
    }
}

static unsigned char *pixel_of(const gn_surface *surface, int32_t x, int32_t y)
{
    return pixel_memory(surface, format_layout(surface->format), x, y);
}

/* Blits the pixels of a triangle in the columns from `left` to `right`, at most TEXEL_COLUMNS. */
static void blit_triangle_columns(const blit *b, const blit_triangle *p, int32_t left,
                                  int32_t right, int32_t bottom, int32_t top)
{
    texel_columns columns;
    texel_rows rows;

    for (int32_t y = bottom; y < top; ++y) {
        int32_t x = left;
        int32_t end = right;

        if (y == bottom || p->plane[0].per_y != 0.0f)
            find_columns(b, p, left, y, (uint32_t)(right - left), &columns);
        covered_columns(p, y, &x, &end);
        while (x < end) {
            int32_t next = end;

            find_rows(b, p, x, y, &rows);
            if (!rows.is_one && end - x > GN_LANES)
                next = x + GN_LANES;
            write_texels(b, pixel_of(b->destination, x, y), (uint32_t)(next - x), &columns,
                         (uint32_t)(x - left), &rows);
            x = next;
        }
    }
}

static void blit_scaled(const blit *b, const gn_rectangle *to, const gn_rectangle *from,
                        const gn_rectangle *drawn)
{
    blit_triangles triangles;

    set_blit_triangles(&triangles, b->destination, to, b->source, from);
    for (uint32_t n = 0; n < triangles.count; ++n)
        for (int32_t x = drawn->x0; x < drawn->x1; x += TEXEL_COLUMNS) {
            const int32_t end = drawn->x1 - x < TEXEL_COLUMNS ? drawn->x1 : x + TEXEL_COLUMNS;

            blit_triangle_columns(b, &triangles.triangle[n], x, end, drawn->y0, drawn->y1);
        }
}

/* Returns the texel of a pixel along one dimension, for rectangles of equal size of which `to` is
 * not mirrored. */
static int32_t moved_texel(int32_t pixel, int32_t to, int32_t from0, int32_t from1)
{
    return from0 <= from1 ? from0 + (pixel - to) : from0 - 1 - (pixel - to);
}

/* Blits a row without scaling or mirroring it: `count` pixels from `from` to `to`. */
static void move_row(const blit *b, unsigned char *to, const unsigned char *from, uint32_t count)
{
    row_work w;

    if (b->keeps_bits) {
        copy_row(b, to, from, count);
        return;
    }
    set_row_work(b, &w);
    w.kind = ROW_CONVERTS;
    w.from = from;
    w.to = to;
    w.count = count;
    rows_on(b->backend, &w);
}

/* Blits a row without scaling it, but mirrored: its first pixel reads the texel at `from`. */
static void mirror_row(const blit *b, unsigned char *to, const unsigned char *from, uint32_t count)
{
    const int32_t size = (int32_t)format_size(b->source->format);
    texel_columns columns;
    texel_rows rows;

    GN_EACH_LANE (l)
        rows.offset[0][l] = from - (const unsigned char *)b->source->pixels;
    for (uint32_t x = 0; x < count; x += TEXEL_COLUMNS) {
        const uint32_t length = count - x < TEXEL_COLUMNS ? count - x : TEXEL_COLUMNS;

        /* Lanes beyond the row repeat its last pixel. */
        for (uint32_t i = 0; i < TEXEL_COLUMNS; ++i)
            columns.offset[0][i] = -(int32_t)(i < length ? x + i : x + length - 1) * size;
        write_texels(b, to, length, &columns, 0, &rows);
        to += TEXEL_COLUMNS * format_size(b->destination->format);
    }
}

static void blit_moved(const blit *b, const gn_rectangle *to, const gn_rectangle *from,
                       const gn_rectangle *drawn)
{
    const int32_t column = moved_texel(drawn->x0, to->x0, from->x0, from->x1);
    const uint32_t count = (uint32_t)(drawn->x1 - drawn->x0);

    for (int32_t y = drawn->y0; y < drawn->y1; ++y) {
        const int32_t row = moved_texel(y, to->y0, from->y0, from->y1);
        unsigned char *const pixels = pixel_of(b->destination, drawn->x0, y);
        const unsigned char *const texels = pixel_of(b->source, column, row);

        if (from->x0 <= from->x1)
            move_row(b, pixels, texels, count);
        else
            mirror_row(b, pixels, texels, count);
    }
}

/* Cuts the rectangles, exchanges corners so that `to` is not mirrored, and blits. */
static void blit_checked(blit *b, gn_rectangle to, gn_rectangle from, const gn_scissor *scissor)
{
    const gn_rectangle bounds = scissored(b->destination, scissor);
    blit_range x = {to.x0, to.x1}, y = {to.y0, to.y1};
    blit_range from_x = {from.x0, from.x1}, from_y = {from.y0, from.y1};

    if (!cut_ranges(&x, &from_x, bounds.x0, bounds.x1, (int32_t)b->source->width) ||
        !cut_ranges(&y, &from_y, bounds.y0, bounds.y1, (int32_t)b->source->height))
        return;

    gn_rectangle drawn = {x.first, y.first, x.last, y.last};

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
    b->is_linear = b->is_linear && is_scaled;
    b->keeps_bits = b->destination->format == b->source->format && !b->is_linear;
    b->backend =
        b->keeps_bits
            ? GN_BACKEND_PORTABLE
            : backend_of_rows((size_t)(drawn.x1 - drawn.x0) * (size_t)(drawn.y1 - drawn.y0));
    if (is_scaled)
        blit_scaled(b, &to, &from, &drawn);
    else
        blit_moved(b, &to, &from, &drawn);
}

/* Sets the bits of depth and stencil that are written. */
static void set_written(blit *b, const gn_blit_options *options)
{
    const gn_format format = b->source->format;

    b->has_mask =
        format == GN_FORMAT_D32FS8 ||
        (format == GN_FORMAT_D24S8 && (options->depth_disabled || options->stencil_disabled));
    if (format == GN_FORMAT_D32FS8) {
        b->written[0] = options->depth_disabled ? 0 : 0xFFFFFFFFu;
        b->written[1] = options->stencil_disabled ? 0 : 255u;
    } else {
        b->written[0] = (options->depth_disabled ? 0 : 0x00FFFFFFu) |
                        (options->stencil_disabled ? 0 : 0xFF000000u);
        b->written[1] = b->written[0];
    }
}

/* Returns whether the options keep all depth and stencil of the format. */
static bool keeps_all(gn_format format, const gn_blit_options *options)
{
    if (format_is_color(format))
        return false;
    return (options->depth_disabled || !format_has_depth(format)) &&
           (options->stencil_disabled || !format_has_stencil(format));
}

void gni_blit_layer(const gn_surface *destination, int dimensions, const gn_surface *source,
                    const gn_surface *next, float next_weight, gn_backend backend)
{
    const gn_rectangle to = whole_surface(destination);
    const gn_rectangle from = whole_surface(source);
    const blit b = {destination, source,  dimensions, next,  next_weight,
                    true,        backend, false,      false, {0, 0}};

    blit_scaled(&b, &to, &from, &to);
}

gn_status gn_blit(const gn_surface *destination, const gn_rectangle *to, const gn_surface *source,
                  const gn_rectangle *from, const gn_blit_options *options)
{
    static const gn_blit_options defaults = {GN_BLIT_NEAREST, {false, 0, 0, 0, 0}, false, false};
    gn_rectangle to_all, from_all;
    gn_status status;

    if (!destination || !source)
        return GN_NULL_POINTER;
    if (!options)
        options = &defaults;
    if ((unsigned)options->filter > GN_BLIT_LINEAR)
        return GN_INVALID_ENUM;
    status = gni_check_any_surface(destination);
    if (status)
        return status;
    status = gni_check_any_surface(source);
    if (status)
        return status;
    if (samples_of(destination) > 1 || samples_of(source) > 1)
        return GN_INVALID_SAMPLES;

    const bool colors = format_is_color(source->format);
    if (colors ? !format_is_color(destination->format)
               : destination->format != source->format || options->filter == GN_BLIT_LINEAR)
        return GN_INVALID_FORMAT;
    if (!GN_HAVE_FORMATS && colors && !format_is_basic(destination->format) &&
        (destination->format != source->format || options->filter == GN_BLIT_LINEAR))
        return GN_NOT_COMPILED;

    to_all = whole_surface(destination);
    from_all = whole_surface(source);
    if (!to)
        to = &to_all;
    if (!from)
        from = &from_all;
    if (!is_in_range(to) || !is_in_range(from))
        return GN_OUT_OF_RANGE;

    blit b;

    b.destination = destination;
    b.source = source;
    b.dimensions = 2;
    b.next = 0;
    b.next_weight = 0.0f;
    b.is_linear = options->filter == GN_BLIT_LINEAR;
    b.keeps_bits = false;
    b.backend = GN_BACKEND_PORTABLE;
    if (overlap(&b, to, from))
        return GN_OVERLAP;
    set_written(&b, options);
    if (!keeps_all(source->format, options))
        blit_checked(&b, *to, *from, &options->scissor);
    return GN_OK;
}
