/* Triangle set-up: winding and culling, edge functions with the tie rule folded
 * in, and the planes of depth, 1/w and the varyings. Coverage is decided on
 * snapped coordinates in integers (exact), attributes on the unsnapped ones
 * (OpenGL 4.5 section 14.6.1; Pineda 1988 for edge functions). */
#ifndef GN_RASTER_SETUP_H
#define GN_RASTER_SETUP_H

#include "types.h"

#if (-1 >> 1) != -1
#error "right shifts of negative numbers must round down"
#endif

/* Beyond this a snapped coordinate is not one of a vertex inside a viewport:
 * GN_MAX_SIZE on either side of an origin within GN_MAX_SIZE. Within it
 * everything below stays under 2^52. */
#define SNAPPED_LIMIT (2u * GN_MAX_SIZE * 256 + 256)

/* The vertices in the order of the edges, found in their batches. */
typedef struct setup_vertices {
    const vertex_batch *batch[3];
    uint32_t lane[3];
    int32_t x[3], y[3]; /* snapped */
    const vertex_batch *provoking;
    uint32_t provoking_lane;
} setup_vertices;

static inline bool is_beyond(int32_t snapped)
{
    return (uint32_t)snapped + SNAPPED_LIMIT > 2 * SNAPPED_LIMIT;
}

/* False where the vertex is beyond SNAPPED_LIMIT. */
static inline bool gather_vertex(setup_vertices *v, int i, const vertex_store *store, uint32_t slot)
{
    const vertex_batch *batch = vertex_batch_of(store, slot);
    const uint32_t lane = slot % GN_LANES;
    const int32_t x = batch->snapped[0][lane];
    const int32_t y = batch->snapped[1][lane];

    v->batch[i] = batch;
    v->lane[i] = lane;
    v->x[i] = x;
    v->y[i] = y;
    return !is_beyond(x) && !is_beyond(y);
}

static inline void exchange_vertices(setup_vertices *v, int i, int j)
{
    const vertex_batch *const batch = v->batch[i];
    const uint32_t lane = v->lane[i];
    const int32_t x = v->x[i];
    const int32_t y = v->y[i];

    v->batch[i] = v->batch[j];
    v->lane[i] = v->lane[j];
    v->x[i] = v->x[j];
    v->y[i] = v->y[j];
    v->batch[j] = batch;
    v->lane[j] = lane;
    v->x[j] = x;
    v->y[j] = y;
}

static bool is_culled(const gn_pipeline *pipeline, bool clockwise)
{
    const bool front = clockwise == (pipeline->front_face == GN_FRONT_CLOCKWISE);

    switch (pipeline->cull) {
    case GN_CULL_BACK:
        return !front;
    case GN_CULL_FRONT:
        return front;
    case GN_CULL_FRONT_AND_BACK:
        return true;
    default:
        return false;
    }
}

/* The reference culls a second time, by the area of the unsnapped window coordinates,
 * where a segment of a draw has vertices outside the view volume; the two disagree on
 * slivers. No area counts as back-facing. */
static bool is_culled_unsnapped(const gn_pipeline *pipeline, const setup_vertices *v)
{
    float x[3], y[3];

    for (int i = 0; i < 3; ++i) {
        x[i] = v->batch[i]->window[0][v->lane[i]];
        y[i] = v->batch[i]->window[1][v->lane[i]];
    }
    const float area = (x[0] - x[2]) * (y[1] - y[2]) - (y[0] - y[2]) * (x[1] - x[2]);
    const bool front_clockwise = pipeline->front_face == GN_FRONT_CLOCKWISE;

    return is_culled(pipeline, area == 0.0f ? !front_clockwise : area < 0.0f);
}

static inline int32_t least(int32_t a, int32_t b, int32_t c)
{
    const int32_t d = a < b ? a : b;
    return d < c ? d : c;
}

static inline int32_t greatest(int32_t a, int32_t b, int32_t c)
{
    const int32_t d = a > b ? a : b;
    return d > c ? d : c;
}

/* Pixels whose centre (256 * px in snapped coordinates) lies between the extremes, and
 * in the target. */
static inline bool bound(const setup_state *state, const setup_vertices *v, raster_triangle *out)
{
    const int32_t min_x = (least(v->x[0], v->x[1], v->x[2]) + 255) >> 8;
    const int32_t min_y = (least(v->y[0], v->y[1], v->y[2]) + 255) >> 8;
    const int32_t max_x = greatest(v->x[0], v->x[1], v->x[2]) >> 8;
    const int32_t max_y = greatest(v->y[0], v->y[1], v->y[2]) >> 8;
    const int32_t right = (int32_t)state->width - 1;
    const int32_t top = (int32_t)state->height - 1;

    out->min_x = min_x < 0 ? 0 : min_x;
    out->min_y = min_y < 0 ? 0 : min_y;
    out->max_x = max_x > right ? right : max_x;
    out->max_y = max_y > top ? top : max_y;
    return out->min_x <= out->max_x && out->min_y <= out->max_y;
}

/* A pixel is inside where C - 256*dx*px + 256*dy*py > 0, C having 1 added on edges
 * that own their ties. With integers, C + 256*k > 0 is floor((C - 1) / 256) + k >= 0,
 * which leaves steps small enough for 32 bits within a block. */
static inline void make_edges(const setup_vertices *v, raster_triangle *out)
{
    for (int i = 0; i < 3; ++i) {
        const int j = i == 2 ? 0 : i + 1;
        const int32_t dx = v->y[i] - v->y[j];
        const int32_t dy = v->x[i] - v->x[j];
        const int32_t owns_ties = dx < 0 || (dx == 0 && dy > 0);
        const int64_t c = (int64_t)dx * v->x[i] - (int64_t)dy * v->y[i] + owns_ties;

        out->edge[i].constant = (c - 1) >> 8;
        out->edge[i].per_x = dx;
        out->edge[i].per_y = dy;
    }
}

/* Window differences of the vertices, divided by the triangle's area. */
typedef struct plane_basis {
    float x0, y0; /* vertex 0, from the pixel's centre */
    float dx01, dy01, dx20, dy20;
} plane_basis;

static inline plane_basis make_basis(const setup_vertices *v)
{
    const float x0 = v->batch[0]->window[0][v->lane[0]];
    const float y0 = v->batch[0]->window[1][v->lane[0]];
    const float dx01 = x0 - v->batch[1]->window[0][v->lane[1]];
    const float dy01 = y0 - v->batch[1]->window[1][v->lane[1]];
    const float dx20 = v->batch[2]->window[0][v->lane[2]] - x0;
    const float dy20 = v->batch[2]->window[1][v->lane[2]] - y0;
    const float one_over_area = 1.0f / (dx01 * dy20 - dx20 * dy01);
    plane_basis b;

    b.x0 = x0 - 0.5f;
    b.y0 = y0 - 0.5f;
    b.dx01 = dx01 * one_over_area;
    b.dy01 = dy01 * one_over_area;
    b.dx20 = dx20 * one_over_area;
    b.dy20 = dy20 * one_over_area;
    return b;
}

static inline attribute_plane make_plane(const plane_basis *b, float a0, float a1, float a2)
{
    const float da01 = a0 - a1;
    const float da20 = a2 - a0;
    attribute_plane p;

    p.per_x = da01 * b->dy20 - da20 * b->dy01;
    p.per_y = da20 * b->dx01 - da01 * b->dx20;
    p.origin = a0 - (p.per_x * b->x0 + p.per_y * b->y0);
    return p;
}

/* The planes of depth, 1/w and the varyings. */
static inline void setup_planes(const gn_pipeline *pipeline, const setup_vertices *v,
                                raster_triangle *out)
{
    const plane_basis basis = make_basis(v);
    float w[3];

    for (int i = 0; i < 3; ++i)
        w[i] = v->batch[i]->window[3][v->lane[i]];
    out->depth = make_plane(&basis, v->batch[0]->window[2][v->lane[0]],
                            v->batch[1]->window[2][v->lane[1]], v->batch[2]->window[2][v->lane[2]]);
    out->one_over_w = make_plane(&basis, w[0], w[1], w[2]);

    for (uint32_t n = 0; n < pipeline->varying_count; ++n) {
        float a[3];

        for (int i = 0; i < 3; ++i)
            a[i] = v->batch[i]->varying[n][v->lane[i]];
        switch (pipeline->interpolation[n]) {
        case GN_FLAT:
            out->varying[n].origin = v->provoking->varying[n][v->provoking_lane];
            out->varying[n].per_x = 0.0f;
            out->varying[n].per_y = 0.0f;
            break;
        case GN_NOPERSPECTIVE:
            out->varying[n] = make_plane(&basis, a[0], a[1], a[2]);
            break;
        default:
            out->varying[n] = make_plane(&basis, a[0] * w[0], a[1] * w[1], a[2] * w[2]);
            break;
        }
    }
}

/* Bounds and edges. False where the triangle is culled, degenerate or has no pixel of
 * the target in its bounds; `out` is then unspecified. */
static inline bool setup_edges(const setup_state *state, const vertex_store *store,
                               const vertex_triangle *triangle, setup_vertices *v,
                               raster_triangle *out)
{
    const gn_pipeline *pipeline = state->pipeline;

    for (int i = 0; i < 3; ++i) {
        if (!gather_vertex(v, i, store, triangle->slot[i]))
            return false;
    }

    const int64_t area = (int64_t)(v->x[0] - v->x[1]) * (v->y[2] - v->y[0]) -
                         (int64_t)(v->x[2] - v->x[0]) * (v->y[0] - v->y[1]);
    if (area == 0 || is_culled(pipeline, area > 0) || !bound(state, v, out))
        return false;
    if (state->any_clipped && pipeline->cull != GN_CULL_NONE && is_culled_unsnapped(pipeline, v))
        return false;

    /* Inside is to one side of every edge only in one winding; the provoking vertex
     * keeps its place. */
    if (area < 0) {
        const bool first = pipeline->provoking_vertex == GN_PROVOKING_FIRST;
        exchange_vertices(v, first ? 1 : 0, first ? 2 : 1);
    }
    v->provoking = vertex_batch_of(store, triangle->provoking);
    v->provoking_lane = triangle->provoking % GN_LANES;
    make_edges(v, out);
    return true;
}

#endif
