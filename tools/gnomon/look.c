/* Turns parts into draws. */
#include "look.h"

#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"

#include "report.h"

#define AMBIENT 0.25f
#define DIFFUSE 0.75f

int look_choose(const options *o, const camera *view, shading which, look *result)
{
    memset(result, 0, sizeof *result);
    result->options = o;
    result->shading = which;
    result->view = *view;
    result->light_direction = view->light_direction;
    result->ambient = (gn_vec3){AMBIENT, AMBIENT, AMBIENT};
    result->diffuse = (gn_vec3){DIFFUSE, DIFFUSE, DIFFUSE};
    if (o->light_given && gn_vec3_normalize(o->light, &result->light_direction) != GN_OK)
        return report_fault("--light", "impossible direction: the vector is zero");
    return 0;
}

static scene_shader shader_of(shading which, bool has_diffuse_map)
{
    switch (which) {
    case SHADING_VERTEX_COLOR:
        return SCENE_VERTEX_COLOR;
    case SHADING_UNLIT:
        return SCENE_UNLIT;
    case SHADING_FLAT:
        return SCENE_FACES;
    case SHADING_TOON:
        return SCENE_TOON;
    case SHADING_PHONG:
        return SCENE_MAPPED_PHONG;
    case SHADING_BLINN_PHONG:
        return SCENE_BLINN_PHONG;
    case SHADING_NORMALS:
        return SCENE_NORMAL_COLOR;
    case SHADING_DEPTH:
        return SCENE_DEPTH_COLOR;
    default:
        return has_diffuse_map ? SCENE_TEXTURED_GOURAUD : SCENE_GOURAUD;
    }
}

/* The sampler of a material's first map: the shaders have one for all maps. Beside a map that does
 * not repeat is the material's colour: its border is white. */
static gn_sampler sampler_of(const options *o, const model_map *map)
{
    const filter_option filter = o->filter;
    gn_sampler sampler;
    memset(&sampler, 0, sizeof sampler);
    sampler.wrap_s = map->wrap_s;
    sampler.wrap_t = map->wrap_t;
    for (int c = 0; c < 4; ++c)
        sampler.border[c] = 1.0f;
    if (map->has_filters && !o->filter_given) {
        sampler.minify = map->minify;
        sampler.magnify = map->magnify;
        return sampler;
    }
    sampler.minify = filter == FILTER_MIPMAP   ? GN_MINIFY_LINEAR_MIPMAP_LINEAR
                     : filter == FILTER_LINEAR ? GN_MINIFY_LINEAR
                                               : GN_MINIFY_NEAREST;
    sampler.magnify = filter == FILTER_NEAREST ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR;
    return sampler;
}

static uint32_t count_levels(uint32_t width, uint32_t height)
{
    uint32_t count = 1;
    for (uint32_t size = width > height ? width : height; size > 1; size /= 2)
        ++count;
    return count;
}

/* The memory of levels generated for the texture; a scene has copies. */
static gn_texture texture_of(const image *from, filter_option filter, void **memory)
{
    gn_texture texture;
    const uint32_t count = filter == FILTER_MIPMAP ? count_levels(from->width, from->height) : 1;
    *memory = NULL;
    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, from->width, from->height, 1, 1, from->texels,
                      &texture);
    if (count > 1) {
        const size_t size = gn_texture_memory_size(GN_TEXTURE_2D, GN_FORMAT_RGBA8, from->width,
                                                   from->height, 1, count) -
                            (size_t)from->width * from->height * sizeof *from->texels;
        *memory = scene_allocate(size, 1);
        gn_texture_generate_levels(&texture, *memory, size);
    }
    return texture;
}

static void set_maps(scene_draw *draw, const look *l, const model_part *part, const part_maps *maps)
{
    static const scene_map places[OPTIONS_MAP_COUNT] = {SCENE_MAP_COUNT, SCENE_NORMAL_MAP,
                                                        SCENE_SPECULAR_MAP, SCENE_GLOW_MAP};
    int first = MAP_DIFFUSE;
    while (first < MAP_GLOW && maps->images[first].texels == NULL)
        ++first;
    for (int i = 0; i < OPTIONS_MAP_COUNT; ++i) {
        void *memory;
        if (maps->images[i].texels == NULL)
            continue;
        const gn_texture texture = texture_of(maps->images + i, l->options->filter, &memory);
        if (i == MAP_DIFFUSE)
            scene_set_levels(draw, &texture);
        else
            scene_set_map(draw, places[i], &texture);
        free(memory);
    }
    draw->uniforms.sampler = sampler_of(l->options, part->maps + first);
    draw->surface.normal_space =
        maps->normals_in_tangent_space ? GN_NORMAL_OF_TANGENTS : GN_NORMAL_OF_MODEL;
}

static void set_shine(scene_draw *draw, const look *l, const model_part *part)
{
    const float *specular = part->surface.shine.specular;
    draw->specular = (gn_vec3){specular[0], specular[1], specular[2]};
    draw->surface.exponent =
        l->options->exponent != 0 ? l->options->exponent : part->surface.shine.exponent;
    draw->surface.bands = l->options->bands;
}

/* Whether a matrix turns right hands into left hands. */
static bool is_mirrored(const gn_mat4 *matrix)
{
    const float(*m)[4] = matrix->m;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += (double)m[0][i] *
               ((double)m[1][j] * (double)m[2][k] - (double)m[1][k] * (double)m[2][j]);
    }
    return sum < 0.0;
}

/* In a mirrored model the bitangent is on the other side of normal and tangent. */
static void mirror_tangents(scene_draw *draw, const model_part *part)
{
    float *mirrored = scene_allocate(part->vertex_count, 4 * sizeof *mirrored);
    memcpy(mirrored, part->tangents, (size_t)part->vertex_count * 4 * sizeof *mirrored);
    for (size_t v = 0; v < part->vertex_count; ++v)
        mirrored[4 * v + 3] = -mirrored[4 * v + 3];
    scene_set_attribute(draw, GN_ATTRIBUTE_TANGENT, mirrored, 4, part->vertex_count);
    free(mirrored);
}

/* The colours of vertices: white where a map takes the material's place, and opaque where alpha has
 * no meaning. */
static void set_colors(scene_draw *draw, const options *o, const model_part *part,
                       const part_maps *maps)
{
    const bool has_map = maps->images[MAP_DIFFUSE].texels != NULL;
    const bool is_white = has_map && maps->replaces_color && !part->has_vertex_colors;
    const bool is_opaque = part->surface.alpha == MODEL_OPAQUE || o->opaque;
    float *const colors = scene_allocate(part->vertex_count, 4 * sizeof *colors);
    memcpy(colors, part->colors, (size_t)part->vertex_count * 4 * sizeof *colors);
    for (size_t v = 0; v < part->vertex_count; ++v) {
        float *const color = colors + 4 * v;
        if (is_white)
            color[0] = color[1] = color[2] = 1.0f;
        if (is_opaque)
            color[3] = 1.0f;
    }
    scene_set_attribute(draw, GN_ATTRIBUTE_COLOR, colors, 4, part->vertex_count);
    free(colors);
}

static void set_attributes(scene_draw *draw, const options *o, const model_part *part,
                           const part_maps *maps)
{
    const uint32_t count = part->vertex_count;
    scene_set_attribute(draw, GN_ATTRIBUTE_POSITION, part->positions, 3, count);
    set_colors(draw, o, part, maps);
    scene_set_attribute(draw, GN_ATTRIBUTE_NORMAL, part->normals, 3, count);
    if (part->has_texcoords)
        scene_set_attribute(draw, GN_ATTRIBUTE_TEXCOORD, part->texcoords, 2, count);
    if (part->has_tangents)
        scene_set_attribute(draw, GN_ATTRIBUTE_TANGENT, part->tangents, 4, count);
    if (part->has_tangents && is_mirrored(&part->world_from_model.matrix))
        mirror_tangents(draw, part);
    scene_set_indices(draw, part->indices, part->index_count, GN_INDEX_UINT32);
}

/* Colours are mixed by alpha; the target's alpha grows towards 1. No depth is written, so that what
 * is behind and drawn later is seen too. */
static void blend(gn_pipeline *state)
{
    state->color.blend[0] = (gn_blend){.enabled = true,
                                       .source = GN_FACTOR_SOURCE_ALPHA,
                                       .destination = GN_FACTOR_ONE_MINUS_SOURCE_ALPHA,
                                       .alpha_source = GN_FACTOR_ONE,
                                       .alpha_destination = GN_FACTOR_ONE_MINUS_SOURCE_ALPHA};
    state->depth.write_disabled = true;
}

bool look_blends(const options *o, const model_part *part)
{
    return part->surface.alpha == MODEL_BLEND && !o->opaque;
}

static void set_state(scene_draw *draw, const options *o, const model_part *part)
{

    gn_pipeline *state = &draw->state;
    const gn_polygon_mode mode = o->wireframe ? GN_POLYGON_LINE
                                 : o->points  ? GN_POLYGON_POINT
                                              : GN_POLYGON_FILL;
    state->depth.test = !o->depth_test_disabled;
    state->raster.topology = model_topology(part->kind);
    if (look_blends(o, part))
        blend(state);
    state->raster.polygon_mode_front = mode;
    state->raster.polygon_mode_back = mode;
    state->raster.point_size = o->point_size;
    if (part->kind == MODEL_LINES)
        state->raster.line_width = o->point_size;
    state->raster.cull = o->cull;
}

void look_place(scene_draw *draw, const look *l, const gn_transform *world_from_model)
{
    scene_light *light = &draw->uniforms.light;
    gn_mat4_multiply(&l->view.clip_from_world, &world_from_model->matrix, &light->clip_from_model);
    gn_transform_normal_matrix(world_from_model, &light->normal_matrix);
    draw->surface.world_from_model = world_from_model->matrix;
    draw->surface.eye = l->view.eye;
    /* The normals of faces are products of derivatives. Upside down, they point into the model. */
    const bool is_inward = draw->shader == SCENE_FACES && l->view.y_down;
    light->light_direction = is_inward ? gn_vec3_negate(l->light_direction) : l->light_direction;
    /* A mirrored front has the opposite sense of rotation; so has a picture upside down. */
    const bool is_turned = is_mirrored(&world_from_model->matrix) != l->view.y_down;
    draw->state.raster.front_face = is_turned ? GN_FRONT_CLOCKWISE : GN_FRONT_COUNTER_CLOCKWISE;
    draw->state.depth.clip_depth = l->view.zero_to_one ? GN_ZERO_TO_ONE : GN_NEGATIVE_ONE_TO_ONE;
}

/* The maps that the shader takes. */
static part_maps taken_maps(shading which, const part_maps *all)
{
    part_maps taken = *all;
    for (int i = 0; i < MAP_COUNT; ++i)
        if ((shading_traits_of(which)->maps >> i & 1) == 0)
            taken.images[i].texels = NULL;
    return taken;
}

/* The shader of a part: that of the picture, but what has no normals is not lit, and neither are
 * materials that are meant to be seen as they are, unless a shader was asked for. */
static shading shading_of(const look *l, const model_part *part)
{
    const bool is_lit = l->shading >= SHADING_FLAT && l->shading <= SHADING_BLINN_PHONG;
    const bool has_no_normals = part->kind != MODEL_TRIANGLES && !part->has_normals;
    return is_lit && (has_no_normals || (part->surface.is_unlit && !l->options->shading_given))
               ? SHADING_UNLIT
               : l->shading;
}

scene_draw *look_add_part(scene *s, const look *l, const model_part *part, const part_maps *maps)
{
    const shading which = shading_of(l, part);
    const part_maps taken = taken_maps(which, maps);
    scene_draw *draw = scene_add_draw(s);
    scene_light *light = &draw->uniforms.light;
    draw->shader = shader_of(which, taken.images[MAP_DIFFUSE].texels != NULL);
    set_state(draw, l->options, part);
    look_place(draw, l, &part->world_from_model);
    light->ambient = l->ambient;
    light->diffuse = l->diffuse;
    set_maps(draw, l, part, &taken);
    set_shine(draw, l, part);
    set_attributes(draw, l->options, part, &taken);
    if (l->shadow != NULL)
        shadow_apply(l->shadow, draw);
    return draw;
}
