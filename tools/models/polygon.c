/* Divides polygons into triangles by cutting off ears. */
#include "polygon.h"

#include <math.h>

/* A corner in the polygon's plane, in the ring of those that are left. */
typedef struct ring_corner {
    double x, y;
    uint32_t previous, next;
    bool is_ear;
} ring_corner;

/* Which coordinates are x and y in the plane: the axis nearest to the normal is left out, so that
 * areas keep their signs and no triangle collapses. */
typedef struct plane {
    int x, y;
} plane;

/* Sums the normal by Newell's method (Sutherland, Sproull and Schumacker, "A Characterization of
 * Ten Hidden-Surface Algorithms", 1974), from the first corner so that distant polygons keep their
 * bits. Returns false if the polygon has no area. */
static bool choose_plane(const double *corners, size_t count, plane *p)
{
    double normal[3] = {0.0, 0.0, 0.0};
    for (size_t i = 1; i + 1 < count; ++i) {
        double a[3], b[3];
        for (size_t c = 0; c < 3; ++c) {
            a[c] = corners[3 * i + c] - corners[c];
            b[c] = corners[3 * i + 3 + c] - corners[c];
        }
        normal[0] += a[1] * b[2] - a[2] * b[1];
        normal[1] += a[2] * b[0] - a[0] * b[2];
        normal[2] += a[0] * b[1] - a[1] * b[0];
    }
    int axis = 0;
    for (int c = 1; c < 3; ++c)
        if (fabs(normal[c]) > fabs(normal[axis]))
            axis = c;
    const bool is_positive = normal[axis] > 0.0;
    p->x = (axis + (is_positive ? 1 : 2)) % 3;
    p->y = (axis + (is_positive ? 2 : 1)) % 3;
    return fabs(normal[axis]) > 0.0 && isfinite(normal[axis]);
}

/* Twice the area of a triangle; positive if it turns left. */
static double area(double ax, double ay, double bx, double by, double cx, double cy)
{
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

/* Whether the polygon turns left at every corner: it is convex, unless it crosses itself. */
static bool is_convex(const double *corners, size_t count, plane p)
{
    for (size_t i = 0; i < count; ++i) {
        const double *const a = corners + 3 * i;
        const double *const b = corners + 3 * ((i + 1) % count);
        const double *const c = corners + 3 * ((i + 2) % count);
        if (!(area(a[p.x], a[p.y], b[p.x], b[p.y], c[p.x], c[p.y]) > 0.0))
            return false;
    }
    return true;
}

static void write_fan(size_t count, uint32_t *triangles)
{
    for (size_t i = 0; i + 2 < count; ++i) {
        triangles[3 * i] = 0;
        triangles[3 * i + 1] = (uint32_t)(i + 1);
        triangles[3 * i + 2] = (uint32_t)(i + 2);
    }
}

static bool turns_left(const ring_corner *ring, uint32_t corner)
{
    const ring_corner *const b = ring + corner;
    const ring_corner *const a = ring + b->previous, *const c = ring + b->next;
    return area(a->x, a->y, b->x, b->y, c->x, c->y) > 0.0;
}

static bool is_same_place(const ring_corner *a, const ring_corner *b)
{
    return a->x == b->x && a->y == b->y;
}

/* A corner is an ear if it turns left and no other corner lies in its triangle or on its edge.
 * Corners in the same place as one of the triangle's, as at the bridge to a hole, do not count. */
static bool is_ear(const ring_corner *ring, uint32_t corner)
{
    const ring_corner *const b = ring + corner;
    const ring_corner *const a = ring + b->previous, *const c = ring + b->next;
    if (!turns_left(ring, corner))
        return false;
    for (const ring_corner *q = ring + c->next; q != a; q = ring + q->next)
        if (area(a->x, a->y, b->x, b->y, q->x, q->y) >= 0.0 &&
            area(b->x, b->y, c->x, c->y, q->x, q->y) >= 0.0 &&
            area(c->x, c->y, a->x, a->y, q->x, q->y) >= 0.0 && !is_same_place(q, a) &&
            !is_same_place(q, b) && !is_same_place(q, c))
            return false;
    return true;
}

/* The first ear from a corner on. Only rounding, or a polygon that crosses itself, leaves none:
 * then a corner that turns left, or any. */
static uint32_t choose_ear(const ring_corner *ring, uint32_t first)
{
    uint32_t left = UINT32_MAX, at = first;
    do {
        if (ring[at].is_ear)
            return at;
        if (left == UINT32_MAX && turns_left(ring, at))
            left = at;
        at = ring[at].next;
    } while (at != first);
    return left != UINT32_MAX ? left : first;
}

static void cut_ears(ring_corner *ring, size_t count, uint32_t *triangles)
{
    uint32_t first = 0;
    for (uint32_t i = 0; i < count; ++i)
        ring[i].is_ear = is_ear(ring, i);
    for (size_t left = count; left > 2; --left) {
        const uint32_t ear = choose_ear(ring, first);
        const uint32_t previous = ring[ear].previous, next = ring[ear].next;
        triangles[0] = previous;
        triangles[1] = ear;
        triangles[2] = next;
        triangles += 3;
        ring[previous].next = next;
        ring[next].previous = previous;
        /* Only the triangles of the two neighbours change. */
        ring[previous].is_ear = is_ear(ring, previous);
        ring[next].is_ear = is_ear(ring, next);
        first = next;
    }
}

bool polygon_triangulate(model_reader *r, const double *corners, size_t count, uint32_t *triangles)
{
    plane p;
    write_fan(count, triangles);
    if (count <= 3 || !choose_plane(corners, count, &p) || is_convex(corners, count, p))
        return true;
    if (count > POLYGON_MAX_CORNERS) {
        reader_warn(r, NULL, "a polygon with more than %d corners is drawn as if it were convex",
                    POLYGON_MAX_CORNERS);
        return true;
    }
    ring_corner *const ring = reader_allocate(r, count, sizeof *ring);
    if (ring == NULL)
        return false;
    for (size_t i = 0; i < count; ++i) {
        ring[i].x = corners[3 * i + (size_t)p.x];
        ring[i].y = corners[3 * i + (size_t)p.y];
        ring[i].previous = (uint32_t)((i + count - 1) % count);
        ring[i].next = (uint32_t)((i + 1) % count);
    }
    cut_ears(ring, count, triangles);
    reader_release(r, ring, count, sizeof *ring);
    return true;
}
