/* The ready-made shaders with what glTF asks for: alpha cut-offs, several lights, and its
 * material. */
#include "generate_parts.h"

#include <math.h>

/* Sets a cut-off for the next draw, whose vertices exist: at random, at the alpha that all vertices
 * share, or where some alphas are NaN. */
static void random_cutoff(builder *b)
{
    random_source *r = &b->random;
    const uint32_t kind = random_below(r, 10);
    const float cutoff = random_float(r, 0.05f, 1.0f);

    b->surface.alpha_cutoff = cutoff;
    for (uint32_t i = 0; kind < 2 && i < b->vertex_count; ++i)
        b->vertices[i].color[3] = cutoff;
    if (kind == 2)
        b->vertices[random_below(r, b->vertex_count)].color[3] = NAN;
}

/* A direction of length 1, but for rounding. */
static gn_vec3 random_direction(builder *b)
{
    const gn_mat3 turn = builder_rotation(b);

    return (gn_vec3){turn.m[2][0], turn.m[2][1], turn.m[2][2]};
}

/* Cosines of a cone of any width; now and then the inner one is not above the outer one. */
static void random_cone(random_source *r, float *inner, float *outer)
{
    *outer = random_float(r, -1.0f, 0.9f);
    *inner = random_chance(r, 85) ? random_float(r, *outer, 1.0f) : *outer;
    if (random_chance(r, 5))
        *inner = *outer - 0.25f;
}

static float random_range(random_source *r)
{
    return random_chance(r, 50) ? random_float(r, 0.5f, 8.0f) : 0.0f;
}

static gn_light random_any_light(builder *b)
{
    random_source *r = &b->random;
    gn_light light = {.kind = GN_LIGHT_DIRECTIONAL};

    light.kind = (gn_light_kind)random_below(r, 3);
    light.direction = random_direction(b);
    light.position = random_vec3(r, -4.0f, 4.0f);
    if (random_chance(r, 60)) {
        light.constant = random_float(r, 0.0f, 2.0f);
        light.linear = random_chance(r, 50) ? random_float(r, 0.0f, 2.0f) : 0.0f;
        light.quadratic = random_float(r, 0.0f, 2.0f);
    }
    light.range = random_range(r);
    random_cone(r, &light.inner_cosine, &light.outer_cosine);
    light.ambient = random_vec3(r, 0.0f, 0.2f);
    light.diffuse = random_vec3(r, 0.0f, 1.0f);
    return light;
}

/* Makes the light of a draw a spot light or gives it a range, and adds lights. */
static void random_lights(builder *b)
{
    random_source *r = &b->random;
    scene_surface *s = &b->surface;

    if (random_chance(r, 40)) {
        s->has_spot_light = true;
        s->light_position = random_vec3(r, -4.0f, 4.0f);
        random_cone(r, &s->cone[0], &s->cone[1]);
    }
    s->light_range = random_range(r);
    s->more_light_count = random_chance(r, 60) ? 1 + random_below(r, GN_MAX_LIGHTS - 1) : 0;
    for (uint32_t i = 0; i < s->more_light_count; ++i)
        s->more_lights[i] = random_any_light(b);
}

static float random_factor(random_source *r)
{
    const uint32_t kind = random_below(r, 4);

    return kind < 2 ? (float)kind : random_unit(r);
}

static void random_factors(builder *b)
{
    random_source *r = &b->random;
    scene_surface *s = &b->surface;

    s->metallic = random_factor(r);
    s->roughness = random_factor(r);
    s->normal_scale = random_float(r, 0.1f, 2.0f);
    s->occlusion_strength = random_factor(r);
    if (random_chance(r, 60))
        s->emissive = random_vec3(r, 0.0f, 1.0f);
    s->double_sided = random_chance(r, 50);
}

void random_metallic(builder *b, shading_memory *memory)
{
    random_source *r = &b->random;

    random_factors(b);
    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        random_map_sampler(r, &b->surface.map_sampler[m]);
    for (int m = SCENE_METALLIC_ROUGHNESS_MAP; m <= SCENE_OCCLUSION_MAP; ++m)
        if (random_chance(r, 50))
            memory->texels[m] = random_map(b, &b->surface.map[m]);
}

static scene_shader random_lit_shader(builder *b)
{
    static const scene_shader shaders[] = {
        SCENE_MAPPED_PHONG, SCENE_BLINN_PHONG, SCENE_FACES, SCENE_TOON,
        SCENE_FLAT,         SCENE_GOURAUD,     SCENE_UNLIT, SCENE_TEXTURED_GOURAUD};
    random_source *r = &b->random;

    if (random_chance(r, 40))
        return SCENE_METALLIC_ROUGHNESS;
    return shaders[random_below(r, sizeof shaders / sizeof *shaders)];
}

static void add_material(builder *b)
{
    random_source *r = &b->random;
    shading_memory memory;

    builder_common_state(b);
    b->shader = random_lit_shader(b);
    shape_shaded(b);
    random_shading(b, &memory);
    random_lights(b);
    if (b->shader == SCENE_METALLIC_ROUGHNESS)
        random_metallic(b, &memory);
    if (random_chance(r, 40) && b->vertex_count > 0)
        random_cutoff(b);
    if (random_chance(r, 15))
        lay_over(b, 0);
    b->counted = random_chance(r, 30);
    builder_draw(b);
    free_shading(&memory);
}

static scene_shader choose_shadowed(builder *b)
{
    return random_chance(&b->random, 60) ? SCENE_METALLIC_ROUGHNESS : SCENE_MAPPED_PHONG;
}

/* Adds lights without shadows to the one that has a shadow map. */
static void add_unshadowed(builder *b)
{
    const scene_surface shadowed = b->surface;

    random_lights(b);
    random_factors(b);
    b->surface.light_position = shadowed.light_position;
    b->surface.has_spot_light &= shadowed.has_point_light;
}

void generate_materials(builder *b)
{
    random_source *r = &b->random;
    const uint32_t kind = random_below(r, 10);

    b->metallic = kind < 2;
    if (b->metallic) {
        generate_sequences(b);
        return;
    }
    builder_common_target(b);
    if (random_chance(r, 40))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws)
        if (kind < 4)
            shadowed_draw(b, choose_shadowed, add_unshadowed);
        else
            add_material(b);
}
