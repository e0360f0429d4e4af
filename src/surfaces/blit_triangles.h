/* A scaled blit as the reference draws it: two triangles, clipped to the destination, over which
 * texture coordinates are planes. This affects only the low bits of the coordinates, and so
 * which texel is read by a pixel whose centre falls between two texels (reference/RULES.md). */
#ifndef GN_SURFACES_BLIT_TRIANGLES_H
#define GN_SURFACES_BLIT_TRIANGLES_H

#include "../lanes/lanes.h"
#include <gnomon/blit.h>

/* A triangle has three vertices; clipping adds at most one for each side of the destination. */
#define BLIT_POLYGON 7
#define BLIT_TRIANGLES (2 * (BLIT_POLYGON - 2))

typedef struct blit_vertex {
    float clip[2], texture[2], window[2];
    int32_t snapped[2];
} blit_vertex;

/* A triangle. A pixel (x, y) is inside if start - 256 * per_x * x + 256 * per_y * y > 0 for all
 * three edges. A coordinate of the texture is per_y * y + (per_x * x + origin). */
typedef struct blit_triangle {
    struct {
        int64_t start;
        int32_t per_x, per_y;
    } edge[3];
    struct {
        float origin, per_x, per_y;
    } plane[2];
} blit_triangle;

typedef struct blit_triangles {
    blit_triangle triangle[BLIT_TRIANGLES];
    uint32_t count;
    float scale[2]; /* of the viewport: half of the destination's size */
} blit_triangles;

static inline void place_blit_vertex(const blit_triangles *all, blit_vertex *v)
{
    int32_t rounded[GN_LANES];

    for (int c = 0; c < 2; ++c) {
        v->window[c] = v->clip[c] * all->scale[c] + all->scale[c];
        lanes_i_store(rounded, lanes_round(lanes_splat((v->window[c] - 0.5f) * 256.0f)));
        v->snapped[c] = rounded[0];
    }
}

/* The sides of the destination, in the order of clipping. */
enum { BLIT_RIGHT, BLIT_LEFT, BLIT_TOP, BLIT_BOTTOM, BLIT_SIDES };

/* Returns the distance of a vertex from a side; not negative inside. */
static inline float blit_distance(const blit_vertex *v, int side)
{
    const float c = v->clip[side / 2];

    return side % 2 != 0 ? c + 1.0f : 1.0f - c;
}

/* Writes a new vertex at p + t * (q - p). Texture coordinates are interpolated in the window, as
 * noperspective varyings are. */
static inline void make_blit_vertex(const blit_triangles *all, blit_vertex *made,
                                    const blit_vertex *p, const blit_vertex *q, float t)
{
    const int along = q->clip[0] != p->clip[0] ? 0 : 1;

    for (int c = 0; c < 2; ++c)
        made->clip[c] = p->clip[c] + t * (q->clip[c] - p->clip[c]);
    if (q->clip[along] != p->clip[along])
        t = (made->clip[along] - p->clip[along]) / (q->clip[along] - p->clip[along]);
    for (int c = 0; c < 2; ++c)
        made->texture[c] = p->texture[c] + t * (q->texture[c] - p->texture[c]);
    place_blit_vertex(all, made);
}

/* Clips a polygon to a side, as triangles are clipped (kernel/geometry/clip.inl). Returns the
 * number of vertices. */
static inline uint32_t clip_blit(const blit_triangles *all, int side, const blit_vertex *in,
                                 uint32_t count, blit_vertex *out)
{
    const blit_vertex *previous = &in[0];
    float previous_distance = blit_distance(previous, side);
    uint32_t made = 0;

    for (uint32_t n = 1; n <= count; ++n) {
        const blit_vertex *const current = &in[n == count ? 0 : n];
        const float distance = blit_distance(current, side);

        if (made + 2 > BLIT_POLYGON)
            return 0;
        if (previous_distance >= 0.0f)
            out[made++] = *previous;
        if ((distance < 0.0f) != (previous_distance < 0.0f)) {
            const float span = distance - previous_distance;
            const bool leaving = distance < 0.0f;
            const float outside = leaving ? -distance : -previous_distance;
            const float inside = leaving ? previous_distance : distance;

            if (leaving == (outside < inside))
                make_blit_vertex(all, &out[made++], current, previous, distance / span);
            else
                make_blit_vertex(all, &out[made++], previous, current, -previous_distance / span);
        }
        previous = current;
        previous_distance = distance;
    }
    return made;
}

/* Sets up a triangle as draws do (kernel/raster/setup.inl). Triangles of a blit are
 * counter-clockwise, so their first two vertices are exchanged. */
static inline void add_blit_triangle(blit_triangles *all, const blit_vertex *first,
                                     const blit_vertex *second, const blit_vertex *c)
{
    const blit_vertex *const a = second;
    const blit_vertex *const b = first;
    const blit_vertex *const v[3] = {a, b, c};
    blit_triangle *const triangle = &all->triangle[all->count];
    const int64_t area =
        (int64_t)(a->snapped[0] - b->snapped[0]) * (c->snapped[1] - a->snapped[1]) -
        (int64_t)(c->snapped[0] - a->snapped[0]) * (a->snapped[1] - b->snapped[1]);

    if (area <= 0)
        return;
    ++all->count;
    for (int i = 0; i < 3; ++i) {
        const int32_t *const from = v[i]->snapped;
        const int32_t *const to = v[i == 2 ? 0 : i + 1]->snapped;
        const int32_t per_x = from[1] - to[1];
        const int32_t per_y = from[0] - to[0];
        const bool owns_ties = per_x < 0 || (per_x == 0 && per_y > 0);

        triangle->edge[i].start = (int64_t)per_x * from[0] - (int64_t)per_y * from[1] + owns_ties;
        triangle->edge[i].per_x = per_x;
        triangle->edge[i].per_y = per_y;
    }

    float dx01 = a->window[0] - b->window[0];
    float dy01 = a->window[1] - b->window[1];
    float dx20 = c->window[0] - a->window[0];
    float dy20 = c->window[1] - a->window[1];
    const float one_over_area = 1.0f / (dx01 * dy20 - dx20 * dy01);
    dx01 *= one_over_area;
    dy01 *= one_over_area;
    dx20 *= one_over_area;
    dy20 *= one_over_area;
    for (int n = 0; n < 2; ++n) {
        const float da01 = a->texture[n] - b->texture[n];
        const float da20 = c->texture[n] - a->texture[n];
        const float per_x = da01 * dy20 - da20 * dy01;
        const float per_y = da20 * dx01 - da01 * dx20;

        triangle->plane[n].per_x = per_x;
        triangle->plane[n].per_y = per_y;
        triangle->plane[n].origin =
            a->texture[n] - (per_x * (a->window[0] - 0.5f) + per_y * (a->window[1] - 0.5f));
    }
}

static inline void add_clipped_triangle(blit_triangles *all, const blit_vertex *a,
                                        const blit_vertex *b, const blit_vertex *c)
{
    blit_vertex polygon[2][BLIT_POLYGON];
    blit_vertex *in = polygon[0];
    blit_vertex *out = polygon[1];
    uint32_t count = 3;
    bool is_clipped = false;

    in[0] = *a;
    in[1] = *b;
    in[2] = *c;
    for (int side = 0; side < BLIT_SIDES; ++side) {
        if (blit_distance(a, side) >= 0.0f && blit_distance(b, side) >= 0.0f &&
            blit_distance(c, side) >= 0.0f)
            continue;
        is_clipped = true;
        count = clip_blit(all, side, in, count, out);
        if (count < 3)
            return;
        blit_vertex *const swap = in;
        in = out;
        out = swap;
    }
    if (!is_clipped) {
        add_blit_triangle(all, a, b, c);
        return;
    }
    for (uint32_t n = 2; n < count; ++n)
        add_blit_triangle(all, &in[n - 1], &in[n], &in[0]);
}

/* Sets up the triangles of a blit. Precondition: `to` is not mirrored. Texture coordinates are from
 * 0 to 1 over the source. */
static inline void set_blit_triangles(blit_triangles *all, const gn_surface *destination,
                                      const gn_rectangle *to, const gn_surface *source,
                                      const gn_rectangle *from)
{
    const float width = (float)destination->width;
    const float height = (float)destination->height;
    blit_vertex corner[4];

    all->count = 0;
    all->scale[0] = 0.5f * width;
    all->scale[1] = 0.5f * height;
    for (int n = 0; n < 4; ++n) {
        const bool right = n == 1 || n == 2;
        const bool top = n >= 2;
        blit_vertex *const v = &corner[n];

        v->clip[0] = (float)(right ? to->x1 : to->x0) / width * 2.0f - 1.0f;
        v->clip[1] = (float)(top ? to->y1 : to->y0) / height * 2.0f - 1.0f;
        v->texture[0] = (float)(right ? from->x1 : from->x0) / (float)source->width;
        v->texture[1] = (float)(top ? from->y1 : from->y0) / (float)source->height;
        place_blit_vertex(all, v);
    }
    add_clipped_triangle(all, &corner[0], &corner[1], &corner[2]);
    add_clipped_triangle(all, &corner[0], &corner[2], &corner[3]);
}

/* Returns whether a pixel is on the inner side of edge i. */
static inline bool is_inside(const blit_triangle *p, int i, int32_t x, int32_t y)
{
    return p->edge[i].start - 256 * (int64_t)p->edge[i].per_x * x +
               256 * (int64_t)p->edge[i].per_y * y >
           0;
}

/* Narrows *first to *end to the columns of row y that a triangle covers. */
static inline void covered_columns(const blit_triangle *p, int32_t y, int32_t *first, int32_t *end)
{
    for (int i = 0; i < 3 && *first < *end; ++i) {
        const bool begins_inside = is_inside(p, i, *first, y);
        int32_t low = *first;
        int32_t high = *end - 1;

        if (begins_inside == is_inside(p, i, high, y)) {
            if (!begins_inside)
                *end = *first;
            continue;
        }
        /* The edge passes between low and high. */
        while (high - low > 1) {
            const int32_t middle = (low + high) / 2;

            if (is_inside(p, i, middle, y) == begins_inside)
                low = middle;
            else
                high = middle;
        }
        if (begins_inside)
            *end = high;
        else
            *first = high;
    }
}

#endif
