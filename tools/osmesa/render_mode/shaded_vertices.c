#include "shaded_vertices.h"

#include <gl_registry.h>
#include <string.h>

#include "../transform/clip_planes.h"

/* At most 27 varyings of colours, fog and other units come before. */
static void set_coordinate_varying(placement *place, gn_program *program)
{
    const unit_derived *const unit = &place->fixed->unit[0];

    place->copies_coordinate = !unit->enabled || unit->varying < 0;
    place->coordinate_varying = unit->varying;
    if (place->copies_coordinate) {
        place->coordinate_varying = (int)program->varying_count;
        program->varying_count += 4;
    }
}

void set_placement(const context *gl, const fixed_function *fixed, gn_program *program,
                   placement *place)
{
    const transform_state *const t = &gl->transform;
    const GLdouble z_near = (GLdouble)t->depth_range[0], z_far = (GLdouble)t->depth_range[1];
    const GLfloat half_width = 0.5f * (GLfloat)t->viewport[2];
    const GLfloat half_height = 0.5f * (GLfloat)t->viewport[3];
    const bool rows_go_down = !gl->draw_framebuffer;

    *place = (placement){
        .fixed = fixed, .program = program, .is_zero_to_one = t->clip_depth == GL_ZERO_TO_ONE};
    place->scale[0] = half_width;
    place->translation[0] = half_width + (GLfloat)t->viewport[0];
    place->scale[1] = t->clip_origin == GL_UPPER_LEFT ? -half_height : half_height;
    place->translation[1] = half_height + (GLfloat)t->viewport[1];
    if (rows_go_down) {
        place->scale[1] = -place->scale[1];
        place->translation[1] = (GLfloat)gl->window.height - place->translation[1];
    }
    place->scale[2] = (GLfloat)(place->is_zero_to_one ? z_far - z_near : 0.5 * (z_far - z_near));
    place->translation[2] = (GLfloat)(place->is_zero_to_one ? z_near : 0.5 * (z_near + z_far));
    set_coordinate_varying(place, program);
}

static void place_in_window(const placement *place, shaded_vertex *v)
{
    const GLfloat one_over_w = 1.0f / v->clip[3];

    for (int i = 0; i < 3; ++i)
        v->window[i] = v->clip[i] * one_over_w * place->scale[i] + place->translation[i];
    v->window[3] = one_over_w;
}

GLfloat plane_distance(const placement *place, const shaded_vertex *v, uint32_t plane)
{
    static const GLfloat volume[VOLUME_PLANES][4] = {
        {-1.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f, 1.0f}, {0.0f, -1.0f, 0.0f, 1.0f},
        {0.0f, 1.0f, 0.0f, 1.0f},  {0.0f, 0.0f, 1.0f, 1.0f}, {0.0f, 0.0f, -1.0f, 1.0f}};
    static const GLfloat zero_near[4] = {0.0f, 0.0f, 1.0f, 0.0f};
    const GLfloat *const c = v->clip;
    const GLfloat *const p = plane >= VOLUME_PLANES
                                 ? place->fixed->clip_plane[plane - VOLUME_PLANES]
                             : plane == 4 && place->is_zero_to_one ? zero_near
                                                                   : volume[plane];

    return clip_distance(p, c[0], c[1], c[2], c[3]);
}

/* NaN is outside the volume, and inside the program's planes. */
static uint32_t planes_outside(const placement *place, const shaded_vertex *v)
{
    const GLfloat *const c = v->clip;
    const GLfloat w = c[3];
    uint32_t outside = 0;

    for (int i = 0; i < 3; ++i) {
        const bool is_below =
            i == 2 && place->is_zero_to_one ? !(c[2] >= 0.0f) : !(c[i] + w >= 0.0f);
        const bool is_above = !(c[i] <= w);

        outside |= (uint32_t)(i < 2 ? is_above : is_below) << 2 * i;
        outside |= (uint32_t)(i < 2 ? is_below : is_above) << (2 * i + 1);
    }
    for (uint32_t i = 0; i < place->fixed->clip_planes; ++i)
        outside |= (uint32_t)(plane_distance(place, v, VOLUME_PLANES + i) < 0.0f)
                   << (VOLUME_PLANES + i);
    return outside;
}

/* Gathers an attribute of a group of vertices, of which the last one is repeated. */
static void gather(const gn_attribute *a, uint32_t first, uint32_t count, float to[4][GN_LANES])
{
    const size_t stride = a->stride ? a->stride : a->components * sizeof(float);

    for (uint32_t l = 0; l < GN_LANES; ++l) {
        const uint32_t vertex = first + (l < count ? l : count - 1);
        const float *const at = (const void *)((const char *)a->data + vertex * stride);

        for (uint32_t c = 0; c < 4; ++c)
            to[c][l] = c < a->components ? at[c] : c == 3 ? 1.0f : 0.0f;
    }
}

static void copy_coordinate(const placement *place, const gn_vertex_input *input,
                            float (*to)[GN_LANES])
{
    const bool is_array = input->present >> TEXTURE_COORDINATE & 1u;

    for (int c = 0; c < 4; ++c)
        for (uint32_t l = 0; l < GN_LANES; ++l)
            to[c][l] = is_array ? input->attribute[TEXTURE_COORDINATE][c][l]
                                : place->fixed->current[TEXTURE_COORDINATE][c];
}

/* Shades up to GN_LANES vertices from `first` on. */
static void shade_group(const placement *place, const gn_mesh *mesh, uint32_t first, uint32_t count,
                        shaded_vertex *to)
{
    float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES], position[4][GN_LANES];
    float point_size[GN_LANES], varying[GN_MAX_VARYINGS][GN_LANES],
        distance[GN_MAX_CLIP_DISTANCES][GN_LANES];
    uint32_t id[GN_LANES], present = 0;
    gn_vertex_input input = {
        .attribute = (const float(*)[4][GN_LANES])attribute, .vertex_id = id, .count = count};
    gn_vertex_output output = {.position = position,
                               .point_size = point_size,
                               .varying = varying,
                               .clip_distance = distance};

    memset(varying, 0, sizeof varying);
    for (int a = 0; a < ATTRIBUTES; ++a) {
        if (!mesh->attribute[a].data)
            continue;
        gather(&mesh->attribute[a], first, count, attribute[a]);
        present |= 1u << a;
    }
    for (uint32_t l = 0; l < GN_LANES; ++l)
        id[l] = first + (l < count ? l : count - 1);
    input.present = present;
    fixed_vertex(place->fixed, &input, &output);
    if (place->copies_coordinate)
        copy_coordinate(place, &input, varying + place->coordinate_varying);
    for (uint32_t l = 0; l < count; ++l) {
        for (int c = 0; c < 4; ++c)
            to[l].clip[c] = position[c][l];
        for (uint32_t i = 0; i < GN_MAX_VARYINGS; ++i)
            to[l].varying[i] = varying[i][l];
        to[l].point_size = point_size[l];
        place_in_window(place, &to[l]);
        to[l].outside = planes_outside(place, &to[l]);
    }
}

shaded_vertex *shade_vertices(context *gl, const placement *place, const gn_mesh *mesh,
                              const char *function)
{
    shaded_vertex *const vertices =
        scratch_memory(gl, &gl->shaded, mesh->vertex_count * sizeof *vertices, function);

    for (uint32_t first = 0; vertices && first < mesh->vertex_count; first += GN_LANES) {
        const uint32_t left = mesh->vertex_count - first;

        shade_group(place, mesh, first, left < GN_LANES ? left : GN_LANES, vertices + first);
    }
    return vertices;
}

static GLfloat between(GLfloat from, GLfloat to, GLfloat fraction)
{
    return from + fraction * (to - from);
}

void set_vertex_between(const placement *place, const shaded_vertex *from, const shaded_vertex *to,
                        GLfloat fraction, shaded_vertex *v)
{
    for (int c = 0; c < 4; ++c)
        v->clip[c] = between(from->clip[c], to->clip[c], fraction);
    place_in_window(place, v);
    v->outside = 0;
    v->point_size = between(from->point_size, to->point_size, fraction);
    for (uint32_t i = 0; i < place->program->varying_count; ++i)
        if (place->program->interpolation[i] != GN_FLAT)
            v->varying[i] = between(from->varying[i], to->varying[i], fraction);
}

void copy_flat_varyings(const placement *place, const shaded_vertex *from, shaded_vertex *to)
{
    for (uint32_t i = 0; i < place->program->varying_count; ++i)
        if (place->program->interpolation[i] == GN_FLAT)
            to->varying[i] = from->varying[i];
}
