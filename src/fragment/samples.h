/* Fragments of multisampled targets, 16 at a time: the shader runs once a pixel; depth, tests and
 * colours once a sample (OpenGL 4.5 section 14.3.1). Each sample is a surface of its own. */
#ifndef GN_FRAGMENT_SAMPLES_H
#define GN_FRAGMENT_SAMPLES_H

#include "../raster/cover_samples.h"
#include "group.h"

/* States of a draw: one for each sample. */
#define SAMPLE_STATES (GN_HAVE_SAMPLES ? GN_SAMPLES : 1)

/* Turns a state of sample 0 into that of another sample. */
static inline void view_sample(fragment_state *s, uint32_t sample)
{
    if (s->color.format != GN_FORMAT_NONE)
        s->color.pixels = sample_memory(&s->color, sample);
    if (s->depth.format != GN_FORMAT_NONE)
        s->depth.pixels = sample_memory(&s->depth, sample);
    for (uint32_t a = 0; GN_HAVE_ATTACHMENTS && a < s->more_count; ++a) {
        gn_surface *const surface = &s->more[a].surface;

        if (surface->format != GN_FORMAT_NONE)
            surface->pixels = sample_memory(surface, sample);
    }
}

/* Returns a sample's place in a pixel, in pixels from the pixel's corner. */
static inline float sample_place(uint32_t sample, int axis)
{
    return (float)(128 + sample_offset(sample, axis)) * (1.0f / 256.0f);
}

static inline uint32_t covered_pixels(const uint32_t coverage[GN_SAMPLES])
{
    return coverage[0] | coverage[1] | coverage[2] | coverage[3];
}

/* Tests stencil and depth of all samples. `written` is the shader's depth, which the samples share,
 * or null. */
static void test_samples(const fragment_state *state, const fragment_place *at,
                         raster_triangle triangle, const float *written,
                         uint32_t coverage[GN_SAMPLES])
{
    const fragment_kind kind = any_kind(state);
    const attribute_plane plane = triangle_plane(triangle, DEPTH_PLANE);

    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        lanes_f depth = plane_in_block(plane, (float)at->block.x[0] + sample_place(s, 0),
                                       (float)at->block.y[0] + sample_place(s, 1));

        if (!coverage[s])
            continue;
        if (written)
            depth = lanes_load(written);
        else if (state->moves_depth)
            depth = lanes_add(depth, lanes_splat(triangle_offset(triangle)));
        coverage[s] = test_group(&state[s], kind, at, triangle, coverage[s], depth);
    }
}

/* Turns masks of pixels for each sample into masks of samples for each lane. */
static inline void masks_of_lanes(const uint32_t coverage[GN_SAMPLES], uint32_t mask[GN_LANES])
{
    lanes_i all = lanes_i_splat(0);

    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        all = lanes_i_or(all, lanes_i_and(lanes_m_as_int(lanes_from_bits(coverage[s])),
                                          lanes_i_splat((int32_t)(1u << s))));
    lanes_i_store((stored_word *)(void *)mask, all);
}

/* Returns the lanes whose mask has the sample. */
static inline uint32_t lanes_with_sample(const uint32_t mask[GN_LANES], uint32_t sample)
{
    const lanes_i masks = lanes_i_load((const stored_word *)(const void *)mask);

    return lanes_i_sign_bits(lanes_i_shift_left(masks, 31 - (int)sample));
}

/* Applies the shader's decisions to the covered samples; may change the alpha of its colours. */
static void cover_by_shader(const fragment_state *state, const shader_verdict *verdict,
                            bool to_coverage, float (*color)[GN_LANES],
                            uint32_t coverage[GN_SAMPLES])
{
    const gn_pipeline *p = state->pipeline;
    const lanes_f alpha = lanes_load(color[3]);

    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        const lanes_f least = lanes_splat((float)(int32_t)s * (1.0f / GN_SAMPLES));

        if (p->program.fragment_discards)
            coverage[s] &= verdict->kept;
        if (verdict->kept_samples)
            coverage[s] &= lanes_with_sample(verdict->kept_samples, s);
        if (to_coverage)
            coverage[s] &= lanes_bits(lanes_not(lanes_less_equal(alpha, least)));
    }
    for (uint32_t a = 0;
         p->samples.alpha_to_one && a <= (GN_HAVE_ATTACHMENTS ? state->more_count : 0); ++a)
        lanes_store(color[4 * a + 3], lanes_splat(1.0f));
}

/* Shades a square in OpenGL's order, as shade_whole does. Changes `coverage` to the samples that
 * passed. */
static void shade_samples(const fragment_state *state, const fragment_place *at,
                          raster_triangle triangle, uint32_t coverage[GN_SAMPLES])
{
    const fragment_kind kind = any_kind(state);
    const gn_pipeline *p = state->pipeline;
    const bool to_coverage = p->samples.alpha_to_coverage && state->color.format != GN_FORMAT_NONE;
    const bool late = p->program.fragment_discards || p->program.fragment_writes_depth ||
                      p->program.fragment_writes_sample_mask || to_coverage;
    block_places middle; /* the pixels' centres */
    float written[GN_LANES];
    float color[4 * COLOR_LIMIT][GN_LANES];
    uint32_t covered[GN_LANES], kept[GN_LANES];
    shader_verdict verdict;

    set_places_in_block(&middle, (float)at->block.x[0] + 0.5f, (float)at->block.y[0] + 0.5f);
    set_verdict(&verdict);
    if (p->program.fragment_reads_sample_mask) {
        masks_of_lanes(coverage, covered);
        verdict.covered_samples = covered;
    }
    verdict.kept_samples = p->program.fragment_writes_sample_mask ? kept : 0;
    if (p->program.fragment_writes_depth) {
        lanes_store(written, plane_at(triangle_plane(triangle, DEPTH_PLANE), &middle));
        verdict.depth = written;
    }
    if (!late)
        test_samples(state, at, triangle, 0, coverage);
    if (!covered_pixels(coverage) || (!late && !has_colors(state)))
        return;

    const lanes_f w =
        lanes_div(lanes_splat(1.0f), plane_at(triangle_plane(triangle, ONE_OVER_W_PLANE), &middle));
    call_fragment_shader(state, triangle, &at->block, &middle, covered_pixels(coverage), w, color,
                         &verdict);
    cover_by_shader(state, &verdict, to_coverage, color, coverage);
    if (late)
        test_samples(state, at, triangle, verdict.depth, coverage);
    for (uint32_t s = 0; has_colors(state) && s < GN_SAMPLES; ++s) {
        if (coverage[s])
            write_colors(&state[s], kind, at, coverage[s], (const float(*)[GN_LANES])color);
    }
}

/* Shades a square: a samples_function. The context is a fragment_context. */
static void shade_sampled_square(const void *context, raster_triangle triangle, int32_t x,
                                 int32_t y, const uint32_t coverage[GN_SAMPLES])
{
    const fragment_context *const counted = (const fragment_context *)context;
    uint32_t passed[GN_SAMPLES];
    fragment_place at;

    const pixel_block block = square_block(x, y);
    set_block(&at, &block, surfaces_hold_block(counted->state, &block));
    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        passed[s] = counted->state->pipeline->samples.write_disabled >> s & 1u ? 0 : coverage[s];
    shade_samples(counted->state, &at, triangle, passed);
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        counted->counts->covered += count_lanes(coverage[s]);
        counted->counts->passed += count_lanes(passed[s]);
    }
}

#endif
