/* Lights of a raster position: one vertex by the functions of libm, not by the shader of vertices
 * (fixed_lighting.c). */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../draw/fixed_function.h"
#include "raster_position.h"

/* Light that is weaker than this, and highlights below the second, are left out. */
static const GLfloat least_attenuation = 1e-3f, least_highlight = 1e-10f, least_distance = 1e-6f;

void make_unit_length(GLfloat v[3])
{
    const GLfloat square = forward_dot_3(v, v);

    if (square != 0.0f) {
        const GLfloat scale = 1.0f / sqrtf(square);

        for (int i = 0; i < 3; ++i)
            v[i] *= scale;
    }
}

/* Returns what is left of a light at a vertex, and the direction to the light; 0 outside its spot.
 */
static GLfloat attenuation_of(const light_derived *light, const GLfloat vertex[4],
                              GLfloat to_light[3])
{
    GLfloat attenuation = 1.0f;

    memcpy(to_light, light->place, sizeof(GLfloat[3]));
    if (!light->is_directional) {
        GLfloat distance;

        for (int i = 0; i < 3; ++i)
            to_light[i] = light->place[i] - vertex[i];
        distance = sqrtf(forward_dot_3(to_light, to_light));
        if (distance > least_distance) {
            const GLfloat scale = 1.0f / distance;

            for (int i = 0; i < 3; ++i)
                to_light[i] *= scale;
        }
        attenuation =
            1.0f / (light->attenuation[0] +
                    distance * (light->attenuation[1] + distance * light->attenuation[2]));
    }
    if (light->is_spot) {
        const GLfloat cosine = -forward_dot_3(to_light, light->spot_direction);

        if (cosine < light->spot_cosine)
            return 0.0f;
        attenuation *= powf(cosine, light->spot_exponent);
    }
    return attenuation;
}

/* Returns the strength of a highlight before it is attenuated. */
static GLfloat highlight_of(const context *gl, const eye_derived *eye, const light_derived *light,
                            const GLfloat vertex[4], const GLfloat normal[3],
                            const GLfloat to_light[3])
{
    const GLfloat *const m = eye->modelview;
    const GLfloat to_eye[3] = {eye->is_used ? 0.0f : m[2], eye->is_used ? 0.0f : m[6],
                               eye->is_used ? 1.0f : m[10]};
    GLfloat half[3], cosine;

    if (gl->lighting.local_viewer) {
        GLfloat from_eye[3] = {vertex[0], vertex[1], vertex[2]};

        make_unit_length(from_eye);
        for (int i = 0; i < 3; ++i)
            half[i] = to_light[i] - from_eye[i];
        make_unit_length(half);
    } else if (!light->is_directional) {
        for (int i = 0; i < 3; ++i)
            half[i] = to_light[i] + to_eye[i];
        make_unit_length(half);
    } else {
        memcpy(half, light->half_vector, sizeof half);
    }
    cosine = forward_dot_3(normal, half);
    return cosine > 0.0f ? powf(cosine, gl->lighting.material[0].shininess) : 0.0f;
}

void light_raster_position(const context *gl, const eye_derived *eye, const GLfloat vertex[4],
                           const GLfloat normal[3], GLfloat color[4], GLfloat secondary[4])
{
    const lighting_state *const state = &gl->lighting;
    const GLfloat(*const material)[4] = state->material[0].color;
    const bool is_separate = state->color_control == GL_SEPARATE_SPECULAR_COLOR;
    lighting_derived lighting;

    set_lighting(gl, eye, false, &lighting);
    for (int c = 0; c < 3; ++c) {
        color[c] =
            material[MATERIAL_EMISSION][c] + material[MATERIAL_AMBIENT][c] * state->ambient[c];
        secondary[c] = 0.0f;
    }
    for (unsigned i = 0; i < lighting.lights; ++i) {
        const light_derived *const light = &lighting.light[i];
        GLfloat to_light[3], cosine, highlight;
        const GLfloat attenuation = attenuation_of(light, vertex, to_light);

        if (attenuation < least_attenuation)
            continue;
        cosine = forward_dot_3(normal, to_light);
        highlight = cosine < 0.0f ? 0.0f : highlight_of(gl, eye, light, vertex, normal, to_light);
        if (!(highlight > least_highlight))
            highlight = 0.0f;
        for (int c = 0; c < 3; ++c) {
            const GLfloat specular =
                highlight * (material[MATERIAL_SPECULAR][c] * light->color[2][c]);
            GLfloat sum = material[MATERIAL_AMBIENT][c] * light->color[0][c];

            if (!(cosine < 0.0f))
                sum += cosine * (material[MATERIAL_DIFFUSE][c] * light->color[1][c]);
            color[c] += attenuation * (is_separate ? sum : sum + specular);
            if (is_separate)
                secondary[c] += attenuation * specular;
        }
    }
    for (int c = 0; c < 3; ++c) {
        color[c] = clamped_color(color[c]);
        secondary[c] = clamped_color(secondary[c]);
    }
    color[3] = clamped_color(material[MATERIAL_DIFFUSE][3]);
    secondary[3] = 1.0f;
}
