/* Fragments of multisampled targets, 16 at a time: the shader runs once a pixel; depth, tests and
 * colours once a sample (OpenGL 4.5 section 14.3.1). Each sample is a surface of its own. */
#ifndef GN_FRAGMENT_SAMPLES_H
#define GN_FRAGMENT_SAMPLES_H

#include "../raster/cover_samples.h"
#include "steps.h"

/* States of a draw: one for each sample. */
#define SAMPLE_STATES (GN_HAVE_SAMPLES ? GN_SAMPLES : 1)

/* Returns a sample's place in a pixel, in pixels from the pixel's corner. */
static inline float sample_place(uint32_t sample, int axis)
{
    return (float)(128 + sample_offset(sample, axis)) * (1.0f / 256.0f);
}

/* Turns a state into that of a sample. The shader runs at pixels' centres. */
static inline void view_sample(fragment_state *s, uint32_t sample)
{
    for (int axis = 0; axis < 2; ++axis) {
        s->test_at[axis] = sample_place(sample, axis);
        s->shade_at[axis] = 0.5f;
    }
    s->source = SOURCE_SHADER;

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

static inline uint32_t covered_pixels(const uint32_t coverage[GN_SAMPLES])
{
    return coverage[0] | coverage[1] | coverage[2] | coverage[3];
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

/* Whether alpha decides on coverage. */
static inline bool alpha_covers(const fragment_state *state)
{
    return state->pipeline->samples.alpha_to_coverage && state->color.format != GN_FORMAT_NONE;
}

/* Applies the shader's decisions to the covered samples; may change the alpha of its colours. */
static void cover_by_shader(const fragment_state *state, uint32_t kept,
                            const uint32_t *kept_samples, float (*color)[4][GN_LANES],
                            uint32_t coverage[GN_SAMPLES])
{
    const gn_pipeline *p = state->pipeline;
    const lanes_f alpha = lanes_load(color[0][3]);

    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        const lanes_f least = lanes_splat((float)(int32_t)s * (1.0f / GN_SAMPLES));

        if (p->program.fragment_discards)
            coverage[s] &= kept;
        if (kept_samples)
            coverage[s] &= lanes_with_sample(kept_samples, s);
        if (alpha_covers(state))
            coverage[s] &= lanes_bits(lanes_not(lanes_less_equal(alpha, least)));
    }
    for (uint32_t a = 0; p->samples.alpha_to_one && a < shader_colors(state); ++a)
        lanes_store(color[a][3], lanes_splat(1.0f));
}

/* Tests all samples of a block. */
static void test_samples(const fragment_state *state, block_batch *b,
                         uint32_t coverage[GN_SAMPLES])
{
    for (uint32_t s = 0; state->depth.format != GN_FORMAT_NONE && s < GN_SAMPLES; ++s) {
        b->coverage[0] = coverage[s];
        if (coverage[s])
            test_batch(&state[s], b);
        coverage[s] = b->coverage[0];
    }
}

/* Shades a block in OpenGL's order. Changes `coverage` to the samples that passed. */
static void shade_samples(const fragment_state *state, block_batch *b,
                          uint32_t coverage[GN_SAMPLES])
{
    const gn_program *const program = &state->pipeline->program;
    const bool late =
        state->is_late || program->fragment_writes_sample_mask || alpha_covers(state);
    uint32_t covered[GN_LANES], kept[GN_LANES];
    shader_verdict verdict;

    if (program->fragment_reads_sample_mask)
        masks_of_lanes(coverage, covered);
    if (!late)
        test_samples(state, b, coverage);
    if (!covered_pixels(coverage) || (!late && !has_colors(state)))
        return;
    set_verdict(&verdict);
    verdict.covered_samples = program->fragment_reads_sample_mask ? covered : 0;
    verdict.kept_samples = program->fragment_writes_sample_mask ? kept : 0;
    b->coverage[0] = covered_pixels(coverage);
    shader_block(state, b, 0, &verdict);
    cover_by_shader(state, verdict.kept, verdict.kept_samples, b->color, coverage);
    if (late)
        test_samples(state, b, coverage);
    for (uint32_t s = 0; has_colors(state) && s < GN_SAMPLES; ++s) {
        b->coverage[0] = coverage[s];
        if (coverage[s])
            output_colors(&state[s], b);
    }
}

/* Shades a square: a samples_function. The context is a fragment_context. */
static void shade_sampled_square(const void *context, raster_triangle triangle, int32_t x,
                                 int32_t y, const uint32_t coverage[GN_SAMPLES])
{
    const fragment_context *const counted = (const fragment_context *)context;
    const covered_block block = {triangle, square_block(x, y), {0, 0}};
    uint32_t passed[GN_SAMPLES];
    block_batch b;

    b.shape = SHAPE_HALVES;
    b.count = 1;
    b.blocks = &block;
    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        passed[s] = counted->state->pipeline->samples.write_disabled >> s & 1u ? 0 : coverage[s];
    shade_samples(counted->state, &b, passed);
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        counted->counts->covered += count_lanes(coverage[s]);
        counted->counts->passed += count_lanes(passed[s]);
    }
}

#endif
