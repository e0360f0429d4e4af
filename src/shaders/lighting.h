/* The light that reaches a place, for vertices and for fragments. */
#ifndef GN_SHADERS_LIGHTING_H
#define GN_SHADERS_LIGHTING_H

#include <gnomon/light.h>

#include "vectors.h"

static inline bool has_attenuation(const gn_light *light)
{
    return light->constant != 0.0f || light->linear != 0.0f || light->quadratic != 0.0f;
}

/* Writes the normalized direction from a place towards the light, and the attenuation of the light
 * by distance. */
static inline void light_at(const gn_light *light, const lanes_f place[3], lanes_f to_light[3],
                            lanes_f *left)
{
    *left = lanes_splat(1.0f);
    if (!GN_HAVE_POINT_LIGHTS || !light->is_point) {
        splat_vector(light->direction, to_light);
        return;
    }
    splat_vector(light->position, to_light);
    for (int c = 0; c < 3; ++c)
        to_light[c] = lanes_sub(to_light[c], place[c]);

    const lanes_f distance = lanes_sqrt(dot(to_light, to_light));
    scale_vector(to_light, one_over(distance));
    if (has_attenuation(light)) {
        const lanes_f linear = lanes_mul(lanes_splat(light->linear), distance);
        const lanes_f quadratic =
            lanes_mul(lanes_mul(lanes_splat(light->quadratic), distance), distance);

        *left = one_over(lanes_add(lanes_add(lanes_splat(light->constant), linear), quadratic));
    }
}

/* Replaces color by color * (ambient + diffuse * lit). */
static inline void light_color(const gn_light *light, lanes_f lit, lanes_f color[3])
{
    lanes_f ambient[3], diffuse[3];

    splat_vector(light->ambient, ambient);
    splat_vector(light->diffuse, diffuse);
    for (int c = 0; c < 3; ++c)
        color[c] = lanes_mul(color[c], lanes_add(ambient[c], lanes_mul(diffuse[c], lit)));
}

#endif
