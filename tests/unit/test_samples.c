/* Several samples a pixel: surfaces, their views and faults; masks and alpha that decide on
 * samples; shaders that run for each sample; varyings at centroids and samples. */
#include <math.h>

#include "drawing.h"

/* ROW is a row of pixels that the strip's diagonal crosses far to the left. */
enum { SIDE = 8, ROW = 6, PIXELS = SIDE * SIDE, CHANNELS = 4, ALL = (1 << GN_SAMPLES) - 1 };

static const float place[GN_SAMPLES][2] = {
    {0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};

static float colors[GN_SAMPLES][PIXELS][CHANNELS];
static float depths[GN_SAMPLES][PIXELS];
static gn_target target;
static gn_pipeline pipeline;
static uint64_t passed;

/* What the shader writes. */
typedef enum show {
    SHOW_SAMPLE,   /* the sample's number and place, and the mask that is read */
    SHOW_POSITION, /* the window position */
    SHOW_DEPTHS,   /* the position's depth, and the depth that is in the output beforehand */
    SHOW_VARYINGS  /* the varyings, of which there are four */
} show;

static show shown;
static uint32_t discarded;  /* bits of samples */
static uint32_t mask_bits;  /* the mask that is written */
static const float *alphas; /* if not null, the alpha that is written for each sample */

/* Varyings: the window position twice, as the pipeline interpolates it. */
static void shade_vertices(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    pass_positions(uniforms, in, out);
    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 4; ++c)
            out->varying[c][l] =
                (out->position[c % 2][l] / out->position[3][l] + 1.0f) * (0.5f * SIDE);
}

static void shade_fragments(const void *uniforms, const gn_fragment_input *in,
                            gn_fragment_output *out)
{
    (void)uniforms;
    assert_int_equal(in->sample_mask != NULL, pipeline.program.fragment_reads_sample_mask);
    assert_int_equal(out->sample_mask != NULL, pipeline.program.fragment_writes_sample_mask);
    for (int l = 0; l < GN_LANES; ++l) {
        const float sample[4] = {(float)in->sample_id, in->sample_position[0],
                                 in->sample_position[1],
                                 in->sample_mask ? (float)in->sample_mask[l] : -1.0f};
        const float shown_depths[4] = {in->position[2][l], out->depth ? out->depth[l] : -1.0f, 0,
                                       0};

        for (int c = 0; c < 4; ++c)
            out->color[c][l] = shown == SHOW_SAMPLE     ? sample[c]
                               : shown == SHOW_POSITION ? in->position[c][l]
                               : shown == SHOW_DEPTHS   ? shown_depths[c]
                                                        : in->varying[c][l];
        if (alphas)
            out->color[3][l] = alphas[in->sample_id];
        if (in->sample_mask && !(in->coverage >> l & 1))
            assert_int_equal(in->sample_mask[l], 0);
        if (out->sample_mask) {
            assert_int_equal(out->sample_mask[l], UINT32_MAX);
            out->sample_mask[l] = mask_bits;
        }
    }
    if (discarded >> in->sample_id & 1u)
        out->kept = 0;
}

static int reset(void **state)
{
    memset(&target, 0, sizeof target);
    target.color[0] = gn_surface_bottom_up(colors, GN_FORMAT_RGBA32F, SIDE, SIDE);
    target.depth = gn_surface_bottom_up(depths, GN_FORMAT_D32F, SIDE, SIDE);
    make_multisampled(&target);
    memset(&pipeline, 0, sizeof pipeline);
    pipeline.raster.topology = GN_TRIANGLE_STRIP;
    pipeline.program.vertex_shader = shade_vertices;
    pipeline.program.fragment_shader = shade_fragments;
    pipeline.program.varying_count = 4;
    pipeline.program.fragment_reads_position = true;
    pipeline.program.fragment_reads_sample_mask = true;
    shown = SHOW_SAMPLE;
    discarded = 0;
    alphas = NULL;
    return 0;
}

/* Clears to -1 and draws a strip from x = 0, where z is -deep, to `right` pixels, where z is
 * deep. */
static void draw_deep_strip(float right, float deep)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(16, 4)];
    const float x = right / (0.5f * SIDE) - 1.0f;
    const float position[4][4] = {
        {-1, -1, -deep, 1}, {x, -1, deep, 1}, {-1, 1, -deep, 1}, {x, 1, deep, 1}};
    const gn_mesh mesh = mesh_of(position[0], 4, 4);
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .samples_passed = &passed};

    passed = 0;
    for (int i = 0; i < 2; ++i)
        if (target.color[i].format != GN_FORMAT_NONE)
            assert_int_equal(gn_clear_color(&target.color[i], -1, -1, -1, -1), GN_OK);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
}

static void draw_strip(float right)
{
    draw_deep_strip(right, 0.0f);
}

/* The colour of a sample of the pixel (x, ROW). */
static const float *color_of(int x, int sample)
{
    return colors[sample][ROW * SIDE + x];
}

/* Fails unless these first channels are `wanted`. */
static void expect(int x, int sample, int channels, const float *wanted)
{
    for (int c = 0; c < channels; ++c)
        assert_true(color_of(x, sample)[c] == wanted[c]);
}

static bool is_drawn(int x, int sample)
{
    return color_of(x, sample)[0] != -1.0f;
}

static void expect_drawn(int x, uint32_t samples)
{
    for (int s = 0; s < GN_SAMPLES; ++s)
        assert_int_equal(is_drawn(x, s), samples >> s & 1u);
}

static void surfaces_and_views(void **state)
{
    const gn_surface down = gn_surface_top_down(colors, GN_FORMAT_RGBA32F, SIDE, SIDE);
    const gn_surface all = gn_surface_multisampled(&down);

    assert_int_equal(all.samples, GN_SAMPLES);
    assert_int_equal(all.sample_stride, sizeof colors[0]);
    for (uint32_t n = 0; n < GN_SAMPLES; ++n) {
        const gn_surface view = gn_surface_sample(&all, n);

        assert_ptr_equal(view.pixels, colors[n][SIDE * (SIDE - 1)]);
        assert_int_equal(view.row_stride, -SIDE * 16);
        assert_int_equal(view.samples, 0);
    }
    assert_null(gn_surface_sample(&all, GN_SAMPLES).pixels);
    assert_null(gn_surface_sample(NULL, 0).pixels);
    assert_null(gn_surface_sample(&down, 1).pixels);
    assert_ptr_equal(gn_surface_sample(&down, 0).pixels, down.pixels);
    assert_int_equal(gn_surface_multisampled(NULL).format, GN_FORMAT_NONE);
    assert_int_equal(gn_surface_rows(&all, 1, 2).samples, GN_SAMPLES);
}

/* Samples follow one another without overlap, otherwise the target is refused. */
static void faults(void **state)
{
    const ptrdiff_t row = SIDE * 16, all = PIXELS * 16, parts = GN_SAMPLES - 1;
    const struct {
        ptrdiff_t stride;
        gn_status status;
    } cases[] = {{4 - row, GN_INVALID_STRIDE},
                 {PTRDIFF_MIN, GN_INVALID_STRIDE},
                 {PTRDIFF_MAX / parts & ~(ptrdiff_t)3, GN_INVALID_STRIDE},
                 {(PTRDIFF_MAX - all) / parts & ~(ptrdiff_t)3, GN_OK},
                 {-all, GN_OK}};
    const ptrdiff_t stride = (PTRDIFF_MAX / GN_MAX_SIZE + 16) & ~(ptrdiff_t)15;
    gn_surface image = target.color[0];

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        target.color[0].sample_stride = cases[i].stride;
        assert_int_equal(gn_target_check(&target), cases[i].status);
    }
    target.color[0].samples = UINT32_MAX;
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_INVALID_SAMPLES);
    target.color[0].samples = 1;
    assert_int_equal(gn_target_check(&target), GN_SIZE_MISMATCH);
    target.depth.samples = 0;
    assert_int_equal(gn_target_check(&target), GN_OK);

    image.samples = 0;
    image.height = 2;
    for (int sign = -1; sign <= 1; sign += 2) {
        image.row_stride = sign * stride;
        assert_true(gn_surface_multisampled(&image).sample_stride == 2 * stride);
    }
    image.row_stride = PTRDIFF_MIN;
    image = gn_surface_multisampled(&image);
    assert_int_equal(gn_clear_color(&image, 0, 0, 0, 0), GN_INVALID_STRIDE);
}

/* The sample planes in any order in memory, and rows of the samples side by side. */
static void strides_of_samples_are_free(void **state)
{
    float *const first = colors[0][0];

    target.depth.format = GN_FORMAT_NONE;
    target.color[0].pixels = colors[3];
    target.color[0].sample_stride = -(ptrdiff_t)sizeof colors[0];
    draw_strip(0.25f); /* sample 2 of the first column */
    for (int i = 0; i < GN_SAMPLES * PIXELS; ++i)
        assert_int_equal(first[CHANNELS * i] != -1.0f, i / PIXELS == 1 && i % SIDE == 0);
    reset(NULL);
    target.depth.format = GN_FORMAT_NONE;
    target.color[0].row_stride = GN_SAMPLES * SIDE * 16;
    target.color[0].sample_stride = SIDE * 16;
    draw_strip(0.25f);
    for (int i = 0; i < GN_SAMPLES * PIXELS; ++i)
        assert_int_equal(first[CHANNELS * i] != -1.0f, i % (GN_SAMPLES * SIDE) == 2 * SIDE);
}

static void faults_of_resolving(void **state)
{
    static float depth[PIXELS];
    gn_surface to = gn_surface_bottom_up(depth, GN_FORMAT_D32F, SIDE, SIDE);

    assert_int_equal(gn_resolve(&to, &target.depth), GN_OK);
    assert_int_equal(gn_resolve(NULL, &target.depth), GN_NULL_POINTER);
    assert_int_equal(gn_resolve(&to, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_resolve(&target.depth, &target.depth), GN_INVALID_SAMPLES);
    assert_int_equal(gn_resolve(&to, &target.color[0]), GN_INVALID_FORMAT);
    to.width = SIDE - 1;
    assert_int_equal(gn_resolve(&to, &target.depth), GN_SIZE_MISMATCH);
    to.width = 0;
    assert_int_equal(gn_resolve(&to, &target.depth), GN_INVALID_SIZE);
}

/* A strip to the middle of pixel 3 covers samples 0 and 2 of that pixel. Sample 3 fails the depth
 * test. The mask that is written leaves samples 1 and 2. */
static void masks_are_of_samples(void **state)
{
    pipeline.depth.test_enabled = true;
    for (int way = 0; way < 8; ++way) {
        const bool reads = way & 1, writes = way & 2;

        pipeline.program.fragment_reads_sample_mask = reads;
        pipeline.program.fragment_writes_sample_mask = writes;
        mask_bits = way & 4 ? 0x7FFFFFF6 : 6;
        assert_int_equal(gn_clear_depth(&target.depth, 1.0f), GN_OK);
        for (int p = 0; p < PIXELS; ++p)
            depths[3][p] = 0.25f;
        draw_strip(3.5f);
        assert_int_equal(passed, SIDE * (writes ? 3 * 2 + 1 : 3 * 3 + 2));
        for (int x = 2; x < 4; ++x) {
            const uint32_t covered = x == 2 ? ALL : 5;
            const float color[4] = {0, 0.5f, 0.5f, reads ? (float)covered : -1.0f};

            expect_drawn(x, covered & (writes ? 6 : 7));
            for (int s = 0; s < GN_SAMPLES; ++s) {
                if (is_drawn(x, s))
                    expect(x, s, 4, color);
                assert_true(depths[s][ROW * SIDE + x] == (is_drawn(x, s) ? 0.5f
                                                          : s == 3       ? 0.25f
                                                                         : 1.0f));
            }
        }
    }
}

/* A sample stays unless alpha is at most s / 4; with NaN all samples stay. The alpha is that of the
 * first colour, whether or not the target has it. */
static void alpha_covers_samples(void **state)
{
    static const struct {
        float alpha;
        uint32_t samples;
    } cases[] = {{-1.0f, 0},  {0.0f, 0},  {0.125f, 1},  {0.25f, 1}, {0.375f, 3}, {0.5f, 3},
                 {0.625f, 7}, {0.75f, 7}, {0.875f, 15}, {1.0f, 15}, {NAN, 15},   {-NAN, 15}};

    const gn_surface image = target.color[0];

    pipeline.samples.alpha_to_coverage_enabled = true;
    pipeline.program.color_count = 2;
    for (size_t i = 0; i < 2 * sizeof cases / sizeof *cases; ++i) {
        alphas = &cases[i / 2].alpha;
        memset(target.color, 0, sizeof target.color);
        target.color[i % 2] = image;
        draw_strip(SIDE);
        expect_drawn(2, cases[i / 2].samples);
    }
}

/* Without a fragment shader there is no alpha, and all samples stay. */
static void depths_alone_have_no_alpha(void **state)
{
    target.color[0].format = GN_FORMAT_NONE;
    pipeline.program.fragment_shader = NULL;
    pipeline.depth.test_enabled = true;
    pipeline.samples.alpha_to_coverage_enabled = true;
    pipeline.samples.shading_enabled = true;
    pipeline.samples.least_shading = 1.0f;
    assert_int_equal(gn_clear_depth(&target.depth, 1.0f), GN_OK);
    draw_strip(SIDE);
    for (int i = 0; i < GN_SAMPLES * PIXELS; ++i)
        assert_true(depths[i / PIXELS][i % PIXELS] == 0.5f);
}

/* Ways in which a pipeline asks for samples, and one in which it does not. */
enum { BY_INPUT, BY_VARYING, BY_FRACTION, NOT_AT_ALL, WAYS };

static void ask(int way, show what)
{
    pipeline.program.fragment_reads_sample = way == BY_INPUT;
    pipeline.program.interpolated_at[3] = way == BY_VARYING ? GN_AT_SAMPLE : GN_AT_CENTER;
    pipeline.samples.shading_enabled = way >= BY_FRACTION;
    pipeline.samples.least_shading = way == BY_FRACTION ? 0.2501f : 0.25f;
    shown = what;
}

/* The place that is asked for along an axis, in the pixel that begins at `from`. */
static float at(float from, int sample, int axis)
{
    return from + (sample < GN_SAMPLES ? place[sample][axis] : 0.5f);
}

/* Half of pixel 3 is covered: samples 0 and 2. A shader that leaves the depth as it finds it leaves
 * that of the sample, or of the pixel. Varyings 0 and 1, which are at centres, move only with the
 * fraction; varying 3 moves if it asks for it. */
static void shaders_run_for_each_sample(void **state)
{
    pipeline.depth.test_enabled = true;
    pipeline.depth.function = GN_ALWAYS;
    for (int way = 0; way < WAYS; ++way) {
        const bool each = way != NOT_AT_ALL;

        pipeline.program.fragment_writes_depth = false;
        ask(way, SHOW_SAMPLE);
        draw_strip(3.5f);
        assert_int_equal(passed, SIDE * (3 * GN_SAMPLES + 2));
        expect_drawn(3, 5);
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const float sample[4] = {(float)s, place[s][0], place[s][1], (float)(1 << s)};
            const float inside[4] = {0, 0.5f, 0.5f, ALL}, beside[4] = {0, 0.5f, 0.5f, 5};

            expect(2, s, 4, each ? sample : inside);
            if (s % 2 == 0)
                expect(3, s, 4, each ? sample : beside);
        }
        ask(way, SHOW_POSITION);
        draw_strip(3.5f);
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const int n = each ? s : GN_SAMPLES;

            expect(2, s, 2, (const float[2]){at(2, n, 0), at(ROW, n, 1)});
        }
        ask(way, SHOW_VARYINGS);
        draw_strip(SIDE);
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const int n = way == BY_FRACTION ? s : GN_SAMPLES;

            expect(2, s, 4,
                   (const float[4]){at(2, n, 0), at(ROW, n, 1), at(2, n, 0),
                                    at(ROW, way == BY_VARYING ? s : n, 1)});
        }
        pipeline.program.fragment_writes_depth = true;
        ask(way, SHOW_DEPTHS);
        draw_deep_strip(SIDE, 1.0f);
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const float depth = at(2, each ? s : GN_SAMPLES, 0) / SIDE;

            expect(2, s, 2, (const float[2]){depth, depth});
            assert_true(depths[s][ROW * SIDE + 2] == depth);
        }
    }
}

/* Varyings 0 and 1 at centroids: at the centre inside, at the lowest covered sample at the edge. */
static void centroids_are_covered(void **state)
{
    static const struct {
        float right;
        uint32_t disabled;
        int sample; /* of the centroid in pixel 3; GN_SAMPLES: the centre */
    } cases[] = {{3.25f, 0, 2}, {3.5f, 0, 0}, {3.75f, 0, 0}, {4.0f, 0, GN_SAMPLES},
                 {4.0f, 1, 1},  {4.0f, 8, 0}, {3.5f, 1, 2}};

    pipeline.program.interpolated_at[0] = pipeline.program.interpolated_at[1] = GN_AT_CENTROID;
    shown = SHOW_VARYINGS;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const int sample = cases[i].sample;
        const float wanted[4] = {at(3, sample, 0), at(ROW, sample, 1), 3.5f, ROW + 0.5f};

        pipeline.samples.write_disabled = cases[i].disabled;
        draw_strip(cases[i].right);
        for (int s = 0; s < GN_SAMPLES; ++s)
            if (is_drawn(3, s))
                expect(3, s, 4, wanted);
        assert_true(is_drawn(3, sample % GN_SAMPLES) || cases[i].disabled & 1u);
    }
}

/* A sample that does not pass the test is no centroid. Depths written before are those of sample 0.
 * The shader comes first where it may discard; if it writes depth, the test cannot come before. */
static void centroids_have_passed(void **state)
{
    pipeline.depth.test_enabled = true;
    pipeline.program.interpolated_at[0] = GN_AT_CENTROID;
    shown = SHOW_VARYINGS;
    for (int kind = 0; kind < 3; ++kind) {
        for (int i = 0; i < GN_SAMPLES * PIXELS; ++i)
            depths[i / PIXELS][i % PIXELS] = i < PIXELS ? 0.0f : 1.0f;
        pipeline.program.fragment_discards = kind == 1;
        pipeline.program.fragment_writes_depth = kind == 2;
        draw_strip(SIDE);
        assert_int_equal(passed, 3 * PIXELS);
        expect_drawn(2, ALL & ~1);
        for (int s = 1; s < GN_SAMPLES; ++s) {
            expect(2, s, 1, (const float[1]){at(2, kind < 2 ? 1 : GN_SAMPLES, 0)});
            assert_true(depths[s][2] == 0.5f);
        }
    }
}

/* Each run decides on its own sample: by discarding, and by its alpha. */
static void samples_are_decided_one_by_one(void **state)
{
    static const float beside[GN_SAMPLES] = {0.125f, 0.125f, 0.625f, 0.625f}; /* s / 4 */

    pipeline.program.fragment_reads_sample = true;
    for (int by_alpha = 0; by_alpha < 2; ++by_alpha) {
        discarded = by_alpha ? 0 : 2;
        alphas = by_alpha ? beside : NULL;
        pipeline.program.fragment_discards = !by_alpha;
        pipeline.samples.alpha_to_coverage_enabled = by_alpha;
        draw_strip(SIDE);
        assert_int_equal(passed, (by_alpha ? 2 : 3) * PIXELS);
        expect_drawn(2, by_alpha ? 5 : ALL & ~2);
        for (int s = 0; s < GN_SAMPLES; ++s)
            assert_true(!is_drawn(2, s) || color_of(2, s)[0] == (float)s);
    }
}

/* With one sample a pixel the shader runs for pixels, whatever the pipeline asks, and no mask that
 * it writes counts. */
static void one_sample_is_the_pixel(void **state)
{
    target.color[0].samples = target.depth.samples = 1;
    pipeline.program.fragment_writes_sample_mask = true;
    pipeline.program.interpolated_at[0] = GN_AT_CENTROID;
    mask_bits = 6;
    for (int way = 0; way < WAYS; ++way) {
        ask(way, SHOW_SAMPLE);
        draw_strip(SIDE);
        assert_int_equal(passed, PIXELS);
        expect(2, 0, 4, (const float[4]){0, 0.5f, 0.5f, 1});
        ask(way, SHOW_VARYINGS);
        draw_strip(SIDE);
        expect(2, 0, 4, (const float[4]){2.5f, ROW + 0.5f, 2.5f, ROW + 0.5f});
    }
}

/* Writes a mask and all colours. */
static void shade_mask(const void *unused, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)unused;
    for (int l = 0; l < GN_LANES; ++l) {
        out->sample_mask[l] = in->x[0] % 2 == 0 ? 5 : 0;
        for (int c = 0; c < 4 * GN_MAX_COLORS; ++c)
            out->color[c][l] = 0.5f;
    }
}

/* A shader that decides on samples runs though the target has no colours, and has room for all that
 * it writes, also where whole rows of squares are covered. */
static void colors_without_a_target_have_room(void **state)
{
    enum { WIDTH = 256, HEIGHT = 4 };
    static float far_away[GN_SAMPLES * WIDTH * HEIGHT];

    target.color[0].format = GN_FORMAT_NONE;
    target.depth = gn_surface_bottom_up(far_away, GN_FORMAT_D32F, WIDTH, HEIGHT);
    make_multisampled(&target);
    pipeline = colored_pipeline(GN_TRIANGLE_STRIP);
    pipeline.program.fragment_shader = shade_mask;
    pipeline.program.fragment_writes_sample_mask = true;
    pipeline.program.color_count = GN_MAX_COLORS;
    pipeline.depth.test_enabled = true;
    assert_int_equal(gn_clear_depth(&target.depth, 1.0f), GN_OK);
    draw_strip(SIDE);
    assert_int_equal(passed, 2 * WIDTH * HEIGHT);
    for (int i = 0; i < GN_SAMPLES * WIDTH * HEIGHT; ++i)
        assert_true(far_away[i] == (i / (WIDTH * HEIGHT) % 2 ? 1.0f : 0.5f));
}

/* A triangle from w = 1 at x = 0.5 to `w` at its right edge, x = 8.25. 1/w falls along x; for w =
 * 32 it is 0 at the centre of pixel 8, whose sample 2 is covered. Red is 1, green falls from 1 to 0
 * and blue rises from 0 to 1, all smooth. Returns the colour of that sample. */
static const void *color_beyond_an_edge(gn_format format, float w, gn_backend backend)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(16, 4)];
    static uint32_t pixels[GN_SAMPLES * 16 * 16 * 4];
    const float corner[3][2] = {{0.5f, 0.25f}, {8.25f, 0.25f}, {8.25f, 8.25f}};
    const float rgb[9] = {1, 1, 0, 1, 0, 1, 1, 0, 1};
    const gn_pipeline p = colored_pipeline(GN_TRIANGLES);
    float position[3][4] = {{0}};
    gn_mesh mesh = mesh_of(position[0], 4, 3);
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .backend = backend};
    gn_target t = {{gn_surface_bottom_up(pixels, format, 16, 16)}, {0}};

    memset(pixels, 0, sizeof pixels);
    make_multisampled(&t);
    for (int i = 0; i < 3; ++i) {
        position[i][3] = i == 0 ? 1.0f : w;
        for (int n = 0; n < 2; ++n)
            position[i][n] = (corner[i][n] / 8.0f - 1.0f) * position[i][3];
    }
    mesh.attribute[GN_ATTRIBUTE_COLOR] = floats(rgb, 3);
    assert_int_equal(gn_draw(&t, &p, &mesh, &workspace), GN_OK);
    return (const char *)pixels + (size_t)(2 * 16 * 16 + 2 * 16 + 8) * gn_format_size(format);
}

/* The reference's results, expected of every back end (reference/RULES.md). */
static void varyings_are_those_of_the_centre(void **state)
{
    for (gn_backend b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; b = backend_after(b)) {
        /* 1/w is negative at the centre: the plane continues beyond the range of the vertices. */
        const float *color = color_beyond_an_edge(GN_FORMAT_RGBA32F, 33.0f, b);
        assert_true(fabsf(color[0] - 1.0f) < 1e-3f && fabsf(color[1] - 33.0f) < 1e-2f &&
                    fabsf(color[2] + 32.0f) < 1e-2f);
        const uint32_t *byte = color_beyond_an_edge(GN_FORMAT_RGBA8, 33.0f, b);
        assert_int_equal(*byte, 0xFF00FFFFu);

        /* 1/w is 0 at the centre: infinity or NaN, and what formats store for them. */
        color = color_beyond_an_edge(GN_FORMAT_RGBA32F, 32.0f, b);
        assert_true(isnan(color[0]) && color[1] == -INFINITY && color[2] == INFINITY);
        const uint16_t *word = color_beyond_an_edge(GN_FORMAT_RGBA16, 32.0f, b);
        assert_true(word[0] == 0 && word[1] == 0 && word[2] == 65535 && word[3] == 0);
        byte = color_beyond_an_edge(GN_FORMAT_RGBA8, 32.0f, b);
        assert_int_equal(*byte, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(surfaces_and_views, reset),
        cmocka_unit_test_setup(faults, reset),
        cmocka_unit_test_setup(strides_of_samples_are_free, reset),
        cmocka_unit_test_setup(faults_of_resolving, reset),
        cmocka_unit_test_setup(masks_are_of_samples, reset),
        cmocka_unit_test_setup(alpha_covers_samples, reset),
        cmocka_unit_test_setup(depths_alone_have_no_alpha, reset),
        cmocka_unit_test_setup(shaders_run_for_each_sample, reset),
        cmocka_unit_test_setup(centroids_are_covered, reset),
        cmocka_unit_test_setup(centroids_have_passed, reset),
        cmocka_unit_test_setup(samples_are_decided_one_by_one, reset),
        cmocka_unit_test_setup(one_sample_is_the_pixel, reset),
        cmocka_unit_test_setup(colors_without_a_target_have_room, reset),
        cmocka_unit_test_setup(varyings_are_those_of_the_centre, reset),
    };
    return cmocka_run_group_tests_name("samples", tests, NULL, NULL);
}
