/* What lighting reads, derived once per draw. The order of operations is the reference's. */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../lighting/color_material.h"
#include "fixed_lighting.h"

static void normalize(float v[3])
{
    const float square = (v[0] * v[0] + v[1] * v[1]) + v[2] * v[2];

    if (square != 0.0f) {
        const float scale = 1.0f / sqrtf(square);

        for (int i = 0; i < 3; ++i)
            v[i] *= scale;
    }
}

/* Whether lights or the viewer are at places, so that vertices need theirs. */
static bool lighting_needs_places(const lighting_state *state)
{
    if (!state->enabled)
        return false;
    for (int i = 0; i < LIGHTS; ++i)
        if (state->light[i].enabled &&
            (state->light[i].position[3] != 0.0f || state->light[i].spot_cutoff != 180.0f))
            return true;
    return state->local_viewer || state->color_control == GL_SEPARATE_SPECULAR_COLOR;
}

/* Returns by what normals are scaled so that those of length 1 keep it, if all axes have one scale.
 */
static float scale_of_normals(const float inverse[16], bool in_eye_space)
{
    const float square =
        inverse[2] * inverse[2] + inverse[6] * inverse[6] + inverse[10] * inverse[10];
    const float length = sqrtf(square < 1e-12f ? 1.0f : square);

    return in_eye_space ? 1.0f / length : length;
}

void set_eye_space(context *gl, bool texture_coordinates_need_it, eye_derived *eye)
{
    matrix_stack *const stack = &gl->transform.modelview;
    const GLfloat *const m = stack->m[stack->depth - 1];
    matrix_kind *const kind = &stack->kind[stack->depth - 1];
    bool keeps;

    analyse_matrix(kind, m);
    keeps = keeps_lengths(kind);
    memcpy(eye->modelview, m, sizeof eye->modelview);
    invert_matrix(kind, m, eye->inverse);
    eye->is_used = texture_coordinates_need_it || lighting_needs_places(&gl->lighting) ||
                   (gl->lighting.enabled && !keeps);
    eye->normalizes = gl->transform.normalize;
    eye->rescales = !eye->normalizes && eye->is_used == gl->transform.rescale_normal;
    eye->normal_scale = keeps ? 1.0f : scale_of_normals(eye->inverse, eye->is_used);
}

/* Places the light in the space of lighting. */
static void place_light(const eye_derived *eye, const light_state *state, light_derived *light)
{
    const float *const p = state->position;
    const float *const m = eye->inverse;
    const float *const modelview = eye->modelview;
    const float to_eye[3] = {eye->is_used ? 0.0f : modelview[2], eye->is_used ? 0.0f : modelview[6],
                             eye->is_used ? 1.0f : modelview[10]};

    light->is_directional = p[3] == 0.0f;
    for (int i = 0; i < 3; ++i)
        light->place[i] =
            eye->is_used ? p[i]
                         : ((m[i] * p[0] + m[4 + i] * p[1]) + m[8 + i] * p[2]) + m[12 + i] * p[3];
    if (!light->is_directional) {
        const float one_over_w = 1.0f / p[3];

        for (int i = 0; i < 3; ++i)
            light->place[i] *= one_over_w;
        return;
    }
    normalize(light->place);
    for (int i = 0; i < 3; ++i)
        light->half_vector[i] = light->place[i] + to_eye[i];
    normalize(light->half_vector);
}

static void set_light(const eye_derived *eye, const light_state *state, light_derived *light)
{
    static const double pi = 3.14159265358979323846;

    place_light(eye, state, light);
    light->is_spot = state->spot_cutoff != 180.0f;
    if (light->is_spot) {
        const float cosine = cosf((float)((double)state->spot_cutoff * pi / 180.0));

        memcpy(light->spot_direction, state->spot_direction, sizeof light->spot_direction);
        normalize(light->spot_direction);
        normalize(light->spot_direction); /* twice, for the last bit */
        light->spot_cosine = cosine < 0.0f ? 0.0f : cosine;
        light->spot_exponent = state->spot_exponent;
    }
    light->attenuation[0] = state->constant_attenuation;
    light->attenuation[1] = state->linear_attenuation;
    light->attenuation[2] = state->quadratic_attenuation;
    light->is_attenuated =
        !light->is_directional && (light->attenuation[0] != 1.0f || light->attenuation[1] != 0.0f ||
                                   light->attenuation[2] != 0.0f);
    memcpy(light->color[0], state->ambient, sizeof light->color[0]);
    memcpy(light->color[1], state->diffuse, sizeof light->color[1]);
    memcpy(light->color[2], state->specular, sizeof light->color[2]);
}

void set_lighting(const context *gl, const eye_derived *eye, bool has_color_array,
                  lighting_derived *lighting)
{
    const lighting_state *const state = &gl->lighting;

    lighting->enabled = state->enabled;
    if (!state->enabled)
        return;
    lighting->two_side = state->two_side;
    lighting->has_separate_specular = state->color_control == GL_SEPARATE_SPECULAR_COLOR;
    lighting->has_local_viewer = state->local_viewer;
    lighting->is_dull = state->material[0].shininess == 0.0f &&
                        !(state->two_side && state->material[1].shininess != 0.0f);
    memcpy(lighting->ambient, state->ambient, sizeof lighting->ambient);
    lighting->lights = 0;
    for (int i = 0; i < LIGHTS; ++i)
        if (state->light[i].enabled)
            set_light(eye, &state->light[i], &lighting->light[lighting->lights++]);
    for (int s = 0; s < 2; ++s) {
        side_derived *const side = &lighting->side[s];

        memcpy(side->material, state->material[s].color, sizeof side->material);
        side->shininess = state->material[s].shininess;
        for (int c = 0; c < MATERIAL_COLORS; ++c)
            side->is_vertex_color[c] = state->color_material && has_color_array &&
                                       follows_color(state, s, (enum material_color)c);
    }
}
