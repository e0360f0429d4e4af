/* Computes the teapot's maps texel by texel. */
#include "teapot_maps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "doubles.h"
#include "teapot.h"

/* Chequers around the axis and in height; dents as waves in all directions. */
#define CHEQUERS_AROUND 16
#define CHEQUERS_HIGH 3.0
#define DOT_RADIUS 0.22
#define DENT_DEPTH 0.035
#define DENT_WAVES 9.0

static const double tau = 6.28318530717958647692;

/* A point of the surface, and its place in its chequer, from -0.5 to 0.5 both ways. */
typedef struct glazed_point {
    double position[3], normal[3], tangent[3];
    double across, up;
    bool is_dark;
} glazed_point;

static void find_point(int patch, double u, double v, glazed_point *p)
{
    teapot_point(patch, u, v, p->position, p->normal, p->tangent);
    const double a = (atan2(p->position[2], p->position[0]) / tau + 1.0) * CHEQUERS_AROUND;
    const double h = p->position[1] * CHEQUERS_HIGH;
    p->across = a - floor(a) - 0.5;
    p->up = h - floor(h) - 0.5;
    p->is_dark = ((int)floor(a) + (int)floor(h)) % 2 != 0;
}

static void diffuse(const glazed_point *p, double color[3])
{
    static const double glaze[2][3] = {{0.93, 0.87, 0.76}, {0.74, 0.36, 0.22}};
    memcpy(color, glaze[p->is_dark], sizeof glaze[0]);
}

static void specular(const glazed_point *p, double color[3])
{
    color[0] = color[1] = color[2] = p->is_dark ? 0.1 : 1.0;
}

static void glow(const glazed_point *p, double color[3])
{
    static const double ember[3] = {1.0, 0.72, 0.2};
    const bool lit = p->is_dark && p->across * p->across + p->up * p->up < DOT_RADIUS * DOT_RADIUS;
    for (int c = 0; c < 3; ++c)
        color[c] = lit ? ember[c] : 0.0;
}

/* The normal minus the slope along the surface of d = depth * sin(x) * sin(y) * sin(z); d is the
 * height by which the surface is raised. */
static void dented_normal(const double p[3], const double n[3], double result[3])
{
    double slope[3];
    for (int c = 0; c < 3; ++c) {
        slope[c] = DENT_DEPTH * DENT_WAVES * cos(DENT_WAVES * p[c]) *
                   sin(DENT_WAVES * p[(c + 1) % 3]) * sin(DENT_WAVES * p[(c + 2) % 3]);
    }
    double outward = doubles_dot(slope, n);
    for (int c = 0; c < 3; ++c)
        result[c] = n[c] - (slope[c] - outward * n[c]);
    double length = sqrt(doubles_dot(result, result));
    for (int c = 0; c < 3; ++c)
        result[c] /= length;
}

/* A vector by its components along the tangent, the bitangent tangent x normal, and the normal. */
static void to_tangent_space(const double n[3], const double t[3], double v[3])
{
    const double b[3] = {t[1] * n[2] - t[2] * n[1], t[2] * n[0] - t[0] * n[2],
                         t[0] * n[1] - t[1] * n[0]};
    const double along[3] = {doubles_dot(v, t), doubles_dot(v, b), doubles_dot(v, n)};
    memcpy(v, along, sizeof along);
}

/* The parameter of texel i of a cell: 0 to 1 from margin to margin. */
static double parameter(uint32_t i, uint32_t size)
{
    double along = (((double)i + 0.5) / size - TEAPOT_MARGIN) / (1.0 - 2.0 * TEAPOT_MARGIN);
    return fmin(fmax(along, 0.0), 1.0);
}

static uint32_t texel(map_kind map, bool in_tangent_space, const glazed_point *p)
{
    double color[3];
    uint32_t result = UINT32_C(0xff000000);
    switch (map) {
    case MAP_DIFFUSE:
        diffuse(p, color);
        break;
    case MAP_SPECULAR:
        specular(p, color);
        break;
    case MAP_GLOW:
        glow(p, color);
        break;
    default:
        dented_normal(p->position, p->normal, color);
        if (in_tangent_space)
            to_tangent_space(p->normal, p->tangent, color);
        for (int c = 0; c < 3; ++c)
            color[c] = 0.5 + 0.5 * color[c];
        break;
    }
    for (int c = 0; c < 3; ++c)
        result |= (uint32_t)(color[c] * 255.0 + 0.5) << (8 * c);
    return result;
}

static bool allocate(unsigned int wanted, uint32_t size, image results[MAP_COUNT])
{
    bool is_whole = true;
    for (int map = 0; map < MAP_COUNT; ++map) {
        if ((wanted >> map & 1) == 0)
            continue;
        results[map].width = size * TEAPOT_COLUMNS;
        results[map].height = size * TEAPOT_ROWS;
        results[map].texels = malloc((size_t)size * TEAPOT_COLUMNS * size * TEAPOT_ROWS *
                                     sizeof *results[map].texels);
        is_whole = is_whole && results[map].texels != NULL;
    }
    for (int map = 0; map < MAP_COUNT && !is_whole; ++map) {
        if ((wanted >> map & 1) == 0)
            continue;
        free(results[map].texels);
        memset(results + map, 0, sizeof *results);
    }
    return is_whole;
}

bool teapot_maps_create(unsigned int wanted, bool in_tangent_space, uint32_t size,
                        image results[MAP_COUNT])
{
    const uint32_t width = size * TEAPOT_COLUMNS;
    if (!allocate(wanted, size, results))
        return false;
    for (uint32_t y = 0; y < size * TEAPOT_ROWS; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
            glazed_point point;
            find_point((int)(y / size * TEAPOT_COLUMNS + x / size), parameter(x % size, size),
                       parameter(y % size, size), &point);
            for (int map = 0; map < MAP_COUNT; ++map)
                if ((wanted >> map & 1) != 0)
                    results[map].texels[(size_t)y * width + x] =
                        texel((map_kind)map, in_tangent_space, &point);
        }
    }
    return true;
}
