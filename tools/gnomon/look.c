/* Turns parts into draws. */
#include "look.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "look_parts.h"
#include "report.h"
#include "scene_memory.h"

int look_choose(const options *o, const camera *view, shading which, look *result)
{
    static const model none;
    static const bounding_sphere nowhere;
    memset(result, 0, sizeof *result);
    result->options = o;
    result->shading = which;
    result->view = *view;
    result->light_direction = view->light_direction;
    result->is_linear = which == SHADING_METALLIC_ROUGHNESS;
    look_choose_lights(result, &none, &nowhere);
    if (o->light_given && gn_vec3_normalize(o->light, &result->light_direction) != GN_OK)
        return report_fault("--light", "impossible direction: the vector is zero");
    return 0;
}

static scene_shader shader_of(shading which, bool has_diffuse_map)
{
    const scene_shader shader = shading_traits_of(which)->shader;
    return shader == SCENE_GOURAUD && has_diffuse_map ? SCENE_TEXTURED_GOURAUD : shader;
}

/* The material's constants. A material with an exponent of highlights is as rough as makes Blinn's
 * highlights as wide: exponent = 2 / roughness^4 - 2. */
static void set_surface(scene_draw *draw, const look *l, const model_part *part)
{
    const model_surface *const surface = &part->surface;
    const float *specular = surface->shine.specular;
    scene_surface *const s = &draw->surface;
    const bool is_own = surface->is_metallic_roughness != 0;
    const bool is_mask = surface->alpha == MODEL_MASK && !l->options->opaque;
    s->metallic = is_own ? surface->metallic : 0.0f;
    s->roughness =
        is_own ? surface->roughness : sqrtf(sqrtf(2.0f / ((float)surface->shine.exponent + 2.0f)));
    s->normal_scale = part->maps[MAP_NORMAL].strength;
    s->occlusion_strength = fminf(fmaxf(part->maps[MAP_OCCLUSION].strength, 0.0f), 1.0f);
    s->emissive = (gn_vec3){surface->emissive[0], surface->emissive[1], surface->emissive[2]};
    s->double_sided = surface->is_double_sided != 0;
    s->alpha_cutoff = is_mask ? surface->alpha_cutoff : 0.0f;
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

static void set_attributes(scene_draw *draw, const look *l, const model_part *part,
                           const part_maps *maps)
{
    const uint32_t count = part->vertex_count;
    scene_set_attribute(draw, GN_ATTRIBUTE_POSITION, part->positions, 3, count);
    look_set_colors(draw, l, part, maps);
    scene_set_attribute(draw, GN_ATTRIBUTE_NORMAL, part->normals, 3, count);
    if (part->has_texcoords)
        scene_set_attribute(draw, GN_ATTRIBUTE_TEXCOORD, part->texcoords, 2, count);
    if (part->has_tangents)
        scene_set_attribute(draw, GN_ATTRIBUTE_TANGENT, part->tangents, 4, count);
    if (part->has_tangents && is_mirrored(&part->world_from_model.matrix))
        mirror_tangents(draw, part);
    scene_set_indices(draw, part->indices, part->index_count, GN_INDEX_UINT32);
}

/* The target's alpha grows towards 1 where something is drawn. Colours are mixed by alpha, or the
 * source's, which is cut out by its alpha. */
static gn_blend blend_over(bool mixes)
{
    return (gn_blend){.enabled = true,
                      .source = mixes ? GN_FACTOR_SOURCE_ALPHA : GN_FACTOR_ONE,
                      .destination = mixes ? GN_FACTOR_ONE_MINUS_SOURCE_ALPHA : GN_FACTOR_ZERO,
                      .alpha_source = GN_FACTOR_ONE,
                      .alpha_destination = GN_FACTOR_ONE_MINUS_SOURCE_ALPHA};
}

/* What is translucent writes no depth, so that what is behind and drawn later is seen too. */
static void set_alpha(gn_pipeline *state, const options *o, const model_part *part)
{
    if (part->surface.alpha == MODEL_OPAQUE || o->opaque)
        return;
    state->color.blend[0] = blend_over(part->surface.alpha == MODEL_BLEND);
    state->depth.write_disabled = part->surface.alpha == MODEL_BLEND;
}

bool look_blends(const options *o, const model_part *part)
{
    return part->surface.alpha == MODEL_BLEND && !o->opaque;
}

gn_cull look_cull(const options *o, const model_part *part)
{
    const bool culls = !o->cull_given && part->surface.culls_back != 0;
    return culls ? GN_CULL_BACK : o->cull;
}

static void set_state(scene_draw *draw, const options *o, const model_part *part)
{
    gn_pipeline *state = &draw->state;
    const gn_polygon_mode mode = o->wireframe ? GN_POLYGON_LINE
                                 : o->points  ? GN_POLYGON_POINT
                                              : GN_POLYGON_FILL;
    state->depth.test_enabled = !o->depth_test_disabled;
    state->raster.topology = model_topology(part->kind);
    set_alpha(state, o, part);
    state->raster.polygon_mode_front = mode;
    state->raster.polygon_mode_back = mode;
    state->raster.point_size = o->point_size;
    if (part->kind == MODEL_LINES)
        state->raster.line_width = o->point_size;
    state->raster.cull = look_cull(o, part);
}

void look_place(scene_draw *draw, const look *l, const gn_transform *world_from_model)
{
    scene_light *light = &draw->uniforms.light;
    gn_mat4_multiply(&l->view.clip_from_world, &world_from_model->matrix, &light->clip_from_model);
    gn_transform_normal_matrix(world_from_model, &light->normal_matrix);
    draw->surface.world_from_model = world_from_model->matrix;
    draw->surface.eye = l->view.eye;
    look_set_lights(draw, l);
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

/* The shader of a part: that of the picture, but what has no normals is not lit. Unless a shader
 * was asked for, materials that are meant to be seen as they are are not lit either, and those with
 * highlights have them beside metals. */
static shading shading_of(const look *l, const model_part *part)
{
    const bool is_metallic = l->shading == SHADING_METALLIC_ROUGHNESS;
    const bool is_lit =
        is_metallic || (l->shading >= SHADING_FLAT && l->shading <= SHADING_BLINN_PHONG);
    const bool has_no_normals = part->kind != MODEL_TRIANGLES && !part->has_normals;
    if (is_lit && (has_no_normals || (part->surface.is_unlit && !l->options->shading_given)))
        return SHADING_UNLIT;
    return is_metallic && !part->surface.is_metallic_roughness && !l->options->shading_given
               ? SHADING_PHONG
               : l->shading;
}

scene_draw *look_add_part(scene *s, const look *l, const model_part *part, const part_maps *maps)
{
    const shading which = shading_of(l, part);
    const part_maps taken = taken_maps(which, maps);
    scene_draw *draw = scene_add_draw(s);
    draw->shader = shader_of(which, taken.images[MAP_DIFFUSE].texels != NULL);
    set_state(draw, l->options, part);
    look_place(draw, l, &part->world_from_model);
    look_set_maps(draw, l, part, &taken);
    set_surface(draw, l, part);
    set_attributes(draw, l, part, &taken);
    if (l->shadow != NULL)
        shadow_apply(l->shadow, draw);
    return draw;
}
