/* The GLSL twins of the ready-made shaders: their programs, uniforms and maps. */
#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "twin_texts.h"

/* ---- Programs ---- */

/* The variant of a program, as bits. */
enum {
    POINT_LIGHT = 1,
    ATTENUATION = 2,
    DIFFUSE_MAP = 4,
    NORMAL_MAP = 8,
    TANGENTS = 16,
    SPECULAR_MAP = 32,
    GLOW_MAP = 64,
    SHADOW_MAP = 128,
    CLIPPED = 256,
    ALPHA_CUTOFF = 512,
    SPOT_LIGHT = 1024,
    LIGHT_RANGE = 2048,
    MORE_LIGHTS = 4096,
    METALLIC_ROUGHNESS_MAP = 8192,
    OCCLUSION_MAP = 16384,
    DOUBLE_SIDED = 32768,
    FEATURES = 65536
};

static bool is_shiny(scene_shader shader)
{
    return shader == SCENE_MAPPED_PHONG || shader == SCENE_BLINN_PHONG;
}

static bool is_attenuated(const scene_surface *s)
{
    return s->attenuation[0] != 0.0f || s->attenuation[1] != 0.0f || s->attenuation[2] != 0.0f;
}

static int features_of_lights(const scene_draw *d)
{
    const scene_surface *s = &d->surface;
    int features = s->more_light_count > 0 ? MORE_LIGHTS : 0;

    if (scene_light_kind(s) == GN_LIGHT_DIRECTIONAL)
        return features;
    features |= POINT_LIGHT;
    if (is_attenuated(s))
        features |= ATTENUATION;
    if (s->light_range > 0.0f)
        features |= LIGHT_RANGE;
    return s->has_spot_light ? features | SPOT_LIGHT : features;
}

static int features_of_normals(const scene_draw *d)
{
    if (!scene_draw_has_map(d, SCENE_NORMAL_MAP))
        return 0;
    return d->surface.normal_space == GN_NORMAL_OF_TANGENTS || d->shader == SCENE_METALLIC_ROUGHNESS
               ? NORMAL_MAP | TANGENTS
               : NORMAL_MAP;
}

/* Returns, as bits, which of the draw's maps the shader reads, and whether the draw is clipped. */
static int features_of(const scene_draw *d)
{
    const bool is_phong = is_shiny(d->shader);
    const bool is_metallic = d->shader == SCENE_METALLIC_ROUGHNESS;
    int features = d->state.program.clip_distance_count > 0 ? CLIPPED : 0;

    if (d->shader != SCENE_NORMAL_COLOR && scene_draw_has_texture(d))
        features |= DIFFUSE_MAP;
    if (scene_draw_has_lights(d))
        features |= features_of_lights(d);
    if (d->shader != SCENE_NORMAL_COLOR && scene_draw_has_map(d, SCENE_SHADOW_MAP))
        features |= SHADOW_MAP;
    if (is_phong || is_metallic || d->shader == SCENE_NORMAL_COLOR)
        features |= features_of_normals(d);
    if (is_phong && scene_draw_has_map(d, SCENE_SPECULAR_MAP))
        features |= SPECULAR_MAP;
    if ((is_phong || is_metallic) && scene_draw_has_map(d, SCENE_GLOW_MAP))
        features |= GLOW_MAP;
    if (is_metallic && scene_draw_has_map(d, SCENE_METALLIC_ROUGHNESS_MAP))
        features |= METALLIC_ROUGHNESS_MAP;
    if (is_metallic && scene_draw_has_map(d, SCENE_OCCLUSION_MAP))
        features |= OCCLUSION_MAP;
    if (is_metallic && d->surface.double_sided)
        features |= DOUBLE_SIDED;
    if (scene_draw_has_cutoff(d))
        features |= ALPHA_CUTOFF;
    return features;
}

typedef struct text {
    char *end;
    char begin[16384];
} text;

static void append(text *t, const char *more)
{
    const size_t length = strlen(more);

    if ((size_t)(t->end - t->begin) + length < sizeof t->begin) {
        memcpy(t->end, more, length + 1);
        t->end += length;
    }
}

static void define(text *t, int features, scene_shader shader)
{
    static const struct {
        int feature;
        const char *line;
    } lines[] = {{POINT_LIGHT, "#define POINT_LIGHT\n"},
                 {ATTENUATION, "#define ATTENUATION\n"},
                 {DIFFUSE_MAP, "#define DIFFUSE_MAP\n"},
                 {NORMAL_MAP, "#define NORMAL_MAP\n"},
                 {TANGENTS, "#define TANGENTS\n"},
                 {SPECULAR_MAP, "#define SPECULAR_MAP\n"},
                 {GLOW_MAP, "#define GLOW_MAP\n"},
                 {SHADOW_MAP, "#define SHADOW_MAP\n"},
                 {ALPHA_CUTOFF, "#define ALPHA_CUTOFF\n"},
                 {SPOT_LIGHT, "#define SPOT_LIGHT\n"},
                 {LIGHT_RANGE, "#define LIGHT_RANGE\n"},
                 {MORE_LIGHTS, "#define MORE_LIGHTS\n"},
                 {METALLIC_ROUGHNESS_MAP, "#define METALLIC_ROUGHNESS_MAP\n"},
                 {OCCLUSION_MAP, "#define OCCLUSION_MAP\n"},
                 {DOUBLE_SIDED, "#define DOUBLE_SIDED\n"}};

    t->end = t->begin;
    for (size_t i = 0; i < sizeof lines / sizeof *lines; ++i)
        if (features & lines[i].feature)
            append(t, lines[i].line);
    if (shader == SCENE_BLINN_PHONG)
        append(t, "#define BLINN\n");
    if (is_shiny(shader))
        append(t, "#define SHINY\n");
    if (shader == SCENE_TOON)
        append(t, "#define TOON\n");
    if (shader == SCENE_METALLIC_ROUGHNESS)
        append(t, "#define METALLIC_ROUGHNESS\n");
    append(t, shader == SCENE_FLAT ? "#define SHADING flat\n" : "#define SHADING smooth\n");
}

static void write_vertex(text *t, scene_shader shader)
{
    if (shader == SCENE_DEPTH_COLOR || shader == SCENE_DEPTH_ONLY) {
        append(t, position_vertex);
    } else if (shader == SCENE_UNLIT) {
        append(t, unlit_vertex);
    } else if (scene_shader_shows_surface(shader)) {
        append(t, surface_vertex);
    } else {
        append(t, light_text);
        append(t, lit_part_text);
        append(t, more_lights_text);
        append(t, gouraud_vertex);
    }
}

static void write_fragment(text *t, scene_shader shader)
{
    if (shader == SCENE_DEPTH_COLOR || shader == SCENE_DEPTH_ONLY) {
        append(t, shader == SCENE_DEPTH_COLOR ? depth_fragment : no_fragment);
        return;
    }
    append(t, fragment_head);
    if (!scene_shader_shows_surface(shader)) {
        append(t, shaded_main);
        return;
    }
    append(t, surface_text);
    append(t, light_text);
    append(t, lit_text);
    append(t, lit_part_text);
    if (is_shiny(shader))
        append(t, highlight_text);
    append(t, more_lights_text);
    append(t, shader == SCENE_NORMAL_COLOR         ? normal_main
              : shader == SCENE_METALLIC_ROUGHNESS ? metallic_main
              : is_shiny(shader)                   ? phong_main
                                                   : matte_main);
}

bool reference_has_twin(const scene_draw *d)
{
    return d->shader >= SCENE_UNLIT || scene_draw_has_cutoff(d) ||
           (scene_draw_has_lights(d) && features_of_lights(d) != 0);
}

GLuint reference_twin_program(reference *r, const scene_draw *d, char *error, size_t error_size)
{
    const int features = features_of(d);
    const uint32_t key = (uint32_t)d->shader * FEATURES + (uint32_t)features;
    text vertex, fragment;
    GLuint program;

    for (size_t i = 0; i < r->twin_count; ++i)
        if (r->twins[i].key == key)
            return r->twins[i].program;
    define(&vertex, features, d->shader);
    write_vertex(&vertex, d->shader);
    define(&fragment, features, d->shader);
    write_fragment(&fragment, d->shader);
    program = reference_link_clipped(vertex.begin, fragment.begin, (features & CLIPPED) != 0, error,
                                     error_size);
    if (program) {
        reference_twin *const grown = realloc(r->twins, (r->twin_count + 1) * sizeof *grown);

        if (!grown) {
            glDeleteProgram(program);
            reference_fail(error, error_size, "out of memory");
            return 0;
        }
        r->twins = grown;
        r->twins[r->twin_count++] = (reference_twin){key, program};
    }
    return program;
}

void reference_free_twins(reference *r)
{
    for (size_t i = 0; i < r->twin_count; ++i)
        glDeleteProgram(r->twins[i].program);
    free(r->twins);
}

/* ---- Uniforms and maps. A uniform that a program does not use has location -1, and setting it
 * there does nothing. ---- */

static void set_vec3(GLuint program, const char *name, gn_vec3 v)
{
    glUniform3f(glGetUniformLocation(program, name), v.x, v.y, v.z);
}

static void set_mat4(GLuint program, const char *name, const gn_mat4 *m)
{
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, &m->m[0][0]);
}

static GLint location_in(GLuint program, int light, const char *member)
{
    char name[64];

    snprintf(name, sizeof name, "more_lights[%d].%s", light, member);
    return glGetUniformLocation(program, name);
}

static void set_more_lights(GLuint program, const scene_surface *s)
{
    glUniform1i(glGetUniformLocation(program, "more_light_count"), (GLint)s->more_light_count);
    for (int i = 0; i < (int)s->more_light_count; ++i) {
        const gn_light *const l = &s->more_lights[i];

        glUniform1i(location_in(program, i, "kind"), (GLint)l->kind);
        glUniform3f(location_in(program, i, "direction"), l->direction.x, l->direction.y,
                    l->direction.z);
        glUniform3f(location_in(program, i, "position"), l->position.x, l->position.y,
                    l->position.z);
        glUniform3f(location_in(program, i, "attenuation"), l->constant, l->linear, l->quadratic);
        glUniform1f(location_in(program, i, "range"), l->range);
        glUniform2fv(location_in(program, i, "cone"), 1,
                     (const float[2]){l->inner_cosine, l->outer_cosine});
        glUniform3f(location_in(program, i, "ambient"), l->ambient.x, l->ambient.y, l->ambient.z);
        glUniform3f(location_in(program, i, "diffuse"), l->diffuse.x, l->diffuse.y, l->diffuse.z);
    }
}

void reference_set_twin_uniforms(const scene_draw *d, GLuint program)
{
    const scene_light *light = &d->uniforms.light;
    const scene_surface *s = &d->surface;
    const bool both_zero = s->black == 0.0f && s->white == 0.0f;

    set_mat4(program, "clip_from_model", &light->clip_from_model);
    glUniformMatrix3fv(glGetUniformLocation(program, "normal_matrix"), 1, GL_FALSE,
                       &light->normal_matrix.m[0][0]);
    set_vec3(program, "light_direction", light->light_direction);
    set_vec3(program, "ambient", light->ambient);
    set_vec3(program, "diffuse", light->diffuse);
    set_mat4(program, "world_from_model", &s->world_from_model);
    set_vec3(program, "light_position", s->light_position);
    glUniform1f(glGetUniformLocation(program, "light_range"), s->light_range);
    glUniform2fv(glGetUniformLocation(program, "cone"), 1, s->cone);
    if (scene_draw_has_lights(d))
        set_more_lights(program, s);
    glUniform3fv(glGetUniformLocation(program, "attenuation"), 1, s->attenuation);
    set_vec3(program, "eye", s->eye);
    set_vec3(program, "specular", d->specular);
    glUniform1ui(glGetUniformLocation(program, "exponent"), s->exponent);
    glUniform1f(glGetUniformLocation(program, "bands"), s->bands ? (float)s->bands : 4.0f);
    set_mat4(program, "shadow_from_world", &s->shadow_from_world);
    glUniform1f(glGetUniformLocation(program, "black"), s->black);
    glUniform1f(glGetUniformLocation(program, "white"), both_zero ? 1.0f : s->white);
    glUniform1f(glGetUniformLocation(program, "alpha_cutoff"), s->alpha_cutoff);
    glUniform1f(glGetUniformLocation(program, "metallic"), s->metallic);
    glUniform1f(glGetUniformLocation(program, "roughness"), s->roughness);
    glUniform1f(glGetUniformLocation(program, "normal_scale"), s->normal_scale);
    glUniform1f(glGetUniformLocation(program, "occlusion_strength"), s->occlusion_strength);
    set_vec3(program, "emissive", s->emissive);
}

void reference_upload_maps(const scene_draw *d, GLuint maps[SCENE_MAP_COUNT])
{
    for (int m = 0; m < SCENE_MAP_COUNT; ++m) {
        maps[m] = 0;
        if (scene_draw_has_map(d, (scene_map)m)) {
            maps[m] =
                reference_upload_texture(&d->surface.map[m], scene_map_sampler(d, (scene_map)m));
        }
    }
}

void reference_bind_maps(const GLuint maps[SCENE_MAP_COUNT])
{
    for (int m = 0; m < SCENE_MAP_COUNT; ++m) {
        glActiveTexture((GLenum)(GL_TEXTURE1 + m));
        glBindTexture(GL_TEXTURE_2D, maps[m]);
    }
}
