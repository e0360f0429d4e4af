#include "primitive_clip.h"

#include <math.h>

static uint32_t lowest_bit(uint32_t bits)
{
    uint32_t i = 0;

    while (!(bits >> i & 1u))
        ++i;
    return i;
}

/* Both ends are reckoned from where the line began, as in the reference. */
bool clip_line(const placement *place, const shaded_vertex *a, const shaded_vertex *b,
               shaded_vertex to[2])
{
    GLfloat from_a = 0.0f, from_b = 0.0f;

    to[0] = *a;
    to[1] = *b;
    if (a->outside & b->outside)
        return false;
    for (uint32_t planes = a->outside | b->outside; planes; planes &= planes - 1) {
        const uint32_t plane = lowest_bit(planes);
        const GLfloat at_a = plane_distance(place, a, plane);
        const GLfloat at_b = plane_distance(place, b, plane);

        if (!isfinite(at_a) || !isfinite(at_b))
            return false;
        if (at_b < 0.0f)
            from_b = fmaxf(from_b, at_b / (at_b - at_a));
        if (at_a < 0.0f)
            from_a = fmaxf(from_a, at_a / (at_a - at_b));
        if (from_a + from_b >= 1.0f)
            return false;
    }
    if (a->outside) {
        set_vertex_between(place, a, b, from_a, &to[0]);
        copy_flat_varyings(place, b, &to[0]);
    }
    if (b->outside)
        set_vertex_between(place, b, a, from_b, &to[1]);
    return true;
}

/* Returns the vertex on a plane between two vertices, reckoned from the one that is nearer to it.
 */
static const shaded_vertex *vertex_on_plane(const placement *place, clipped_polygon *polygon,
                                            const shaded_vertex *before, GLfloat at_before,
                                            const shaded_vertex *after, GLfloat at_after)
{
    const bool is_after_nearer = at_after < 0.0f ? -at_after < at_before : !(-at_before < at_after);
    const GLfloat denominator = at_after - at_before;
    shaded_vertex *const made = &polygon->memory[polygon->made++];

    copy_flat_varyings(place, polygon->provoking, made);
    if (is_after_nearer)
        set_vertex_between(place, after, before, at_after / denominator, made);
    else
        set_vertex_between(place, before, after, -at_before / denominator, made);
    return made;
}

/* Cuts a polygon by one plane. Returns false if a distance is no number. The edge along a plane of
 * the view volume is none, along one of the program it is. */
static bool cut(const placement *place, uint32_t plane, clipped_polygon *polygon)
{
    const uint32_t count = polygon->count;
    const shaded_vertex *to[MOST_CLIPPED + 1];
    bool has_edge[MOST_CLIPPED + 1];
    uint32_t kept = 0;
    GLfloat at_before = plane_distance(place, polygon->vertex[0], plane);

    if (!isfinite(at_before))
        return false;
    for (uint32_t i = 0; i < count; ++i) {
        const shaded_vertex *const before = polygon->vertex[i];
        const shaded_vertex *const after = polygon->vertex[(i + 1) % count];
        const GLfloat at_after = plane_distance(place, after, plane);
        const bool was_inside = at_before >= 0.0f;

        if (!isfinite(at_after))
            return false;
        /* Rounding can make a convex polygon cross a plane more than twice. */
        if (kept + 2 > MOST_CLIPPED || polygon->made == MOST_MADE)
            return false;
        if (was_inside) {
            has_edge[kept] = polygon->has_edge[i];
            to[kept++] = before;
        }
        if (was_inside != !(at_after < 0.0f)) {
            has_edge[kept] = was_inside ? plane >= VOLUME_PLANES : polygon->has_edge[i];
            to[kept++] = vertex_on_plane(place, polygon, before, at_before, after, at_after);
        }
        at_before = at_after;
    }
    for (uint32_t i = 0; i < kept; ++i) {
        polygon->vertex[i] = to[i];
        polygon->has_edge[i] = has_edge[i];
    }
    polygon->count = kept;
    return true;
}

void clip_triangle(const placement *place, const shaded_vertex *const v[3], unsigned edges,
                   clipped_polygon *polygon)
{
    polygon->count = 0;
    polygon->made = 0;
    polygon->provoking = v[2];
    if (v[0]->outside & v[1]->outside & v[2]->outside)
        return;
    polygon->count = 3;
    for (int i = 0; i < 3; ++i) {
        polygon->vertex[i] = v[i];
        polygon->has_edge[i] = edges >> i & 1u;
    }
    for (uint32_t planes = v[0]->outside | v[1]->outside | v[2]->outside;
         planes && polygon->count >= 3; planes &= planes - 1)
        if (!cut(place, lowest_bit(planes), polygon))
            polygon->count = 0;
    if (polygon->count < 3) {
        polygon->count = 0;
    } else if (polygon->vertex[0] != v[2]) {
        shaded_vertex *const first = &polygon->memory[polygon->made++];

        *first = *polygon->vertex[0];
        copy_flat_varyings(place, v[2], first);
        polygon->vertex[0] = first;
    }
}
