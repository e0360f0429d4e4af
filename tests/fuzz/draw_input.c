/* Makes draws out of a fuzzer's input. */
#include "draw_input.h"

#include <stdlib.h>
#include <string.h>

#include "scene_members.h"

/* The user's shaders: they read every input and write every output, so that no stage is idle. */

static void shade_vertices(const void *uniforms, const gn_vertex_input *input,
                           gn_vertex_output *output)
{
    const draw_uniforms *const u = uniforms;

    for (int c = 0; c < 4; ++c)
        memcpy(output->position[c], input->attribute[0][c], sizeof output->position[c]);
    for (uint32_t v = 0; v < u->varyings; ++v)
        memcpy(output->varying[v], input->attribute[1][v], sizeof output->varying[v]);
    for (uint32_t i = 0; i < u->distances; ++i)
        memcpy(output->clip_distance[i], input->attribute[1 + i % 2][i % 4],
               GN_LANES * sizeof(float));
    if (output->point_size)
        memcpy(output->point_size, input->attribute[1][0], GN_LANES * sizeof(float));
}

static void shade_fragments(const void *uniforms, const gn_fragment_input *input,
                            gn_fragment_output *output)
{
    const draw_uniforms *const u = uniforms;
    static const float none[GN_LANES] = {0.0f};
    const float *varying[4];
    float texel[4][GN_LANES];

    FUZZ_REQUIRE(input->sample_id < GN_SAMPLES);
    for (uint32_t v = 0; v < 4; ++v)
        varying[v] = v < u->varyings ? input->varying[v] : none;
    memset(texel, 0, sizeof texel);
    if (u->has_texture) {
        const gn_lookup lookup = {.coordinate = {varying[0], varying[1], varying[2]},
                                  .reference = varying[3]};

        gn_fragment_lookup(input, &u->texture.texture, &u->texture.sampler, &lookup, texel);
    }
    for (uint32_t c = 0; c < 4 * u->colors; ++c)
        for (int lane = 0; lane < GN_LANES; ++lane) {
            float value = varying[c % 4][lane] + texel[c % 4][lane];

            if (input->position)
                value *= input->position[c % 4][lane];
            if (input->sample_mask)
                value += (float)input->sample_mask[lane];
            if (input->point_coordinate)
                value -= input->point_coordinate[c % 2][lane];
            if (input->front_facing)
                value += 0.125f;
            value += (float)input->sample_id * 0.25f + input->sample_position[c % 2];
            output->color[c][lane] = value + (float)(input->primitive_id & 7) * 0.0625f;
        }
    for (int lane = 0; lane < GN_LANES && output->sample_mask; ++lane)
        output->sample_mask[lane] = 0x96A53C0Fu >> lane;
    if (output->depth)
        memcpy(output->depth, varying[3], GN_LANES * sizeof(float));
    for (int lane = 0; lane < GN_LANES; ++lane)
        if (varying[2][lane] > 1.5f)
            output->kept &= ~(1u << lane);
}

/* State: some members have another value than the default. */

static uint32_t word_of(float f)
{
    uint32_t word;

    memcpy(&word, &f, sizeof word);
    return word;
}

static uint32_t member_value(fuzz_input *in, const scene_member *m)
{
    switch (m->type) {
    case MEMBER_SWITCH:
        return fuzz_byte(in) & 1;
    case MEMBER_NAMED:
        return fuzz_rarely(in, 64) ? fuzz_word(in)
                                   : fuzz_below(in, (uint32_t)text_name_count(m->names));
    case MEMBER_BYTE:
        return fuzz_byte(in);
    case MEMBER_NUMBER:
        return fuzz_rarely(in, 64)        ? fuzz_word(in)
               : m->largest == UINT32_MAX ? fuzz_below(in, 48)
                                          : fuzz_below(in, m->largest + 1);
    case MEMBER_INTEGER:
        return fuzz_rarely(in, 8) ? fuzz_word(in) : fuzz_below(in, 48) - 8;
    default:
        return word_of(fuzz_byte(in) & 1 ? fuzz_float(in)
                       : m->high <= 1.0f ? (float)fuzz_byte(in) * (1.0f / 255.0f)
                                         : (float)fuzz_byte(in) * 0.125f);
    }
}

static void make_state(fuzz_input *in, gn_pipeline *pipeline)
{
    scene_draw d;

    scene_default_draw(&d);
    for (int changes = fuzz_byte(in) & 15; changes > 0; --changes) {
        const scene_member *const m = &scene_members[fuzz_below(in, (uint32_t)scene_member_count)];
        const size_t line = fuzz_below(in, (uint32_t)scene_member_lines(m));

        if (!scene_member_is_state(m) || m->type == MEMBER_ELSEWHERE)
            continue;
        for (size_t v = 0; v < scene_member_values(m); ++v)
            scene_member_set(m, &d, line, v, member_value(in, m));
    }
    *pipeline = d.state;
}

static gn_mat4 matrix(fuzz_input *in)
{
    gn_mat4 m;

    gn_mat4_identity(&m);
    for (int changes = fuzz_byte(in) & 7; changes > 0; --changes) {
        const uint8_t at = fuzz_byte(in);

        m.m[at >> 2 & 3][at & 3] = fuzz_tame(in);
    }
    return m;
}

static void make_lit(fuzz_input *in, draw_uniforms *u, const gn_texture *map)
{
    const uint8_t maps = fuzz_byte(in);
    gn_lit_uniforms *const l = &u->lit;

    l->clip_from_model = matrix(in);
    l->world_from_model = matrix(in);
    gn_mat3_identity(&l->normal_matrix);
    l->eye = (gn_vec3){fuzz_tame(in), 0.0f, 2.0f};
    l->light.direction.x = fuzz_tame(in);
    l->light.direction.y = fuzz_tame(in);
    l->light.direction.z = 1.0f;
    l->light.diffuse = (gn_vec3){fuzz_tame(in), 1.0f, 0.5f};
    l->light.kind = maps & 32 ? GN_LIGHT_POINT : GN_LIGHT_DIRECTIONAL;
    l->light.constant = fuzz_tame(in);
    l->material.diffuse_map = maps & 1 ? map : NULL;
    l->material.normal_map = maps & 2 ? map : NULL;
    l->material.specular_map = maps & 4 ? map : NULL;
    l->material.glow_map = maps & 8 ? map : NULL;
    l->shadow.map = maps & 16 ? map : NULL;
    l->material.sampler = l->shadow.sampler = u->texture.sampler;
    if (maps & 128)
        l->shadow.sampler.compare = GN_LESS_OR_EQUAL;
    l->shadow.clip_from_world = matrix(in);
    l->material.normal_space = maps & 64 ? GN_NORMAL_OF_TANGENTS : GN_NORMAL_OF_MODEL;
    l->material.specular = (gn_vec3){1.0f, fuzz_tame(in), 0.5f};
    l->material.exponent = fuzz_rarely(in, 16) ? fuzz_word(in) : fuzz_byte(in);
    l->material.bands = fuzz_byte(in);
}

/* Takes what the materials share from the lit uniforms, which are made. */
static const gn_metallic_roughness_uniforms *make_metallic(fuzz_input *in, draw_uniforms *u)
{
    const gn_lit_uniforms *const l = &u->lit;
    gn_metallic_roughness_uniforms *const m = &u->metallic;
    gn_metallic_roughness *const material = &m->material;

    m->clip_from_model = l->clip_from_model;
    m->world_from_model = l->world_from_model;
    m->normal_matrix = l->normal_matrix;
    m->eye = l->eye;
    m->light = l->light;
    m->shadow = l->shadow;
    m->more_lights = &m->light;
    m->more_light_count = fuzz_byte(in) & 1;
    material->base_color_map = (gn_map){l->material.diffuse_map, l->material.sampler};
    material->normal_map = (gn_map){l->material.normal_map, l->material.sampler};
    material->metallic_roughness_map = (gn_map){l->material.specular_map, l->material.sampler};
    material->occlusion_map = (gn_map){l->material.specular_map, l->material.sampler};
    material->emissive_map = (gn_map){l->material.glow_map, l->material.sampler};
    material->metallic = (float)fuzz_byte(in) / 255.0f;
    material->roughness = (float)fuzz_byte(in) / 255.0f;
    material->normal_scale = fuzz_tame(in);
    material->occlusion_strength = 1.0f;
    material->emissive.x = fuzz_tame(in);
    material->double_sided = fuzz_byte(in) & 1;
    return m;
}

/* Sets a ready-made shader. Returns whether the library accepts the uniforms. */
static bool use_ready_made(fuzz_input *in, draw_input *d, uint8_t which)
{
    draw_uniforms *const u = &d->uniforms;
    const gn_texture *const map = u->has_texture ? &u->texture.texture : NULL;
    gn_pipeline *const p = &d->pipeline;

    u->color.clip_from_model = u->unlit.clip_from_model = u->depth_color.clip_from_model =
        matrix(in);
    u->unlit.map = map;
    u->unlit.sampler = u->texture.sampler;
    u->depth_color.white = fuzz_tame(in);
    if (which >= 4)
        make_lit(in, u, map);
    switch (which) {
    case 0:
        return gn_use_vertex_color(p, &u->color) == GN_OK;
    case 1:
        return gn_use_depth_only(p, &u->color) == GN_OK;
    case 2:
        return gn_use_unlit(p, &u->unlit) == GN_OK;
    case 3:
        return gn_use_depth_color(p, &u->depth_color) == GN_OK;
    case 4:
        return gn_use_flat(p, &u->lit) == GN_OK;
    case 5:
        return gn_use_gouraud(p, &u->lit) == GN_OK;
    case 6:
        return gn_use_toon(p, &u->lit) == GN_OK;
    case 7:
        return gn_use_phong(p, &u->lit) == GN_OK;
    case 8:
        return gn_use_blinn_phong(p, &u->lit) == GN_OK;
    case 9:
        return gn_use_normal_color(p, &u->lit) == GN_OK;
    default:
        return gn_use_metallic_roughness(p, make_metallic(in, u)) == GN_OK;
    }
}

/* The shader runs for each sample, or varyings have the values of centroids and samples. */
static void make_locations(fuzz_input *in, gn_pipeline *p)
{
    const uint8_t kind = fuzz_byte(in), locations = fuzz_byte(in);

    p->program.fragment_reads_sample = kind & 1;
    p->samples.shading_enabled = kind & 2;
    p->samples.least_shading = (float)(kind >> 2) * (1.0f / 63.0f);
    for (int v = 0; v < 4; ++v)
        p->program.interpolated_at[v] = (gn_interpolation_point)((locations >> 2 * v & 3) % 3);
}

static bool make_shaders(fuzz_input *in, draw_input *d)
{
    const uint8_t kind = fuzz_byte(in);
    draw_uniforms *const u = &d->uniforms;
    gn_program *const program = &d->pipeline.program;

    memset(u, 0, sizeof *u);
    if (kind & 0x80) {
        if (!texture_make(in, 6, &u->texture))
            return false;
        u->has_texture = gn_texture_check(&u->texture.texture) == GN_OK &&
                         gn_sampler_check(&u->texture.sampler) == GN_OK;
    }
    u->colors = program->color_count ? program->color_count : 1;
    u->distances = program->clip_distance_count;
    if (kind & 0x10)
        make_locations(in, &d->pipeline);
    if ((kind & 0x60) == 0x60) {
        if (use_ready_made(in, d, kind % 11))
            return true;
        d->pipeline.program.uniforms = NULL;
    }
    program->vertex_shader = fuzz_rarely(in, 64) ? NULL : shade_vertices;
    program->fragment_shader = fuzz_rarely(in, 64) ? NULL : shade_fragments;
    program->uniforms = u;
    program->varying_count = fuzz_rarely(in, 64) ? fuzz_word(in) : 4 + fuzz_below(in, 3);
    u->varyings = program->varying_count < 4 ? program->varying_count : 4;
    return true;
}

/* Meshes */

#define MOST_ELEMENTS 64

static bool make_attribute(fuzz_input *in, gn_attribute *a, bool is_position, uint32_t vertices,
                           uint32_t instances)
{
    const uint8_t byte = fuzz_byte(in);
    /* Positions are mostly plain: four components each, before the eye. */
    const uint8_t kind = is_position && byte < 0xC0 ? byte & 0x30 : byte;
    uint32_t elements = vertices;

    a->components = fuzz_rarely(in, 256) ? fuzz_byte(in) : kind & 1 ? 4 - (kind >> 1 & 3) : 4;
    a->stride = kind & 4 ? 4 * (uint32_t)fuzz_below(in, 8) : 0;
    if (fuzz_rarely(in, 256))
        a->stride = fuzz_word(in);
    if (kind & 8) {
        a->divisor = fuzz_byte(in);
        if (a->divisor)
            elements = (instances - 1) / a->divisor + 1;
    }
    const uint32_t components = a->components <= 4 ? a->components : 4;
    const uint64_t stride = a->stride ? a->stride : 4 * components;
    const uint64_t bytes = elements ? (elements - 1) * stride + 4 * components : 0;

    if (bytes > 1 << 14)
        return false;

    const size_t floats = (size_t)bytes / 4;
    const uint32_t repeat = kind & 16 ? 1 + fuzz_below(in, 48) : (uint32_t)floats;
    float *const data = fuzz_memory(floats ? 4 * floats : 4);

    /* Few bytes make many numbers if they repeat. */
    for (size_t i = 0; i < (floats ? floats : 1); ++i)
        data[i] = i >= repeat                         ? data[i - repeat]
                  : (kind & 32) && fuzz_rarely(in, 4) ? fuzz_float(in)
                                                      : fuzz_tame(in);
    if (is_position && kind == (byte & 0x30) && a->components == 4)
        for (size_t i = 3; i < floats; i += 4)
            data[i] = 1.0f + (data[i] < 0.0f ? -data[i] : data[i]) * 0.5f;
    a->data = data;
    return true;
}

static bool make_indices(fuzz_input *in, gn_mesh *m, uint8_t kind)
{
    m->index_format = (gn_index_format)(kind & 4 ? kind & 3 : GN_INDEX_NONE);
    m->restart = (gn_restart)((kind >> 4 & 3) % 3);
    if (fuzz_rarely(in, 64))
        m->restart = (gn_restart)fuzz_word(in);
    m->restart_index = fuzz_rarely(in, 2) ? fuzz_byte(in) : UINT32_MAX;
    m->base_vertex = fuzz_rarely(in, 16) ? (int32_t)fuzz_word(in) : 0;
    if (m->index_format == GN_INDEX_NONE)
        return true;

    const size_t size = m->index_format == GN_INDEX_UINT8    ? 1
                        : m->index_format == GN_INDEX_UINT16 ? 2
                                                             : 4;
    const uint64_t elements = (uint64_t)m->first + m->count;

    if (elements > MOST_ELEMENTS)
        return false;
    unsigned char *const memory = fuzz_memory(elements ? (size_t)elements * size : 1);

    memset(memory, 0, elements ? (size_t)elements * size : 1);
    for (size_t i = 0; i < elements; ++i) {
        const uint8_t byte = fuzz_byte(in);
        const uint32_t index = byte >= 0xF8          ? UINT32_MAX >> (byte == 0xF9)
                               : m->vertex_count > 0 ? byte % m->vertex_count
                                                     : byte;
        const uint8_t narrow = (uint8_t)(index & 0xFF);
        const uint16_t half = (uint16_t)(index & 0xFFFF);

        memcpy(memory + i * size,
               size == 1   ? (const void *)&narrow
               : size == 2 ? (const void *)&half
                           : (const void *)&index,
               size);
    }
    m->indices = memory;
    return true;
}

static bool make_mesh(fuzz_input *in, gn_mesh *m)
{
    const uint8_t kind = fuzz_byte(in);

    /* Often a triangle, whose numbers are near the input's begin. */
    m->vertex_count = fuzz_rarely(in, 2) ? 3 : fuzz_below(in, MOST_ELEMENTS);
    m->first = fuzz_rarely(in, 8) ? fuzz_byte(in) % 8 : 0;
    m->count = m->vertex_count > m->first ? m->vertex_count - m->first : 0;
    if (fuzz_rarely(in, 8))
        m->count = fuzz_below(in, MOST_ELEMENTS);
    m->instance_count = fuzz_rarely(in, 8) ? fuzz_below(in, 5) : 0;
    if (fuzz_rarely(in, 128)) {
        m->first = fuzz_word(in);
        m->count = fuzz_word(in);
    }
    for (int a = 0; a < 5; ++a)
        if ((a < 2 || fuzz_rarely(in, 3)) &&
            !make_attribute(in, &m->attribute[a], a == 0, m->vertex_count,
                            m->instance_count ? m->instance_count : 1))
            return false;
    return make_indices(in, m, kind);
}

/* Targets */

static bool make_target(fuzz_input *in, draw_input *d)
{
    const uint8_t kind = fuzz_byte(in);
    const uint32_t width = 1 + fuzz_below(in, fuzz_rarely(in, 8) ? 200 : 40);
    const uint32_t height = 1 + fuzz_below(in, 40);
    const uint32_t samples = kind & 8 ? GN_SAMPLES : kind & 1;
    const int colors = kind >> 4 < 12 ? 1 : (kind >> 4) - 9;

    for (int i = 0; i <= GN_MAX_COLORS; ++i) {
        const bool present = i == GN_MAX_COLORS ? kind & 6 : i < colors;
        const gn_format format = present ? surface_format(in, i == GN_MAX_COLORS) : GN_FORMAT_NONE;

        if (present && !surface_make(in, format, width, height, samples, &d->surface[i]))
            return false;
        *(i < GN_MAX_COLORS ? &d->target.color[i] : &d->target.depth) = d->surface[i].surface;
    }
    return true;
}

bool draw_make(fuzz_input *in, draw_input *d)
{
    memset(d, 0, sizeof *d);
    if (make_target(in, d)) {
        make_state(in, &d->pipeline);
        if (make_shaders(in, d) && make_mesh(in, &d->mesh))
            return true;
    }
    draw_free(d);
    return false;
}

void draw_free(draw_input *d)
{
    for (int i = 0; i <= GN_MAX_COLORS; ++i)
        surface_free(&d->surface[i]);
    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a)
        free((void *)d->mesh.attribute[a].data);
    free((void *)d->mesh.indices);
    texture_free(&d->uniforms.texture);
    memset(d, 0, sizeof *d);
}
