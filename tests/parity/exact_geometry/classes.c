/* Random triangles in clip space. */
#include "classes.h"

#include <math.h>

const char *class_name(triangle_class c)
{
    static const char *const names[] = {
        "w = 1, inside",           "perspective, inside",   "smaller than 4 pixels",
        "up to 512 pixels",        "clipped by any planes", "through the plane of the eye",
        "random clip positions",   "corners on planes",     "2^8 to 2^16 pixels",
        "2^17 to 2^26 pixels",     "1 to 1/16 pixel thin",  "1/16 to 1/256 pixel thin",
        "thinner than 1/256 pixel"};

    return names[c];
}

/* Sets the position that the viewport maps to the window's (x, y), about. */
static void place(const gn_viewport *v, float x, float y, float z, float w, float position[4])
{
    position[0] = (2.0f * (x - v->x) / v->width - 1.0f) * w;
    position[1] = (2.0f * (y - v->y) / v->height - 1.0f) * w;
    position[2] = z * w;
    position[3] = w;
}

/* A window coordinate within a margin of the viewport, as a part of its size. */
static float window_x(random_source *r, const gn_viewport *v, float margin)
{
    return v->x + v->width * random_float(r, -margin, 1.0f + margin);
}

static float window_y(random_source *r, const gn_viewport *v, float margin)
{
    return v->y + v->height * random_float(r, -margin, 1.0f + margin);
}

static void place_somewhere(random_source *r, const gn_viewport *v, float margin, float depth,
                            float w, float position[4])
{
    const float x = window_x(r, v, margin);
    const float y = window_y(r, v, margin);

    place(v, x, y, random_float(r, -depth, depth), w, position);
}

static void make_small(random_source *r, const gn_viewport *v, clip_vertex vertex[3])
{
    const float x = window_x(r, v, -0.05f);
    const float y = window_y(r, v, -0.05f);
    const float z = random_float(r, -0.9f, 0.9f);

    for (int k = 0; k < 3; ++k) {
        const float dx = random_float(r, -2.0f, 2.0f);
        const float dy = random_float(r, -2.0f, 2.0f);
        const float dz = random_float(r, -0.05f, 0.05f);

        place(v, x + dx, y + dy, z + dz, random_octave(r, -2, 1), vertex[k].position);
    }
}

/* A camera at the origin, and triangles on all sides of it. */
static void make_behind(random_source *r, clip_vertex vertex[3])
{
    const float z_near = random_octave(r, -5, 0);
    const float z_far = z_near * random_octave(r, 1, 8);
    const float a = (z_far + z_near) / (z_near - z_far);
    const float b = 2.0f * z_far * z_near / (z_near - z_far);
    const float zoom = random_octave(r, -1, 1);
    const float extent = z_near * random_octave(r, 0, 5);

    for (int k = 0; k < 3; ++k) {
        const float z = random_float(r, -2.0f * extent, 0.7f * extent);
        float *const position = vertex[k].position;

        position[0] = zoom * random_float(r, -extent, extent);
        position[1] = zoom * random_float(r, -extent, extent);
        position[2] = a * z + b;
        position[3] = -z;
    }
}

/* Two long sides that meet at the first corner run along both sides of a pixel's centre, as far
 * from it as the thickness says, in octaves of a pixel. */
static void make_thin(random_source *r, const gn_viewport *v, int32_t from, int32_t to,
                      clip_vertex vertex[3])
{
    const float cx = floorf(window_x(r, v, -0.1f)) + 0.5f;
    const float cy = floorf(window_y(r, v, -0.1f)) + 0.5f;
    const float angle = random_float(r, 0.0f, 6.2831853f);
    const float ex = cosf(angle), ey = sinf(angle);
    const float length = random_octave(r, 0, 3);
    const bool is_affine = random_chance(r, 50);
    const uint32_t turn = random_below(r, 3);
    float x[3] = {cx - ex * length}, y[3] = {cy - ey * length};

    for (int k = 1; k < 3; ++k) {
        const float along = length * random_float(r, 0.1f, 1.0f);
        const float thickness = random_octave(r, from, to);
        const float aside = k == 1 ? 0.5f * thickness : -0.5f * thickness;

        x[k] = cx + ex * along - ey * aside;
        y[k] = cy + ey * along + ex * aside;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const float w = is_affine ? 1.0f : random_octave(r, -2, 1);

        place(v, x[(k + turn) % 3], y[(k + turn) % 3], random_float(r, -0.99f, 0.99f), w,
              vertex[k].position);
    }
}

/* Corners on a coarse grid, so that many lie on planes of the view volume, and edges in them. */
static void make_grid(random_source *r, clip_vertex vertex[3])
{
    for (int k = 0; k < 3; ++k) {
        float *const position = vertex[k].position;
        const float w = random_power(r, -1, 1);

        for (int c = 0; c < 3; ++c)
            position[c] = 0.5f * w * (float)random_between(r, -4, 4);
        position[3] = w;
    }
}

static void make_huge(random_source *r, const gn_viewport *v, int32_t from, int32_t to,
                      clip_vertex vertex[3])
{
    const float size = random_octave(r, from, to);
    const bool is_affine = random_chance(r, 50);

    for (int k = 0; k < 3; ++k) {
        const float x = random_float(r, -size, size);
        const float y = random_float(r, -size, size);
        const float z = random_float(r, -1.0f, 1.0f);

        place(v, x, y, z, is_affine ? 1.0f : random_octave(r, -4, 3), vertex[k].position);
    }
}

void random_clip_triangle(random_source *r, triangle_class c, const gn_viewport *v,
                          clip_vertex vertex[3])
{
    for (int k = 0; k < 3; ++k) {
        float *const position = vertex[k].position;

        switch (c) {
        case CLASS_AFFINE:
            place_somewhere(r, v, -0.001f, 0.99f, 1.0f, position);
            break;
        case CLASS_INSIDE:
        case CLASS_LARGE:
            place_somewhere(r, v, -0.001f, 0.99f, random_octave(r, -2, 1), position);
            break;
        case CLASS_RAW:
            for (int n = 0; n < 4; ++n)
                position[n] = random_float(r, -2.0f, 2.0f);
            break;
        default:
            place_somewhere(r, v, 0.7f, 1.5f, random_octave(r, -2, 1), position);
            break;
        }
        for (int a = 0; a < EXACT_ATTRIBUTES; ++a)
            vertex[k].attribute[a] = random_unit(r);
    }
    if (c == CLASS_SMALL)
        make_small(r, v, vertex);
    else if (c == CLASS_BEHIND)
        make_behind(r, vertex);
    else if (c == CLASS_GRID)
        make_grid(r, vertex);
    else if (c == CLASS_HUGE || c == CLASS_VAST)
        make_huge(r, v, c == CLASS_HUGE ? 8 : 17, c == CLASS_HUGE ? 15 : 25, vertex);
    else if (c >= CLASS_THIN)
        make_thin(r, v,
                  c == CLASS_THIN      ? -4
                  : c == CLASS_THINNER ? -8
                                       : -14,
                  c == CLASS_THIN      ? -1
                  : c == CLASS_THINNER ? -5
                                       : -9,
                  vertex);
}
