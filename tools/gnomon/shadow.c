/* Draws and uses shadow maps. */
#include "shadow.h"

#include <math.h>
#include <string.h>

#include "report.h"

#define MAP_SIZE 1024

/* Margin around the sphere, so that nothing lies on the border of the map or on a plane of
 * depth. */
#define MARGIN 1.01

/* Keeps a surface from shadowing itself: the map's depths move away from the light by this many
 * times their slope from texel to texel, and by this many of the smallest steps. */
#define OFFSET_FACTOR 2.0f
#define OFFSET_UNITS 4.0f

/* The up direction of the map does not matter, but must not be parallel to the light. */
static gn_vec3 any_up(gn_vec3 direction)
{
    return fabsf(direction.y) < 0.9f ? (gn_vec3){0.0f, 1.0f, 0.0f} : (gn_vec3){0.0f, 0.0f, 1.0f};
}

int shadow_begin(const bounding_sphere *bounds, gn_vec3 direction, shadow_pass *result)
{
    gn_transform view;
    gn_transform projection;
    gn_transform clip;
    const float radius = (float)(bounds->radius * MARGIN);
    const gn_vec3 center = {(float)bounds->center[0], (float)bounds->center[1],
                            (float)bounds->center[2]};
    const gn_vec3 eye = gn_vec3_add(center, gn_vec3_scale(direction, 2.0f * radius));
    memset(result, 0, sizeof *result);
    gn_status status = gn_look_at_rh(eye, center, any_up(direction), &view);
    if (status == GN_OK)
        status = gn_orthographic_rh_no(-radius, radius, -radius, radius, radius, 3.0f * radius,
                                       &projection);
    if (status == GN_OK)
        status = gn_transform_compose(&projection, &view, &clip);
    if (status != GN_OK)
        return report_fault("--shadows", "impossible for this model: %s", gn_status_text(status));
    result->clip_from_world = clip.matrix;
    result->scene = scene_create(MAP_SIZE, MAP_SIZE, GN_FORMAT_NONE, GN_FORMAT_D32F);
    result->scene->clear_depth = 1.0f;
    return 0;
}

void shadow_add_part(shadow_pass *pass, const model_part *part)
{
    scene_draw *draw = scene_add_draw(pass->scene);
    draw->shader = SCENE_DEPTH_ONLY;
    draw->state.depth.test_enabled = true;
    draw->state.raster.polygon_offset.enabled = true;
    draw->state.raster.polygon_offset.factor = OFFSET_FACTOR;
    draw->state.raster.polygon_offset.units = OFFSET_UNITS;
    scene_set_attribute(draw, GN_ATTRIBUTE_POSITION, part->positions, 3, part->vertex_count);
    draw->state.raster.topology = model_topology(part->kind);
    scene_set_indices(draw, part->indices, part->index_count, GN_INDEX_UINT32);
    shadow_place(pass, pass->scene->draw_count - 1, &part->world_from_model.matrix);
}

void shadow_place(shadow_pass *pass, size_t i, const gn_mat4 *world_from_model)
{
    gn_mat4_multiply(&pass->clip_from_world, world_from_model,
                     &pass->scene->draws[i].uniforms.light.clip_from_model);
}

int shadow_draw(shadow_pass *pass, gn_backend backend)
{
    if (!scene_frame_allocate(&pass->frame, pass->scene))
        return report_fault("--shadows", "not enough memory");
    const gn_status status = scene_draw_library(pass->scene, &pass->frame, 0, backend);
    return status == GN_OK ? 0 : report_fault("drawing", "%s", gn_status_text(status));
}

/* Four texels are compared and the results mixed (percentage-closer filtering); places beyond the
 * map are lit. */
static gn_sampler comparing_sampler(void)
{
    gn_sampler sampler;
    memset(&sampler, 0, sizeof sampler);
    sampler.wrap_s = sampler.wrap_t = GN_WRAP_CLAMP_TO_BORDER;
    sampler.minify = GN_MINIFY_LINEAR;
    sampler.compare = GN_LESS_OR_EQUAL;
    for (int c = 0; c < 4; ++c)
        sampler.border[c] = 1.0f;
    return sampler;
}

void shadow_apply(const shadow_pass *pass, scene_draw *draw)
{
    gn_texture map;
    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, MAP_SIZE, MAP_SIZE, 1, 1, pass->frame.depth,
                      &map);
    scene_set_map(draw, SCENE_SHADOW_MAP, &map);
    draw->surface.shadow_sampler = comparing_sampler();
    draw->surface.shadow_from_world = pass->clip_from_world;
}

void shadow_free(shadow_pass *pass)
{
    if (pass->scene != NULL)
        scene_free(pass->scene);
    scene_frame_free(&pass->frame);
    memset(pass, 0, sizeof *pass);
}
