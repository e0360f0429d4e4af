/* The ready-made shaders with what glTF asks for: alpha cut-offs, several lights. */
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

static gn_vec3 random_triple(random_source *r, float low, float high)
{
    gn_vec3 v;

    v.x = random_float(r, low, high);
    v.y = random_float(r, low, high);
    v.z = random_float(r, low, high);
    return v;
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
    gn_light light = {GN_LIGHT_DIRECTIONAL};

    light.kind = (gn_light_kind)random_below(r, 3);
    light.direction = random_direction(b);
    light.position = random_triple(r, -4.0f, 4.0f);
    if (random_chance(r, 60)) {
        light.constant = random_float(r, 0.0f, 2.0f);
        light.linear = random_chance(r, 50) ? random_float(r, 0.0f, 2.0f) : 0.0f;
        light.quadratic = random_float(r, 0.0f, 2.0f);
    }
    light.range = random_range(r);
    random_cone(r, &light.inner_cosine, &light.outer_cosine);
    light.ambient = random_triple(r, 0.0f, 0.2f);
    light.diffuse = random_triple(r, 0.0f, 1.0f);
    return light;
}

/* Makes the light of a draw a spot light or gives it a range, and adds lights. */
static void random_lights(builder *b)
{
    random_source *r = &b->random;
    scene_surface *s = &b->surface;

    if (random_chance(r, 40)) {
        s->has_spot_light = true;
        s->light_position = random_triple(r, -4.0f, 4.0f);
        random_cone(r, &s->cone[0], &s->cone[1]);
    }
    s->light_range = random_range(r);
    s->more_light_count = random_chance(r, 60) ? 1 + random_below(r, GN_MAX_LIGHTS - 1) : 0;
    for (uint32_t i = 0; i < s->more_light_count; ++i)
        s->more_lights[i] = random_any_light(b);
}

static void add_material(builder *b)
{
    static const scene_shader shaders[] = {
        SCENE_MAPPED_PHONG, SCENE_BLINN_PHONG, SCENE_FACES, SCENE_TOON,
        SCENE_FLAT,         SCENE_GOURAUD,     SCENE_UNLIT, SCENE_TEXTURED_GOURAUD};
    random_source *r = &b->random;
    shading_memory memory;

    builder_common_state(b);
    b->shader = shaders[random_below(r, sizeof shaders / sizeof *shaders)];
    shape_shaded(b);
    random_shading(b, &memory);
    random_lights(b);
    if (random_chance(r, 50) && b->vertex_count > 0)
        random_cutoff(b);
    if (random_chance(r, 20))
        lay_over(b, 0);
    b->counted = random_chance(r, 30);
    builder_draw(b);
    free_shading(&memory);
}

void generate_materials(builder *b)
{
    random_source *r = &b->random;

    builder_common_target(b);
    if (random_chance(r, 40))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws)
        add_material(b);
}
