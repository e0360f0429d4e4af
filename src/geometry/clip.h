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
    const viewport_transform *viewport;
    unsigned char *memory; /* of all vertices */
    uint32_t scratch;      /* offset of CLIP_MAX_VERTICES new ones */
    uint32_t used;         /* of them */
    float point_size[CLIP_MAX_VERTICES];
    uint32_t hidden; /* of the last polygon: edges that lie on planes */
} clipper;

typedef struct polygon {
    uint32_t vertex[CLIP_MAX_POLYGON];
    uint32_t count;
    uint32_t hidden; /* bit n: the edge from vertex n on lies on a plane */
} polygon;

/* The signed distance a0*x + a1*y + a2*z + a3*w to a plane: not negative inside.
 * The terms of value zero are left out: they can change neither the sum nor, the
 * coordinates being finite, make it NaN. */
static float plane_distance(const stored_vertex *v, uint32_t plane)
{
    const float coordinate = v->clip[plane / 2];
    const float w = v->clip[3];
    const bool positive = plane == CLIP_LEFT || plane == CLIP_BOTTOM || plane == CLIP_NEAR;

    return positive ? coordinate + w : w - coordinate;
}

/* The parameter of the new vertex between `from` and `to` in window x (or y where
 * the clip x agree): noperspective varyings are linear there. */
static float window_parameter(const stored_vertex *from, const stored_vertex *to,
                              const stored_vertex *made, float t)
{
    for (int c = 0; c < 2; ++c) {
        if (to->clip[c] != from->clip[c]) {
            const float p = from->clip[c] / from->clip[3];
            const float q = to->clip[c] / to->clip[3];
            const float d = made->clip[c] / made->clip[3];
            return (d - p) / (q - p);
        }
    }
    return t;
}

/* A new vertex at from + t * (to - from). What flat varyings get is not used: theirs is
 * the provoking vertex of the whole triangle. */
static uint32_t interpolate_vertex(clipper *c, uint32_t from, uint32_t to, float t)
{
    const uint32_t stride = vertex_stride(c->pipeline->varying_count);
    const uint32_t number = c->used++;
    const uint32_t offset = c->scratch + number * stride;
    const stored_vertex *p = vertex_at(c->memory, from);
    const stored_vertex *q = vertex_at(c->memory, to);
    stored_vertex *made = vertex_at(c->memory, offset);

    for (int n = 0; n < 4; ++n)
        made->clip[n] = p->clip[n] + t * (q->clip[n] - p->clip[n]);

    made->point_size = p->point_size + t * (q->point_size - p->point_size);
    c->point_size[number] = made->point_size;

    const float linear = window_parameter(p, q, made, t);
    for (uint32_t v = 0; v < c->pipeline->varying_count; ++v) {
        const float s = c->pipeline->interpolation[v] == GN_NOPERSPECTIVE ? linear : t;
        made->varying[v] = p->varying[v] + s * (q->varying[v] - p->varying[v]);
    }
    return offset;
}

/* Clips a polygon to one plane; false where nothing is left, a distance is not finite
 * or a limit (CLIP_MAX_POLYGON, CLIP_MAX_VERTICES) is reached. The new vertex of an edge
 * is measured from its end nearer the plane, where t is small. */
static bool clip_to_plane(clipper *c, uint32_t plane, const polygon *in, polygon *out)
{
    uint32_t previous = in->vertex[0];
    float previous_distance = plane_distance(vertex_at(c->memory, previous), plane);

    out->count = 0;
    out->hidden = 0;
    if (!gn_is_finite(previous_distance))
        return false;

    for (uint32_t n = 1; n <= in->count; ++n) {
        const uint32_t current = in->vertex[n == in->count ? 0 : n];
        const float distance = plane_distance(vertex_at(c->memory, current), plane);

        if (!gn_is_finite(distance) || out->count > CLIP_MAX_POLYGON - 2 ||
            c->used == CLIP_MAX_VERTICES)
            return false;
        const uint32_t hidden = in->hidden >> (n - 1) & 1u;
        if (previous_distance >= 0.0f) {
            out->hidden |= hidden << out->count;
            out->vertex[out->count++] = previous;
        }

        if ((distance < 0.0f) != (previous_distance < 0.0f)) {
            const float span = distance - previous_distance;
            const bool leaving = distance < 0.0f;
            const float outside = leaving ? -distance : -previous_distance;
            const float inside = leaving ? previous_distance : distance;
            const bool from_current = leaving == (outside < inside);

            out->hidden |= (leaving ? 1u : hidden) << out->count;
            out->vertex[out->count++] =
                from_current ? interpolate_vertex(c, current, previous, distance / span)
                             : interpolate_vertex(c, previous, current, -previous_distance / span);
        }
        previous = current;
        previous_distance = distance;
    }
    return out->count >= 3;
}

/* Window coordinates of the new vertices, which are inside, whatever rounding says. Lanes
 * beyond them repeat the first, so that nothing is read that was not written. */
GN_STEP void place_new_vertices(const clipper *c)
{
    const uint32_t stride = vertex_stride(c->pipeline->varying_count);
    uint32_t offset[GN_LANES];
    lanes_i row[4];
    lanes_f clip[4];

    if (c->used == 0)
        return;
    GN_EACH_LANE (l) {
        const uint32_t n = (uint32_t)l < c->used ? (uint32_t)l : 0;

        offset[l] = c->scratch + n * stride + VERTEX_CLIP;
    }
    lanes_i_gather_rows(c->memory, offset, 1, row);
    for (int n = 0; n < 4; ++n)
        clip[n] = lanes_as_float(row[n]);
    place_vertices(c->viewport, clip, lanes_as_int(lanes_load(c->point_size)),
                   c->memory + c->scratch, stride);
    for (uint32_t n = 0; n < c->used; ++n)
        vertex_at(c->memory, c->scratch + n * stride)->outcode = 0;
}

/* Clips a triangle to the planes of its outcodes into a group of triangles, which may be
 * empty. New vertices are in the clipper's scratch until the next call. */
static inline void clip_triangle(clipper *c, uint32_t planes, const uint32_t triangle[3],
                                 triangle_group *out)
{
    polygon polygons[2];
    polygon *in = &polygons[0];
    polygon *result = &polygons[1];

    c->used = 0;
    out->count = 0;
    in->count = 3;
    in->hidden = 0;
    for (int n = 0; n < 3; ++n)
        in->vertex[n] = triangle[n];

    for (uint32_t plane = 0; plane < CLIP_PLANE_COUNT; ++plane) {
        if (planes >> plane & 1u) {
            if (!clip_to_plane(c, plane, in, result))
                return;
            polygon *const swap = in;
            in = result;
            result = swap;
        }
    }
    c->hidden = in->hidden;
    place_new_vertices(c);

    /* A fan whose first polygon vertex takes the provoking vertex's place. */
    const bool first = c->pipeline->provoking_vertex == GN_PROVOKING_FIRST;
    out->count = in->count - 2;
    out->step = 1;
    for (int n = 0; n < 3; ++n)
        out->corner[n] = out->made[n];
    for (uint32_t l = 0; l < GN_LANES; ++l) {
        const uint32_t n = l < out->count ? l + 2 : 2;

        out->made[0][l] = in->vertex[first ? 0 : n - 1];
        out->made[1][l] = in->vertex[first ? n - 1 : n];
        out->made[2][l] = in->vertex[first ? n : 0];
    }
}

#endif
