/* Draws from parts. */
#include "look.h"

#include <stdlib.h>
#include <string.h>

#include "report.h"

#define AMBIENT 0.25f
#define DIFFUSE 0.75f

int look_choose(const options *o, const camera *view, const bounding_sphere *bounds, shading which,
                look *result)
{
    memset(result, 0, sizeof *result);
    result->options = o;
    result->shading = which;
    result->view = *view;
    result->bounds = *bounds;
    result->light_direction = view->light_direction;
    result->ambient = (gn_vec3){AMBIENT, AMBIENT, AMBIENT};
    result->diffuse = (gn_vec3){DIFFUSE, DIFFUSE, DIFFUSE};
    if (o->light_given && gn_vec3_normalize(o->light, &result->light_direction) != GN_OK)
        return report_fault("--light", "impossible direction: the vector is zero");
    return 0;
}

static void set_attributes(scene_draw *draw, const model_part *part, bool has_map)
{
    uint32_t count = part->vertex_count;
    scene_set_attribute(draw, GN_ATTRIBUTE_POSITION, part->positions, 3, count);
    if (!has_map || part->has_vertex_colors)
        scene_set_attribute(draw, GN_ATTRIBUTE_COLOR, part->colors, 4, count);
    scene_set_attribute(draw, GN_ATTRIBUTE_NORMAL, part->normals, 3, count);
    if (part->has_texcoords)
        scene_set_attribute(draw, GN_ATTRIBUTE_TEXCOORD, part->texcoords, 2, count);
    scene_set_indices(draw, part->indices, part->index_count, GN_INDEX_UINT32);
}

scene_draw *look_add_part(scene *s, const look *l, const model_part *part, const part_maps *maps)
{
    const image *diffuse = maps->images + MAP_DIFFUSE;
    scene_draw *draw = scene_add_draw(s);
    scene_light *light = &draw->uniforms.light;
    draw->shader = diffuse->texels != NULL ? SCENE_TEXTURED_GOURAUD : SCENE_GOURAUD;
    if (l->shading == SHADING_FLAT)
        draw->shader = SCENE_FLAT;
    if (l->shading == SHADING_VERTEX_COLOR)
        draw->shader = SCENE_VERTEX_COLOR;
    draw->state.depth_test = true;
    if (l->options->wireframe) {
        draw->state.polygon_mode_front = GN_POLYGON_LINE;
        draw->state.polygon_mode_back = GN_POLYGON_LINE;
    }
    draw->uniforms.sampler.minify = GN_MINIFY_LINEAR;
    light->clip_from_model = l->view.clip_from_world;
    gn_mat3_identity(&light->normal_matrix);
    light->light_direction = l->light_direction;
    light->ambient = l->ambient;
    light->diffuse = l->diffuse;
    if (diffuse->texels != NULL)
        scene_set_texture(draw, diffuse->texels, diffuse->width, diffuse->height, GN_FORMAT_RGBA8);
    set_attributes(draw, part, diffuse->texels != NULL);
    return draw;
}
