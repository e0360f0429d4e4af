/* Shaders that run for each sample, and varyings at centroids and samples. */
#include <math.h>
#include <string.h>

#include "unit.h"

/* ROW is a row of pixels that the strip's diagonal crosses far to the left. */
enum { SIDE = 8, ROW = 6, PIXELS = SIDE * SIDE, CHANNELS = 4 };

static const float place[GN_SAMPLES][2] = {
    {0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};

static float colors[GN_SAMPLES][PIXELS][CHANNELS];
static float depths[GN_SAMPLES][PIXELS];

/* What the shader writes. */
typedef enum show {
    SHOW_SAMPLE,   /* the sample's number and place, and the mask that is read */
    SHOW_POSITION, /* the window position */
    SHOW_DEPTHS,   /* the position's depth, and the depth that is in the output beforehand */
    SHOW_VARYINGS  /* the varyings, of which there are four */
} show;

typedef struct test_uniforms {
    show shown;
    uint32_t discarded;      /* bits of samples */
    float alpha[GN_SAMPLES]; /* if one is not 0, the alpha that is written for each sample */
} test_uniforms;

/* Varyings: the window position twice, as the pipeline interpolates it. */
static void shade_vertices(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 4; ++c) {
            out->position[c][l] = in->attribute[0][c][l];
            out->varying[c][l] =
                (in->attribute[0][c % 2][l] / in->attribute[0][3][l] + 1.0f) * (0.5f * SIDE);
        }
}

static void shade_fragments(const void *uniforms, const gn_fragment_input *in,
                            gn_fragment_output *out)
{
    const test_uniforms *const u = uniforms;

    for (int l = 0; l < GN_LANES; ++l) {
        const float sample[4] = {(float)in->sample_id, in->sample_position[0],
                                 in->sample_position[1],
                                 in->sample_mask ? (float)in->sample_mask[l] : -1.0f};
        const float shown_depths[4] = {in->position[2][l], out->depth ? out->depth[l] : -1.0f, 0,
                                       0};

        for (int c = 0; c < 4; ++c)
            out->color[c][l] = u->shown == SHOW_SAMPLE     ? sample[c]
                               : u->shown == SHOW_POSITION ? in->position[c][l]
                               : u->shown == SHOW_DEPTHS   ? shown_depths[c]
                                                           : in->varying[c][l];
        if (u->alpha[in->sample_id] != 0.0f)
            out->color[3][l] = u->alpha[in->sample_id];
    }
    if (u->discarded >> in->sample_id & 1u)
        out->kept = 0;
}

static test_uniforms uniforms;
static gn_pipeline pipeline;
static uint32_t samples_of_target;
static uint64_t passed;

static int reset(void **state)
{
    (void)state;
    memset(&uniforms, 0, sizeof uniforms);
    memset(&pipeline, 0, sizeof pipeline);
    samples_of_target = GN_SAMPLES;
    pipeline.program.vertex_shader = shade_vertices;
    pipeline.program.fragment_shader = shade_fragments;
    pipeline.program.uniforms = &uniforms;
    pipeline.program.varying_count = 4;
    pipeline.program.fragment_reads_position = true;
    pipeline.program.fragment_reads_sample_mask = true;
    return 0;
}

/* Clears to -1 and draws a strip from x = 0 to `right` pixels. Its left side has w = 1, its right
 * side has the given w. The left side's z is -deep, the right side's deep * w. */
static void draw_deep_strip(float right, float w, float deep)
{
    static unsigned char memory[65536];
    const float x = right / (0.5f * SIDE) - 1.0f;
    const float position[4][4] = {
        {-1, -1, -deep, 1}, {x * w, -w, deep * w, w}, {-1, 1, -deep, 1}, {x * w, w, deep * w, w}};
    const gn_surface color = gn_surface_bottom_up(colors, GN_FORMAT_RGBA32F, SIDE, SIDE);
    const gn_surface depth = gn_surface_bottom_up(depths, GN_FORMAT_D32F, SIDE, SIDE);
    gn_target target;
    gn_mesh mesh;
    gn_workspace workspace;

    memset(&target, 0, sizeof target);
    memset(&mesh, 0, sizeof mesh);
    memset(&workspace, 0, sizeof workspace);
    passed = 0;
    target.color[0] = samples_of_target > 1 ? gn_surface_multisampled(&color) : color;
    target.depth = samples_of_target > 1 ? gn_surface_multisampled(&depth) : depth;
    mesh.vertex_count = mesh.count = 4;
    mesh.attribute[0].data = &position[0][0];
    mesh.attribute[0].components = 4;
    pipeline.raster.topology = GN_TRIANGLE_STRIP;
    workspace.memory = memory;
    workspace.size = sizeof memory;
    workspace.samples_passed = &passed;
    assert_int_equal(gn_clear_color(&target.color[0], -1, -1, -1, -1), GN_OK);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
}

static void draw_strip(float right, float w)
{
    draw_deep_strip(right, w, 0.0f);
}

/* Fails unless a sample of the pixel (x, ROW) has these first channels. */
static void expect(int x, int sample, int channels, const float *wanted)
{
    for (int c = 0; c < channels; ++c)
        assert_true(colors[sample][ROW * SIDE + x][c] == wanted[c]);
}

static void expect_nothing(int x, int sample)
{
    assert_true(colors[sample][ROW * SIDE + x][0] == -1.0f);
}

/* Ways in which a pipeline asks for samples, and one in which it does not. */
enum { BY_INPUT, BY_VARYING, BY_FRACTION, NOT_AT_ALL, WAYS };

static void ask(int way)
{
    pipeline.program.fragment_reads_sample = way == BY_INPUT;
    pipeline.program.location[3] = way == BY_VARYING ? GN_AT_SAMPLE : GN_AT_CENTER;
    pipeline.samples.shading = way >= BY_FRACTION;
    pipeline.samples.least_shading = way == BY_FRACTION ? 0.2501f : 0.25f;
}

/* Half of pixel 3 is covered: samples 0 and 2. */
static void shaders_run_for_each_sample(void **state)
{
    (void)state;
    for (int way = 0; way < WAYS; ++way) {
        const bool each = way != NOT_AT_ALL;

        ask(way);
        uniforms.shown = SHOW_SAMPLE;
        draw_strip(3.5f, 1.0f);
        assert_int_equal(passed, SIDE * (3 * GN_SAMPLES + 2));
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const float sample[4] = {(float)s, place[s][0], place[s][1], (float)(1 << s)};
            const float inside[4] = {0, 0.5f, 0.5f, 15}, beside[4] = {0, 0.5f, 0.5f, 5};

            expect(2, s, 4, each ? sample : inside);
            if (s % 2)
                expect_nothing(3, s);
            else
                expect(3, s, 4, each ? sample : beside);
        }
        uniforms.shown = SHOW_POSITION;
        draw_strip(3.5f, 1.0f);
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const float position[2] = {2.0f + (each ? place[s][0] : 0.5f),
                                       ROW + (each ? place[s][1] : 0.5f)};

            expect(2, s, 2, position);
        }
    }
}

/* A shader that leaves the depth as it finds it leaves that of the sample, or of the pixel. */
static void depths_are_the_samples(void **state)
{
    (void)state;
    pipeline.depth.test = true;
    pipeline.depth.function = GN_ALWAYS;
    pipeline.program.fragment_writes_depth = true;
    uniforms.shown = SHOW_DEPTHS;
    for (int way = 0; way < WAYS; ++way) {
        ask(way);
        draw_deep_strip(SIDE, 1.0f, 1.0f);
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const float x = 2.0f + (way == NOT_AT_ALL ? 0.5f : place[s][0]);
            const float wanted[2] = {x / SIDE, x / SIDE};

            expect(2, s, 2, wanted);
            assert_true(depths[s][ROW * SIDE + 2] == wanted[0]);
        }
    }
}

/* Varyings 0 and 1, which are at centres, move only with the fraction; varying 3 moves if it asks
 * for it. */
static void varyings_are_where_they_ask(void **state)
{
    (void)state;
    for (int way = 0; way < WAYS; ++way) {
        ask(way);
        uniforms.shown = SHOW_VARYINGS;
        draw_strip(SIDE, 1.0f);
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const bool moved = way == BY_FRACTION, last = moved || way == BY_VARYING;
            const float wanted[4] = {
                2.0f + (moved ? place[s][0] : 0.5f), ROW + (moved ? place[s][1] : 0.5f),
                2.0f + (moved ? place[s][0] : 0.5f), ROW + (last ? place[s][1] : 0.5f)};

            expect(2, s, 4, wanted);
        }
    }
}

/* Varyings 0 and 1 at centroids: at the centre inside, at the lowest covered sample at the edge. */
static void centroids_are_covered(void **state)
{
    (void)state;
    static const struct {
        float right;
        uint32_t disabled;
        int sample; /* of the centroid in pixel 3; GN_SAMPLES: the centre */
    } cases[] = {{3.25f, 0, 2}, {3.5f, 0, 0}, {3.75f, 0, 0}, {4.0f, 0, GN_SAMPLES},
                 {4.0f, 1, 1},  {4.0f, 8, 0}, {3.5f, 1, 2}};

    pipeline.program.location[0] = pipeline.program.location[1] = GN_AT_CENTROID;
    uniforms.shown = SHOW_VARYINGS;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const int sample = cases[i].sample;
        const float wanted[4] = {3.0f + (sample < GN_SAMPLES ? place[sample][0] : 0.5f),
                                 ROW + (sample < GN_SAMPLES ? place[sample][1] : 0.5f), 3.5f,
                                 ROW + 0.5f};

        pipeline.samples.write_disabled = cases[i].disabled;
        draw_strip(cases[i].right, 1.0f);
        for (int s = 0; s < GN_SAMPLES; ++s)
            if (colors[s][ROW * SIDE + 3][0] != -1.0f)
                expect(3, s, 4, wanted);
        assert_true(colors[sample % GN_SAMPLES][ROW * SIDE + 3][0] != -1.0f ||
                    cases[i].disabled & 1u);
    }
}

/* A sample that does not pass the test is no centroid. Depths written before are those of sample 0.
 * The shader comes first where it may discard; if it writes depth, the test cannot come before. */
static void centroids_have_passed(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; ++kind) {
        const int sample = kind < 2 ? 1 : GN_SAMPLES;

        for (int s = 0; s < GN_SAMPLES; ++s)
            for (int p = 0; p < PIXELS; ++p)
                depths[s][p] = s == 0 ? 0.0f : 1.0f;
        pipeline.depth.test = true;
        pipeline.program.location[0] = GN_AT_CENTROID;
        pipeline.program.fragment_discards = kind == 1;
        pipeline.program.fragment_writes_depth = kind == 2;
        uniforms.shown = SHOW_VARYINGS;
        draw_strip(SIDE, 1.0f);
        assert_int_equal(passed, 3 * PIXELS);
        for (int s = 1; s < GN_SAMPLES; ++s) {
            const float wanted[1] = {2.0f + (sample < GN_SAMPLES ? place[sample][0] : 0.5f)};

            expect(2, s, 1, wanted);
            assert_true(depths[s][2] == 0.5f);
        }
        expect_nothing(2, 0);
    }
}

/* What is constant stays constant, and a linear function of clip space is its value at the place,
 * however w differs. */
static void values_are_perspective_correct(void **state)
{
    (void)state;
    const gn_varying_location locations[] = {GN_AT_CENTROID, GN_AT_SAMPLE, GN_AT_CENTER};

    uniforms.shown = SHOW_VARYINGS;
    for (size_t i = 0; i < sizeof locations / sizeof *locations; ++i) {
        for (int s = 0; s < GN_SAMPLES; ++s) {
            const double w0 = 1.0, w1 = 8.0, right = 3.75;
            memset(pipeline.program.location, 0, sizeof pipeline.program.location);
            pipeline.program.location[0] = locations[i];
            pipeline.samples.shading = locations[i] == GN_AT_CENTER;
            pipeline.samples.least_shading = 1.0f;
            draw_strip((float)right, (float)w1);
            if (colors[s][ROW * SIDE + 3][0] == -1.0f)
                continue;
            /* The varying is linear in clip space: x of the window at both sides. */
            const int at = locations[i] == GN_AT_CENTROID ? 0 : s;
            const double x = 3.0 + (double)place[at][0];
            const double t = x / right;
            const double exact = t * right / w1 / ((1.0 - t) / w0 + t / w1);

            assert_true(fabs((double)colors[s][ROW * SIDE + 3][0] - exact) < 1e-5);
        }
    }
}

/* Each run decides on its own sample: by discarding, and by its alpha. */
static void samples_are_decided_one_by_one(void **state)
{
    (void)state;
    uniforms.shown = SHOW_SAMPLE;
    uniforms.discarded = 2;
    pipeline.program.fragment_reads_sample = true;
    pipeline.program.fragment_discards = true;
    draw_strip(SIDE, 1.0f);
    assert_int_equal(passed, 3 * PIXELS);
    for (int s = 0; s < GN_SAMPLES; ++s)
        if (s == 1)
            expect_nothing(2, s);
        else
            assert_true(colors[s][2][0] == (float)s);

    reset(NULL);
    uniforms.shown = SHOW_SAMPLE;
    pipeline.program.fragment_reads_sample = true;
    pipeline.samples.alpha_to_coverage = true;
    for (int s = 0; s < GN_SAMPLES; ++s) /* on either side of s / 4 */
        uniforms.alpha[s] = 0.25f * (float)s + (s % 2 ? -0.125f : 0.125f);
    draw_strip(SIDE, 1.0f);
    assert_int_equal(passed, 2 * PIXELS);
    for (int s = 0; s < GN_SAMPLES; ++s)
        if (s % 2)
            expect_nothing(2, s);
        else
            assert_true(colors[s][2][0] == (float)s);
}

/* With one sample a pixel the shader runs for pixels, whatever the pipeline asks. */
static void one_sample_is_the_pixel(void **state)
{
    (void)state;
    const float sample[4] = {0, 0.5f, 0.5f, 1}, values[4] = {2.5f, ROW + 0.5f, 2.5f, ROW + 0.5f};

    samples_of_target = 1;
    for (int way = 0; way < WAYS; ++way) {
        ask(way);
        pipeline.program.location[0] = GN_AT_CENTROID;
        uniforms.shown = SHOW_SAMPLE;
        draw_strip(SIDE, 1.0f);
        assert_int_equal(passed, PIXELS);
        expect(2, 0, 4, sample);
        uniforms.shown = SHOW_VARYINGS;
        draw_strip(SIDE, 1.0f);
        expect(2, 0, 4, values);
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
    (void)state;
    enum { WIDTH = 256, HEIGHT = 4 };
    static float far_away[GN_SAMPLES * WIDTH * HEIGHT];
    static unsigned char memory[65536];
    const float position[3][2] = {{-1, -1}, {3, -1}, {-1, 3}};
    const gn_surface depth = gn_surface_bottom_up(far_away, GN_FORMAT_D32F, WIDTH, HEIGHT);
    gn_color_uniforms identity;
    gn_target target;
    gn_mesh mesh;
    gn_workspace workspace;

    memset(&target, 0, sizeof target);
    memset(&mesh, 0, sizeof mesh);
    memset(&workspace, 0, sizeof workspace);
    passed = 0;
    target.depth = gn_surface_multisampled(&depth);
    mesh.vertex_count = mesh.count = 3;
    mesh.attribute[0].data = &position[0][0];
    mesh.attribute[0].components = 2;
    workspace.memory = memory;
    workspace.size = sizeof memory;
    workspace.samples_passed = &passed;
    gn_mat4_identity(&identity.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &identity), GN_OK);
    pipeline.program.fragment_shader = shade_mask;
    pipeline.program.fragment_writes_sample_mask = true;
    pipeline.program.color_count = GN_MAX_COLORS;
    pipeline.depth.test = true;
    assert_int_equal(gn_clear_depth(&target.depth, 1.0f), GN_OK);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    assert_int_equal(passed, 2 * WIDTH * HEIGHT);
    for (int i = 0; i < GN_SAMPLES * WIDTH * HEIGHT; ++i)
        assert_true(far_away[i] == (i / (WIDTH * HEIGHT) % 2 ? 1.0f : 0.5f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(shaders_run_for_each_sample, reset),
        cmocka_unit_test_setup(depths_are_the_samples, reset),
        cmocka_unit_test_setup(varyings_are_where_they_ask, reset),
        cmocka_unit_test_setup(centroids_are_covered, reset),
        cmocka_unit_test_setup(centroids_have_passed, reset),
        cmocka_unit_test_setup(values_are_perspective_correct, reset),
        cmocka_unit_test_setup(samples_are_decided_one_by_one, reset),
        cmocka_unit_test_setup(one_sample_is_the_pixel, reset),
        cmocka_unit_test_setup(colors_without_a_target_have_room, reset),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
