/* Colours combined with the target's colours: write masks, blending and logical operations. */
#include "generate_parts.h"

/* Masks one to three channels, mostly. */
void random_mask(builder *b, int attachment)
{
    random_source *r = &b->random;
    const uint32_t which = random_below(r, 16);
    b->state.color.write_disabled[attachment] = random_chance(r, 50) ? which : 1u << which % 4;
}

/* A target whose size is odd now and then, so that blocks reach beyond its edges. */
static void color_target(builder *b)
{
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D16, GN_FORMAT_D24,
                                       GN_FORMAT_D32F};
    random_source *r = &b->random;
    if (random_chance(r, 60)) {
        builder_common_target(b);
    } else {
        const uint32_t width = 1 + random_below(r, 70), height = 1 + random_below(r, 70);
        builder_target(b, width, height, GN_FORMAT_RGBA8, depths[random_below(r, 4)]);
    }
}

/* RGBA8, for which the library has functions of its own, or another normalized format. */
static void fixed_format(builder *b)
{
    while (random_chance(&b->random, 60) || scene_is_float_format(b->scene->color_format))
        b->scene->color_format = random_color_format(b);
}

/* Triangles that cover one another, with colours that may lie outside 0..1. */
static void color_draw(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    const uint32_t shape = random_below(r, 4);
    if (shape == 0)
        shape_any_grid(b, 6);
    else if (shape == 1)
        shape_ties(b, count);
    else
        shape_pile(b, count);
    b->shader = (scene_shader)(random_chance(r, 15) ? SCENE_GOURAUD : SCENE_VERTEX_COLOR);
    b->uniforms.light.light_direction.z = 1.0f;
    b->uniforms.light.ambient = (gn_vec3){0.25f, 0.25f, 0.5f};
    b->uniforms.light.diffuse = (gn_vec3){0.75f, 0.5f, 0.5f};
    if (random_chance(r, 30)) {
        const float low = -random_unit(r), high = 1.0f + random_unit(r);
        for (uint32_t i = 0; i < b->vertex_count; ++i)
            for (int c = 0; c < 4; ++c)
                b->vertices[i].color[c] = random_float(r, low, high);
    }
}

void generate_color_mask(builder *b)
{
    random_source *r = &b->random;
    color_target(b);
    if (random_chance(r, 60))
        b->scene->color_format = random_chance(r, 25) ? GN_FORMAT_RGBA32F : random_color_format(b);
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        random_mask(b, 0);
        color_draw(b, 1 + builder_triangle_count(b) / 2);
        builder_draw(b);
    }
}

/* Half of the time the factors are one of the pairs that are common in programs. */
static void random_factors(random_source *r, gn_blend_factor *source, gn_blend_factor *destination)
{
    static const gn_blend_factor pairs[][2] = {
        {GN_FACTOR_SOURCE_ALPHA, GN_FACTOR_ONE_MINUS_SOURCE_ALPHA},
        {GN_FACTOR_ONE, GN_FACTOR_ONE_MINUS_SOURCE_ALPHA},
        {GN_FACTOR_ONE_MINUS_SOURCE_ALPHA, GN_FACTOR_SOURCE_ALPHA},
        {GN_FACTOR_ONE, GN_FACTOR_ONE},
        {GN_FACTOR_SOURCE_ALPHA, GN_FACTOR_ONE},
        {GN_FACTOR_DESTINATION_COLOR, GN_FACTOR_ZERO},
        {GN_FACTOR_ZERO, GN_FACTOR_SOURCE_COLOR},
        {GN_FACTOR_SOURCE_ALPHA_SATURATE, GN_FACTOR_ONE},
        {GN_FACTOR_ONE_MINUS_DESTINATION_COLOR, GN_FACTOR_ONE},
        {GN_FACTOR_CONSTANT_ALPHA, GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA},
        {GN_FACTOR_DEFAULT, GN_FACTOR_DEFAULT},
    };
    if (random_chance(r, 50)) {
        const uint32_t pair = random_below(r, sizeof pairs / sizeof *pairs);
        *source = pairs[pair][0];
        *destination = pairs[pair][1];
    } else {
        *source = (gn_blend_factor)random_below(r, 16);
        *destination = (gn_blend_factor)random_below(r, 16);
    }
}

static gn_blend_equation random_equation(random_source *r)
{
    return (gn_blend_equation)(random_chance(r, 50) ? 0 : random_below(r, 6));
}

void lay_over(builder *b, int attachment)
{
    b->state.color.blend[attachment].enabled = true;
    b->state.color.blend[attachment].source = GN_FACTOR_SOURCE_ALPHA;
    b->state.color.blend[attachment].destination = GN_FACTOR_ONE_MINUS_SOURCE_ALPHA;
}

/* A factor and one minus that factor, in either order; formats of one channel compute that pair
 * differently. */
static void random_mix(random_source *r, gn_blend *blend)
{
    static const gn_blend_equation equations[] = {GN_EQUATION_ADD, GN_EQUATION_SUBTRACT,
                                                  GN_EQUATION_REVERSE_SUBTRACT};
    const uint32_t pair = random_below(r, 7), second = random_below(r, 2);
    blend->equation = equations[random_below(r, 3)];
    blend->source = (gn_blend_factor)(GN_FACTOR_ZERO + 2 * pair + second);
    blend->destination = (gn_blend_factor)(GN_FACTOR_ZERO + 2 * pair + !second);
}

static bool has_one_channel(gn_format format)
{
    return scene_format_of(format)->channels == 1;
}

void random_blend(builder *b, int attachment)
{
    random_source *r = &b->random;
    gn_blend *blend = &b->state.color.blend[attachment];
    blend->enabled = true;
    if (random_chance(r, 25)) { /* formats for which the library has functions of its own */
        lay_over(b, attachment);
        return;
    }
    blend->equation = random_equation(r);
    random_factors(r, &blend->source, &blend->destination);
    if (random_chance(r, 50)) {
        blend->alpha_equation = random_equation(r);
        random_factors(r, &blend->alpha_source, &blend->alpha_destination);
    }
    if (has_one_channel(scene_color_format(b->scene, attachment)) && random_chance(r, 60))
        random_mix(r, blend);
    const bool beyond = random_chance(r, 20);
    for (int c = 0; c < 4; ++c)
        b->state.color.blend_constant[c] = beyond ? random_float(r, -1.0f, 2.0f) : random_unit(r);
}

/* One triangle over a colour that sRGB represents. If the reference's encoding is a step off, a
 * second layer would multiply that step. */
static void srgb_blend(builder *b)
{
    random_source *r = &b->random;
    for (int c = 0; c < 3; ++c) { /* within a fifth of a step */
        const float x = (float)random_between(r, 16, 255) / 255.0f;
        b->scene->clear_color[c] = x * (0.0030f + x * x * 0.3012f) + (0.0023f + x * x * 0.6935f);
    }
    builder_common_state(b);
    random_blend(b, 0);
    if (random_chance(r, 20))
        random_mask(b, 0);
    shape_pile(b, 1);
    builder_draw(b);
}

void generate_blend(builder *b)
{
    random_source *r = &b->random;
    color_target(b);
    fixed_format(b);
    if (b->scene->color_format == GN_FORMAT_SRGB8_A8) {
        srgb_blend(b);
        return;
    }
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        random_blend(b, 0);
        if (random_chance(r, 20))
            random_mask(b, 0);
        color_draw(b, 1 + builder_triangle_count(b) / 2);
        builder_draw(b);
    }
}

/* Draws few layers: products of many layers become denormals, which the reference flushes. */
void generate_float_blend(builder *b)
{
    random_source *r = &b->random;
    static const gn_format formats[] = {GN_FORMAT_RGBA32F, GN_FORMAT_RGB32F,
                                        GN_FORMAT_R32F,    GN_FORMAT_RGBA16F,
                                        GN_FORMAT_RG16F,   GN_FORMAT_R11F_G11F_B10F};
    color_target(b);
    b->scene->color_format = formats[random_below(r, 6)];
    for (int c = 0; c < 4; ++c)
        b->scene->clear_color[c] = random_float(r, -2.0f, 3.0f);
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        random_blend(b, 0);
        if (random_chance(r, 20))
            random_mask(b, 0);
        color_draw(b, 1 + random_below(r, 8));
        builder_draw(b);
    }
}

static void random_logic(builder *b)
{
    b->state.color.logic_enabled = true;
    b->state.color.logic_operation = (gn_logic_operation)random_below(&b->random, 16);
}

void generate_logic(builder *b)
{
    random_source *r = &b->random;
    color_target(b);
    if (random_chance(r, 60))
        b->scene->color_format = random_chance(r, 20) ? GN_FORMAT_RGBA32F : random_color_format(b);
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        random_logic(b);
        if (random_chance(r, 10))
            random_blend(b, 0);
        if (random_chance(r, 20))
            random_mask(b, 0);
        color_draw(b, 1 + builder_triangle_count(b) / 2);
        builder_draw(b);
    }
}

/* Over many layers R32F would hold denormals, and sRGB would differ by more than a step. */
void mix_color_state(builder *b)
{
    const gn_format format = b->scene->color_format;
    if (random_chance(&b->random, 10))
        random_mask(b, 0);
    if (random_chance(&b->random, 20) && format != GN_FORMAT_R32F && format != GN_FORMAT_SRGB8_A8)
        random_blend(b, 0);
    if (random_chance(&b->random, 5))
        random_logic(b);
}
