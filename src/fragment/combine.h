/* Combines colours with those of the surface: blending or a logical operation, then write masks
 * (OpenGL 4.5 section 17.4.2). */
#ifndef GN_FRAGMENT_COMBINE_H
#define GN_FRAGMENT_COMBINE_H

#include "blend.h"
#include "color.h"
#include "logic.h"
#include "pixels.h"

GN_OUT_OF_LINE void set_color_state(color_state *s, const gn_pipeline *pipeline,
                                    uint32_t attachment, gn_format format)
{
    const gn_blend *blend = &pipeline->color.blend[attachment];

    s->written = GN_CHANNEL_ALL & ~pipeline->color.write_disabled[attachment];
    s->written_bits[0] = 0;
    s->written_bits[1] = 0;
    for (int c = 0; c < 4; ++c)
        if (s->written >> c & 1u)
            add_channel_bits(format, c, s->written_bits);
    set_blend_state(s, blend, pipeline->color.blend_constant, format);
    set_logic_state(s, pipeline->color.logic_operation);
    s->is_logical = pipeline->color.logic;
    s->blends = blend->enabled && !s->is_logical;
    s->use = COLOR_COMBINES;
    if (s->written == GN_CHANNEL_ALL && !s->blends && !s->is_logical)
        s->use = COLOR_REPLACES;
    else if (s->written == GN_CHANNEL_ALL && s->blends && GN_SPECIALISED && is_over(&s->color) &&
             is_over(&s->alpha))
        s->use = COLOR_OVER;
}

/* Loads pixel by pixel, for squares that hang over the surface's edge. */
GN_OUT_OF_LINE lanes_i load_covered_pixels(const gn_surface *surface, int32_t x, int32_t y,
                                           uint32_t coverage)
{
    int32_t pixel[GN_LANES];

    GN_EACH_LANE (l) {
        pixel[l] = 0;
        if (coverage >> l & 1u) {
            const void *const row = surface_row(surface, (uint32_t)(y + l / SQUARE_SIZE));
            pixel[l] = ((const stored_word *)row)[x + l % SQUARE_SIZE];
        }
    }
    return lanes_i_load(pixel);
}

GN_INLINE void combine_rgba8(const color_state *state, const gn_surface *surface, color_use use,
                             const fragment_place *at, uint32_t coverage, const lanes_f color[4])
{
    const bool whole = at->shape != SHAPE_SQUARE || surface_holds_square(surface, at->x, at->y);
    const lanes_i there = whole ? load_words(at->shape, &at->color, surface->row_stride)
                                : load_covered_pixels(surface, at->x, at->y, coverage);
    lanes_i pixels = lanes_pack_unorm8(color[0], color[1], color[2], color[3]);

    if (use == COLOR_OVER)
        pixels = blend_over(pixels, there);
    else if (state->blends)
        pixels = blend_pixels(state, pixels, there);
    else if (state->is_logical)
        pixels = operate_on_bits(state, pixels, there);
    if (use != COLOR_OVER)
        pixels = lanes_i_or(lanes_i_and(pixels, lanes_i_splat(state->written_bits[0])),
                            lanes_i_and(there, lanes_i_splat(~state->written_bits[0])));
    if (!whole) {
        store_covered_pixels(surface, at->x, at->y, coverage, pixels);
        return;
    }
    if (coverage != GN_ALL_LANES)
        pixels = lanes_i_select(lanes_from_bits(coverage), pixels, there);
    store_words(at->shape, &at->color, surface->row_stride, pixels);
}

/* Loads the four channels of GN_FORMAT_RGBA32F pixels; 0 where not covered. */
static inline void load_rgba32f(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                                lanes_f color[4])
{
    int32_t channel[4][GN_LANES];

    GN_EACH_LANE (l) {
        const bool covered = coverage >> l & 1u;
        const void *const row =
            surface_row(surface, (uint32_t)(y + (covered ? l / SQUARE_SIZE : 0)));
        const stored_word *const in =
            (const stored_word *)row + 4 * (x + (covered ? l % SQUARE_SIZE : 0));

        for (int c = 0; c < 4; ++c)
            channel[c][l] = covered ? in[c] : 0;
    }
    for (int c = 0; c < 4; ++c)
        color[c] = lanes_as_float(lanes_i_load(channel[c]));
}

static inline void combine_rgba32f(const color_state *state, const gn_surface *surface, int32_t x,
                                   int32_t y, uint32_t coverage, const lanes_f color[4])
{
    lanes_f there[4], result[4];

    if (!state->blends) {
        write_rgba32f(surface, x, y, coverage, state->written, color);
        return;
    }
    load_rgba32f(surface, x, y, coverage, there);
    for (int c = 0; c < 4; ++c)
        result[c] = blend_float(state, color, there, c);
    write_rgba32f(surface, x, y, coverage, state->written, result);
}

/* Blends as floats. If the format has a largest value, both colours lie within 0 to 1. */
static inline void combine_floats(const color_state *state, gn_format format,
                                  const lanes_f color[4], const lanes_i there[2], lanes_i word[2])
{
    lanes_f source[4], destination[4], result[4];

    decode_floats(format, there, destination);
    for (int c = 0; c < 4; ++c)
        source[c] = format_is_float(format) ? color[c] : saturated(color[c]);
    for (int c = 0; c < 4; ++c)
        result[c] = blend_float(state, source, destination, c);
    encode_colors(format, result, word);
}

/* Combines and writes pixels of formats of up to two words, in the format's arithmetic. */
static inline void combine_encoded(const color_state *state, const gn_surface *surface,
                                   gn_format format, int32_t x, int32_t y, uint32_t coverage,
                                   const lanes_f color[4])
{
    const pixel_layout layout = format_layout(format);
    const color_arithmetic arithmetic = arithmetic_of(format);
    lanes_i there[2], word[2];

    load_pixels(surface, x, y, coverage, layout, there);
    encode_colors(format, color, word);
    if (arithmetic == ARITHMETIC_BYTES && (state->blends || state->is_logical)) {
        const lanes_i source = encode_rgba8(color);
        const lanes_i destination = to_rgba8(format, there[0]);

        word[0] = from_rgba8(format, state->blends ? blend_pixels(state, source, destination)
                                                   : operate_on_bits(state, source, destination));
    } else if (arithmetic == ARITHMETIC_SHORTS && (state->blends || state->is_logical)) {
        lanes_i source[2], destination[2] = {there[0], there[1]};

        encode_shorts(color, source);
        to_rgba16(format, destination);
        if (state->blends)
            blend_shorts(state, source, destination, word);
        for (int i = 0; !state->blends && i < 2; ++i)
            word[i] = operate_on_bits(state, source[i], destination[i]);
        from_rgba16(format, word);
    } else if (arithmetic == ARITHMETIC_FLOATS && state->blends) {
        combine_floats(state, format, color, there, word);
    }
    for (int i = 0; i < 2; ++i)
        word[i] = lanes_i_or(lanes_i_and(word[i], lanes_i_splat(state->written_bits[i])),
                             lanes_i_and(there[i], lanes_i_splat(~state->written_bits[i])));
    store_pixels(surface, x, y, coverage, layout, word);
}

/* Writes a colour that does not simply replace the surface's. */
GN_INLINE void combine_color(const color_state *state, const gn_surface *surface, gn_format format,
                             color_use use, const fragment_place *at, uint32_t coverage,
                             const lanes_f color[4])
{
    if (format == GN_FORMAT_RGBA8)
        combine_rgba8(state, surface, use, at, coverage, color);
    else
        combine_rgba32f(state, surface, at->x, at->y, coverage, color);
}

/* Writes a colour to a surface of any format, as its state says. */
static inline void put_color(const color_state *state, const gn_surface *surface,
                             const fragment_place *at, uint32_t coverage, const lanes_f color[4])
{
    const bool replaces = !GN_HAVE_COMBINING || state->use == COLOR_REPLACES;

    if (GN_HAVE_FORMATS && format_is_encoded(surface->format))
        if (replaces)
            write_encoded(surface, surface->format, at->x, at->y, coverage, color);
        else
            combine_encoded(state, surface, surface->format, at->x, at->y, coverage, color);
    else if (replaces)
        write_color(surface, surface->format, at, coverage, color);
    else
        combine_color(state, surface, surface->format, state->use, at, coverage, color);
}

/* Writes a shader's colours to all attachments; each colour is four rows of lanes. */
GN_STEP void put_colors(const fragment_state *state, const fragment_place *at, uint32_t coverage,
                        const float (*shaded)[GN_LANES])
{
    fragment_place place = *at;
    lanes_f color[4];

    for (uint32_t a = 0; a <= (GN_HAVE_ATTACHMENTS ? state->more_count : 0); ++a) {
        const gn_surface *surface = a > 0 ? &state->more[a - 1].surface : &state->color;

        if (surface->format == GN_FORMAT_NONE)
            continue;
        if (a > 0)
            place.color = square_memory(surface, surface->format, at->x, at->y);
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_load(shaded[4 * a + (uint32_t)c]);
        put_color(a > 0 ? &state->more[a - 1].combine : &state->combine, surface, &place, coverage,
                  color);
    }
}

#endif
