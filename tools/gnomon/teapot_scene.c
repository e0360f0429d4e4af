/* Sets the teapot's scene up. */
#include "teapot_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "teapot.h"
#include "teapot_maps.h"

const float teapot_background[4] = {0.933f, 0.925f, 0.906f, 1.0f};

static const model_shine shine = {{0.45f, 0.45f, 0.45f}, 40};
static const float glaze[4] = {0.80f, 0.46f, 0.31f, 1.0f};

/* Texels per side of each patch's cell of the maps. */
#define MAP_CELL 64

/* The shadow is a disc on the ground, dark in the middle and of the background's colour at its
 * edge, so that the edge is not visible. */
#define SHADOW_SEGMENTS 64
#define SHADOW_RINGS 16

void teapot_place_camera(camera_options *o)
{
    if (!o->eye_given)
        o->eye = (gn_vec3){3.4f, 4.6f, 8.6f};
    if (!o->target_given)
        o->target = (gn_vec3){0.2f, 1.35f, 0.0f};
    o->eye_given = o->target_given = true;
}

bounding_sphere teapot_sphere(void)
{
    return (bounding_sphere){{0.2, 1.45, 0.0}, 3.6, {0.0, 0.0, 0.0}};
}

void teapot_light(look *l)
{
    gn_vec3_normalize((gn_vec3){-0.4f, 0.75f, 0.7f}, &l->light_direction);
    l->ambient = (gn_vec3){0.30f, 0.31f, 0.36f};
    l->diffuse = (gn_vec3){0.82f, 0.78f, 0.72f};
}

bool teapot_create_glazed(uint32_t tessellation, model *result)
{
    const bool made = teapot_create(tessellation, glaze, result);
    if (made)
        result->parts->surface.shine = shine;
    return made;
}

/* Gives the ground the colours of a shadow that is painted on it. */
static void paint_ground(model_part *ground)
{
    for (size_t v = 0; v < ground->vertex_count; ++v) {
        const double r = (double)(v / (SHADOW_SEGMENTS + 1)) / SHADOW_RINGS;
        const double fade = (1.0 - r * r) * (1.0 - r * r);
        for (size_t c = 0; c < 3; ++c)
            ground->colors[4 * v + c] = teapot_background[c] * (float)(1.0 - 0.62 * fade);
        ground->colors[4 * v + 3] = 1.0f;
    }
}

bool teapot_create_ground(model *result)
{
    uint32_t columns = SHADOW_SEGMENTS + 1;
    if (!model_allocate(result, false, columns * (SHADOW_RINGS + 1),
                        SHADOW_SEGMENTS * SHADOW_RINGS * 6))
        return false;
    model_part *part = result->parts;
    part->index_count = 0;
    for (uint32_t ring = 0; ring <= SHADOW_RINGS; ++ring) {
        double r = (double)ring / SHADOW_RINGS;
        for (uint32_t i = 0; i <= SHADOW_SEGMENTS; ++i) {
            double angle = 2.0 * 3.14159265358979323846 * (i % SHADOW_SEGMENTS) / SHADOW_SEGMENTS;
            size_t v = (size_t)ring * columns + i;
            part->positions[3 * v] = (float)(0.25 + 3.3 * r * cos(angle));
            part->positions[3 * v + 1] = -0.01f;
            part->positions[3 * v + 2] = (float)(-0.25 + 2.7 * r * sin(angle));
            if (ring == 0 || i == 0)
                continue;
            uint32_t d = (uint32_t)v;
            uint32_t corners[6] = {d, d - 1, d - columns, d - 1, d - 1 - columns, d - columns};
            memcpy(part->indices + part->index_count, corners, sizeof corners);
            part->index_count += 6;
        }
    }
    paint_ground(part);
    return true;
}

/* The lit ground, which has the background's colour where there is no shadow. */
static void light_ground(model_part *ground, const look *l)
{
    float lit = fmaxf(l->light_direction.y, 0.0f);
    const float light[3] = {l->ambient.x + l->diffuse.x * lit, l->ambient.y + l->diffuse.y * lit,
                            l->ambient.z + l->diffuse.z * lit};
    for (size_t v = 0; v < ground->vertex_count; ++v) {
        for (size_t c = 0; c < 3; ++c)
            ground->colors[4 * v + c] = teapot_background[c] / light[c];
        ground->normals[3 * v + 1] = 1.0f;
    }
}

bool teapot_create_maps(unsigned int wanted, bool in_tangent_space, part_maps *result)
{
    memset(result, 0, sizeof *result);
    result->replaces_color = true;
    result->normals_in_tangent_space = in_tangent_space;
    if (teapot_maps_create(wanted, in_tangent_space, MAP_CELL, result->images))
        return true;
    memset(result, 0, sizeof *result);
    return false;
}

void teapot_add_draws(const look *l, const part_maps *maps, model *ground, const model *teapot,
                      scene *s)
{
    static const part_maps none;
    look below = *l;
    below.shading = l->shadow != NULL ? SHADING_PHONG : SHADING_VERTEX_COLOR;
    if (l->shadow != NULL)
        light_ground(ground->parts, l);
    else
        paint_ground(ground->parts);
    if (l->shading != SHADING_NORMALS && l->shading != SHADING_DEPTH)
        look_add_part(s, &below, ground->parts, &none);
    look_add_part(s, l, teapot->parts, maps);
}
