/* The GLSL twins of the ready-made shaders of gnomon/shaders.h, written as a user would write them.
 * Macros in front of the text say which maps and lights the draw has. */
#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Vertices ---- */

static const char unlit_vertex[] = "smooth out vec4 shade;\n"
                                   "smooth out vec2 coordinates;\n"
                                   "void main()\n"
                                   "{\n"
                                   "    gl_Position = clip_from_model * position;\n"
                                   "    shade = color;\n"
                                   "    coordinates = texcoord.st;\n"
                                   "}\n";

/* The direction towards the light at a place, and the light's attenuation there. */
static const char light_text[] = "uniform vec3 light_position;\n"
                                 "uniform float light_range;\n"
                                 "uniform vec2 cone;\n"
                                 "float within_range(float range, float distance)\n"
                                 "{\n"
                                 "    float part = distance / range;\n"
                                 "    float squared = part * part;\n"
                                 "    return max(1.0 - squared * squared, 0.0);\n"
                                 "}\n"
                                 "float within_cone(vec3 axis, vec2 cone, vec3 to_light)\n"
                                 "{\n"
                                 "    float inside = dot(to_light, axis) - cone.y;\n"
                                 "    float part = inside / max(cone.x - cone.y, 0.001);\n"
                                 "    part = min(max(part, 0.0), 1.0);\n"
                                 "    return part * part;\n"
                                 "}\n"
                                 "uniform vec3 attenuation;\n"
                                 "void light_at(vec3 place, out vec3 to_light, out float left)\n"
                                 "{\n"
                                 "    left = 1.0;\n"
                                 "#ifdef POINT_LIGHT\n"
                                 "    to_light = light_position - place;\n"
                                 "    float distance = length(to_light);\n"
                                 "    to_light = normalize(to_light);\n"
                                 "#ifdef ATTENUATION\n"
                                 "    left = 1.0 / (attenuation.x + attenuation.y * distance +\n"
                                 "                  attenuation.z * distance * distance);\n"
                                 "#endif\n"
                                 "#ifdef LIGHT_RANGE\n"
                                 "    left = left * within_range(light_range, distance);\n"
                                 "#endif\n"
                                 "#ifdef SPOT_LIGHT\n"
                                 "    left = left * within_cone(light_direction, cone, to_light);\n"
                                 "#endif\n"
                                 "#else\n"
                                 "    to_light = light_direction;\n"
                                 "#endif\n"
                                 "}\n";

/* The lights after the first. */
static const char more_lights_text[] =
    "#ifdef MORE_LIGHTS\n"
    "struct light {\n"
    "    int kind;\n"
    "    vec3 direction;\n"
    "    vec3 position;\n"
    "    vec3 attenuation;\n"
    "    float range;\n"
    "    vec2 cone;\n"
    "    vec3 ambient;\n"
    "    vec3 diffuse;\n"
    "};\n"
    "uniform light more_lights[7];\n"
    "uniform int more_light_count;\n"
    "void more_light_at(int i, vec3 place, out vec3 to_light, out float left)\n"
    "{\n"
    "    left = 1.0;\n"
    "    to_light = more_lights[i].direction;\n"
    "    if (more_lights[i].kind == 0)\n"
    "        return;\n"
    "    to_light = more_lights[i].position - place;\n"
    "    float distance = length(to_light);\n"
    "    to_light = normalize(to_light);\n"
    "    vec3 fade = more_lights[i].attenuation;\n"
    "    if (fade != vec3(0.0))\n"
    "        left = 1.0 / (fade.x + fade.y * distance + fade.z * distance * distance);\n"
    "    if (more_lights[i].range > 0.0)\n"
    "        left = left * within_range(more_lights[i].range, distance);\n"
    "    if (more_lights[i].kind == 2)\n"
    "        left = left * within_cone(more_lights[i].direction, more_lights[i].cone, to_light);\n"
    "}\n"
    "void add_more_lights(vec3 place, vec3 n, vec3 to_eye, inout vec3 received,\n"
    "                     inout float shone)\n"
    "{\n"
    "    for (int i = 0; i < more_light_count; ++i) {\n"
    "        vec3 to_light;\n"
    "        float left;\n"
    "        more_light_at(i, place, to_light, left);\n"
    "        float cosine = dot(n, to_light);\n"
    "        float lit = lit_part(cosine) * left;\n"
    "        received = received + (more_lights[i].ambient + more_lights[i].diffuse * lit);\n"
    "#ifdef SHINY\n"
    "        shone = shone + highlight(n, to_light, cosine, to_eye) * left;\n"
    "#endif\n"
    "    }\n"
    "}\n"
    "#endif\n";

/* The part of a light that a surface diffuses. */
static const char lit_part_text[] =
    "#ifdef TOON\n"
    "uniform float bands;\n"
    "#endif\n"
    "float lit_part(float cosine)\n"
    "{\n"
    "    float lit = max(cosine, 0.0);\n"
    "#ifdef TOON\n"
    "    lit = min(floor(lit * bands), bands - 1.0) / (bands - 1.0);\n"
    "#endif\n"
    "    return lit;\n"
    "}\n";

static const char gouraud_vertex[] =
    "uniform mat4 world_from_model;\n"
    "SHADING out vec4 shade;\n"
    "smooth out vec2 coordinates;\n"
    "void main()\n"
    "{\n"
    "    vec3 n = normalize(normal_matrix * normal.xyz);\n"
    "    vec3 to_light;\n"
    "    float left;\n"
    "    light_at((world_from_model * position).xyz, to_light, left);\n"
    "    float lit = lit_part(dot(n, to_light)) * left;\n"
    "    gl_Position = clip_from_model * position;\n"
    "    vec3 received = ambient + diffuse * lit;\n"
    "#ifdef MORE_LIGHTS\n"
    "    float shone = 0.0;\n"
    "    add_more_lights((world_from_model * position).xyz, n, vec3(0.0), received, shone);\n"
    "#endif\n"
    "    shade = vec4(color.rgb * received, color.a);\n"
    "    coordinates = texcoord.st;\n"
    "}\n";

static const char surface_vertex[] =
    "layout(location = 4) in vec4 tangent;\n"
    "uniform mat4 world_from_model;\n"
    "smooth out vec4 shade;\n"
    "smooth out vec2 coordinates;\n"
    "smooth out vec3 turned_normal;\n"
    "smooth out vec3 place;\n"
    "smooth out vec4 turned_tangent;\n"
    "vec3 unit(vec3 v)\n"
    "{\n"
    "    float square = dot(v, v);\n"
    "    return v * (square > 0.0 ? inversesqrt(square) : 0.0);\n"
    "}\n"
    "void main()\n"
    "{\n"
    "    gl_Position = clip_from_model * position;\n"
    "    shade = color;\n"
    "    coordinates = texcoord.st;\n"
    "    turned_normal = unit(normal_matrix * normal.xyz);\n"
    "    place = (world_from_model * position).xyz;\n"
    "    turned_tangent = vec4(unit(mat3(world_from_model) * tangent.xyz), tangent.w);\n"
    "}\n";

/* ---- Fragments ---- */

static const char fragment_head[] = "smooth in vec2 coordinates;\n"
                                    "layout(binding = 0) uniform sampler2D diffuse_map;\n"
                                    "layout(location = 0) out vec4 result;\n"
                                    "uniform float alpha_cutoff;\n"
                                    "void put(vec4 color)\n"
                                    "{\n"
                                    "#ifdef ALPHA_CUTOFF\n"
                                    "    if (color.a < alpha_cutoff)\n"
                                    "        discard;\n"
                                    "#endif\n"
                                    "    result = color;\n"
                                    "}\n";

static const char shaded_main[] = "SHADING in vec4 shade;\n"
                                  "void main()\n"
                                  "{\n"
                                  "#ifdef DIFFUSE_MAP\n"
                                  "    put(shade * texture(diffuse_map, coordinates));\n"
                                  "#else\n"
                                  "    put(shade);\n"
                                  "#endif\n"
                                  "}\n";

static const char surface_text[] =
    "smooth in vec4 shade;\n"
    "smooth in vec3 turned_normal;\n"
    "smooth in vec3 place;\n"
    "smooth in vec4 turned_tangent;\n"
    "layout(binding = 1) uniform sampler2D normal_map;\n"
    "layout(binding = 2) uniform sampler2D specular_map;\n"
    "layout(binding = 3) uniform sampler2D glow_map;\n"
    "layout(binding = 4) uniform sampler2DShadow shadow_map;\n"
    "uniform mat3 normal_matrix;\n"
    "uniform mat4 shadow_from_world;\n"
    "uniform vec3 light_direction;\n"
    "uniform vec3 ambient;\n"
    "uniform vec3 diffuse;\n"
    "uniform vec3 specular;\n"
    "uniform vec3 eye;\n"
    "uniform uint exponent;\n"
    "vec4 surface_color()\n"
    "{\n"
    "#ifdef DIFFUSE_MAP\n"
    "    return shade * texture(diffuse_map, coordinates);\n"
    "#else\n"
    "    return shade;\n"
    "#endif\n"
    "}\n"
    "vec3 surface_normal()\n"
    "{\n"
    "    vec3 n = turned_normal;\n"
    "#ifdef NORMAL_MAP\n"
    "    vec3 m = texture(normal_map, coordinates).xyz * 2.0 - 1.0;\n"
    "#ifdef TANGENTS\n"
    "    vec3 bitangent = cross(n, turned_tangent.xyz) * turned_tangent.w;\n"
    "    n = m.x * turned_tangent.xyz + m.y * bitangent + m.z * n;\n"
    "#else\n"
    "    n = normal_matrix * m;\n"
    "#endif\n"
    "#endif\n"
    "    return normalize(n);\n"
    "}\n";

static const char lit_text[] =
    "void light_fragment(out vec3 to_light, out float left)\n"
    "{\n"
    "    light_at(place, to_light, left);\n"
    "#ifdef SHADOW_MAP\n"
    "    vec4 seen = shadow_from_world * vec4(place, 1.0);\n"
    "    left = left * texture(shadow_map, (seen.xyz / seen.w) * 0.5 + 0.5);\n"
    "#endif\n"
    "}\n";

/* Flat and toon shading. */
static const char matte_main[] = "void main()\n"
                                 "{\n"
                                 "    vec3 to_light;\n"
                                 "    float left;\n"
                                 "    light_fragment(to_light, left);\n"
                                 "#ifdef TOON\n"
                                 "    vec3 n = normalize(turned_normal);\n"
                                 "#else\n"
                                 "    vec3 n = normalize(cross(dFdx(place), dFdy(place)));\n"
                                 "#endif\n"
                                 "    vec4 c = surface_color();\n"
                                 "    float lit = lit_part(dot(n, to_light)) * left;\n"
                                 "    vec3 received = ambient + diffuse * lit;\n"
                                 "#ifdef MORE_LIGHTS\n"
                                 "    float shone = 0.0;\n"
                                 "    add_more_lights(place, n, vec3(0.0), received, shone);\n"
                                 "#endif\n"
                                 "    put(vec4(c.rgb * received, c.a));\n"
                                 "}\n";

/* The highlight of a light. */
static const char highlight_text[] =
    "float power(float base, uint exponent)\n"
    "{\n"
    "    float p = 1.0;\n"
    "    for (; exponent > 0u; exponent >>= 1) {\n"
    "        if ((exponent & 1u) != 0u)\n"
    "            p = p * base;\n"
    "        base = base * base;\n"
    "    }\n"
    "    return p;\n"
    "}\n"
    "float highlight(vec3 n, vec3 to_light, float cosine, vec3 to_eye)\n"
    "{\n"
    "#ifdef BLINN\n"
    "    float base = dot(n, normalize(to_light + to_eye));\n"
    "#else\n"
    "    float base = dot(reflect(-to_light, n), to_eye);\n"
    "#endif\n"
    "    return cosine > 0.0 ? power(max(base, 0.0), exponent) : 0.0;\n"
    "}\n";

static const char phong_main[] =
    "void main()\n"
    "{\n"
    "    vec3 to_light;\n"
    "    float left;\n"
    "    light_fragment(to_light, left);\n"
    "    vec3 to_eye = normalize(eye - place);\n"
    "    vec3 n = surface_normal();\n"
    "    float cosine = dot(n, to_light);\n"
    "    float shone = highlight(n, to_light, cosine, to_eye) * left;\n"
    "    vec3 s = specular;\n"
    "#ifdef SPECULAR_MAP\n"
    "    s = s * texture(specular_map, coordinates).rgb;\n"
    "#endif\n"
    "    vec4 c = surface_color();\n"
    "    float lit = lit_part(cosine) * left;\n"
    "    vec3 received = ambient + diffuse * lit;\n"
    "#ifdef MORE_LIGHTS\n"
    "    add_more_lights(place, n, to_eye, received, shone);\n"
    "#endif\n"
    "    vec3 rgb = c.rgb * received;\n"
    "#ifdef GLOW_MAP\n"
    "    rgb = rgb + texture(glow_map, coordinates).rgb;\n"
    "#endif\n"
    "    rgb = rgb + s * shone;\n"
    "    put(vec4(rgb, c.a));\n"
    "}\n";

static const char normal_main[] = "void main()\n"
                                  "{\n"
                                  "    result = vec4(0.5 * surface_normal() + 0.5, 1.0);\n"
                                  "}\n";

static const char depth_fragment[] =
    "uniform float black;\n"
    "uniform float white;\n"
    "layout(location = 0) out vec4 result;\n"
    "void main()\n"
    "{\n"
    "    result = vec4(vec3((gl_FragCoord.z - black) / (white - black)), 1.0);\n"
    "}\n";

static const char position_vertex[] = "void main() { gl_Position = clip_from_model * position; }\n";

static const char no_fragment[] = "void main() {}\n";

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
    FEATURES = 8192
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
    return d->surface.normal_space == GN_NORMAL_OF_TANGENTS ? NORMAL_MAP | TANGENTS : NORMAL_MAP;
}

/* Returns, as bits, which of the draw's maps the shader reads, and whether the draw is clipped. */
static int features_of(const scene_draw *d)
{
    const bool is_phong = is_shiny(d->shader);
    int features = d->state.program.clip_distance_count > 0 ? CLIPPED : 0;

    if (d->shader != SCENE_NORMAL_COLOR && scene_draw_has_texture(d))
        features |= DIFFUSE_MAP;
    if (scene_draw_has_lights(d))
        features |= features_of_lights(d);
    if (d->shader != SCENE_NORMAL_COLOR && scene_draw_has_map(d, SCENE_SHADOW_MAP))
        features |= SHADOW_MAP;
    if (is_phong || d->shader == SCENE_NORMAL_COLOR)
        features |= features_of_normals(d);
    if (is_phong && scene_draw_has_map(d, SCENE_SPECULAR_MAP))
        features |= SPECULAR_MAP;
    if (is_phong && scene_draw_has_map(d, SCENE_GLOW_MAP))
        features |= GLOW_MAP;
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
    } lines[] = {{POINT_LIGHT, "#define POINT_LIGHT\n"},   {ATTENUATION, "#define ATTENUATION\n"},
                 {DIFFUSE_MAP, "#define DIFFUSE_MAP\n"},   {NORMAL_MAP, "#define NORMAL_MAP\n"},
                 {TANGENTS, "#define TANGENTS\n"},         {SPECULAR_MAP, "#define SPECULAR_MAP\n"},
                 {GLOW_MAP, "#define GLOW_MAP\n"},         {SHADOW_MAP, "#define SHADOW_MAP\n"},
                 {ALPHA_CUTOFF, "#define ALPHA_CUTOFF\n"}, {SPOT_LIGHT, "#define SPOT_LIGHT\n"},
                 {LIGHT_RANGE, "#define LIGHT_RANGE\n"},   {MORE_LIGHTS, "#define MORE_LIGHTS\n"}};

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
    append(t, shader == SCENE_NORMAL_COLOR ? normal_main
              : is_shiny(shader)           ? phong_main
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
}

void reference_upload_maps(const scene_draw *d, GLuint maps[SCENE_MAP_COUNT])
{
    for (int m = 0; m < SCENE_MAP_COUNT; ++m) {
        maps[m] = 0;
        if (scene_draw_has_map(d, (scene_map)m)) {
            maps[m] = reference_upload_texture(&d->surface.map[m], m == SCENE_SHADOW_MAP
                                                                       ? &d->surface.shadow_sampler
                                                                       : &d->uniforms.sampler);
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
