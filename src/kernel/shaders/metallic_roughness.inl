/* The fragment shader of gn_use_metallic_roughness, whose formula stands in gnomon/shaders.h. */
#ifndef GN_KERNEL_SHADERS_METALLIC_ROUGHNESS_INL
#define GN_KERNEL_SHADERS_METALLIC_ROUGHNESS_INL

#include "lit.inl"

/* What the reflection of every light needs of a fragment; comments name the formula's terms. */
typedef struct reflector {
    lanes_f place[3], normal[3], to_eye[3];
    lanes_f diffuse[3]; /* cd */
    lanes_f facing[3];  /* f0, the reflectance of a surface that faces the eye */
    lanes_f squared;    /* A */
    lanes_f n_v;        /* N.V */
    lanes_f root;       /* sqrt((N.V)^2 * (1 - A) + A) */
} reflector;

/* Returns sqrt(cosine^2 * (1 - A) + A). */
static inline lanes_f masking_root(lanes_f cosine, lanes_f squared)
{
    const lanes_f part =
        lanes_mul(lanes_mul(cosine, cosine), lanes_sub(lanes_splat(1.0f), squared));

    return lanes_sqrt(lanes_add(part, squared));
}

/* Returns 0.5 * D / G; 0 where the surface faces away from the light, since G may be 0 there. */
static inline lanes_f specular_part(const reflector *r, lanes_f n_l, lanes_f n_h)
{
    const lanes_f zero = lanes_splat(0.0f), one = lanes_splat(1.0f);
    const lanes_f width =
        lanes_add(lanes_mul(lanes_mul(n_h, n_h), lanes_sub(r->squared, one)), one);
    const lanes_f masking =
        lanes_add(lanes_mul(n_l, r->root), lanes_mul(r->n_v, masking_root(n_l, r->squared)));
    const lanes_f part = lanes_div(lanes_mul(lanes_splat(0.5f), r->squared),
                                   lanes_mul(lanes_mul(width, width), masking));

    return lanes_select(lanes_greater(n_l, zero), part, zero);
}

/* Writes the light that the fragment reflects to the eye. H is NaN if the light is exactly behind
 * the surface as the eye sees it; its cosines are then 0. */
static inline void reflect_light(const reflector *r, const gn_light *light,
                                 const lanes_f to_light[3], lanes_f remaining, lanes_f reflected[3])
{
    const lanes_f one = lanes_splat(1.0f);
    lanes_f half[3], color[3];

    for (int c = 0; c < 3; ++c)
        half[c] = lanes_add(to_light[c], r->to_eye[c]);
    normalize(half);
    splat_vector(light->diffuse, color);

    const lanes_f n_l = above_zero(dot(r->normal, to_light));
    const lanes_f specular = specular_part(r, n_l, above_zero(dot(r->normal, half)));
    const lanes_f x = lanes_sub(one, above_zero(dot(r->to_eye, half)));
    const lanes_f x2 = lanes_mul(x, x);
    const lanes_f x5 = lanes_mul(lanes_mul(x2, x2), x);
    const lanes_f received =
        lanes_mul(lanes_mul(n_l, remaining), lanes_splat(0.318309886f)); /* 1/pi */

    for (int c = 0; c < 3; ++c) {
        const lanes_f fresnel =
            lanes_add(r->facing[c], lanes_mul(lanes_sub(one, r->facing[c]), x5));
        const lanes_f part = lanes_add(lanes_mul(lanes_sub(one, fresnel), r->diffuse[c]),
                                       lanes_mul(fresnel, specular));

        reflected[c] = lanes_mul(part, lanes_mul(color[c], received));
    }
}

/* Adds the lights after the first to `reflected` and `ambient`. */
GN_OUT_OF_LINE void reflect_more_lights(const gn_metallic_roughness_uniforms *u, const reflector *r,
                                        lanes_f reflected[3], lanes_f ambient[3])
{
    for (uint32_t i = 0; i < u->more_light_count; ++i) {
        const gn_light *light = &u->more_lights[i];
        lanes_f to_light[3], more[3], around[3], remaining;

        light_at(light, r->place, to_light, &remaining);
        reflect_light(r, light, to_light, remaining, more);
        splat_vector(light->ambient, around);
        for (int c = 0; c < 3; ++c) {
            reflected[c] = lanes_add(reflected[c], more[c]);
            ambient[c] = lanes_add(ambient[c], around[c]);
        }
    }
}

/* Looks up a map; returns false if there is none. */
static inline bool lookup_if_there(const gn_map *map, const gn_fragment_input *input,
                                   lanes_f texel[4])
{
    if (map->texture)
        lookup_map(map->texture, &map->sampler, input, texel);
    return map->texture != 0;
}

/* Sets the normal: the normal map's if there is one, and reversed on the back of a double-sided
 * surface. */
static inline void set_reflector_normal(const gn_metallic_roughness *material,
                                        const gn_fragment_input *input, lanes_f normal[3])
{
    lanes_f texel[4];

    load_vector(&input->varying[VARYING_NORMAL], normal);
    if (lookup_if_there(&material->normal_map, input, texel)) {
        const lanes_f scale = lanes_splat(material->normal_scale);

        for (int c = 0; c < 3; ++c)
            texel[c] = lanes_sub(lanes_mul(texel[c], lanes_splat(2.0f)), lanes_splat(1.0f));
        texel[0] = lanes_mul(texel[0], scale);
        texel[1] = lanes_mul(texel[1], scale);
        from_tangents(input, texel, normal);
    }
    normalize(normal);
    if (material->double_sided && !input->front_facing)
        scale_vector(normal, lanes_splat(-1.0f));
}

/* Sets what depends on colour, metallic and roughness. */
static inline void set_reflector_surface(const gn_metallic_roughness *material,
                                         const gn_fragment_input *input, const lanes_f color[3],
                                         reflector *r)
{
    const lanes_f least = lanes_splat(0.045f);
    lanes_f metallic = lanes_splat(material->metallic);
    lanes_f roughness = lanes_splat(material->roughness);
    lanes_f texel[4];

    if (lookup_if_there(&material->metallic_roughness_map, input, texel)) {
        metallic = lanes_mul(metallic, texel[2]);
        roughness = lanes_mul(roughness, texel[1]);
    }
    roughness = lanes_select(lanes_greater(roughness, least), roughness, least);

    const lanes_f alpha = lanes_mul(roughness, roughness);
    const lanes_f rest = lanes_sub(lanes_splat(1.0f), metallic);
    const lanes_f dielectric = lanes_mul(lanes_splat(0.04f), rest);

    r->squared = lanes_mul(alpha, alpha);
    for (int c = 0; c < 3; ++c) {
        r->diffuse[c] = lanes_mul(color[c], rest);
        r->facing[c] = lanes_add(dielectric, lanes_mul(color[c], metallic));
    }
}

/* Returns the part of the ambient light that reaches the fragment. */
static inline lanes_f unoccluded(const gn_metallic_roughness *material,
                                 const gn_fragment_input *input)
{
    const lanes_f one = lanes_splat(1.0f);
    lanes_f texel[4];

    if (!lookup_if_there(&material->occlusion_map, input, texel))
        return one;
    return lanes_add(
        one, lanes_mul(lanes_splat(material->occlusion_strength), lanes_sub(texel[0], one)));
}

/* Adds the light that the surface gives off. */
static inline void add_emission(const gn_metallic_roughness *material,
                                const gn_fragment_input *input, lanes_f color[3])
{
    lanes_f emissive[3], texel[4];
    const bool mapped = lookup_if_there(&material->emissive_map, input, texel);

    splat_vector(material->emissive, emissive);
    for (int c = 0; c < 3; ++c)
        color[c] = lanes_add(color[c], mapped ? lanes_mul(emissive[c], texel[c]) : emissive[c]);
}

static inline void shade_metallic_roughness(const void *uniforms, const gn_fragment_input *input,
                                            gn_fragment_output *output)
{
    const gn_metallic_roughness_uniforms *u = (const gn_metallic_roughness_uniforms *)uniforms;
    lanes_f to_light[3], color[4], reflected[3], ambient[3], remaining;
    reflector r;

    load_vector(&input->varying[VARYING_PLACE], r.place);
    light_fragment(&u->light, &u->shadow, input, r.place, to_light, &remaining);
    splat_vector(u->eye, r.to_eye);
    for (int c = 0; c < 3; ++c)
        r.to_eye[c] = lanes_sub(r.to_eye[c], r.place[c]);
    normalize(r.to_eye);
    set_reflector_normal(&u->material, input, r.normal);
    surface_color(u->material.base_color_map.texture, &u->material.base_color_map.sampler, input,
                  color);
    set_reflector_surface(&u->material, input, color, &r);
    r.n_v = above_zero(dot(r.normal, r.to_eye));
    r.root = masking_root(r.n_v, r.squared);
    reflect_light(&r, &u->light, to_light, remaining, reflected);
    splat_vector(u->light.ambient, ambient);
    if (GN_HAVE_POINT_LIGHTS && u->more_light_count > 0)
        reflect_more_lights(u, &r, reflected, ambient);

    const lanes_f open = unoccluded(&u->material, input);
    for (int c = 0; c < 3; ++c) {
        const lanes_f around =
            lanes_mul(lanes_add(r.diffuse[c], r.facing[c]), lanes_mul(ambient[c], open));

        color[c] = lanes_add(reflected[c], around);
    }
    add_emission(&u->material, input, color);
    put_color(color, output);
    cut_off(u->material.alpha_cutoff, color[3], output);
}

#endif
