/* Cuts polygons into triangles: ear clipping in the plane of Newell's normal (Meisters, "Polygons
 * have ears", 1975). A convex polygon is a fan around its first corner. */
#include "polygon.h"

#include <math.h>

/* Turns below this, beside the square of the polygon's size, are rounding: the corner is straight.
 */
#define STRAIGHT 1e-12

/* No corner. */
#define NOTHING UINT32_MAX

static void add_triangle(polygon *p, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *const triangle = p->triangles + p->index_count;
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
    p->index_count += 3;
}

/* Twice the area of a triangle, positive if it turns left. */
static double turn_of(const polygon_corner *a, const polygon_corner *b, const polygon_corner *c)
{
    return (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
}

/* Newell's normal: the sum of the cross products of neighbours, from the first corner. */
static void find_normal(polygon *p)
{
    const double *const origin = p->corners[0].position;
    p->normal[0] = p->normal[1] = p->normal[2] = 0.0;
    for (size_t i = 1; i + 1 < p->count; ++i) {
        double a[3], b[3];
        for (int c = 0; c < 3; ++c) {
            a[c] = p->corners[i].position[c] - origin[c];
            b[c] = p->corners[i + 1].position[c] - origin[c];
        }
        p->normal[0] += a[1] * b[2] - a[2] * b[1];
        p->normal[1] += a[2] * b[0] - a[0] * b[2];
        p->normal[2] += a[0] * b[1] - a[1] * b[0];
    }
}

/* Projects the corners along the normal onto the two axes across its longest component, so that
 * the polygon turns left. Returns the size in the plane, or 0 if there is no normal. A projection
 * along the normal is an affine image of the polygon in its plane, and exact if the normal is an
 * axis. */
static double project(polygon *p)
{
    const double *const n = p->normal, *const origin = p->corners[0].position;
    int axis = fabs(n[1]) > fabs(n[0]);
    axis = fabs(n[2]) > fabs(n[axis]) ? 2 : axis;
    if (!(fabs(n[axis]) > 0.0) || !isfinite(n[0] + n[1] + n[2]))
        return 0.0;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double slope_u = n[u] / n[axis], slope_v = n[v] / n[axis];
    double size = 0.0;
    for (size_t i = 0; i < p->count; ++i) {
        polygon_corner *const corner = p->corners + i;
        const double depth = corner->position[axis] - origin[axis];
        corner->x = corner->position[u] - origin[u] - depth * slope_u;
        corner->y = corner->position[v] - origin[v] - depth * slope_v;
        if (n[axis] < 0.0)
            corner->x = -corner->x;
        size = fabs(corner->x) > size ? fabs(corner->x) : size;
        size = fabs(corner->y) > size ? fabs(corner->y) : size;
    }
    return size;
}

static void compute_turn(polygon *p, uint32_t corner)
{
    polygon_corner *const c = p->corners + corner;
    c->turn = turn_of(p->corners + c->previous, c, p->corners + c->next);
    c->blocker = NOTHING;
}

static bool is_same_place(const polygon_corner *a, const polygon_corner *b)
{
    return a->x == b->x && a->y == b->y;
}

/* Whether corner k is in the way of cutting off b: it does not turn left, and lies in the triangle
 * or on its edge, but on none of its corners. Some corner that does not turn left lies there if
 * any corner does. */
static bool blocks(const polygon *p, uint32_t k, uint32_t b, double straight)
{
    const polygon_corner *const at = p->corners + k, *const corner = p->corners + b;
    const polygon_corner *const a = p->corners + corner->previous;
    const polygon_corner *const c = p->corners + corner->next;
    return at->turn <= straight && turn_of(a, corner, at) >= 0.0 && turn_of(corner, c, at) >= 0.0 &&
           turn_of(c, a, at) >= 0.0 && !is_same_place(at, a) && !is_same_place(at, corner) &&
           !is_same_place(at, c);
}

/* A corner that was cut off has itself as its next. */
static bool is_left(const polygon *p, uint32_t corner)
{
    return p->corners[corner].next != corner;
}

/* Whether a corner can be cut off. The corner that was last in the way is looked at first: while
 * it is, the others need not be. */
static bool is_ear(polygon *p, uint32_t b, double straight)
{
    polygon_corner *const corner = p->corners + b;
    if (corner->turn <= straight)
        return false;
    if (corner->blocker != NOTHING && is_left(p, corner->blocker) &&
        blocks(p, corner->blocker, b, straight))
        return false;
    corner->blocker = NOTHING;
    for (uint32_t k = p->corners[corner->next].next; k != corner->previous && p->work_left > 0;
         k = p->corners[k].next) {
        --p->work_left;
        if (blocks(p, k, b, straight)) {
            corner->blocker = k;
            return false;
        }
    }
    return true;
}

/* Takes a corner out. Returns the one behind the next: to go on there keeps triangles compact. */
static uint32_t take_out(polygon *p, uint32_t corner)
{
    const uint32_t previous = p->corners[corner].previous, next = p->corners[corner].next;
    p->corners[previous].next = next;
    p->corners[next].previous = previous;
    p->corners[corner].next = corner;
    compute_turn(p, previous);
    compute_turn(p, next);
    return p->corners[next].next;
}

/* Whether the border goes back on itself here, or stands still. */
static bool is_spike(const polygon *p, uint32_t corner, double straight)
{
    const polygon_corner *const b = p->corners + corner;
    const polygon_corner *const a = p->corners + b->previous, *const c = p->corners + b->next;
    return fabs(b->turn) <= straight &&
           (a->x - b->x) * (c->x - b->x) + (a->y - b->y) * (c->y - b->y) >= 0.0;
}

/* Takes out spikes and repeated corners, which no triangle needs. Returns a corner that is left. */
static uint32_t take_out_spikes(polygon *p, double straight, size_t *left)
{
    uint32_t at = 0;
    for (size_t good = 0; good<*left && * left> 3;) {
        const polygon_corner *const corner = p->corners + at;
        const uint32_t previous = corner->previous, next = corner->next;
        if (!is_spike(p, at, straight)) {
            ++good;
            at = next;
            continue;
        }
        take_out(p, at);
        --*left;
        good = 0;
        at = previous;
    }
    return at;
}

/* Cuts off ears until three corners are left. Returns false if there are more and no ear. */
static bool cut_ears(polygon *p, double straight, uint32_t *first, size_t *left)
{
    uint32_t straight_corner = NOTHING;
    size_t misses = 0;
    uint32_t at = take_out_spikes(p, straight, left);
    while (*left > 3 && p->work_left > 0) {
        polygon_corner *const corner = p->corners + at;
        *first = at;
        --p->work_left;
        if (is_ear(p, at, straight)) {
            add_triangle(p, corner->previous, at, corner->next);
        } else {
            if (fabs(corner->turn) <= straight)
                straight_corner = at;
            if (++misses < *left) {
                at = corner->next;
                continue;
            }
            if (straight_corner == NOTHING)
                return false;
            at = straight_corner;
        }
        at = take_out(p, at);
        straight_corner = NOTHING;
        misses = 0;
        --*left;
    }
    *first = at;
    return *left == 3 && p->corners[at].turn >= -straight;
}

/* A fan of the corners that are left, `left` of them, around one of them. */
static void add_fan(polygon *p, uint32_t first, size_t left)
{
    uint32_t b = p->corners[first].next;
    for (size_t i = 2; i < left; ++i, b = p->corners[b].next)
        add_triangle(p, first, b, p->corners[b].next);
}

bool polygon_cut(model_reader *r, polygon *p, bool *is_simple)
{
    const size_t count = p->count;
    *is_simple = true;
    p->index_count = 0;
    if (!reader_grow(r, &p->triangles, &p->triangle_room, 3 * count, sizeof *p->triangles))
        return false;
    find_normal(p);
    if (count == 3) {
        add_triangle(p, 0, 1, 2);
        return true;
    }
    const double size = project(p), straight = STRAIGHT * size * size;
    bool is_convex = true;
    for (uint32_t i = 0; i < count; ++i) {
        p->corners[i].previous = i > 0 ? i - 1 : (uint32_t)count - 1;
        p->corners[i].next = i + 1 < count ? i + 1 : 0;
    }
    for (uint32_t i = 0; i < count && size > 0.0; ++i) {
        compute_turn(p, i);
        is_convex = is_convex && p->corners[i].turn > straight;
    }
    uint32_t first = 0;
    size_t left = count;
    if (!is_convex)
        *is_simple = cut_ears(p, straight, &first, &left);
    /* Three corners in a line are no triangle if others are. */
    if (left > 3 || p->index_count == 0 || fabs(p->corners[first].turn) > straight)
        add_fan(p, first, left);
    return true;
}

bool polygon_begin(model_reader *r, polygon *p, size_t count)
{
    p->count = count;
    return reader_grow(r, &p->corners, &p->room, count, sizeof *p->corners);
}

void polygon_release(model_reader *r, polygon *p)
{
    reader_release(r, p->corners, p->room, sizeof *p->corners);
    reader_release(r, p->triangles, p->triangle_room, sizeof *p->triangles);
    p->corners = NULL;
    p->triangles = NULL;
    p->room = p->triangle_room = 0;
}
