/* The lights of draws: one over the viewer's shoulder, or those of the model's file. */
#include <math.h>
#include <string.h>

#include "look_parts.h"
#include "report.h"

#define AMBIENT 0.25f
#define DIFFUSE 0.75f

/* Light that a surface reflects in all directions is 1 / pi as bright in each. */
#define PI 3.14159265f

/* Luminance (ITU-R BT.709) of a light at a place, the middle of the model. */
static double luminance_at(const model_light *l, const double place[3])
{
    const double y =
        0.2126 * (double)l->color[0] + 0.7152 * (double)l->color[1] + 0.0722 * (double)l->color[2];
    double square = 0.0;
    for (int c = 0; c < 3; ++c)
        square += (l->position[c] - place[c]) * (l->position[c] - place[c]);
    return l->kind == GN_LIGHT_DIRECTIONAL || !(square > 0.0) ? y : y / square;
}

static gn_light light_of(const model_light *from, float exposure)
{
    gn_light l;
    memset(&l, 0, sizeof l);
    l.kind = from->kind;
    l.direction = (gn_vec3){-from->direction[0], -from->direction[1], -from->direction[2]};
    l.position =
        (gn_vec3){(float)from->position[0], (float)from->position[1], (float)from->position[2]};
    l.quadratic = 1.0f;
    l.range = from->range;
    l.inner_cosine = cosf(from->inner);
    l.outer_cosine = cosf(from->outer);
    l.diffuse =
        (gn_vec3){from->color[0] * exposure, from->color[1] * exposure, from->color[2] * exposure};
    return l;
}

void look_choose_lights(look *l, const model *m, const bounding_sphere *bounds)
{
    const uint32_t count = m->light_count < GN_MAX_LIGHTS ? m->light_count : GN_MAX_LIGHTS;
    const float strength = l->is_linear ? DIFFUSE * PI : DIFFUSE;
    double sum = 0.0;
    l->ambient = (gn_vec3){AMBIENT, AMBIENT, AMBIENT};
    l->diffuse = (gn_vec3){strength, strength, strength};
    l->light_count = 0;
    if (!l->is_linear || l->options->light_given)
        return;
    for (uint32_t i = 0; i < count; ++i)
        sum += luminance_at(m->lights + i, bounds->center);
    if (!(sum > 0.0))
        return;
    l->light_count = count;
    for (uint32_t i = 0; i < count; ++i)
        l->lights[i] = light_of(m->lights + i, (float)((double)strength / sum));
}

void look_set_lights(scene_draw *draw, const look *l)
{
    scene_light *const light = &draw->uniforms.light;
    scene_surface *const s = &draw->surface;
    /* The normals of faces are products of derivatives. Upside down, they point into the model. */
    const bool is_inward = draw->shader == SCENE_FACES && l->view.y_down;
    light->ambient = l->ambient;
    light->diffuse = l->diffuse;
    light->light_direction = is_inward ? gn_vec3_negate(l->light_direction) : l->light_direction;
    if (l->light_count == 0)
        return;
    const gn_light *const first = l->lights;
    light->diffuse = first->diffuse;
    light->light_direction = first->direction;
    s->has_point_light = first->kind == GN_LIGHT_POINT;
    s->has_spot_light = first->kind == GN_LIGHT_SPOT;
    s->light_position = first->position;
    s->attenuation[2] = first->quadratic;
    s->light_range = first->range;
    s->cone[0] = first->inner_cosine;
    s->cone[1] = first->outer_cosine;
    s->more_light_count = l->light_count - 1;
    memcpy(s->more_lights, l->lights + 1, s->more_light_count * sizeof *s->more_lights);
}
