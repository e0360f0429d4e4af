/* Divides large pictures into tiles and draws them. */
#include "tiles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The most bytes of a strip and a tile. */
#define STRIP_SIZE ((uint64_t)192 << 20)

/* A picture has at least about so many strips, so that several ranks have something to do. */
enum { STRIP_COUNT = 8 };

/* Pixels on each side of a tile that its points and lines may reach over its edges. */
static uint32_t margin_of(const scene *s)
{
    double widest = 0.0;
    for (size_t i = 0; i < s->draw_count; ++i) {
        const gn_pipeline *p = &s->draws[i].state;
        const bool is_filled = p->raster.polygon_mode_front == GN_POLYGON_FILL &&
                               p->raster.polygon_mode_back == GN_POLYGON_FILL;
        const bool has_triangles = p->raster.topology <= GN_TRIANGLE_FAN;
        if (has_triangles && is_filled)
            continue;
        const double size = fmax((double)p->raster.point_size, (double)p->raster.line_width);
        widest = fmax(widest, fmax(fmin(size, GN_MAX_POINT_SIZE), 1.0));
    }
    return widest > 0.0 ? (uint32_t)ceil(widest / 2.0) + 1 : 0;
}

static uint64_t pixel_size(const scene *s)
{
    uint64_t size = gn_format_size(s->depth_format);
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        size += gn_format_size(scene_color_format(s, a));
    return size;
}

tiling tiles_divide(const scene *s, uint32_t unit, uint32_t largest)
{
    const uint32_t margin = margin_of(s), inner = largest - 2 * margin;
    const uint32_t columns = (s->width + inner - 1) / inner;
    const uint64_t width = s->width / columns + 1 + 2 * margin;
    const uint64_t images = scene_is_sampled(s) ? GN_SAMPLES + 1 : 1;
    const uint64_t row = pixel_size(s) * (s->width + width * images);
    uint64_t rows = STRIP_SIZE / row;
    const uint64_t shared = (uint64_t)s->height / STRIP_COUNT + unit;
    rows = rows < shared ? rows : shared;
    rows = rows < inner ? rows : inner;
    rows = rows / unit * unit;
    return (tiling){rows > unit ? (uint32_t)rows : unit, columns, margin};
}

row_range tiles_strip(const scene *s, const tiling *t, uint32_t number)
{
    return band_of_units(s->height, t->rows, number, (uint64_t)number + 1);
}

/* A rectangle of pixels of the window, counted from its lower left corner. */
typedef struct rectangle {
    uint32_t x, y, width, height;
} rectangle;

static uint32_t widened(uint32_t *first, uint32_t count, uint32_t margin, uint32_t size)
{
    const uint32_t before = *first < margin ? *first : margin;
    const uint32_t behind = size - *first - count;
    *first -= before;
    return count + before + (behind < margin ? behind : margin);
}

/* A tile with its margin. Beyond the picture there is none, so that what lies outside the picture
 * is clipped as in one target. */
static rectangle with_margin(const scene *s, rectangle r, uint32_t margin)
{
    r.width = widened(&r.x, r.width, margin, s->width);
    r.height = widened(&r.y, r.height, margin, s->height);
    return r;
}

/* Maps the part of clip space that a rectangle shows onto the whole. With W pixels in all, a tile's
 * x in NDC is ((x + 1) W - 2 first) / width - 1. */
static gn_mat4 crop(const scene *s, const rectangle *r)
{
    gn_mat4 m;
    gn_mat4_identity(&m);
    m.m[0][0] = (float)((double)s->width / r->width);
    m.m[1][1] = (float)((double)s->height / r->height);
    m.m[3][0] = (float)(((double)s->width - 2.0 * r->x - r->width) / r->width);
    m.m[3][1] = (float)(((double)s->height - 2.0 * r->y - r->height) / r->height);
    return m;
}

/* Copies the resolved pixels of `from`, a part of the tile, to their place in the picture. */
static void copy_out(const scene_frame *tile, const rectangle *placed, const rectangle *from,
                     scene_frame *picture)
{
    for (int a = 0; a <= GN_MAX_COLORS; ++a) {
        const bool is_depth = a == GN_MAX_COLORS;
        const char *source = is_depth ? tile->depth : scene_frame_color(tile, a);
        char *to = is_depth ? picture->depth : scene_frame_color(picture, a);
        const size_t pixel =
            gn_format_size(is_depth ? tile->depth_format : scene_frame_format(tile, a));
        const size_t shown = (size_t)(tile->images - 1) * tile->height;
        for (size_t y = from->y; source != NULL && y < (size_t)from->y + from->height; ++y)
            memcpy(to + (y * picture->width + from->x) * pixel,
                   source + ((shown + y - placed->y) * tile->width + from->x - placed->x) * pixel,
                   from->width * pixel);
    }
}

static gn_status draw_tile(const scene *s, const rectangle *part, uint32_t margin,
                           scene_frame *picture, gn_workspace *workspace, bool *is_short)
{
    const rectangle placed = with_margin(s, *part, margin);
    const gn_mat4 cropped = crop(s, &placed);
    scene tile = *s;
    scene_frame frame;
    tile.width = placed.width;
    tile.height = placed.height;
    tile.draws = calloc(s->draw_count + 1, sizeof *tile.draws);
    *is_short = tile.draws == NULL || !scene_frame_allocate(&frame, &tile);
    if (*is_short) {
        free(tile.draws);
        return GN_OK;
    }
    for (size_t i = 0; i < s->draw_count; ++i) {
        tile.draws[i] = s->draws[i];
        gn_mat4_multiply(&cropped, &s->draws[i].uniforms.light.clip_from_model,
                         &tile.draws[i].uniforms.light.clip_from_model);
    }
    const gn_status status = scene_draw_in_workspace(&tile, &frame, workspace);
    if (status == GN_OK)
        copy_out(&frame, &placed, part, picture);
    scene_frame_free(&frame);
    free(tile.draws);
    return status;
}

gn_status tiles_draw(const scene *s, const tiling *t, row_range strip, scene_frame *picture,
                     gn_workspace *workspace, bool *is_short)
{
    gn_status status = GN_OK;
    *is_short = false;
    for (uint32_t c = 0; strip.count > 0 && c < t->columns && status == GN_OK && !*is_short; ++c) {
        const uint32_t first = (uint32_t)((uint64_t)s->width * c / t->columns);
        const uint32_t end = (uint32_t)((uint64_t)s->width * (c + 1) / t->columns);
        const rectangle part = {first, s->height - strip.first - strip.count, end - first,
                                strip.count};
        status = draw_tile(s, &part, t->margin, picture, workspace, is_short);
    }
    return status;
}
