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

/* Whether the shader's decisions or colours change before samples are tested. */
static inline bool is_late_for_samples(const fragment_state *state)
{
    return state->is_late || state->pipeline->program.fragment_writes_sample_mask ||
           alpha_covers(state);
}

/* A batch of a multisampled target: the coverage of each sample, at first and after the steps so
 * far. The blocks' own coverage is that of the sample which takes a step, or of pixels with any
 * sample. */
typedef struct sampled_batch {
    uint32_t covered[GN_SAMPLES][STEP_BLOCKS];
    uint32_t coverage[GN_SAMPLES][STEP_BLOCKS];
    covered_block blocks[STEP_BLOCKS];
    block_batch batch;
} sampled_batch;

static inline uint32_t any_coverage(const sampled_batch *b, uint32_t n)
{
    return b->coverage[0][n] | b->coverage[1][n] | b->coverage[2][n] | b->coverage[3][n];
}

/* Applies the shader's decisions to the covered samples of block n; may change the alpha of its
 * colours. */
static void cover_by_shader(const fragment_state *state, sampled_batch *b, uint32_t n,
                            const shader_verdict *verdict)
{
    const gn_pipeline *p = state->pipeline;
    float(*const color)[4][GN_LANES] = &b->batch.color[n * shader_colors(state)];
    const lanes_f alpha = lanes_load(color[0][3]);

    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        const lanes_f least = lanes_splat((float)(int32_t)s * (1.0f / GN_SAMPLES));

        if (p->program.fragment_discards)
            b->coverage[s][n] &= verdict->kept;
        if (verdict->kept_samples)
            b->coverage[s][n] &= lanes_with_sample(verdict->kept_samples, s);
        if (alpha_covers(state))
            b->coverage[s][n] &= lanes_bits(lanes_not(lanes_less_equal(alpha, least)));
    }
    for (uint32_t a = 0; p->samples.alpha_to_one && a < shader_colors(state); ++a)
        lanes_store(color[a][3], lanes_splat(1.0f));
}

/* Runs the shader for a batch. */
GN_OUT_OF_LINE void shade_samples(const fragment_state *state, sampled_batch *b)
{
    const gn_program *const program = &state->pipeline->program;
    uint32_t covered[GN_LANES], kept[GN_LANES], coverage[GN_SAMPLES];
    shader_verdict verdict;

    for (uint32_t n = 0; n < b->batch.count; ++n) {
        set_verdict(&verdict);
        if (program->fragment_reads_sample_mask) {
            for (uint32_t s = 0; s < GN_SAMPLES; ++s)
                coverage[s] = b->covered[s][n];
            masks_of_lanes(coverage, covered);
            verdict.covered_samples = covered;
        }
        verdict.kept_samples = program->fragment_writes_sample_mask ? kept : 0;
        shader_block(state, &b->batch, n, &verdict);
        cover_by_shader(state, b, n, &verdict);
    }
}

/* Computes the colours of pixels with any sample. */
static inline void source_samples(const fragment_state *state, sampled_batch *b)
{
    for (uint32_t n = 0; n < b->batch.count; ++n)
        b->batch.coverage[n] = any_coverage(b, n);
    if (state->source == SOURCE_SHADER)
        shade_samples(state, b);
    else
        source_batch(state, &b->batch);
}

/* Tests all samples of a batch. */
static inline void test_samples(const fragment_state *state, sampled_batch *b)
{
    for (uint32_t s = 0; state->depth.format != GN_FORMAT_NONE && s < GN_SAMPLES; ++s) {
        for (uint32_t n = 0; n < b->batch.count; ++n)
            b->batch.coverage[n] = b->coverage[s][n];
        test_batch(&state[s], &b->batch);
        for (uint32_t n = 0; n < b->batch.count; ++n)
            b->coverage[s][n] = b->batch.coverage[n];
    }
}

/* Removes blocks of which no sample passed. */
static inline void compact_samples(sampled_batch *b)
{
    uint32_t kept = 0;

    for (uint32_t n = 0; n < b->batch.count; ++n) {
        const bool any = any_coverage(b, n) != 0;

        b->blocks[kept] = b->blocks[n];
        for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
            b->covered[s][kept] = b->covered[s][n];
            b->coverage[s][kept] = b->coverage[s][n];
        }
        kept += any;
    }
    b->batch.count = kept;
}

/* Adds the covered samples of a batch. */
static inline uint64_t count_samples(const sampled_batch *b)
{
    uint64_t count = 0;

    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        for (uint32_t n = 0; n < b->batch.count; ++n)
            count += count_lanes(b->coverage[s][n]);
    return count;
}

/* Takes a batch through the steps in OpenGL's order. Leaves the samples that passed. */
static inline void take_sampled_steps(const fragment_state *state, sampled_batch *b)
{
    const bool late = is_late_for_samples(state);

    if (late)
        source_samples(state, b);
    test_samples(state, b);
}

/* Writes the colours of the samples that passed. */
static inline void output_samples(const fragment_state *state, sampled_batch *b)
{
    if (!is_late_for_samples(state)) {
        compact_samples(b);
        if (b->batch.count)
            source_samples(state, b);
    }
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        for (uint32_t n = 0; n < b->batch.count; ++n)
            b->batch.coverage[n] = b->coverage[s][n];
        output_colors(&state[s], &b->batch);
    }
}

/* Shades squares: a samples_function. The context is a fragment_context. */
static void shade_sampled_squares(const void *context, const sampled_square *squares,
                                  uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;
    const fragment_state *const state = c->state;
    const uint32_t disabled = state->pipeline->samples.write_disabled;
    sampled_batch b;

    b.batch.shape = SHAPE_HALVES;
    b.batch.blocks = b.blocks;
    while (count > 0) {
        uint32_t together = 0;

        do {
            b.blocks[together].triangle = squares->triangle;
            b.blocks[together].at = square_block(squares->x, squares->y);
            for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
                c->counts->covered += count_lanes(squares->coverage[s]);
                b.covered[s][together] = disabled >> s & 1u ? 0 : squares->coverage[s];
                b.coverage[s][together] = b.covered[s][together];
            }
            ++together;
            ++squares;
            --count;
        } while (count > 0 && together < most_together(state) &&
                 (!state->combines || squares->triangle.planes == squares[-1].triangle.planes));
        b.batch.count = together;
        take_sampled_steps(state, &b);
        c->counts->passed += count_samples(&b);
        if (has_colors(state))
            output_samples(state, &b);
    }
}

#endif
