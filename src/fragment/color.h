/* Writes colours in a surface's format: they replace the surface's colours, or are combined with
 * them by blending or a logical operation, then by write masks (OpenGL 4.5 section 17.4.2). */
#ifndef GN_FRAGMENT_COLOR_H
#define GN_FRAGMENT_COLOR_H

#include "../formats/decode.h"
#include "blend.h"
#include "logic.h"
#include "pixels.h"

GN_OUT_OF_LINE void set_color_state(color_state *s, const gn_pipeline *pipeline,
                                    uint32_t attachment, gn_format format)
{
    const gn_blend *blend = &pipeline->color.blend[attachment];

    s->written = GN_CHANNEL_ALL & ~pipeline->color.write_disabled[attachment];
    for (int i = 0; i < 4; ++i)
        s->written_bits[i] = 0;
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
             is_over(&s->alpha) && s->mixes == MIXES_NOTHING)
        s->use = COLOR_OVER;
}

/* Combines bytes, the arithmetic of most formats. */
GN_INLINE void combine_bytes(const color_state *state, gn_format format, color_use use,
                             const lanes_f color[4], const lanes_i there[4], lanes_i word[4])
{
    const lanes_i source = encode_rgba8(color);
    const lanes_i destination = to_rgba8(format, there[0]);
    lanes_i result;

    if (use == COLOR_OVER)
        result = blend_over(source, destination);
    else if (state->blends)
        result = blend_pixels(state, source, destination);
    else
        result = operate_on_bits(state, source, destination);
    word[0] = from_rgba8(format, result);
}

GN_INLINE void combine_shorts(const color_state *state, gn_format format, const lanes_f color[4],
                              const lanes_i there[4], lanes_i word[4])
{
    lanes_i source[2], destination[2] = {there[0], there[1]};

    encode_shorts(color, source);
    to_rgba16(format, destination);
    if (state->blends)
        blend_shorts(state, source, destination, word);
    for (int i = 0; !state->blends && i < 2; ++i)
        word[i] = operate_on_bits(state, source[i], destination[i]);
    from_rgba16(format, word);
}

/* Blends floats. If the format has a largest value, both colours lie within 0 to 1. */
GN_INLINE void blend_floats(const color_state *state, gn_format format, const lanes_f color[4],
                            const lanes_i there[4], lanes_i word[4])
{
    lanes_f source[4], destination[4], result[4];

    decode_floats(format, there, destination);
    for (int c = 0; c < 4; ++c)
        source[c] = format_is_float(format) ? color[c] : saturated(color[c]);
    for (int c = 0; c < 4; ++c)
        result[c] = blend_float(state, source, destination, c);
    encode_colors(format, result, word);
}

/* Combines colours with the words of a group's pixels, in the format's arithmetic. Logical
 * operations leave floats as they are. */
GN_INLINE void combine_colors(const color_state *state, gn_format format, color_use use,
                              const lanes_f color[4], const lanes_i there[4], lanes_i word[4])
{
    const color_arithmetic arithmetic = arithmetic_of(format);
    const bool combines = use == COLOR_OVER || state->blends || state->is_logical;

    if (combines && arithmetic == ARITHMETIC_BYTES)
        combine_bytes(state, format, use, color, there, word);
    else if (combines && arithmetic == ARITHMETIC_SHORTS)
        combine_shorts(state, format, color, there, word);
    else if (use == COLOR_OVER || state->blends)
        blend_floats(state, format, color, there, word);
    else
        encode_colors(format, color, word);
    if (use == COLOR_COMBINES)
        for (int i = 0; i < layout_words(format_layout(format)); ++i)
            word[i] = lanes_i_or(lanes_i_and(word[i], lanes_i_splat(state->written_bits[i])),
                                 lanes_i_and(there[i], lanes_i_splat(~state->written_bits[i])));
}

/* Writes red, green, blue and alpha to the covered pixels of a surface, as its state says. */
GN_INLINE void write_color(const color_state *state, const gn_surface *surface, gn_format format,
                           color_use use, const fragment_place *at, uint32_t coverage,
                           const lanes_f color[4])
{
    const pixel_layout layout = format_layout(format);
    const group_memory memory = memory_of(at, surface, format);
    const bool selects = memory.whole && (at->shape != SHAPE_ROW || coverage != GN_ALL_LANES);
    lanes_i there[4], word[4];

    if (use != COLOR_REPLACES || selects)
        load_pixels(layout, &memory, coverage, there);
    if (use == COLOR_REPLACES)
        encode_colors(format, color, word);
    else
        combine_colors(state, format, use, color, there, word);
    for (int i = 0; selects && i < layout_words(layout); ++i)
        word[i] = lanes_i_select(lanes_from_bits(coverage), word[i], there[i]);
    store_pixels(layout, &memory, coverage, word);
}

#endif
