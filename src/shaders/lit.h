/* The shaders that light fragments (gnomon/light.h). */
#ifndef GN_SHADERS_LIT_H
#define GN_SHADERS_LIT_H

#include "derivative.h"
#include "shadow.h"
#include "surface.h"

/* Writes the normalized direction from a fragment towards the light, and the part of the light that
 * distance and shadows leave. */
GN_OUT_OF_LINE void light_fragment(const gn_lit_uniforms *u, const gn_fragment_input *input,
                                   const lanes_f place[3], lanes_f to_light[3], lanes_f *left)
{
    light_at(&u->light, place, to_light, left);
    if (u->shadow.map)
        *left = lanes_mul(*left, light_in_shadow(&u->shadow, input->sampling, place));
}

/* Writes the normal of the triangle: the cross product of the derivatives of the place along x and
 * y of the window. */
static inline void face_normal(const gn_fragment_input *input, lanes_f normal[3])
{
    lanes_f along_x[3], along_y[3];

    for (int c = 0; c < 3; ++c) {
        const lanes_f place = lanes_load(input->varying[VARYING_PLACE + c]);

        along_x[c] = derivative_x(place);
        along_y[c] = derivative_y(place);
    }
    cross(along_x, along_y, normal);
    normalize(normal);
}

static inline void shade_flat(const void *uniforms, const gn_fragment_input *input,
                              gn_fragment_output *output)
{
    const gn_lit_uniforms *u = (const gn_lit_uniforms *)uniforms;
    lanes_f place[3], to_light[3], normal[3], color[4], left;

    load_vector(&input->varying[VARYING_PLACE], place);
    light_fragment(u, input, place, to_light, &left);
    face_normal(input, normal);
    surface_color(&u->material, input, color);
    light_color(&u->light, lanes_mul(above_zero(dot(normal, to_light)), left), color);
    put_color(color, output);
    cut_off(u->material.alpha_cutoff, color[3], output);
}

static inline lanes_f in_bands(lanes_f lit, uint32_t bands)
{
    const float count = bands ? (float)bands : 4.0f;
    const lanes_f last = lanes_splat(count - 1.0f);

    return lanes_div(lanes_min(lanes_floor(lanes_mul(lit, lanes_splat(count))), last), last);
}

static inline void shade_toon(const void *uniforms, const gn_fragment_input *input,
                              gn_fragment_output *output)
{
    const gn_lit_uniforms *u = (const gn_lit_uniforms *)uniforms;
    lanes_f place[3], to_light[3], normal[3], color[4], left;

    load_vector(&input->varying[VARYING_PLACE], place);
    light_fragment(u, input, place, to_light, &left);
    load_vector(&input->varying[VARYING_NORMAL], normal);
    normalize(normal);
    surface_color(&u->material, input, color);

    const lanes_f lit = in_bands(above_zero(dot(normal, to_light)), u->material.bands);
    light_color(&u->light, lanes_mul(lit, left), color);
    put_color(color, output);
    cut_off(u->material.alpha_cutoff, color[3], output);
}

/* Returns base to the power of exponent by squaring (Knuth, The Art of Computer Programming 4.6.3),
 * from the lowest bit of the exponent on. */
static inline lanes_f raise(lanes_f base, uint32_t exponent)
{
    lanes_f power = exponent & 1 ? base : lanes_splat(1.0f);

    while (exponent >>= 1) {
        base = lanes_mul(base, base);
        if (exponent & 1)
            power = lanes_mul(power, base);
    }
    return power;
}

/* Returns the cosine whose power is Phong's highlight: R.V with R = 2 * N.L * N - L. */
static inline lanes_f reflected_cosine(const lanes_f normal[3], const lanes_f to_light[3],
                                       lanes_f cosine, const lanes_f to_eye[3])
{
    const lanes_f twice = lanes_mul(lanes_splat(2.0f), cosine);
    lanes_f reflected[3];

    for (int c = 0; c < 3; ++c)
        reflected[c] = lanes_sub(lanes_mul(twice, normal[c]), to_light[c]);
    return dot(reflected, to_eye);
}

/* Returns the cosine whose power is Blinn's highlight: N.H. */
static inline lanes_f halfway_cosine(const lanes_f normal[3], const lanes_f to_light[3],
                                     const lanes_f to_eye[3])
{
    lanes_f half[3];

    for (int c = 0; c < 3; ++c)
        half[c] = lanes_add(to_light[c], to_eye[c]);
    normalize(half);
    return dot(normal, half);
}

/* Adds the specular colour times `shine`. */
static inline void add_highlight(const gn_material *material, const gn_fragment_input *input,
                                 lanes_f shine, lanes_f color[3])
{
    lanes_f specular[3], texel[4];

    splat_vector(material->specular, specular);
    if (material->specular_map)
        sample_map(material->specular_map, &material->sampler, input, texel);
    for (int c = 0; c < 3; ++c) {
        if (material->specular_map)
            specular[c] = lanes_mul(specular[c], texel[c]);
        color[c] = lanes_add(color[c], lanes_mul(specular[c], shine));
    }
}

static inline void add_glow(const gn_material *material, const gn_fragment_input *input,
                            lanes_f color[3])
{
    lanes_f texel[4];

    if (!material->glow_map)
        return;
    sample_map(material->glow_map, &material->sampler, input, texel);
    for (int c = 0; c < 3; ++c)
        color[c] = lanes_add(color[c], texel[c]);
}

/* Phong's and Blinn's shaders, which differ only in the highlight. */
GN_OUT_OF_LINE void shade_shiny(const gn_lit_uniforms *u, bool is_blinn,
                                const gn_fragment_input *input, gn_fragment_output *output)
{
    const lanes_f zero = lanes_splat(0.0f);
    lanes_f place[3], to_light[3], to_eye[3], normal[3], color[4], left;

    load_vector(&input->varying[VARYING_PLACE], place);
    light_fragment(u, input, place, to_light, &left);
    splat_vector(u->eye, to_eye);
    for (int c = 0; c < 3; ++c)
        to_eye[c] = lanes_sub(to_eye[c], place[c]);
    normalize(to_eye);
    surface_normal(u, input, normal);

    const lanes_f cosine = dot(normal, to_light);
    const lanes_f highlight =
        raise(above_zero(is_blinn ? halfway_cosine(normal, to_light, to_eye)
                                  : reflected_cosine(normal, to_light, cosine, to_eye)),
              u->material.exponent);
    const lanes_f shine = lanes_select(lanes_greater(cosine, zero), highlight, zero);

    surface_color(&u->material, input, color);
    light_color(&u->light, lanes_mul(above_zero(cosine), left), color);
    add_glow(&u->material, input, color);
    add_highlight(&u->material, input, lanes_mul(shine, left), color);
    put_color(color, output);
    cut_off(u->material.alpha_cutoff, color[3], output);
}

static inline void shade_phong(const void *uniforms, const gn_fragment_input *input,
                               gn_fragment_output *output)
{
    shade_shiny((const gn_lit_uniforms *)uniforms, false, input, output);
}

static inline void shade_blinn_phong(const void *uniforms, const gn_fragment_input *input,
                                     gn_fragment_output *output)
{
    shade_shiny((const gn_lit_uniforms *)uniforms, true, input, output);
}

#endif
