/* Fragments of multisampled targets, 16 at a time: the shader runs once a pixel, or once a sample
 * if the state says so; depth, tests and colours once a sample (OpenGL 4.5 section 14.3.1). Each
 * sample is a surface of its own. */
#ifndef GN_KERNEL_FRAGMENT_SAMPLES_INL
#define GN_KERNEL_FRAGMENT_SAMPLES_INL

#include "steps.inl"

/* States of a draw: one for each sample. */
#define SAMPLE_STATES (DRAWS_SAMPLES ? GN_SAMPLES : 1)

/* Turns a state into that of a sample. Varyings are at pixels' centres, unless all samples are
 * shaded. */
static inline void view_sample(fragment_state *s, uint32_t sample)
{
    const bool all = shades_all_samples(s->pipeline);

    s->sample = s->runs_per_sample ? sample : 0;
    for (int axis = 0; axis < 2; ++axis) {
        s->test_at[axis] = sample_place(sample, axis);
        s->shade_at[axis] = all ? s->test_at[axis] : 0.5f;
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

/* The samples that a call of the shader is for: all samples of its pixels, or one. */
typedef struct sample_range {
    uint32_t first, end;
} sample_range;

static inline sample_range samples_of_call(const fragment_state *state)
{
    const sample_range all = {0, GN_SAMPLES}, one = {state->sample, state->sample + 1};

    return state->runs_per_sample ? one : all;
}

/* Turns masks of pixels for each sample into masks of samples for each lane. */
static inline void masks_of_lanes(const uint32_t coverage[GN_SAMPLES], sample_range samples,
                                  uint32_t mask[GN_LANES])
{
    lanes_i all = lanes_i_splat(0);

    for (uint32_t s = samples.first; s < samples.end; ++s)
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

/* Whether the shader runs before samples are tested. */
static inline bool is_late_for_samples(const fragment_state *state)
{
    return state->is_late || state->covers_late;
}

/* A batch of a multisampled target. `covered` is the coverage of each sample at first, `coverage`
 * what the steps so far have left of it. `present` is what decides on centroids, set if the state
 * is_located. The coverage in `batch` is that of the sample that takes a step, or of pixels
 * with any sample. */
typedef struct sampled_batch {
    uint32_t covered[GN_SAMPLES][STEP_BLOCKS];
    uint32_t coverage[GN_SAMPLES][STEP_BLOCKS];
    uint32_t present[GN_SAMPLES][STEP_BLOCKS];
    covered_block blocks[STEP_BLOCKS];
    fragment_batch batch;
} sampled_batch;

static inline uint32_t any_coverage(const sampled_batch *b, uint32_t n)
{
    return b->coverage[0][n] | b->coverage[1][n] | b->coverage[2][n] | b->coverage[3][n];
}

/* Applies the shader's decisions and alpha to coverage to the covered samples of a block, then
 * alpha to one to its colours. */
static void cover_by_shader(const fragment_state *state, const shader_verdict *verdict,
                            float (*color)[4][GN_LANES], uint32_t coverage[GN_SAMPLES])
{
    const gn_pipeline *p = state->pipeline;
    const sample_range samples = samples_of_call(state);
    const lanes_f alpha = lanes_load(color[0][3]);

    for (uint32_t s = samples.first; s < samples.end; ++s) {
        const lanes_f least = lanes_splat((float)(int32_t)s * (1.0f / GN_SAMPLES));

        if (p->program.fragment_discards)
            coverage[s] &= verdict->kept;
        if (verdict->kept_samples)
            coverage[s] &= lanes_with_sample(verdict->kept_samples, s);
        if (p->samples.alpha_to_coverage_enabled)
            coverage[s] &= lanes_bits(lanes_not(lanes_less_equal(alpha, least)));
    }
    for (uint32_t a = 0; p->samples.alpha_to_one_enabled && a < shader_colors(state); ++a)
        lanes_store(color[a][3], lanes_splat(1.0f));
}

/* Masks of samples, by lanes, that a shader reads and writes. */
typedef struct shader_masks {
    uint32_t covered[GN_LANES], kept[GN_LANES];
} shader_masks;

/* Sets the masks that the shader reads, and where it writes them. */
static inline void set_masks(const fragment_state *state, const uint32_t covered[GN_SAMPLES],
                             shader_masks *masks, shader_verdict *verdict)
{
    const gn_program *const program = &state->pipeline->program;

    if (program->fragment_reads_sample_mask) {
        masks_of_lanes(covered, samples_of_call(state), masks->covered);
        verdict->covered_samples = masks->covered;
    }
    verdict->kept_samples = program->fragment_writes_sample_mask ? masks->kept : 0;
}

/* Whether samples that the shader discards decide on the centroids of the samples that follow. */
static inline bool discards_centroids(const fragment_state *state)
{
    return state->runs_per_sample && state->is_located &&
           state->pipeline->program.fragment_discards;
}

/* Sets to 0 the colours of a block in which nothing is shaded, but which takes the other steps with
 * the rest of its batch. */
static inline void clear_colors(float (*color)[4][GN_LANES], uint32_t count)
{
    for (uint32_t a = 0; a < count; ++a)
        for (int c = 0; c < 4; ++c)
            lanes_store(color[a][c], lanes_splat(0.0f));
}

/* Runs the shader for a batch of halves. */
GN_OUT_OF_LINE void shade_samples(const fragment_state *state, sampled_batch *b)
{
    const uint32_t colors = shader_colors(state);
    uint32_t coverage[GN_SAMPLES], present[GN_SAMPLES];
    shader_masks masks;
    shader_verdict verdict;

    for (uint32_t n = 0; n < b->batch.count; ++n) {
        if (state->runs_per_sample && !b->batch.coverage[n]) {
            clear_colors(&b->batch.color[n * colors], colors);
            if (state->pipeline->program.fragment_writes_depth)
                lanes_store(b->batch.shared.terms.depth[n], lanes_splat(0.0f));
            continue;
        }
        set_verdict(&verdict);
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            coverage[s] = b->covered[s][n];
        set_masks(state, coverage, &masks, &verdict);
        for (uint32_t s = 0; state->is_located && s < GN_SAMPLES; ++s)
            present[s] = b->present[s][n];
        verdict.present = present;
        call_for_block(state, &b->batch, n, &verdict);
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            coverage[s] = b->coverage[s][n];
        cover_by_shader(state, &verdict, &b->batch.color[n * colors], coverage);
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            b->coverage[s][n] = coverage[s];
        if (discards_centroids(state))
            b->present[state->sample][n] &= verdict.kept;
    }
}

/* Runs the shader for a batch of rows. */
GN_OUT_OF_LINE void shade_sample_rows(const fragment_state *state, sampled_batch *b)
{
    fragment_batch *const rows = &b->batch;
    GN_ALIGNED_LANES float depth[STEP_BLOCKS][GN_LANES];
    uint32_t coverage[GN_SAMPLES], present[GN_SAMPLES];
    shader_masks masks;
    shader_verdict verdict;
    shader_call call;

    start_square_calls(state, rows, &call);
    set_verdict(&verdict);
    verdict.present = present;
    for (uint32_t n = 0; n < square_count(rows); ++n) {
        const uint32_t any = covered_in_square(rows, rows->coverage, n);

        rows->shaded[n] = (uint16_t)any;
        if (!any)
            continue;
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            coverage[s] = covered_in_square(rows, b->covered[s], n);
        set_masks(state, coverage, &masks, &verdict);
        for (uint32_t s = 0; state->is_located && s < GN_SAMPLES; ++s)
            present[s] = covered_in_square(rows, b->present[s], n);
        call_for_square(state, rows, n, any, depth[n], &verdict, &call);
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            coverage[s] = GN_ALL_LANES;
        cover_by_shader(state, &verdict, &rows->color[n * shader_colors(state)], coverage);
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            discard_in_square(rows, b->coverage[s], n, coverage[s]);
        if (discards_centroids(state))
            discard_in_square(rows, b->present[state->sample], n, verdict.kept);
    }
    if (state->pipeline->program.fragment_writes_depth)
        store_depths((const float(*)[GN_LANES])depth, rows);
}

/* Computes the colours of pixels with any sample or, if the shader runs per sample, the state's. */
static inline void source_samples(const fragment_state *state, sampled_batch *b)
{
    for (uint32_t n = 0; n < b->batch.count; ++n)
        b->batch.coverage[n] =
            state->runs_per_sample ? b->coverage[state->sample][n] : any_coverage(b, n);
    if (state->source != SOURCE_SHADER)
        source_batch(state, &b->batch);
    else if (is_of_rows(&b->batch))
        shade_sample_rows(state, b);
    else
        shade_samples(state, b);
}

/* Tests the state's sample of a batch. `test` is the state's, or one that does not write.
 * `coverage` becomes what passed. */
GN_OUT_OF_LINE void test_sample(const fragment_state *state, const comparison *test,
                                uint32_t coverage[STEP_BLOCKS], sampled_batch *b)
{
    for (uint32_t n = 0; n < b->batch.count; ++n)
        b->batch.coverage[n] = coverage[n];
    if (is_of_rows(&b->batch))
        set_terms(&b->batch, DEPTH_PLANE, ONE_OVER_W_PLANE, state->test_at);
    test_batch(state, test, &b->batch);
    for (uint32_t n = 0; n < b->batch.count; ++n)
        coverage[n] = b->batch.coverage[n];
}

/* Tests the samples of a batch from `first` up to, but not including, `end`. */
GN_OUT_OF_LINE void test_samples(const fragment_state *state, uint32_t first, uint32_t end,
                                 sampled_batch *b)
{
    for (uint32_t s = first; state->depth.format != GN_FORMAT_NONE && s < end; ++s)
        test_sample(&state[s], &state[s].test, b->coverage[s], b);
}

/* Finds the samples that decide on centroids: those that passed the tests, even if the shader comes
 * first. Nothing is written meanwhile. */
GN_OUT_OF_LINE void find_present_samples(const fragment_state *state, sampled_batch *b)
{
    const bool previews = state->previews_tests && is_late_for_samples(state);

    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        comparison test = state[s].test;

        test.write = false;
        for (uint32_t n = 0; n < b->batch.count; ++n)
            b->present[s][n] = b->coverage[s][n];
        if (previews)
            test_sample(&state[s], &test, b->present[s], b);
    }
}

/* Removes blocks of which no sample passed, as compact_batch does. */
static inline void compact_samples(const fragment_state *state, sampled_batch *b)
{
    const bool are_rows = is_of_rows(&b->batch);
    uint32_t kept = 0;

    for (uint32_t n = 0; n < b->batch.count; ++n)
        kept += any_coverage(b, n) != 0;
    if (kept == b->batch.count || (kept > 0 && are_rows && calls_shader(state)))
        return;
    kept = 0;
    for (uint32_t n = 0; n < b->batch.count; ++n) {
        const bool any = any_coverage(b, n) != 0;

        if (are_rows) {
            b->batch.column[kept] = b->batch.column[n];
            b->batch.row[kept] = b->batch.row[n];
        } else {
            b->blocks[kept] = b->blocks[n];
        }
        for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
            b->covered[s][kept] = b->covered[s][n];
            b->coverage[s][kept] = b->coverage[s][n];
        }
        kept += any;
    }
    b->batch.count = kept;
}

/* Returns how many samples of a batch are covered. */
static inline uint64_t count_samples(const sampled_batch *b)
{
    uint64_t count = 0;

    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        for (uint32_t n = 0; n < b->batch.count; ++n)
            count += count_lanes(b->coverage[s][n]);
    return count;
}

/* Writes the colours of the samples from `first` up to, but not including, `end`. */
static inline void output_samples(const fragment_state *state, uint32_t first, uint32_t end,
                                  sampled_batch *b)
{
    const uint32_t count = shader_colors(state);

    for (uint32_t a = 0; a < count; ++a) {
        if (!encode_color(state, a, count, &b->batch))
            continue;
        for (uint32_t s = first; s < end; ++s) {
            for (uint32_t n = 0; n < b->batch.count; ++n)
                b->batch.coverage[n] = b->coverage[s][n];
            output_batch(&state[s], combine_of(&state[s], a), surface_of(&state[s], a), &b->batch);
        }
    }
}

/* Takes a batch through all steps in OpenGL's order, and counts its samples that passed. The steps
 * from the shader on are taken for all samples at once or, if the shader runs for each sample, for
 * one sample after the other. */
static inline void shade_sampled_batch(const fragment_context *c, sampled_batch *b)
{
    const fragment_state *const state = c->state;
    const uint32_t together = state->runs_per_sample ? 1 : GN_SAMPLES;
    const bool late = is_late_for_samples(state);

    if (!late) {
        test_samples(state, 0, GN_SAMPLES, b);
        c->counts->passed += count_samples(b);
        if (!has_colors(state))
            return;
        compact_samples(state, b);
        if (b->batch.count == 0)
            return;
    }
    if (state->is_located)
        find_present_samples(state, b);
    for (uint32_t s = 0; s < GN_SAMPLES; s += together) {
        source_samples(&state[s], b);
        if (late)
            test_samples(state, s, s + together, b);
        if (has_colors(state))
            output_samples(state, s, s + together, b);
    }
    if (late)
        c->counts->passed += count_samples(b);
}

/* Whether a square needs another batch than the `count` squares before it. Tests keep the order of
 * triangles, but colours are loaded before any is stored: a sample may be combined only once. Tests
 * that are previewed must see what other triangles have stored. */
static inline bool stays_apart(const fragment_state *state, const sampled_square *squares,
                               uint32_t count)
{
    const sampled_square *const square = &squares[count];
    bool overlaps = false;

    if (state->previews_tests && is_late_for_samples(state))
        return square->lane != square[-1].lane;
    for (uint32_t i = 0; state->combines && i < count; ++i)
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            overlaps |= squares[i].x == square->x && squares[i].y == square->y &&
                        (squares[i].coverage[s] & square->coverage[s]) != 0;
    return overlaps;
}

/* Sets the samples of half `to` of block n to those of half `from` of a square. */
static inline void set_half(const sampled_square *square, uint32_t from, uint32_t to,
                            uint32_t disabled, uint32_t n, sampled_batch *b)
{
    b->blocks[n].at.x[to] = square->x;
    b->blocks[n].at.y[to] = square->y + (int32_t)from * (SQUARE_SIZE / 2);
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        const uint32_t half = square->coverage[s] >> HALF_LANES * from & HALF_COVERED;
        const uint32_t drawn = disabled >> s & 1u ? 0 : half << HALF_LANES * to;

        b->covered[s][n] |= drawn;
        b->coverage[s][n] = b->covered[s][n];
    }
}

/* Returns the half of a square that alone has covered samples; 2 if both have. */
static inline uint32_t only_half(const sampled_square *square)
{
    const uint32_t *const c = square->coverage;
    const uint32_t any = c[0] | c[1] | c[2] | c[3];

    return !(any >> HALF_LANES) ? 0 : !(any & HALF_COVERED) ? 1 : 2;
}

/* Makes a batch of the first squares, as many as may take the steps together, and returns their
 * number. Of a triangle's squares that have samples in one half, two are a block: the empty half of
 * a block is in no other block of the triangle. */
static inline uint32_t batch_squares(const fragment_state *state, const sampled_square *squares,
                                     uint32_t count, sampled_batch *b)
{
    const uint32_t disabled = state->pipeline->samples.write_disabled;
    const uint32_t most = most_together(state);
    uint32_t i = 0, n = 0;
    uint32_t room = 2, room_in = 0; /* an empty half of a block; 2: none */

    do {
        const sampled_square *const square = &squares[i];
        const uint32_t half = only_half(square);

        if (i > 0 && square->lane != square[-1].lane)
            room = 2;
        if (half < 2 && room < 2) {
            set_half(square, half, room, disabled, room_in, b);
            room = 2;
            continue;
        }
        b->blocks[n].lane = square->lane;
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            b->covered[s][n] = 0;
        set_half(square, 0, 0, disabled, n, b);
        set_half(square, 1, 1, disabled, n, b);
        if (half < 2) {
            room = 1 - half;
            room_in = n;
        }
        ++n;
    } while (++i < count && n < most && !stays_apart(state, squares, i));
    b->batch.count = n;
    return i;
}

/* Shades squares: a samples_function. The context is a fragment_context. */
static void shade_sampled_squares(const void *context, const sampled_square *squares,
                                  uint32_t count)
{
    const fragment_context *const c = (const fragment_context *)context;
    sampled_batch b;

    b.batch.shape = SHAPE_HALVES;
    b.batch.blocks = b.blocks;
    b.batch.primitive = primitive_in(c->setup, 0);
    while (count > 0) {
        const uint32_t together = batch_squares(c->state, squares, count, &b);

        for (uint32_t i = 0; i < together; ++i)
            for (uint32_t s = 0; s < GN_SAMPLES; ++s)
                c->counts->covered += count_lanes(squares[i].coverage[s]);
        shade_sampled_batch(c, &b);
        squares += together;
        count -= together;
    }
}

/* Shades the columns of a span that are 16 pixels wide. Out of line, so that the batch's memory is
 * free when the rest of the span is shaded. */
GN_OUT_OF_LINE void shade_sampled_columns(const fragment_context *c, uint32_t lane, int32_t x,
                                          int32_t y, uint32_t columns)
{
    const uint32_t most = most_columns(c->state);
    const uint32_t disabled = c->state->pipeline->samples.write_disabled;
    sampled_batch b;

    b.batch.shape = SHAPE_ROW;
    b.batch.blocks = 0;
    b.batch.count = b.batch.columns = 0;
    b.batch.primitive = primitive_in(c->setup, lane);
    for (uint32_t together; columns > 0; columns -= together) {
        together = columns < most ? columns : most;
        set_rows(c->state, &b.batch, x, y, together);
        c->counts->covered += GN_SAMPLES * LANES * b.batch.count;
        for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
            for (uint32_t n = 0; n < b.batch.count; ++n) {
                b.covered[s][n] = disabled >> s & 1u ? 0 : GN_ALL_LANES;
                b.coverage[s][n] = b.covered[s][n];
            }
        }
        shade_sampled_batch(c, &b);
        x += (int32_t)(together * LANES);
    }
}

/* Shades a span of squares all of whose samples are covered: a span_function. The context is a
 * fragment_context. */
static void shade_sampled_span(const void *context, uint32_t lane, int32_t x, int32_t y,
                               uint32_t count)
{
    const uint32_t columns = count / SQUARES_IN_ROW;
    const uint32_t rest = count % SQUARES_IN_ROW;
    sampled_square square[SQUARES_IN_ROW];

    shade_sampled_columns((const fragment_context *)context, lane, x, y, columns);
    for (uint32_t i = 0; i < rest; ++i) {
        square[i].lane = lane;
        square[i].x = x + (int32_t)(columns * LANES + i * SQUARE_SIZE);
        square[i].y = y;
        for (uint32_t s = 0; s < GN_SAMPLES; ++s)
            square[i].coverage[s] = GN_ALL_LANES;
    }
    if (rest)
        shade_sampled_squares(context, square, rest);
}

#endif
