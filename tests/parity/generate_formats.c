/* Targets of every colour format, with colours at the limits of its conversion. */
#include "generate_parts.h"

#include <math.h>

/* All formats of colours that scenes have beside the two most common. */
static const gn_format formats[] = {GN_FORMAT_BGRA8,    GN_FORMAT_R8,
                                    GN_FORMAT_RG8,      GN_FORMAT_RGB8,
                                    GN_FORMAT_RGB565,   GN_FORMAT_RGB5_A1,
                                    GN_FORMAT_RGBA4,    GN_FORMAT_R16,
                                    GN_FORMAT_RGBA16,   GN_FORMAT_R32F,
                                    GN_FORMAT_RGBA16F,  GN_FORMAT_SRGB8_A8,
                                    GN_FORMAT_RG16F,    GN_FORMAT_RGB565_SWAPPED,
                                    GN_FORMAT_RGB10_A2, GN_FORMAT_R11F_G11F_B10F,
                                    GN_FORMAT_RGB32F};

#define FORMATS (sizeof formats / sizeof *formats)

gn_format random_color_format(builder *b)
{
    return formats[random_below(&b->random, FORMATS)];
}

gn_format random_texel_format(random_source *r, bool is_common)
{
    const uint32_t n = random_below(r, is_common ? 3 : 2 + (uint32_t)FORMATS);

    if (is_common && n == 2)
        return GN_FORMAT_SRGB8_A8;
    return n == 0   ? GN_FORMAT_RGBA8
           : n == 1 ? GN_FORMAT_RGBA32F
                    : formats[(n - 2 + FORMATS - 1) % FORMATS];
}

/* Steps and half steps of channels of 1 to 16 bits, the ends of the range, and magnitudes beyond
 * it, among them those at which halves become denormal and infinite. */
static float format_color(random_source *r)
{
    static const float largest[] = {1.0f, 15.0f, 31.0f, 63.0f, 255.0f, 255.0f, 65535.0f, 65535.0f};
    const float steps = largest[random_below(r, 8)];
    const float step = (float)random_between(r, -1, (int32_t)steps + 1);
    const float sign = random_sign(r);
    switch (random_below(r, 8)) {
    case 0:
        return (step + 0.5f) / steps;
    case 1:
        return step / steps;
    case 2:
        return nextafterf((step + 0.5f) / steps, random_chance(r, 50) ? 2.0f : -2.0f);
    case 3:
        return sign * random_octave(r, 0, 40);
    case 4:
        return sign * random_octave(r, -30, -10);
    case 5:
        return sign * random_octave(r, 14, 17);
    case 6:
        return random_float(r, -1.0f, 2.0f);
    default:
        return random_unit(r);
    }
}

void generate_formats(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    b->scene->color_format = random_color_format(b);
    if (random_chance(r, 30)) { /* blocks reach beyond the target */
        b->scene->width = 1 + random_below(r, 40);
        b->scene->height = 1 + random_below(r, 40);
    }
    for (int i = 0; i < 4; ++i)
        b->scene->clear_color[i] = format_color(r);
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        const bool flat = random_chance(r, 60);
        for (int i = 0; flat && i < 4; ++i)
            b->state.program.interpolation[i] = GN_FLAT;
        const placement p = (placement)random_below(r, PLACE_COUNT);
        shape_triangles(b, p, builder_triangle_count(b));
        const bool gradient = !flat && random_chance(r, 50);
        for (uint32_t i = 0; !gradient && i < b->vertex_count; ++i)
            for (int c = 0; c < 4; ++c)
                b->vertices[i].color[c] = format_color(r);
        builder_draw(b);
    }
}
