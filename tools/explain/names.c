/* Names of what the stages read. */
#include "names.h"

#include <string.h>

#include "../../src/kernel/shaders/ready_made.h"
#include "told.h"

#define MOST_MATRICES 6
#define MOST_VECTORS 8
#define MOST_MAPS 6

static struct {
    struct {
        const char *name;
        const float *at;
    } matrix[MOST_MATRICES];
    struct {
        const char *name;
        gn_vec3 v;
    } vector[MOST_VECTORS];
    struct {
        const char *name;
        const gn_texture *map;
    } map[MOST_MAPS];
    int matrices, vectors, maps;
} known;

static const char axis[4][2] = {"x", "y", "z", "w"};
static const char channel[4][6] = {"red", "green", "blue", "alpha"};

static void add_matrix(const char *name, const float *m, int size)
{
    known.matrix[known.matrices].name = name;
    known.matrix[known.matrices++].at = m;
    for (int row = 0; row < size; ++row) {
        prose value = {0}, bits = {0};

        for (int column = 0; column < size; ++column) {
            prose_put(&value, column ? "  " : "");
            prose_put(&bits, column ? " " : "");
            prose_float(&value, m[size * column + row]);
            prose_hexadecimal(&bits, bits_of_float(m[size * column + row]), 8);
        }
        report_tell(joined(name, " row ", axis[row]), prose_of(&value), prose_of(&bits),
                    row ? "" : joined(name, "[column][row]: both are counted from 0 on", ""));
        prose_free(&value);
        prose_free(&bits);
    }
}

void names_add_world(const gn_mat4 *world_from_model, const gn_mat4 *view_from_world)
{
    bool is_known = false;

    for (int i = 0; i < known.matrices; ++i)
        is_known = is_known || strcmp(known.matrix[i].name, "world_from_model") == 0;
    if (!is_known)
        add_matrix("world_from_model", &world_from_model->m[0][0], 4);
    add_matrix("view_from_world", &view_from_world->m[0][0], 4);
}

static void add_vector(const char *name, gn_vec3 v, bool is_color)
{
    const float part[3] = {v.x, v.y, v.z};
    prose value = {0}, bits = {0};

    for (int i = 0; i < 3; ++i) {
        prose_put(&value, i ? "  " : "");
        prose_put(&bits, i ? " " : "");
        prose_float(&value, part[i]);
        prose_hexadecimal(&bits, bits_of_float(part[i]), 8);
    }
    report_tell(name, prose_of(&value), prose_of(&bits),
                is_color ? "red, green, blue" : "x, y, z in world space");
    known.vector[known.vectors].name = name;
    known.vector[known.vectors++].v = v;
    prose_free(&value);
    prose_free(&bits);
}

static void add_map(const char *name, const gn_texture *map)
{
    prose size = {0};

    if (!map)
        return;
    prose_integer(&size, map->width);
    prose_put(&size, " x ");
    prose_integer(&size, map->height);
    prose_put(&size, " texels");
    report_tell(name, prose_of(&size), "",
                map->level_count > 1 ? joined_number("", map->level_count, " levels")
                                     : "one level");
    prose_free(&size);
    known.map[known.maps].name = name;
    known.map[known.maps++].map = map;
}

static void add_spaces(const gn_mat4 *clip_from_model, const gn_mat4 *world_from_model,
                       const gn_mat3 *normal_matrix)
{
    add_matrix("clip_from_model", &clip_from_model->m[0][0], 4);
    add_matrix("world_from_model", &world_from_model->m[0][0], 4);
    add_matrix("normal_matrix", &normal_matrix->m[0][0], 3);
}

static void add_light(const gn_light *light)
{
    if (light->kind != GN_LIGHT_DIRECTIONAL)
        add_vector("light.position", light->position, false);
    if (light->kind != GN_LIGHT_POINT)
        add_vector("light.direction", light->direction, false);
    add_vector("light.ambient", light->ambient, true);
    add_vector("light.diffuse", light->diffuse, true);
}

static void add_shadow(const gn_shadow *shadow)
{
    add_map("shadow_map", shadow->map);
    if (shadow->map)
        add_matrix("shadow_from_world", &shadow->clip_from_world.m[0][0], 4);
}

static void add_metallic(const gn_metallic_roughness_uniforms *u)
{
    add_spaces(&u->clip_from_model, &u->world_from_model, &u->normal_matrix);
    add_light(&u->light);
    add_vector("eye", u->eye, false);
    add_vector("emissive", u->material.emissive, true);
    add_map("base_color_map", u->material.base_color_map.texture);
    add_map("metallic_roughness_map", u->material.metallic_roughness_map.texture);
    add_map("normal_map", u->material.normal_map.texture);
    add_map("occlusion_map", u->material.occlusion_map.texture);
    add_map("emissive_map", u->material.emissive_map.texture);
    add_shadow(&u->shadow);
}

static void add_lit(const gn_lit_uniforms *u)
{
    add_spaces(&u->clip_from_model, &u->world_from_model, &u->normal_matrix);
    add_light(&u->light);
    add_vector("eye", u->eye, false);
    add_vector("specular", u->material.specular, true);
    add_map("diffuse_map", u->material.diffuse_map);
    add_map("normal_map", u->material.normal_map);
    add_map("specular_map", u->material.specular_map);
    add_map("glow_map", u->material.glow_map);
    add_shadow(&u->shadow);
}

void names_of_draw(const gn_pipeline *pipeline)
{
    const gn_program *const program = &pipeline->program;

    known.matrices = known.vectors = known.maps = 0;
    report_begin("What the draw hands to its shaders");
    if (program->vertex_shader == gni_shade_vertex_lit ||
        program->vertex_shader == gni_shade_vertex_surface) {
        add_lit(program->uniforms);
    } else if (program->vertex_shader == gni_shade_vertex_metallic) {
        add_metallic(program->uniforms);
    } else if (program->vertex_shader == gni_shade_vertex_unlit) {
        const gn_unlit_uniforms *const u = program->uniforms;

        add_matrix("clip_from_model", &u->clip_from_model.m[0][0], 4);
        add_map("diffuse_map", u->map);
    } else if (program->vertex_shader == gni_shade_vertex_color ||
               program->vertex_shader == gni_shade_vertex_position) {
        const gn_color_uniforms *const u = program->uniforms;

        add_matrix("clip_from_model", &u->clip_from_model.m[0][0], 4);
    }
}

const char *names_attribute(uint32_t a, uint32_t c)
{
    return a == GN_ATTRIBUTE_POSITION   ? joined("position.", axis[c], "")
           : a == GN_ATTRIBUTE_NORMAL   ? joined("normal.", axis[c], "")
           : a == GN_ATTRIBUTE_COLOR    ? joined("color.", channel[c], "")
           : a == GN_ATTRIBUTE_TEXCOORD ? joined("texcoord.", c ? "t" : "s", "")
           : a == GN_ATTRIBUTE_TANGENT  ? joined("tangent.", axis[c], "")
                                        : joined(joined_number("attribute", a, "."), axis[c], "");
}

const char *names_varying(uint32_t n)
{
    static const char name[GN_SHADER_VARYINGS][11] = {
        "red",       "green",     "blue",      "alpha",     "s",       "t",
        "normal.x",  "normal.y",  "normal.z",  "place.x",   "place.y", "place.z",
        "tangent.x", "tangent.y", "tangent.z", "handedness"};

    return n < GN_SHADER_VARYINGS ? name[n] : joined_number("varying", n, "");
}

const char *names_matrix(const void *matrix)
{
    for (int i = 0; i < known.matrices; ++i)
        if ((const void *)known.matrix[i].at == matrix)
            return known.matrix[i].name;
    return "";
}

static bool same_bits(float a, float b)
{
    return bits_of_float(a) == bits_of_float(b);
}

const char *names_vector(gn_vec3 v)
{
    for (int i = 0; i < known.vectors; ++i)
        if (same_bits(v.x, known.vector[i].v.x) && same_bits(v.y, known.vector[i].v.y) &&
            same_bits(v.z, known.vector[i].v.z))
            return known.vector[i].name;
    return "";
}

const char *names_map(const gn_texture *map)
{
    for (int i = 0; i < known.maps; ++i)
        if (known.map[i].map == map)
            return known.map[i].name;
    return "texture";
}

/* Returns where in a level an address is, in texels; false if it is not in the level. */
static bool find_in_level(const gn_texture *map, uint32_t level, uintptr_t address, ptrdiff_t *x,
                          ptrdiff_t *y)
{
    const uintptr_t first = (uintptr_t)map->level[level].texels;
    const ptrdiff_t stride = map->level[level].row_stride;
    const ptrdiff_t size = (ptrdiff_t)gn_format_size(map->format);
    const uint32_t width = map->width >> level ? map->width >> level : 1;
    const uint32_t height = map->height >> level ? map->height >> level : 1;

    if (!first || stride <= 0)
        return false;
    const ptrdiff_t offset = (ptrdiff_t)(address - first);

    *y = offset / stride;
    *x = offset % stride / size;
    return address >= first && *y < (ptrdiff_t)height && *x < (ptrdiff_t)width;
}

const char *names_texel(const void *address, bool *is_float)
{
    ptrdiff_t x, y;

    for (int i = 0; i < known.maps; ++i) {
        const gn_texture *const map = known.map[i].map;
        const uint32_t levels = map->level_count ? map->level_count : 1;

        for (uint32_t level = 0; level < levels; ++level) {
            if (!find_in_level(map, level, (uintptr_t)address, &x, &y))
                continue;
            *is_float = map->format == GN_FORMAT_D32F;
            return joined(joined(known.map[i].name, levels > 1 ? ".level" : "",
                                 levels > 1 ? joined_number("", level, "") : ""),
                          joined_number("[", x, ", "), joined_number("", y, "]"));
        }
    }
    return "";
}
