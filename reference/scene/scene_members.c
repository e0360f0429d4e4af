/* The table of members. */
#include "scene_members.h"

#include <ctype.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

/* A row's name is its path, but where scenes have another word: a shorter one for switches. */
#define ROW(path, ...) ROW_AS(#path, path, __VA_ARGS__)
#define ROW_AS(words, path, ...)                                                                   \
    {                                                                                              \
        .name = words, .offset = AT(path), __VA_ARGS__                                             \
    }

#define ELSEWHERE(type_name) .type = MEMBER_ELSEWHERE, .bytes = sizeof(type_name)
#define SWITCH .type = MEMBER_SWITCH
#define NAMED(set) .type = MEMBER_NAMED, .names = set
#define BYTE .type = MEMBER_BYTE, .largest = UINT8_MAX
#define NUMBER(most) .type = MEMBER_NUMBER, .largest = most
#define INTEGER .type = MEMBER_INTEGER
#define FLOAT(least, most) .type = MEMBER_FLOAT, .low = least, .high = most
#define ANY_FLOAT FLOAT(-FLT_MAX, FLT_MAX)
#define SIMPLEST(constant) .simplest = constant
#define EACH(count, type_name) .lines = count, .stride = sizeof(type_name)
#define ALONE .lines = 0
#define TOGETHER(count) .together = count

#define STENCIL_FACE(face)                                                                         \
    ROW(face.function, NAMED(TEXT_COMPARE)), ROW(face.reference, BYTE),                            \
        ROW(face.compare_disabled, BYTE), ROW(face.write_disabled, BYTE),                          \
        ROW(face.fail, NAMED(TEXT_STENCIL_OPERATION)),                                             \
        ROW(face.depth_fail, NAMED(TEXT_STENCIL_OPERATION)),                                       \
        ROW(face.pass, NAMED(TEXT_STENCIL_OPERATION))

#define BLENDS EACH(GN_MAX_COLORS, gn_blend)
#define ATTRIBUTES EACH(GN_MAX_ATTRIBUTES, gn_attribute)
#define MORE_LIGHTS EACH(GN_MAX_LIGHTS - 1, gn_light)

/* Shrinking prefers the nearest texel and clamping to the edge: they are simpler to follow than the
 * filter over levels, which 0 means. */
#define SAMPLER(sampler, ...)                                                                      \
    ROW(sampler.wrap_s, NAMED(TEXT_WRAP), SIMPLEST(GN_WRAP_CLAMP_TO_EDGE), __VA_ARGS__),           \
        ROW(sampler.wrap_t, NAMED(TEXT_WRAP), SIMPLEST(GN_WRAP_CLAMP_TO_EDGE), __VA_ARGS__),       \
        ROW(sampler.magnify, NAMED(TEXT_MAGNIFY), SIMPLEST(GN_MAGNIFY_NEAREST), __VA_ARGS__),      \
        ROW(sampler.minify, NAMED(TEXT_MINIFY), SIMPLEST(GN_MINIFY_NEAREST), __VA_ARGS__),         \
        ROW(sampler.wrap_r, NAMED(TEXT_WRAP), SIMPLEST(GN_WRAP_CLAMP_TO_EDGE), __VA_ARGS__),       \
        ROW(sampler.compare, NAMED(TEXT_COMPARE), __VA_ARGS__),                                    \
        ROW(sampler.lod_bias, ANY_FLOAT, __VA_ARGS__),                                             \
        ROW_AS(#sampler ".lod_clamped", sampler.lod_clamp_enabled, SWITCH, __VA_ARGS__),           \
        ROW(sampler.min_lod, ANY_FLOAT, __VA_ARGS__),                                              \
        ROW(sampler.max_lod, ANY_FLOAT, __VA_ARGS__),                                              \
        ROW(sampler.max_anisotropy, NUMBER(GN_MAX_ANISOTROPY), __VA_ARGS__),                       \
        ROW(sampler.border, ANY_FLOAT, TOGETHER(4), __VA_ARGS__)

/* AT(path) is the offset of a row's path. Paths begin in scene_draw.state; in the rows further
 * below they begin in scene_draw. */

/* clang-format off */
const scene_member scene_members[] = {
#define AT(path) offsetof(scene_draw, state.path)
    ROW(program.vertex_shader, ELSEWHERE(gn_vertex_shader *)),
    ROW(program.fragment_shader, ELSEWHERE(gn_fragment_shader *)),
    ROW(program.needs_quads, ELSEWHERE(gn_needs_quads *)),
    ROW(program.uniforms, ELSEWHERE(const void *)),
    ROW(program.varying_count, ELSEWHERE(uint32_t)),
    ROW(program.interpolation[0], NAMED(TEXT_INTERPOLATION),
        EACH(GN_MAX_VARYINGS, gn_interpolation)),
    ROW_AS("program.location[0]", program.interpolated_at[0], NAMED(TEXT_LOCATION),
        EACH(GN_MAX_VARYINGS, gn_interpolation_point)),
    ROW(program.color_count, NUMBER(GN_MAX_COLORS)),
    ROW(program.clip_distance_count, NUMBER(GN_MAX_CLIP_DISTANCES)),
    ROW(program.clip_plane, ELSEWHERE(const float (*)[4])),
    ROW(program.vertex_writes_point_size, SWITCH),
    ROW(program.fragment_reads_position, SWITCH),
    ROW(program.fragment_reads_primitive, SWITCH),
    ROW(program.fragment_reads_point_coordinate, SWITCH),
    ROW(program.fragment_reads_sample_mask, SWITCH),
    ROW(program.fragment_reads_sample, SWITCH),
    ROW(program.fragment_discards, SWITCH),
    ROW(program.fragment_writes_all_colors, ELSEWHERE(bool)),
    ROW(program.fragment_writes_depth, SWITCH),
    ROW(program.fragment_writes_sample_mask, SWITCH),

    ROW(raster.topology, NAMED(TEXT_TOPOLOGY)),
    ROW(raster.provoking_vertex, NAMED(TEXT_PROVOKING)),
    ROW(raster.cull, NAMED(TEXT_CULL)),
    ROW(raster.front_face, NAMED(TEXT_FRONT_FACE)),
    ROW(raster.polygon_mode_front, NAMED(TEXT_POLYGON_MODE)),
    ROW(raster.polygon_mode_back, NAMED(TEXT_POLYGON_MODE)),
    ROW_AS("raster.polygon_offset.set", raster.polygon_offset.enabled, SWITCH),
    ROW(raster.polygon_offset.factor, ANY_FLOAT),
    ROW(raster.polygon_offset.units, ANY_FLOAT),
    ROW(raster.polygon_offset.clamp, ANY_FLOAT),
    ROW_AS("raster.viewport.set", raster.viewport.enabled, SWITCH),
    ROW(raster.viewport.x, FLOAT(-GN_MAX_SIZE, GN_MAX_SIZE)),
    ROW(raster.viewport.y, FLOAT(-GN_MAX_SIZE, GN_MAX_SIZE)),
    ROW(raster.viewport.width, FLOAT(0.0f, GN_MAX_SIZE)),
    ROW(raster.viewport.height, FLOAT(-GN_MAX_SIZE, GN_MAX_SIZE)),
    ROW_AS("raster.scissor.set", raster.scissor.enabled, SWITCH),
    ROW(raster.scissor.x, INTEGER),
    ROW(raster.scissor.y, INTEGER),
    ROW(raster.scissor.width, NUMBER(UINT32_MAX)),
    ROW(raster.scissor.height, NUMBER(UINT32_MAX)),
    ROW(raster.point_size, FLOAT(0.0f, FLT_MAX)),
    ROW(raster.point_origin, NAMED(TEXT_POINT_ORIGIN)),
    ROW(raster.line_width, FLOAT(0.0f, FLT_MAX)),

    ROW_AS("depth.test", depth.test_enabled, SWITCH),
    ROW(depth.function, NAMED(TEXT_COMPARE)),
    ROW(depth.write_disabled, SWITCH),
    ROW_AS("depth.clamp", depth.clamp_enabled, SWITCH),
    ROW(depth.clip_depth, NAMED(TEXT_CLIP_DEPTH)),
    ROW_AS("depth.range.set", depth.range.enabled, SWITCH),
    ROW(depth.range.z_near, FLOAT(0.0f, 1.0f)),
    ROW(depth.range.z_far, FLOAT(0.0f, 1.0f)),

    ROW_AS("stencil.test", stencil.test_enabled, SWITCH),
    STENCIL_FACE(stencil.front),
    STENCIL_FACE(stencil.back),

    ROW(color.write_disabled[0], NUMBER(GN_CHANNEL_ALL), EACH(GN_MAX_COLORS, uint32_t)),
    ROW(color.blend[0].enabled, SWITCH, BLENDS),
    ROW(color.blend[0].equation, NAMED(TEXT_EQUATION), BLENDS),
    ROW(color.blend[0].source, NAMED(TEXT_FACTOR), BLENDS),
    ROW(color.blend[0].destination, NAMED(TEXT_FACTOR), BLENDS),
    ROW(color.blend[0].alpha_equation, NAMED(TEXT_EQUATION), BLENDS),
    ROW(color.blend[0].alpha_source, NAMED(TEXT_FACTOR), BLENDS),
    ROW(color.blend[0].alpha_destination, NAMED(TEXT_FACTOR), BLENDS),
    ROW(color.blend_constant, ANY_FLOAT, TOGETHER(4)),
    ROW_AS("color.logic", color.logic_enabled, SWITCH),
    ROW(color.logic_operation, NAMED(TEXT_LOGIC)),

    ROW(samples.write_disabled, NUMBER((1u << GN_SAMPLES) - 1)),
    ROW_AS("samples.alpha_to_coverage", samples.alpha_to_coverage_enabled, SWITCH),
    ROW_AS("samples.alpha_to_one", samples.alpha_to_one_enabled, SWITCH),
    ROW_AS("samples.shading", samples.shading_enabled, SWITCH),
    ROW(samples.least_shading, FLOAT(0.0f, 1.0f)),
#undef AT

#define AT(path) offsetof(scene_draw, path)
    ROW(shader, ELSEWHERE(scene_shader)),
    ROW(counted, SWITCH),
    ROW(clear.color, SWITCH),
    ROW(clear.depth, SWITCH),
    ROW(clear.color_value, ANY_FLOAT, TOGETHER(4)),
    ROW(clear.depth_value, ANY_FLOAT),
    ROW(clear.stencil_value, BYTE),
    ROW(clip_plane[0], ANY_FLOAT, EACH(GN_MAX_CLIP_DISTANCES, float[4]), TOGETHER(4)),

    ROW(mesh.attribute[0].data, ELSEWHERE(const float *), ATTRIBUTES),
    ROW(mesh.attribute[0].components, ELSEWHERE(uint32_t), ATTRIBUTES),
    ROW(mesh.attribute[0].stride, ELSEWHERE(uint32_t), ATTRIBUTES),
    ROW(mesh.attribute[0].divisor, NUMBER(UINT32_MAX), ATTRIBUTES),
    ROW(mesh.vertex_count, ELSEWHERE(uint32_t)),
    ROW(mesh.indices, ELSEWHERE(const void *)),
    ROW(mesh.index_format, ELSEWHERE(gn_index_format)),
    ROW(mesh.first, ELSEWHERE(uint32_t)),
    ROW(mesh.count, ELSEWHERE(uint32_t)),
    ROW(index_count, ELSEWHERE(uint32_t)),
    ROW(mesh.restart, NAMED(TEXT_RESTART)),
    ROW(mesh.restart_index, NUMBER(UINT32_MAX)),
    ROW(mesh.base_vertex, INTEGER),
    ROW(mesh.instance_count, NUMBER(UINT32_MAX)),

    ROW(uniforms.light.clip_from_model, ANY_FLOAT, TOGETHER(16)),
    ROW(uniforms.light.normal_matrix, ANY_FLOAT, TOGETHER(9)),
    ROW(uniforms.light.light_direction, ANY_FLOAT, TOGETHER(3)),
    ROW(uniforms.light.ambient, ANY_FLOAT, TOGETHER(3)),
    ROW(uniforms.light.diffuse, ANY_FLOAT, TOGETHER(3)),
    ROW(uniforms.texture, ELSEWHERE(gn_texture)),
    SAMPLER(uniforms.sampler, ALONE),

    ROW(surface.world_from_model, ANY_FLOAT, TOGETHER(16)),
    ROW(surface.eye, ANY_FLOAT, TOGETHER(3)),
    ROW(surface.has_point_light, SWITCH),
    ROW(surface.light_position, ANY_FLOAT, TOGETHER(3)),
    ROW(surface.attenuation, ANY_FLOAT, TOGETHER(3)),
    ROW(surface.exponent, NUMBER(UINT32_MAX)),
    ROW(surface.bands, NUMBER(UINT32_MAX)),
    ROW(surface.normal_space, NAMED(TEXT_NORMAL_SPACE)),
    ROW(surface.map, ELSEWHERE(gn_texture[SCENE_MAP_COUNT])),
    SAMPLER(surface.shadow_sampler, ALONE),
    SAMPLER(surface.map_sampler[0], EACH(SCENE_MAP_COUNT, gn_sampler)),
    ROW(surface.shadow_from_world, ANY_FLOAT, TOGETHER(16)),
    ROW(surface.black, ANY_FLOAT),
    ROW(surface.white, ANY_FLOAT),
    ROW(surface.alpha_cutoff, FLOAT(0.0f, FLT_MAX)),
    ROW(surface.has_spot_light, SWITCH),
    ROW(surface.light_range, ANY_FLOAT),
    ROW(surface.cone, FLOAT(-1.0f, 1.0f), TOGETHER(2)),
    ROW(surface.more_light_count, NUMBER(GN_MAX_LIGHTS - 1)),
    ROW(surface.more_lights[0].kind, NAMED(TEXT_LIGHT_KIND), MORE_LIGHTS),
    ROW(surface.more_lights[0].direction, ANY_FLOAT, MORE_LIGHTS, TOGETHER(3)),
    ROW(surface.more_lights[0].position, ANY_FLOAT, MORE_LIGHTS, TOGETHER(3)),
    ROW(surface.more_lights[0].constant, ANY_FLOAT, MORE_LIGHTS),
    ROW(surface.more_lights[0].linear, ANY_FLOAT, MORE_LIGHTS),
    ROW(surface.more_lights[0].quadratic, ANY_FLOAT, MORE_LIGHTS),
    ROW(surface.more_lights[0].range, ANY_FLOAT, MORE_LIGHTS),
    ROW(surface.more_lights[0].inner_cosine, FLOAT(-1.0f, 1.0f), MORE_LIGHTS),
    ROW(surface.more_lights[0].outer_cosine, FLOAT(-1.0f, 1.0f), MORE_LIGHTS),
    ROW(surface.more_lights[0].ambient, ANY_FLOAT, MORE_LIGHTS, TOGETHER(3)),
    ROW(surface.more_lights[0].diffuse, ANY_FLOAT, MORE_LIGHTS, TOGETHER(3)),
    ROW(surface.metallic, FLOAT(0.0f, 1.0f)),
    ROW(surface.roughness, FLOAT(0.0f, 1.0f)),
    ROW(surface.normal_scale, ANY_FLOAT),
    ROW(surface.occlusion_strength, FLOAT(0.0f, 1.0f)),
    ROW(surface.emissive, ANY_FLOAT, TOGETHER(3)),
    ROW(surface.double_sided, SWITCH),
    ROW(view_from_model, ANY_FLOAT, TOGETHER(16)),
    ROW(phong_functions, SWITCH),
    ROW(specular, ANY_FLOAT, TOGETHER(3)),
};
/* clang-format on */

const size_t scene_member_count = sizeof scene_members / sizeof *scene_members;

size_t scene_member_size(const scene_member *m)
{
    switch (m->type) {
    case MEMBER_ELSEWHERE:
        return m->bytes;
    case MEMBER_SWITCH:
        return sizeof(bool);
    case MEMBER_BYTE:
        return sizeof(uint8_t);
    default:
        return sizeof(uint32_t);
    }
}

static size_t offset_of(const scene_member *m, size_t line, size_t value)
{
    return m->offset + line * m->stride + value * scene_member_size(m);
}

uint32_t scene_member_get(const scene_member *m, const scene_draw *d, size_t line, size_t value)
{
    const char *const from = (const char *)d + offset_of(m, line, value);
    uint32_t word;

    if (m->type == MEMBER_SWITCH)
        return *(const bool *)from;
    if (m->type == MEMBER_BYTE)
        return *(const uint8_t *)from;
    memcpy(&word, from, sizeof word);
    return word;
}

void scene_member_set(const scene_member *m, scene_draw *d, size_t line, size_t value,
                      uint32_t word)
{
    char *const to = (char *)d + offset_of(m, line, value);

    if (m->type == MEMBER_SWITCH)
        *(bool *)to = word != 0;
    else if (m->type == MEMBER_BYTE)
        *(uint8_t *)to = (uint8_t)word;
    else
        memcpy(to, &word, sizeof word);
}

/* Whether `name` is the row's name with any index. Sets `line` to that index or to 0. */
static bool matches(const char *name, const char *row, size_t *line)
{
    const size_t before = strcspn(row, "[");
    char *after;

    *line = 0;
    if (!row[before])
        return !strcmp(name, row);
    if (strncmp(name, row, before + 1) != 0 || !isdigit((unsigned char)name[before + 1]))
        return false;
    *line = strtoul(name + before + 1, &after, 10);
    return !strcmp(after, strchr(row, ']'));
}

const scene_member *scene_member_named(const char *name, size_t *line)
{
    for (size_t i = 0; i < scene_member_count; ++i) {
        const scene_member *const m = &scene_members[i];

        if (m->type != MEMBER_ELSEWHERE && matches(name, m->name, line) &&
            *line < scene_member_lines(m))
            return m;
    }
    return NULL;
}

void scene_member_name(const scene_member *m, size_t line, char *name)
{
    const size_t before = strcspn(m->name, "[");

    if (m->name[before]) {
        snprintf(name, SCENE_MEMBER_NAME, "%.*s[%d%s", (int)before, m->name, (int)line,
                 strchr(m->name, ']'));
    } else {
        snprintf(name, SCENE_MEMBER_NAME, "%s", m->name);
    }
}
