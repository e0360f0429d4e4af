/* The ready-made shaders with what glTF materials ask for: alpha cut-offs. */
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
    if (random_chance(r, 80) && b->vertex_count > 0)
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
