/* Colours combined with those of the surface: blending or a logical operation, then
 * write masks (OpenGL 4.5 section 17.4.2). */
#ifndef GN_FRAGMENT_COMBINE_H
#define GN_FRAGMENT_COMBINE_H

#include "blend.h"
#include "color.h"
#include "logic.h"

static inline void set_color_state(color_state *s, const gn_pipeline *pipeline)
{
    s->written = GN_CHANNEL_ALL & ~pipeline->color_write_disabled;
    s->written_bits = 0;
    for (int c = 0; c < 4; ++c) {
        if (s->written >> c & 1u)
            s->written_bits |= (int32_t)(0xFFu << 8 * c);
    }
    set_blend_state(s, &pipeline->blend);
    set_logic_state(s, pipeline->logic_operation);
    s->is_logical = pipeline->color_logic;
    s->blends = pipeline->blend.enabled && !s->is_logical;
    s->use = COLOR_COMBINES;
    if (s->written == GN_CHANNEL_ALL && !s->blends && !s->is_logical)
        s->use = COLOR_REPLACES;
    else if (s->written == GN_CHANNEL_ALL && s->blends && GN_SPECIALISED && is_over(&s->color) &&
             is_over(&s->alpha))
        s->use = COLOR_OVER;
}

/* Pixel by pixel, for blocks that hang over the surface's edge. */
GN_OUT_OF_LINE lanes_i load_covered_pixels(const gn_surface *surface, int32_t x, int32_t y,
                                           uint32_t coverage)
{
    int32_t pixel[GN_LANES];

    GN_EACH_LANE (l) {
        pixel[l] = 0;
        if (coverage >> l & 1u) {
            const void *const row = surface_row(surface, (uint32_t)(y + l / BLOCK_SIZE));
            pixel[l] = ((const stored_word *)row)[x + l % BLOCK_SIZE];
        }
    }
    return lanes_i_load(pixel);
}

GN_INLINE void combine_rgba8(const color_state *state, const gn_surface *surface, color_use use,
                             const fragment_place *at, uint32_t coverage, const lanes_f color[4])
{
    const bool whole = at->shape == SHAPE_ROW || surface_holds_block(surface, at->x, at->y);
    const lanes_i there = whole ? load_words(at->shape, at->color, surface->row_stride)
                                : load_covered_pixels(surface, at->x, at->y, coverage);
    lanes_i pixels = lanes_pack_unorm8(color[0], color[1], color[2], color[3]);

    if (use == COLOR_OVER)
        pixels = blend_over(pixels, there);
    else if (state->blends)
        pixels = blend_pixels(state, pixels, there);
    else if (state->is_logical)
        pixels = operate_on_bits(state, pixels, there);
    if (use != COLOR_OVER)
        pixels = lanes_i_or(lanes_i_and(pixels, lanes_i_splat(state->written_bits)),
                            lanes_i_and(there, lanes_i_splat(~state->written_bits)));
    if (!whole) {
        store_covered_pixels(surface, at->x, at->y, coverage, pixels);
        return;
    }
    if (coverage != GN_ALL_LANES)
        pixels = lanes_i_select(lanes_from_bits(coverage), pixels, there);
    store_words(at->shape, at->color, surface->row_stride, pixels);
}

/* The four channels of pixels of GN_FORMAT_RGBA32F; 0 where not covered. */
static inline void load_rgba32f(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                                lanes_f color[4])
{
    float channel[4][GN_LANES];

    GN_EACH_LANE (l) {
        const bool covered = coverage >> l & 1u;
        const uint32_t row = (uint32_t)(y + (covered ? l / BLOCK_SIZE : 0));
        const float *in = (const float *)(const void *)surface_row(surface, row) +
                          4 * (x + (covered ? l % BLOCK_SIZE : 0));

        for (int c = 0; c < 4; ++c)
            channel[c][l] = covered ? in[c] : 0.0f;
    }
    for (int c = 0; c < 4; ++c)
        color[c] = lanes_load(channel[c]);
}

static inline void combine_rgba32f(const color_state *state, const gn_surface *surface, int32_t x,
                                   int32_t y, uint32_t coverage, const lanes_f color[4])
{
    float channel[4][GN_LANES];
    lanes_f there[4];

    if (state->blends)
        load_rgba32f(surface, x, y, coverage, there);
    for (int c = 0; c < 4; ++c)
        lanes_store(channel[c], state->blends ? blend_float(state, color, there, c) : color[c]);
    GN_EACH_LANE (l) {
        if (coverage >> l & 1u) {
            const uint32_t row = (uint32_t)(y + l / BLOCK_SIZE);
            float *out = (float *)(void *)surface_row(surface, row) + 4 * (x + l % BLOCK_SIZE);

            for (int c = 0; c < 4; ++c) {
                if (state->written >> c & 1u)
                    out[c] = channel[c][l];
            }
        }
    }
}

/* write_color for what does not just replace. */
GN_INLINE void combine_color(const color_state *state, const gn_surface *surface, gn_format format,
                             color_use use, const fragment_place *at, uint32_t coverage,
                             const lanes_f color[4])
{
    if (format == GN_FORMAT_RGBA8)
        combine_rgba8(state, surface, use, at, coverage, color);
    else
        combine_rgba32f(state, surface, at->x, at->y, coverage, color);
}

#endif
