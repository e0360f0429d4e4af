/* What a share of the work costs, by the figures. */
#include "scale_cost.h"

#include <math.h>

double cost_ns(const figures *f, figure_kind kind, double count)
{
    return f->value[kind] * count * 1e-9;
}

static cost cost_of(const figures *f, double vertices, double triangles, double pixels,
                    const work_share *drawn, double file_pixels, double covered)
{
    const double empty = file_pixels > covered ? file_pixels - covered : 0.0;
    return (cost){
        .clear = cost_ns(f, FIGURE_CLEAR, pixels),
        .vertices = cost_ns(f, FIGURE_VERTEX, vertices),
        .triangles = cost_ns(f, FIGURE_TRIANGLE, triangles) +
                     cost_ns(f, FIGURE_DRAWN, drawn->drawn) + cost_ns(f, FIGURE_ROW, drawn->rows),
        .fragments = cost_ns(f, FIGURE_FRAGMENT, drawn->fragments),
        .compress =
            cost_ns(f, FIGURE_COMPRESS_EMPTY, empty) + cost_ns(f, FIGURE_COMPRESS_DRAWN, covered),
        .bytes = f->value[FIGURE_BYTES_EMPTY] * empty + f->value[FIGURE_BYTES_DRAWN] * covered,
    };
}

double cost_pixels(const work *w)
{
    return (double)w->scene.side * w->scene.side;
}

/* Files are compressed in units of 16 rows, and a band is whole units; so a picture has at most so
 * many bands, and other ranks have none. */
#define UNIT_ROWS 16

static const work_share *band_of(const work *w, uint32_t ranks, uint32_t rank, double *pixels)
{
    static const work_share nothing;
    uint32_t bands = ranks;
    while (bands > 1 && w->scene.side / bands < UNIT_ROWS)
        bands /= 2;
    *pixels = rank < bands ? cost_pixels(w) / bands : 0.0;
    return rank < bands ? &w->band[bands + rank] : &nothing;
}

cost cost_of_picture(way_kind way, const work *w, const figures *f, uint32_t ranks, uint32_t rank)
{
    double band_pixels;
    const work_share *band = band_of(w, ranks, rank, &band_pixels);
    if (way == WAY_SORT_FIRST)
        return cost_of(f, band_pixels > 0.0 ? w->vertices : 0.0,
                       band_pixels > 0.0 ? w->triangles : 0.0, band_pixels, band, band_pixels,
                       band->covered);
    return cost_of(f, w->vertices / ranks, w->triangles / ranks, cost_pixels(w),
                   &w->part[ranks + rank], band_pixels, band->covered);
}

double cost_of_preparing(way_kind way, const work *w, const figures *f, uint32_t ranks)
{
    const double pixels = cost_pixels(w) / (way == WAY_SORT_FIRST ? ranks : 1);
    return cost_ns(f, FIGURE_PREPARE, w->triangles) + cost_ns(f, FIGURE_TOUCH, pixels);
}

cost cost_of_frame(const work *w, const figures *f, uint32_t frame)
{
    const uint64_t turn = (uint64_t)frame * WORK_TURNS / w->scene.frames;
    const work_share *s = &w->turn[turn % WORK_TURNS];
    const double pixels = cost_pixels(w);
    cost result = cost_of(f, w->vertices, w->triangles, pixels, s, pixels, s->covered);
    result.compress = cost_ns(f, FIGURE_FRAME_EMPTY, pixels - s->covered) +
                      cost_ns(f, FIGURE_FRAME_DRAWN, s->covered);
    return result;
}

/* Bytes of the pieces that a rank holds at a time (merge.c). */
#define PIECES_BYTES 67108864.0

double cost_pieces(const work *w, uint32_t ranks)
{
    const double row = 8.0 * w->scene.side, rows = (double)w->scene.side / ranks;
    const double most = floor(PIECES_BYTES / (ranks + 1) / row);
    return most < 1.0 ? ceil(rows) : ceil(rows / most);
}
