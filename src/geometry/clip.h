/* Clipping to the view volume: Sutherland and Hodgman's reentrant polygon
 * clipping (1974) in homogeneous coordinates (Blinn and Newell 1978), plane after
 * plane. There is no guard band, so that what is inside the volume keeps its
 * vertices and nothing reaches the rasterizer from beyond the viewport. */
#ifndef GN_GEOMETRY_CLIP_H
#define GN_GEOMETRY_CLIP_H

#include "viewport.h"

#include "../lanes/lanes.h"
#include "../math/bits.h"

typedef struct clipper {
    const gn_pipeline *pipeline;
    const vertex_store *store;
    uint32_t scratch; /* batch of the new vertices */
    uint32_t used;    /* lanes of it in use */
} clipper;

typedef struct polygon {
    uint32_t slot[CLIP_MAX_POLYGON];
    uint32_t count;
} polygon;

/* The signed distance a0*x + a1*y + a2*z + a3*w to a plane: not negative inside.
 * The terms of value zero are left out: they can change neither the sum nor, the
 * coordinates being finite, make it NaN. */
static float plane_distance(const vertex_store *store, uint32_t slot, uint32_t plane)
{
    const vertex_batch *batch = vertex_batch_of(store, slot);
    const float coordinate = batch->clip[plane / 2][slot % GN_LANES];
    const float w = batch->clip[3][slot % GN_LANES];
    const bool positive = plane == CLIP_LEFT || plane == CLIP_BOTTOM || plane == CLIP_NEAR;

    return positive ? coordinate + w : w - coordinate;
}

/* The parameter of the new vertex between `from` and `to` in window x (or y where
 * the clip x agree): noperspective varyings are linear there. */
static float window_parameter(const vertex_batch *from, uint32_t from_lane, const vertex_batch *to,
                              uint32_t to_lane, const vertex_batch *made, uint32_t made_lane,
                              float t)
{
    for (int c = 0; c < 2; ++c) {
        if (to->clip[c][to_lane] != from->clip[c][from_lane]) {
            const float p = from->clip[c][from_lane] / from->clip[3][from_lane];
            const float q = to->clip[c][to_lane] / to->clip[3][to_lane];
            const float d = made->clip[c][made_lane] / made->clip[3][made_lane];
            return (d - p) / (q - p);
        }
    }
    return t;
}

/* A new vertex at from + t * (to - from). What flat varyings get is not used: theirs is
 * the provoking vertex of the whole triangle. */
static uint32_t interpolate_vertex(clipper *c, uint32_t from, uint32_t to, float t)
{
    const vertex_batch *p = vertex_batch_of(c->store, from);
    const vertex_batch *q = vertex_batch_of(c->store, to);
    vertex_batch *made = vertex_batch_at(c->store, c->scratch);
    const uint32_t i = from % GN_LANES;
    const uint32_t j = to % GN_LANES;
    const uint32_t k = c->used++;

    for (int n = 0; n < 4; ++n)
        made->clip[n][k] = p->clip[n][i] + t * (q->clip[n][j] - p->clip[n][i]);

    const float linear = window_parameter(p, i, q, j, made, k, t);
    for (uint32_t v = 0; v < c->pipeline->varying_count; ++v) {
        const float s = c->pipeline->interpolation[v] == GN_NOPERSPECTIVE ? linear : t;
        made->varying[v][k] = p->varying[v][i] + s * (q->varying[v][j] - p->varying[v][i]);
    }
    return c->scratch * GN_LANES + k;
}

/* Clips a polygon to one plane; false where nothing is left, a distance is not finite
 * or a limit of CLIP_MAX_POLYGON is reached. The new vertex of an edge is measured
 * from its end nearer the plane, where t is small. */
static bool clip_to_plane(clipper *c, uint32_t plane, const polygon *in, polygon *out)
{
    uint32_t previous = in->slot[0];
    float previous_distance = plane_distance(c->store, previous, plane);

    out->count = 0;
    if (!gn_is_finite(previous_distance))
        return false;

    for (uint32_t n = 1; n <= in->count; ++n) {
        const uint32_t current = in->slot[n == in->count ? 0 : n];
        const float distance = plane_distance(c->store, current, plane);

        if (!gn_is_finite(distance) || out->count > CLIP_MAX_POLYGON - 2 || c->used == GN_LANES)
            return false;
        if (previous_distance >= 0.0f)
            out->slot[out->count++] = previous;

        if ((distance < 0.0f) != (previous_distance < 0.0f)) {
            const float span = distance - previous_distance;
            const bool leaving = distance < 0.0f;
            const float outside = leaving ? -distance : -previous_distance;
            const float inside = leaving ? previous_distance : distance;
            const bool from_current = leaving == (outside < inside);

            out->slot[out->count++] =
                from_current ? interpolate_vertex(c, current, previous, distance / span)
                             : interpolate_vertex(c, previous, current, -previous_distance / span);
        }
        previous = current;
        previous_distance = distance;
    }
    return out->count >= 3;
}

static inline uint32_t clip_triangle(const gn_pipeline *pipeline,
                                     const viewport_transform *viewport, const vertex_store *store,
                                     uint32_t scratch, uint32_t planes,
                                     const vertex_triangle *triangle,
                                     vertex_triangle out[CLIP_MAX_POLYGON - 2])
{
    clipper c = {pipeline, store, scratch, 0};
    polygon polygons[2];
    polygon *in = &polygons[0];
    polygon *result = &polygons[1];

    in->count = 3;
    for (int n = 0; n < 3; ++n)
        in->slot[n] = triangle->slot[n];

    for (uint32_t plane = 0; plane < CLIP_PLANE_COUNT; ++plane) {
        if (planes >> plane & 1u) {
            if (!clip_to_plane(&c, plane, in, result))
                return 0;
            polygon *const swap = in;
            in = result;
            result = swap;
        }
    }
    transform_batch(viewport, vertex_batch_at(store, scratch));

    /* A fan whose first polygon vertex takes the provoking vertex's place. */
    const bool first = pipeline->provoking_vertex == GN_PROVOKING_FIRST;
    for (uint32_t n = 2; n < in->count; ++n) {
        vertex_triangle *t = &out[n - 2];
        t->slot[0] = first ? in->slot[0] : in->slot[n - 1];
        t->slot[1] = first ? in->slot[n - 1] : in->slot[n];
        t->slot[2] = first ? in->slot[n] : in->slot[0];
        t->provoking = triangle->provoking;
    }
    return in->count - 2;
}

#endif
