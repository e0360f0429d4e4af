/* Stencil: formats, faces, functions, operations, masks and references. */
#include "generate_parts.h"

static uint8_t random_byte(random_source *r)
{
    return (uint8_t)random_below(r, 256);
}

/* References and masks are mostly small and whole, so that values meet. */
static gn_stencil_face random_face(random_source *r, uint8_t near)
{
    gn_stencil_face f;
    f.function = random_comparison(r);
    f.reference = random_chance(r, 70) ? (uint8_t)(near + random_below(r, 3) - 1) : random_byte(r);
    f.compare_disabled = random_chance(r, 70) ? 0 : random_byte(r);
    f.write_disabled = random_chance(r, 70) ? 0 : random_byte(r);
    f.fail = (gn_stencil_operation)random_below(r, 8);
    f.depth_fail = (gn_stencil_operation)random_below(r, 8);
    f.pass = (gn_stencil_operation)random_below(r, 8);
    return f;
}

/* The reference compiles a program for every state except references, which takes longer than
 * everything else. So most draws have one of a few states; each state belongs to one number. */
#define KNOWN_STATES 64

void random_stencil(builder *b)
{
    random_source *r = &b->random;
    const uint8_t near = b->scene->clear_stencil;
    random_source state = random_seed(random_below(r, KNOWN_STATES));
    if (random_chance(r, 4))
        state = random_seed(random_bits(r));
    b->state.stencil.test_enabled = true;
    b->state.stencil.front = random_face(&state, near);
    b->state.stencil.back = random_face(&state, near);
    b->state.depth.function =
        random_chance(&state, 50) ? random_comparison(&state) : GN_COMPARE_DEFAULT;
    b->state.depth.write_disabled = random_chance(&state, 25);
    for (int i = 0; i < 2; ++i)
        if (random_chance(r, 30))
            (i ? &b->state.stencil.front : &b->state.stencil.back)->reference = random_byte(r);
}

void generate_stencil(builder *b)
{
    static const gn_format formats[] = {GN_FORMAT_D24S8,  GN_FORMAT_D24S8,  GN_FORMAT_D24S8,
                                        GN_FORMAT_D32FS8, GN_FORMAT_D32FS8, GN_FORMAT_S8,
                                        GN_FORMAT_S8,     GN_FORMAT_D24};
    random_source *r = &b->random;
    builder_common_target(b);
    b->scene->depth_format = formats[random_below(r, 8)];
    const uint8_t clears[] = {0, 1, 127, 254, 255, random_byte(r)};
    b->scene->clear_stencil = clears[random_below(r, 6)];
    for (uint32_t draws = 1 + random_below(r, 5); draws > 0; --draws) {
        builder_common_state(b);
        b->state.raster.front_face = (gn_front_face)random_below(r, 2);
        b->state.raster.cull = (gn_cull)(random_chance(r, 15) ? random_below(r, 3) : 0);
        if (random_chance(r, 90))
            random_stencil(b);
        shape_any(b, 1 + builder_triangle_count(b) / 2);
        if (random_chance(r, 5))
            random_inputs(b);
        builder_draw(b);
    }
}
