/* The light that reaches a place, for vertices and for fragments. */
#ifndef GN_KERNEL_SHADERS_LIGHTING_INL
#define GN_KERNEL_SHADERS_LIGHTING_INL

#include <gnomon/light.h>

#include "vectors.inl"

static inline bool has_attenuation(const gn_light *light)
{
    return light->constant != 0.0f || light->linear != 0.0f || light->quadratic != 0.0f;
}

/* Whether light comes from a position, so that the place that it reaches matters. */
static inline bool has_position(const gn_light *light)
{
    return GN_HAVE_POINT_LIGHTS && light->kind != GN_LIGHT_DIRECTIONAL;
}

/* Returns how much of the light is left near the end of its range (gnomon/light.h, "window"). */
static inline lanes_f within_range(float range, lanes_f distance)
{
    const lanes_f part = lanes_div(distance, lanes_splat(range));
    const lanes_f squared = lanes_mul(part, part);

    return above_zero(lanes_sub(lanes_splat(1.0f), lanes_mul(squared, squared)));
}

/* Returns how much of a spot light is left beside its axis (gnomon/light.h, "cone"). */
static inline lanes_f within_cone(const gn_light *light, const lanes_f to_light[3])
{
    const float width = light->inner_cosine - light->outer_cosine;
    const lanes_f one = lanes_splat(1.0f);
    lanes_f axis[3];

    splat_vector(light->direction, axis);

    const lanes_f inside = lanes_sub(dot(to_light, axis), lanes_splat(light->outer_cosine));
    const lanes_f part =
        above_zero(lanes_div(inside, lanes_splat(width > 0.001f ? width : 0.001f)));
    const lanes_f most_one = lanes_select(lanes_greater(one, part), part, one);

    return lanes_mul(most_one, most_one);
}

/* Returns `remaining` times what range and cone leave of a light. */
GN_OUT_OF_LINE lanes_f remaining_within(const gn_light *light, const lanes_f to_light[3],
                                        lanes_f distance, lanes_f remaining)
{
    if (light->range > 0.0f)
        remaining = lanes_mul(remaining, within_range(light->range, distance));
    if (light->kind == GN_LIGHT_SPOT)
        remaining = lanes_mul(remaining, within_cone(light, to_light));
    return remaining;
}

/* Writes the normalized direction from a place towards the light, and the part of the light that
 * distance, range and cone leave. */
GN_INLINE void light_at(const gn_light *light, const lanes_f place[3], lanes_f to_light[3],
                        lanes_f *remaining)
{
    *remaining = lanes_splat(1.0f);
    if (!has_position(light)) {
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

        *remaining =
            one_over(lanes_add(lanes_add(lanes_splat(light->constant), linear), quadratic));
    }
    if (light->range > 0.0f || light->kind == GN_LIGHT_SPOT) {
        /* A copy, so that the original stays in registers. */
        lanes_f in_memory[3];

        copy_vector(to_light, in_memory);
        *remaining = remaining_within(light, in_memory, distance, *remaining);
    }
}

/* Writes ambient + diffuse * lit. */
static inline void receive_light(const gn_light *light, lanes_f lit, lanes_f received[3])
{
    lanes_f ambient[3], diffuse[3];

    splat_vector(light->ambient, ambient);
    splat_vector(light->diffuse, diffuse);
    for (int c = 0; c < 3; ++c)
        received[c] = lanes_add(ambient[c], lanes_mul(diffuse[c], lit));
}

/* Adds ambient + diffuse * lit. */
static inline void receive_more(const gn_light *light, lanes_f lit, lanes_f received[3])
{
    lanes_f more[3];

    receive_light(light, lit, more);
    for (int c = 0; c < 3; ++c)
        received[c] = lanes_add(received[c], more[c]);
}

static inline void multiply_color(lanes_f color[3], const lanes_f received[3])
{
    for (int c = 0; c < 3; ++c)
        color[c] = lanes_mul(color[c], received[c]);
}

#endif
