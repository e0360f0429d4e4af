/* Separate triangles of every kind that the clipper and the rasterizer must distinguish. */
#include "generate_parts.h"

#include <math.h>

static float viewport_x(builder *b, float margin)
{
    const gn_viewport v = builder_viewport(b);
    return v.x + v.width * random_float(&b->random, -margin, 1.0f + margin);
}

static float viewport_y(builder *b, float margin)
{
    const gn_viewport v = builder_viewport(b);
    return v.y + v.height * random_float(&b->random, -margin, 1.0f + margin);
}

static float device_depth(builder *b)
{
    return random_float(&b->random, -1.0f, 1.0f);
}

/* Coordinates are integers divided by one of these numbers. With 512 a vertex may be half way
 * between two snapped positions, where rounding goes to the even one. */
static float tie_grain(random_source *r)
{
    static const float grains[] = {1.0f, 2.0f, 2.0f, 2.0f, 4.0f, 4.0f, 256.0f, 512.0f};
    return grains[random_below(r, 8)];
}

static float on_grain(float coordinate, float grain)
{
    return floorf(coordinate * grain) / grain;
}

/* A place within a margin of the viewport, at a depth from -depth to depth. */
static void place_in_viewport(builder *b, vertex *v, float margin, float depth, float w)
{
    const float x = viewport_x(b, margin), y = viewport_y(b, margin);
    builder_place(b, v, x, y, depth * device_depth(b), w);
}

void shape_place(builder *b, vertex *v, placement p)
{
    random_source *r = &b->random;
    switch (p) {
    case PLACE_AFFINE:
        place_in_viewport(b, v, 0.2f, 1.0f, 1.0f);
        break;
    case PLACE_INSIDE:
        place_in_viewport(b, v, -0.001f, 0.99f, random_octave(r, -2, 1));
        break;
    case PLACE_TIES: {
        const float grain = tie_grain(r);
        const float x = on_grain(viewport_x(b, 0.1f), grain);
        const float y = on_grain(viewport_y(b, 0.1f), grain);
        const float z = (float)random_between(r, -4, 4) * 0.25f;
        builder_place(b, v, x, y, z, random_chance(r, 60) ? 1.0f : random_power(r, -3, 3));
        break;
    }
    case PLACE_CLIP:
        for (int c = 0; c < 4; ++c)
            v->position[c] = random_float(r, -2.0f, 2.0f);
        if (random_chance(r, 50))
            v->position[3] = fabsf(v->position[3]);
        break;
    default:
        place_in_viewport(b, v, 0.3f, 1.2f, random_octave(r, -2, 1));
        break;
    }
}

void shape_triangles(builder *b, placement p, uint32_t count)
{
    for (uint32_t i = 0; i < 3 * count; ++i)
        shape_place(b, builder_vertex(b), p);
}

void shape_tiny(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < count; ++i) {
        const float x = viewport_x(b, 0.02f), y = viewport_y(b, 0.02f);
        const float size = random_chance(r, 50) ? random_octave(r, -7, 0) : random_octave(r, 0, 2);
        const float z = device_depth(b);
        const bool affine = random_chance(r, 50);
        for (int k = 0; k < 3; ++k) {
            vertex *v = builder_vertex(b);
            const float dx = random_float(r, -size, size), dy = random_float(r, -size, size);
            const float dz = 0.01f * random_float(r, -1.0f, 1.0f);
            builder_place(b, v, x + dx, y + dy, z + dz, affine ? 1.0f : random_octave(r, -2, 1));
        }
    }
}

void shape_slivers(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < count; ++i) {
        const float x0 = viewport_x(b, 0.2f), y0 = viewport_y(b, 0.2f);
        const bool along = random_chance(r, 25); /* nearly parallel to an axis */
        const bool vertical = random_chance(r, 50);
        const float x1 = along && vertical ? x0 + random_octave(r, -9, 0) : viewport_x(b, 0.2f);
        const float y1 = along && !vertical ? y0 + random_octave(r, -9, 0) : viewport_y(b, 0.2f);
        const float t = random_float(r, -0.1f, 1.1f), thickness = random_octave(r, -12, 0);
        const float x2 = x0 + (x1 - x0) * t + random_float(r, -thickness, thickness);
        const float y2 = y0 + (y1 - y0) * t + random_float(r, -thickness, thickness);
        const bool affine = random_chance(r, 50);
        const float corner[3][2] = {{x0, y0}, {x1, y1}, {x2, y2}};
        const uint32_t turn = random_below(r, 3);
        for (uint32_t k = 0; k < 3; ++k) {
            const float *at = corner[(k + turn) % 3];
            vertex *v = builder_vertex(b);
            const float z = device_depth(b);
            builder_place(b, v, at[0], at[1], z, affine ? 1.0f : random_octave(r, -2, 1));
        }
    }
}

static float snapped(float window)
{
    return rintf((window - 0.5f) * 256.0f);
}

/* Twice the area, counter-clockwise positive. */
static float area_of(float p[3][2])
{
    return (p[0][0] - p[2][0]) * (p[1][1] - p[2][1]) - (p[0][1] - p[2][1]) * (p[1][0] - p[2][0]);
}

static bool in_viewport(const builder *b, const float p[2])
{
    const gn_viewport v = builder_viewport(b);
    return p[0] > v.x && p[0] < v.x + v.width && p[1] > v.y && p[1] < v.y + v.height;
}

void shape_turning(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < count; ++i) {
        float p[3][2], s[3][2];
        bool turned = false;
        for (int attempt = 0; attempt < 100 && !turned; ++attempt) {
            const bool middle = random_chance(r, 50); /* no area before it is snapped */
            const float t = middle ? 0.5f : random_unit(r);
            /* The long side goes through the centre of a pixel, or just beside it. */
            const float x = viewport_x(b, -0.2f), y = viewport_y(b, -0.2f);
            const float centre[2] = {floorf(x) + 0.5f, floorf(y) + 0.5f};
            p[0][0] = on_grain(viewport_x(b, -0.02f), 256.0f);
            p[0][1] = on_grain(viewport_y(b, -0.02f), 256.0f);
            for (int c = 0; c < 2; ++c)
                p[1][c] = 2.0f * centre[c] - p[0][c] + (float)random_between(r, -1, 1) / 256.0f;
            for (int c = 0; c < 2; ++c) {
                const float off = middle ? 0.0f : random_float(r, -0.004f, 0.004f);
                p[2][c] = p[0][c] + (p[1][c] - p[0][c]) * t + off;
            }
            for (int k = 0; k < 3; ++k)
                for (int c = 0; c < 2; ++c)
                    s[k][c] = snapped(p[k][c]);
            const float area = area_of(p), snapped_area = area_of(s);
            turned = in_viewport(b, p[1]) && ((area > 0.0f && snapped_area < 0.0f) ||
                                              (area <= 0.0f && snapped_area > 0.0f) ||
                                              (area == 0.0f && snapped_area != 0.0f));
        }
        for (int k = 0; k < 3; ++k) {
            vertex *v = builder_vertex(b);
            builder_place(b, v, p[k][0], p[k][1], device_depth(b), 1.0f);
        }
    }
}

/* Triangles in pairs that share an edge, so that a tie drawn twice or not at all shows. Half of the
 * time vertices are close together, so that there are many ties. */
void shape_ties(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < count; i += 2) {
        const float grain = tie_grain(r);
        const bool near_each_other = random_chance(r, 50), shared_w = random_chance(r, 50);
        const float w = random_power(r, -3, 3);
        const float x0 = on_grain(viewport_x(b, 0.05f), grain);
        const float y0 = on_grain(viewport_y(b, 0.05f), grain);
        vertex corner[4];
        for (int k = 0; k < 4; ++k) {
            float x = on_grain(viewport_x(b, 0.05f), grain);
            float y = on_grain(viewport_y(b, 0.05f), grain);
            if (near_each_other) {
                x = x0 + (float)random_between(r, -9, 9) / (grain < 4.0f ? grain : 4.0f);
                y = y0 + (float)random_between(r, -9, 9) / (grain < 4.0f ? grain : 4.0f);
            }
            if (k > 0 && random_chance(r, 30)) /* an edge along an axis */
                x = x0;
            else if (k > 0 && random_chance(r, 40))
                y = y0;
            corner[k] = *builder_vertex(b);
            --b->vertex_count;
            const float z = (float)random_between(r, -4, 4) * 0.25f;
            builder_place(b, &corner[k], x, y, z, shared_w ? w : random_power(r, -3, 3));
        }
        static const int order[6] = {0, 1, 2, 2, 1, 3};
        for (uint32_t k = 0; k < (i + 1 < count ? 6u : 3u); ++k)
            *builder_vertex(b) = corner[order[k]];
    }
}

void shape_huge(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < count; ++i) {
        /* Mostly up to 1e5 pixels; from 2^23 on, neighbouring floats are pixels apart. Beyond 2^35
         * the contract ends: clipping an edge twice there leaves vertices so far from the viewport
         * that their snapped coordinates overflow. */
        const float size = random_chance(r, 85)   ? random_octave(r, 8, 16)
                           : random_chance(r, 80) ? random_octave(r, 17, 26)
                                                  : random_octave(r, 27, 34);
        const bool affine = random_chance(r, 50);
        for (int k = 0; k < 3; ++k) {
            const bool small = random_chance(r, 20);
            const float extent = small ? 50.0f : size;
            vertex *v = builder_vertex(b);
            const float x = random_float(r, -extent, extent);
            const float y = random_float(r, -extent, extent);
            const float z = device_depth(b);
            builder_place(b, v, x, y, z, affine ? 1.0f : random_octave(r, -4, 3));
        }
    }
}

void shape_offscreen(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    const gn_viewport v = builder_viewport(b);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t kind = random_below(r, 4);
        const float side = random_chance(r, 50) ? 1.0f : -1.0f;
        const uint32_t axis = random_below(r, 3);
        const bool affine = random_chance(r, 50);
        for (int k = 0; k < 3; ++k) {
            const float w = affine ? random_power(r, -1, 1) : random_octave(r, -2, 1);
            vertex *p = builder_vertex(b);
            place_in_viewport(b, p, kind == 0 ? 3.0f : 0.5f, 2.0f, w);
            /* All vertices are beyond one plane or on it, or one or two of them are inside. */
            if (kind == 1) {
                p->position[axis] = side * w * random_float(r, 1.0f, 3.0f);
            } else if (kind == 2 && random_chance(r, 60)) {
                p->position[axis] = side * w;
            } else if (kind == 3 && random_chance(r, 60)) {
                const float x = v.x + v.width * (float)random_between(r, -1, 2);
                const float y = v.y + v.height * (float)random_between(r, -1, 2);
                builder_place(b, p, x, y, (float)random_between(r, -2, 2), w);
            }
        }
    }
}

void shape_behind(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t behind = random_below(r, 4), first = random_below(r, 3);
        const float spread = random_octave(r, -1, 2);
        for (uint32_t k = 0; k < 3; ++k) {
            vertex *p = builder_vertex(b);
            for (int c = 0; c < 3; ++c)
                p->position[c] = random_float(r, -spread, spread);
            p->position[3] = random_octave(r, -3, 1);
            if ((k + first) % 3 < behind)
                p->position[3] = -p->position[3];
        }
    }
}

/* A perspective camera at the origin among triangles on all sides of it. */
void shape_near_crossing(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    const float z_near = random_octave(r, -5, 0), z_far = z_near * random_octave(r, 1, 8);
    const float a = (z_far + z_near) / (z_near - z_far);
    const float c = 2.0f * z_far * z_near / (z_near - z_far);
    const float zoom = random_octave(r, -1, 1);
    for (uint32_t i = 0; i < count; ++i) {
        const float extent = z_near * random_octave(r, 0, 5);
        for (int k = 0; k < 3; ++k) {
            const float x = random_float(r, -extent, extent);
            const float y = random_float(r, -extent, extent);
            const float z = random_float(r, -2.0f * extent, 0.5f * extent);
            vertex *p = builder_vertex(b);
            p->position[0] = zoom * x;
            p->position[1] = zoom * y;
            p->position[2] = a * z + c;
            p->position[3] = -z;
        }
    }
}

/* A clip position of w = 0 that is not the origin: a point at infinity. At most one vertex of a
 * triangle is on an axis or a coordinate plane: an edge between two such vertices may go through
 * the origin, and the contract leaves out a clipped vertex of 0, 0, 0, 0. */
static void place_at_infinity(builder *b, vertex *v, bool on_axis)
{
    random_source *r = &b->random;
    do {
        for (int c = 0; c < 3; ++c)
            v->position[c] = on_axis && random_chance(r, 50) ? 0.0f : random_float(r, -1.0f, 1.0f);
    } while (v->position[0] == 0.0f && v->position[1] == 0.0f && v->position[2] == 0.0f);
    v->position[3] = 0.0f;
}

void shape_degenerate(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < count; ++i) {
        const placement p = (placement)random_below(r, PLACE_COUNT);
        shape_triangles(b, p, 1);
        vertex *v = b->vertices + b->vertex_count - 3;
        const uint32_t k = random_below(r, 3), other = (k + 1 + random_below(r, 2)) % 3;
        switch (random_below(r, 7)) {
        case 0: /* two corners equal, sometimes all three */
            v[k] = v[other];
            if (random_chance(r, 30))
                v[3 - k - other] = v[other];
            break;
        case 1: { /* exactly collinear: on a row, a column or a diagonal */
            const float x = on_grain(viewport_x(b, 0.1f), 2.0f);
            const float y = on_grain(viewport_y(b, 0.1f), 2.0f);
            const int32_t dx = random_between(r, -1, 1), dy = random_between(r, -1, 1);
            for (int n = 0; n < 3; ++n) {
                const float t = (float)random_between(r, -20, 20) * 0.5f;
                const float z = device_depth(b);
                builder_place(b, &v[n], x + (float)dx * t, y + (float)dy * t, z,
                              random_power(r, -2, 2));
            }
            break;
        }
        case 2: { /* little or no area after snapping to 1/256 pixel */
            const float x = on_grain(viewport_x(b, 0.0f), 2.0f);
            const float y = on_grain(viewport_y(b, 0.0f), 2.0f);
            for (int n = 0; n < 3; ++n) {
                const float dx = random_float(r, -0.006f, 0.006f);
                const float dy = random_float(r, -0.006f, 0.006f);
                builder_place(b, &v[n], x + dx, y + dy, device_depth(b), 1.0f);
            }
            break;
        }
        case 3:
            place_at_infinity(b, &v[k], random_chance(r, 60));
            if (random_chance(r, 30))
                place_at_infinity(b, &v[other], false);
            break;
        case 4: /* all of them at w = 0 */
            for (int n = 0; n < 3; ++n)
                place_at_infinity(b, &v[n], n == 0 && random_chance(r, 50));
            break;
        case 5: /* without extent in depth, or seen from the side */
            for (int n = 0; n < 3; ++n)
                v[n].position[random_chance(r, 50) ? 2 : 0] = 0.0f;
            break;
        default: /* an ordinary triangle, so that something is drawn */
            break;
        }
    }
}
