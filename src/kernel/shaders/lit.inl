/* The shaders that light fragments (gnomon/light.h). */
#ifndef GN_KERNEL_SHADERS_LIT_INL
#define GN_KERNEL_SHADERS_LIT_INL

#include "../../lanes/derivative.h"
#include "shadow.inl"
#include "surface_point.inl"

/* Writes the normalized direction from a fragment towards the light, and the part of the light that
 * distance, range, cone and shadow leave. */
GN_OUT_OF_LINE void light_fragment_at(const gn_light *light, const gn_shadow *shadow,
                                      const gn_fragment_input *input, const lanes_f place[3],
                                      lanes_f to_light[3], lanes_f *remaining)
{
    light_at(light, place, to_light, remaining);
    if (shadow->map)
        *remaining =
            lanes_mul(*remaining, light_in_shadow(shadow, input->texture_functions, place));
}

static inline void light_fragment(const gn_light *light, const gn_shadow *shadow,
                                  const gn_fragment_input *input, const lanes_f place[3],
                                  lanes_f to_light[3], lanes_f *remaining)
{
    if (has_position(light) || shadow->map) {
        light_fragment_at(light, shadow, input, place, to_light, remaining);
    } else {
        splat_vector(light->direction, to_light);
        *remaining = lanes_splat(1.0f);
    }
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

/* How the surface of a fragment answers light: by the cosine; by the cosine in bands; by the cosine
 * with Phong's highlight or with Blinn's. */
typedef enum light_answer { ANSWER_COSINE, ANSWER_BANDS, ANSWER_PHONG, ANSWER_BLINN } light_answer;

static inline bool has_highlights(light_answer answer)
{
    return answer == ANSWER_PHONG || answer == ANSWER_BLINN;
}

static inline lanes_f in_bands(lanes_f lit, uint32_t bands)
{
    const float count = bands ? (float)bands : 4.0f;
    const lanes_f last = lanes_splat(count - 1.0f);

    return lanes_div(lanes_min(lanes_floor(lanes_mul(lit, lanes_splat(count))), last), last);
}

/* Returns the diffuse part of the answer, from 0 to 1. */
static inline lanes_f lit_part(const gn_material *material, light_answer answer, lanes_f cosine)
{
    const lanes_f lit = above_zero(cosine);

    return answer == ANSWER_BANDS ? in_bands(lit, material->bands) : lit;
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

/* Returns the highlight of a light, whose cosine is N.L; 0 where the surface faces away. */
static inline lanes_f highlight(const gn_material *material, light_answer answer,
                                const lanes_f normal[3], const lanes_f to_light[3], lanes_f cosine,
                                const lanes_f to_eye[3])
{
    const lanes_f zero = lanes_splat(0.0f);
    const lanes_f power = raise(
        above_zero(answer == ANSWER_BLINN ? halfway_cosine(normal, to_light, to_eye)
                                          : reflected_cosine(normal, to_light, cosine, to_eye)),
        material->exponent);

    return lanes_select(lanes_greater(cosine, zero), power, zero);
}

/* A fragment under several lights, and what it has received. */
typedef struct light_sum {
    lanes_f place[3], normal[3];
    lanes_f to_eye[3], shone; /* only for answers with highlights */
    lanes_f received[3];
} light_sum;

/* Adds the lights after the first to `received` and `shone`. */
GN_OUT_OF_LINE void add_more_lights(const gn_lit_uniforms *u, light_answer answer, light_sum *sum)
{
    for (uint32_t i = 0; i < more_lights(u); ++i) {
        const gn_light *light = &u->more_lights[i];
        lanes_f to_light[3], remaining;

        light_at(light, sum->place, to_light, &remaining);

        const lanes_f cosine = dot(sum->normal, to_light);
        receive_more(light, lanes_mul(lit_part(&u->material, answer, cosine), remaining),
                     sum->received);
        if (has_highlights(answer)) {
            const lanes_f shine =
                highlight(&u->material, answer, sum->normal, to_light, cosine, sum->to_eye);

            sum->shone = lanes_add(sum->shone, lanes_mul(shine, remaining));
        }
    }
}

/* Adds the specular colour times `shine`. */
static inline void add_highlight(const gn_material *material, const gn_fragment_input *input,
                                 lanes_f shine, lanes_f color[3])
{
    lanes_f specular[3], texel[4];

    splat_vector(material->specular, specular);
    if (material->specular_map)
        lookup_map(material->specular_map, &material->sampler, input, texel);
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
    lookup_map(material->glow_map, &material->sampler, input, texel);
    for (int c = 0; c < 3; ++c)
        color[c] = lanes_add(color[c], texel[c]);
}

/* Whether a draw has one light and no cut-off, as most have. The shaders are compiled once more for
 * this case. */
static inline bool is_one_light(const gn_lit_uniforms *u)
{
    return more_lights(u) == 0 && !(u->material.alpha_cutoff > 0.0f);
}

/* Writes the normal that receives light. One that has no highlights has no normal map either. */
static inline void lit_normal(const gn_lit_uniforms *u, light_answer answer,
                              const gn_fragment_input *input, lanes_f normal[3])
{
    if (has_highlights(answer)) {
        surface_normal(u, input, normal);
    } else if (answer == ANSWER_BANDS) {
        load_vector(&input->varying[VARYING_NORMAL], normal);
        normalize(normal);
    } else {
        face_normal(input, normal);
    }
}

/* The shaders of gn_use_flat, gn_use_toon, gn_use_phong and gn_use_blinn_phong. `one_light` is
 * is_one_light, as a constant. */
GN_INLINE void shade_by_answer(const gn_lit_uniforms *u, light_answer answer, bool one_light,
                               const gn_fragment_input *input, gn_fragment_output *output)
{
    const bool shines = has_highlights(answer);
    lanes_f place[3], to_light[3], to_eye[3], normal[3], color[4], received[3], remaining;
    lanes_f shone = lanes_splat(0.0f);

    load_vector(&input->varying[VARYING_PLACE], place);
    light_fragment(&u->light, &u->shadow, input, place, to_light, &remaining);
    if (shines) {
        splat_vector(u->eye, to_eye);
        for (int c = 0; c < 3; ++c)
            to_eye[c] = lanes_sub(to_eye[c], place[c]);
        normalize(to_eye);
    }
    lit_normal(u, answer, input, normal);

    const lanes_f cosine = dot(normal, to_light);
    if (shines)
        shone =
            lanes_mul(highlight(&u->material, answer, normal, to_light, cosine, to_eye), remaining);
    surface_color(u->material.diffuse_map, &u->material.sampler, input, color);
    receive_light(&u->light, lanes_mul(lit_part(&u->material, answer, cosine), remaining),
                  received);
    if (!one_light) {
        light_sum sum;

        copy_vector(place, sum.place);
        copy_vector(normal, sum.normal);
        if (shines)
            copy_vector(to_eye, sum.to_eye);
        copy_vector(received, sum.received);
        sum.shone = shone;
        add_more_lights(u, answer, &sum);
        copy_vector(sum.received, received);
        shone = sum.shone;
    }
    multiply_color(color, received);
    if (shines) {
        add_glow(&u->material, input, color);
        add_highlight(&u->material, input, shone, color);
    }
    put_color(color, output);
    if (!one_light)
        cut_off(u->material.alpha_cutoff, color[3], output);
}

/* Phong's and Blinn's shaders share code, since they differ only in the highlight. */
GN_OUT_OF_LINE void shade_highlight(const gn_lit_uniforms *u, light_answer answer,
                                    const gn_fragment_input *input, gn_fragment_output *output)
{
    if (has_highlights(answer)) /* compilers leave out the other answers */
        shade_by_answer(u, answer, true, input, output);
}

GN_OUT_OF_LINE void shade_any_lights(const gn_lit_uniforms *u, light_answer answer,
                                     const gn_fragment_input *input, gn_fragment_output *output)
{
    shade_by_answer(u, answer, false, input, output);
}

GN_INLINE void shade_lit_fragment(const void *uniforms, light_answer answer,
                                  const gn_fragment_input *input, gn_fragment_output *output)
{
    const gn_lit_uniforms *const u = (const gn_lit_uniforms *)uniforms;

    if (!is_one_light(u))
        shade_any_lights(u, answer, input, output);
    else if (has_highlights(answer))
        shade_highlight(u, answer, input, output);
    else
        shade_by_answer(u, answer, true, input, output);
}

static inline void shade_flat(const void *uniforms, const gn_fragment_input *input,
                              gn_fragment_output *output)
{
    shade_lit_fragment(uniforms, ANSWER_COSINE, input, output);
}

static inline void shade_toon(const void *uniforms, const gn_fragment_input *input,
                              gn_fragment_output *output)
{
    shade_lit_fragment(uniforms, ANSWER_BANDS, input, output);
}

static inline void shade_phong(const void *uniforms, const gn_fragment_input *input,
                               gn_fragment_output *output)
{
    shade_lit_fragment(uniforms, ANSWER_PHONG, input, output);
}

static inline void shade_blinn_phong(const void *uniforms, const gn_fragment_input *input,
                                     gn_fragment_output *output)
{
    shade_lit_fragment(uniforms, ANSWER_BLINN, input, output);
}

#endif
