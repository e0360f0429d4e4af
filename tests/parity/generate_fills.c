/* Layers over most of the target, which are drawn in long rows: floors under a level camera and a
 * rolled one, walls, flat pictures. */
#include "generate_parts.h"

#include <stdlib.h>

/* A quad over most of the target; w is constant along every row, along every column, everywhere, or
 * is random. */
static void shape_fill(builder *b)
{
    random_source *r = &b->random;
    const gn_viewport view = builder_viewport(b);
    const uint32_t base = b->vertex_count, turn = random_below(r, 4), kind = random_below(r, 4);
    const bool powers = random_chance(r, 50);
    float side[2][2], w[2], z[2];
    for (int k = 0; k < 2; ++k) {
        const float reach = random_chance(r, 60) ? 0.2f : -0.2f;
        side[0][k] = view.x + view.width * ((float)k + (float)(2 * k - 1) * reach * random_unit(r));
        side[1][k] =
            view.y + view.height * ((float)k + (float)(2 * k - 1) * reach * random_unit(r));
        w[k] = powers ? random_power(r, -2, 2) : random_octave(r, -2, 1);
        z[k] = random_float(r, -0.9f, 0.9f);
    }
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t corner = (k + turn) % 4;
        const uint32_t x = corner == 1 || corner == 2, y = corner / 2;
        const uint32_t varies = kind == 0 ? y : kind == 1 ? x : 0;
        vertex *v = builder_vertex(b);
        const float roll = kind == 3 ? random_octave(r, -1, 0) : 1.0f;
        builder_place(b, v, side[0][x], side[1][y], z[varies], roll * w[varies]);
    }
    const uint32_t order[6] = {0, 1, 2, 0, 2, 3};
    for (int k = 0; k < 6; ++k)
        builder_index(b, base + order[k]);
}

void *random_picture(builder *b)
{
    random_source *r = &b->random;
    const uint32_t side = 1u << random_below(r, 6);
    uint32_t *texels = malloc(side * side * sizeof *texels);
    if (!texels)
        abort();
    const bool opaque = random_chance(r, 50);
    for (uint32_t i = 0; i < side * side; ++i)
        texels[i] = (uint32_t)(random_bits(r) >> 32) | (opaque ? 0xFF000000u : 0);
    b->shader = SCENE_TEXTURED_GOURAUD;
    random_light(b);
    b->uniforms.texture.width = side;
    b->uniforms.texture.height = side;
    b->uniforms.texture.format = GN_FORMAT_RGBA8;
    b->uniforms.texture.level[0].texels = texels;
    b->uniforms.sampler.magnify = (gn_magnify)random_below(r, 2);
    b->uniforms.sampler.minify =
        b->uniforms.sampler.magnify == GN_MAGNIFY_LINEAR ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST;
    return texels;
}

void generate_fills(builder *b)
{
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D24, GN_FORMAT_D24,
                                       GN_FORMAT_D32F};
    random_source *r = &b->random;
    builder_common_target(b);
    b->scene->depth_format = depths[random_below(r, 4)];
    for (uint32_t draws = 2 + random_below(r, 5); draws > 0; --draws) {
        void *texels = NULL;
        builder_common_state(b);
        b->state.depth.test_enabled =
            b->scene->depth_format != GN_FORMAT_NONE && random_chance(r, 90);
        if (random_chance(r, 60))
            b->state.depth.function = random_comparison(r);
        b->state.depth.write_disabled = random_chance(r, 15);
        for (uint32_t quads = 1 + random_below(r, 4); quads > 0; --quads)
            shape_fill(b);
        b->color_components = random_chance(r, 75) ? 3 : 4;
        if (random_chance(r, 30))
            texels = random_picture(b);
        if (random_chance(r, 15))
            lay_over(b, 0);
        builder_draw(b);
        free(texels);
    }
}
