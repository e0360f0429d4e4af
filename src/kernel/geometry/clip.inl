/* Clipping to the view volume: Sutherland and Hodgman's reentrant polygon clipping (1974) in
 * homogeneous coordinates (Blinn and Newell 1978), plane after plane. There is no guard band: a
 * triangle inside the volume keeps its vertices, and nothing beyond the viewport reaches the
 * rasterizer. */
#ifndef GN_KERNEL_GEOMETRY_CLIP_INL
#define GN_KERNEL_GEOMETRY_CLIP_INL

#include "viewport.inl"

#include "../../lanes/lanes.h"
#include "../../scalars/bits.h"

typedef struct clipper {
    const gn_pipeline *pipeline;
    const viewport_transform *viewport;
    unsigned char *memory; /* offsets of vertices count from here */
    uint32_t scratch;      /* offset of the room for clip_room new vertices */
    uint32_t room;
    uint32_t used;   /* new vertices made so far */
    uint32_t hidden; /* edges of the last polygon that lie on planes of the view volume */
    float point_size[CLIP_MAX_VERTICES];
} clipper;

typedef struct polygon {
    uint32_t vertex[CLIP_MAX_POLYGON];
    uint32_t count;
    uint32_t hidden; /* bit n: the edge that begins at vertex n lies on one of those planes */
} polygon;

/* Returns the signed distance a0*x + a1*y + a2*z + a3*w to a plane: not negative inside. A term
 * whose factor is 0 changes the sum only if its coordinate is not finite: the sum is then NaN. */
static float plane_distance(const clipper *c, const stored_vertex *v, uint32_t plane)
{
    if (GN_HAVE_DISTANCES && plane >= CLIP_DISTANCE)
        return v->varying[c->pipeline->program.varying_count + (plane - CLIP_DISTANCE)];

    const float coordinate = v->clip[plane / 2];
    const float w = v->clip[3];
    const bool positive = plane == CLIP_LEFT || plane == CLIP_BOTTOM || plane == CLIP_NEAR;
    const float zero =
        0.0f * v->clip[0] + 0.0f * v->clip[1] + 0.0f * v->clip[2] + 0.0f * v->clip[3];

    if (plane == CLIP_NEAR && c->viewport->zero_to_one)
        return coordinate + zero;
    return (positive ? coordinate + w : w - coordinate) + zero;
}

/* Returns the new vertex's parameter between `from` and `to` in window x, or in window y if their
 * clip x are equal. Noperspective varyings are linear in it. */
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

/* Sets the clip distances of a new vertex to its distances from the program's planes. */
static void set_plane_distances(const gn_program *program, stored_vertex *made)
{
    float *const distance = made->varying + program->varying_count;

    for (uint32_t i = 0; i < program->clip_distance_count; ++i) {
        const float *const plane = program->clip_plane[i];

        distance[i] =
            ((made->clip[0] * plane[0] + made->clip[1] * plane[1]) + made->clip[2] * plane[2]) +
            made->clip[3] * plane[3];
    }
}

/* Makes a new vertex at from + t * (to - from); returns its offset. The values of flat varyings are
 * not used: the provoking vertex of the whole triangle has them. */
static uint32_t interpolate_vertex(clipper *c, uint32_t from, uint32_t to, float t)
{
    const uint32_t stride = vertex_stride(stored_values(c->pipeline));
    const uint32_t number = c->used++;
    const uint32_t offset = c->scratch + number * stride;
    const stored_vertex *p = vertex_at(c->memory, from);
    const stored_vertex *q = vertex_at(c->memory, to);
    stored_vertex *made = vertex_at(c->memory, offset);

    for (int n = 0; n < 4; ++n)
        made->clip[n] = p->clip[n] + t * (q->clip[n] - p->clip[n]);

    if (DRAWS_LINES) {
        made->point_size = p->point_size + t * (q->point_size - p->point_size);
        c->point_size[number] = made->point_size;
    }

    const float linear = window_parameter(p, q, made, t);
    for (uint32_t v = 0; v < stored_values(c->pipeline); ++v) {
        const bool is_linear = v < c->pipeline->program.varying_count &&
                               c->pipeline->program.interpolation[v] == GN_NOPERSPECTIVE;
        const float s = is_linear ? linear : t;
        made->varying[v] = p->varying[v] + s * (q->varying[v] - p->varying[v]);
    }
    if (GN_HAVE_DISTANCES && c->pipeline->program.clip_plane)
        set_plane_distances(&c->pipeline->program, made);
    return offset;
}

static inline uint32_t room_of(const clipper *c)
{
    return !GN_HAVE_DISTANCES            ? CLIP_ROOM
           : c->room < CLIP_MAX_VERTICES ? c->room
                                         : CLIP_MAX_VERTICES;
}

/* Clips a polygon to one plane. Returns false if nothing is left, if a distance is not finite, or
 * if a limit is reached (CLIP_MAX_POLYGON, room_of). A new vertex is measured from the end of its
 * edge that is nearer to the plane, where t is small. */
static bool clip_to_plane(clipper *c, uint32_t plane, const polygon *in, polygon *out)
{
    uint32_t previous = in->vertex[0];
    float previous_distance = plane_distance(c, vertex_at(c->memory, previous), plane);

    const uint32_t hides = plane < CLIP_DISTANCE;
    out->count = 0;
    out->hidden = 0;
    if (!is_finite(previous_distance))
        return false;

    for (uint32_t n = 1; n <= in->count; ++n) {
        const uint32_t current = in->vertex[n == in->count ? 0 : n];
        const float distance = plane_distance(c, vertex_at(c->memory, current), plane);

        if (!is_finite(distance) || out->count > CLIP_MAX_POLYGON - 2 || c->used == room_of(c))
            return false;
        const uint32_t hidden = DRAWS_LINES ? in->hidden >> (n - 1) & 1u : 0;
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

            if (DRAWS_LINES)
                out->hidden |= (leaving ? hides : hidden) << out->count;
            out->vertex[out->count++] =
                from_current ? interpolate_vertex(c, current, previous, distance / span)
                             : interpolate_vertex(c, previous, current, -previous_distance / span);
        }
        previous = current;
        previous_distance = distance;
    }
    return out->count >= 3;
}

/* Finds the window coordinates of the new vertices, which count as inside, whatever rounding says.
 * Lanes beyond them repeat the first, so that no lane reads uninitialised memory. */
GN_FRAMED void place_new_vertices(const clipper *c)
{
    const uint32_t stride = vertex_stride(stored_values(c->pipeline));

    for (uint32_t first = 0;
         first < c->used && (GN_HAVE_DISTANCES || LANES < CLIP_ROOM || first == 0);
         first += LANES) {
        uint32_t offset[LANES];
        lanes_i row[4];
        lanes_f clip[4];

        GN_EACH_LANE (l) {
            const uint32_t n = first + (uint32_t)l < c->used ? first + (uint32_t)l : first;

            offset[l] = c->scratch + n * stride + VERTEX_CLIP;
        }
        lanes_i_gather_rows(c->memory, offset, 1, row);
        for (int n = 0; n < 4; ++n)
            clip[n] = lanes_as_float(row[n]);
        place_vertices(c->viewport, clip, lanes_i_splat(0), lanes_i_splat(0),
                       c->memory + c->scratch + first * stride, stride);
    }
    for (uint32_t n = 0; n < c->used; ++n) {
        stored_vertex *const v = vertex_at(c->memory, c->scratch + n * stride);

        v->outcode = 0;
        if (DRAWS_LINES)
            v->point_size = c->point_size[n];
    }
}

/* Clips a triangle to the planes of its outcodes. Returns what is left of it, one of the two
 * polygons, or null if nothing is. New vertices are in the clipper's scratch until the next
 * call. */
static inline const polygon *clip_triangle(clipper *c, uint32_t planes, const uint32_t triangle[3],
                                           polygon polygons[2])
{
    polygon *in = &polygons[0];
    polygon *result = &polygons[1];

    c->used = 0;
    c->room = clip_room(planes);
    in->count = 3;
    in->hidden = 0;
    for (int n = 0; n < 3; ++n)
        in->vertex[n] = triangle[n];

    for (uint32_t plane = 0; plane < CLIP_PLANE_COUNT; ++plane) {
        if (planes >> plane & 1u) {
            if (!clip_to_plane(c, plane, in, result))
                return 0;
            polygon *const swap = in;
            in = result;
            result = swap;
        }
    }
    c->hidden = in->hidden;
    place_new_vertices(c);
    return in;
}

/* Returns how many triangles a clipped polygon is made of. */
static inline uint32_t piece_count(const polygon *p)
{
    return p->count - 2;
}

/* Writes the pieces of a polygon from number `from` on, as many as there are lanes, as a group. The
 * pieces are a fan whose first vertex takes the provoking vertex's place. */
static inline void take_pieces(const clipper *c, const polygon *p, uint32_t from,
                               triangle_group *out)
{
    const bool first = c->pipeline->raster.provoking_vertex == GN_PROVOKING_FIRST;
    const uint32_t left = piece_count(p) - from;

    out->count = left < LANES ? left : LANES;
    out->stride = 1;
    for (int n = 0; n < 3; ++n)
        out->corner[n] = out->made[n];
    for (uint32_t l = 0; l < LANES; ++l) {
        const uint32_t n = l < out->count ? from + l + 2 : 2;

        out->made[0][l] = p->vertex[first ? 0 : n - 1];
        out->made[1][l] = p->vertex[first ? n - 1 : n];
        out->made[2][l] = p->vertex[first ? n : 0];
    }
}

#endif
