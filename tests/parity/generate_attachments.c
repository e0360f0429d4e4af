/* Several colour attachments of different formats, with holes among them, each with its own
 * blending and mask; shaders that write more colours than there are attachments, and fewer. */
#include "generate_parts.h"

static gn_format attachment_format(builder *b)
{
    random_source *r = &b->random;
    const uint32_t which = random_below(r, 10);
    if (which < 2)
        return GN_FORMAT_NONE;
    if (which < 5)
        return GN_FORMAT_RGBA8;
    return which == 5 ? GN_FORMAT_RGBA32F : random_color_format(b);
}

void add_attachments(builder *b)
{
    const uint32_t count = 1 + random_below(&b->random, GN_MAX_COLORS - 1);
    for (uint32_t a = 0; a < count; ++a)
        b->scene->more_colors[a] = attachment_format(b);
    b->scene->more_colors[count - 1] = GN_FORMAT_RGBA8;
}

void random_outputs(builder *b)
{
    b->shader = SCENE_OUTPUTS;
    b->state.program.color_count = 2 + random_below(&b->random, GN_MAX_COLORS - 1);
}

void mix_attachments(builder *b, bool blends_floats)
{
    random_source *r = &b->random;
    for (int a = 1; a < GN_MAX_COLORS; ++a) {
        const gn_format format = scene_color_format(b->scene, a);
        const bool keeps =
            format == GN_FORMAT_NONE || format == GN_FORMAT_SRGB8_A8 ||
            (!blends_floats && (format == GN_FORMAT_RGBA32F || format == GN_FORMAT_R32F));
        if (random_chance(r, 40) && !keeps)
            random_blend(b, a);
        if (random_chance(r, 20))
            random_mask(b, a);
    }
}

void generate_attachments(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    add_attachments(b);
    if (random_chance(r, 30)) { /* blocks reach beyond the target */
        b->scene->width = 1 + random_below(r, 40);
        b->scene->height = 1 + random_below(r, 40);
    }
    if (random_chance(r, 25))
        b->scene->color_format = attachment_format(b);
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        if (random_chance(r, 40) && b->scene->color_format != GN_FORMAT_SRGB8_A8)
            random_blend(b, 0);
        if (random_chance(r, 20))
            random_mask(b, 0);
        mix_attachments(b, true);
        if (random_chance(r, 5)) {
            b->state.color.logic_enabled = true;
            b->state.color.logic_operation = (gn_logic_operation)random_below(r, 16);
        }
        shape_pile(b, 1 + random_below(r, 8));
        if (random_chance(r, 90))
            random_outputs(b);
        builder_draw(b);
    }
}
