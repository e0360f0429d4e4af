/* The vertices of the fixed function, over lanes. The order of operations is the reference's. */
#include <math.h>
#include <string.h>

#include "fixed_function.h"
#include "lane_function.h"
#include "../transform/clip_planes.h"

LANE_FUNCTION
void place_in_clip_space(const fixed_function *fixed, const float position[4][GN_LANES],
                         float clip[4][GN_LANES])
{
    const GLfloat *const m = fixed->to_clip;

    for (int row = 0; row < 4; ++row) {
        for (int l = 0; l < GN_LANES; ++l)
            clip[row][l] = ((m[row] * position[0][l] + m[4 + row] * position[1][l]) +
                            m[8 + row] * position[2][l]) +
                           m[12 + row] * position[3][l];
    }
}

static void write_clip_distances(const fixed_function *fixed, gn_vertex_output *output)
{
    const float(*const clip)[GN_LANES] = (const float(*)[GN_LANES])output->position;

    for (uint32_t i = 0; i < fixed->clip_planes; ++i)
        for (int l = 0; l < GN_LANES; ++l)
            output->clip_distance[i][l] =
                clip_distance(fixed->clip_plane[i], clip[0][l], clip[1][l], clip[2][l], clip[3][l]);
}

float whole_point_size(float size)
{
    const float whole = ceilf(rintf(size * 256.0f) / 256.0f - 0.5f);

    return whole < 1.0f ? 1.0f : whole > GN_MAX_POINT_SIZE ? GN_MAX_POINT_SIZE : whole;
}

/* A point on the boundary of two pixels belongs to the right one, and to the upper one, which is
 * the lesser in rows that go down. */
float point_center(float whole_size, int axis, float window)
{
    const float snapped = rintf(window * 256.0f) - (axis == 1 ? 1.0f : 0.0f);

    return fmodf(whole_size, 2.0f) == 0.0f ? floorf((snapped + 128.0f) / 256.0f)
                                           : floorf(snapped / 256.0f) + 0.5f;
}

/* Moves a point in the window. One outside the view volume stays there, so that it is not drawn. */
static void place_point(const point_placement *points, float size, float clip[4][GN_LANES], int l)
{
    const float w = clip[3][l], one_over_w = 1.0f / w;

    if (!(fabsf(clip[0][l]) <= w && fabsf(clip[1][l]) <= w && fabsf(clip[2][l]) <= w && w > 0.0f))
        return;
    for (int c = 0; c < 2; ++c) {
        const float window = clip[c][l] * one_over_w * points->scale[c] + points->translation[c];
        const float moved =
            (point_center(size, c, window) - points->translation[c]) / points->scale[c] * w;

        clip[c][l] = moved < -w ? -w : moved > w ? w : moved;
    }
}

/* Writes the distances from the eye along z. */
static void write_depth(const float to_depth[4], const float (*position)[GN_LANES],
                        float to[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l)
        to[l] = fabsf(((to_depth[0] * position[0][l] + to_depth[1] * position[1][l]) +
                       to_depth[2] * position[2][l]) +
                      to_depth[3] * position[3][l]);
}

/* Places points where they are drawn without the stages of primitives, and writes their sizes. */
static void write_points(const point_placement *points, const gn_vertex_input *input,
                         gn_vertex_output *output)
{
    float size[GN_LANES], depth[GN_LANES];

    if (points->is_attenuated)
        write_depth(points->to_depth, input->attribute[POSITION], depth);
    for (int l = 0; l < GN_LANES; ++l) {
        const float *const a = points->attenuation;

        size[l] = points->size;
        if (points->is_attenuated) {
            const float attenuation = depth[l] * (depth[l] * a[2] + a[1]) + a[0];
            const float attenuated = 1.0f / sqrtf(attenuation) * points->size;
            const float least = attenuated > points->least ? attenuated : points->least;

            size[l] = least < points->most ? least : points->most;
        }
        if (points->enabled) {
            size[l] = whole_point_size(size[l]);
            place_point(points, size[l], output->position, l);
        }
    }
    if (output->point_size)
        memcpy(output->point_size, size, sizeof size);
}

/* Writes varyings of a colour. */
static void write_color(const fixed_function *fixed, const float (*color)[GN_LANES], int count,
                        float (*to)[GN_LANES])
{
    for (int c = 0; c < count; ++c) {
        if (fixed->clamps_vertex_colors)
            for (int l = 0; l < GN_LANES; ++l)
                to[c][l] = clamped_color(color[c][l]);
        else
            memcpy(to[c], color[c], sizeof(float[GN_LANES]));
    }
}

/* Writes the fog coordinate: the vertices', or their distance from the eye along z. */
static void write_fog(const fixed_function *fixed, const gn_vertex_input *input, float to[GN_LANES])
{
    if (fixed->fog.from_array)
        memcpy(to, input->attribute[SECONDARY_AND_FOG][3], sizeof(float[GN_LANES]));
    else
        write_depth(fixed->fog.to_depth, input->attribute[POSITION], to);
}

/* Sets what an attribute of the vertices is, or the current value of all. */
static const float (*attribute_of(const fixed_function *fixed, const gn_vertex_input *input,
                                  enum attribute_name name, float memory[4][GN_LANES]))[GN_LANES]
{
    if (input->present >> name & 1u)
        return input->attribute[name];
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            memory[c][l] = fixed->current[name][c];
    return (const float(*)[GN_LANES])memory;
}

static void write_lit_colors(const fixed_function *fixed, const gn_vertex_input *input,
                             lit_vertices *v, gn_vertex_output *output)
{
    float color_memory[4][GN_LANES];
    lit_colors lit;

    light_vertices(&fixed->lighting, v, attribute_of(fixed, input, COLOR, color_memory), &lit);
    for (int side = 0; side < (fixed->lighting.two_side ? 2 : 1); ++side) {
        const int first = side ? fixed->back_color_varying : fixed->color_varying;
        const int secondary = side ? fixed->back_secondary_varying : fixed->secondary_varying;

        write_color(fixed, (const float(*)[GN_LANES])lit.primary[side], 4, output->varying + first);
        if (secondary >= 0)
            write_color(fixed, (const float(*)[GN_LANES])lit.secondary[side], 3,
                        output->varying + secondary);
    }
}

LANE_FUNCTION
void fixed_vertex(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)
{
    const fixed_function *const fixed = uniforms;
    float normal_memory[4][GN_LANES];
    lit_vertices v;

    v.has_place = v.has_direction = v.has_normal = false;
    place_in_clip_space(fixed, input->attribute[POSITION], output->position);
    write_clip_distances(fixed, output);
    if (fixed->points.enabled || output->point_size)
        write_points(&fixed->points, input, output);
    v.eye = &fixed->eye;
    v.position = input->attribute[POSITION];
    v.object_normal = attribute_of(fixed, input, NORMAL, normal_memory);
    if (fixed->lighting.enabled)
        write_lit_colors(fixed, input, &v, output);
    else if (fixed->color_varying >= 0)
        write_color(fixed, input->attribute[COLOR], 4, output->varying + fixed->color_varying);
    if (fixed->secondary_varying >= 0 && !fixed->lighting.enabled)
        write_color(fixed, input->attribute[SECONDARY_AND_FOG], 3,
                    output->varying + fixed->secondary_varying);
    for (int u = 0; u <= fixed->last_unit; ++u) {
        const unit_derived *const unit = &fixed->unit[u];
        float memory[4][GN_LANES];

        if (unit->enabled && unit->varying >= 0)
            write_texture_coordinates(
                unit, &v,
                attribute_of(fixed, input, (enum attribute_name)(TEXTURE_COORDINATE + u), memory),
                output->varying + unit->varying);
    }
    if (fixed->fog.enabled && fixed->fog.varying >= 0)
        write_fog(fixed, input, output->varying[fixed->fog.varying]);
}
