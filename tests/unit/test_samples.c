/* Several samples a pixel: surfaces, their faults and views, clears, coverage, resolving. */
#include <math.h>
#include <string.h>

#include "unit.h"

enum { SIDE = 6, PIXELS = SIDE * SIDE, PAD = 8 };

static uint32_t colors[GN_SAMPLES * PIXELS + 2 * PAD];
static float depths[GN_SAMPLES * PIXELS];

static gn_target sampled_target(void)
{
    const gn_surface color = gn_surface_bottom_up(colors + PAD, GN_FORMAT_RGBA8, SIDE, SIDE);
    const gn_surface depth = gn_surface_bottom_up(depths, GN_FORMAT_D32F, SIDE, SIDE);
    gn_target t;

    memset(&t, 0, sizeof t);
    memset(colors, 0, sizeof colors);
    t.color[0] = gn_surface_multisampled(&color);
    t.depth = gn_surface_multisampled(&depth);
    return t;
}

static void surfaces_and_views(void **state)
{
    (void)state;
    const gn_surface down = gn_surface_top_down(colors, GN_FORMAT_RGBA8, SIDE, SIDE);
    const gn_surface all = gn_surface_multisampled(&down);

    assert_int_equal(all.samples, GN_SAMPLES);
    assert_int_equal(all.sample_stride, PIXELS * 4);
    for (uint32_t n = 0; n < GN_SAMPLES; ++n) {
        const gn_surface view = gn_surface_sample(&all, n);

        assert_ptr_equal(view.pixels, colors + PIXELS * n + SIDE * (SIDE - 1));
        assert_int_equal(view.row_stride, -SIDE * 4);
        assert_int_equal(view.samples, 0);
    }
    assert_null(gn_surface_sample(&all, GN_SAMPLES).pixels);
    assert_null(gn_surface_sample(NULL, 0).pixels);
    assert_null(gn_surface_sample(&down, 1).pixels);
    assert_ptr_equal(gn_surface_sample(&down, 0).pixels, down.pixels);
    assert_int_equal(gn_surface_multisampled(NULL).format, GN_FORMAT_NONE);
    assert_int_equal(gn_surface_rows(&all, 1, 2).samples, GN_SAMPLES);
}

static void faults(void **state)
{
    (void)state;
    gn_target t = sampled_target();

    assert_int_equal(gn_target_check(&t), GN_OK);
    t.color[0].samples = 2;
    assert_int_equal(gn_target_check(&t), GN_INVALID_SAMPLES);
    t.color[0].samples = UINT32_MAX;
    assert_int_equal(gn_clear_color(&t.color[0], 0, 0, 0, 0), GN_INVALID_SAMPLES);
    t.color[0].samples = 1;
    assert_int_equal(gn_target_check(&t), GN_SIZE_MISMATCH);
    t.depth.samples = 0;
    assert_int_equal(gn_target_check(&t), GN_OK);

    t = sampled_target();
    t.color[0].sample_stride += 2;
    assert_int_equal(gn_target_check(&t), GN_MISALIGNED);
    t.color[0].sample_stride = SIDE * 4 - 4;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].sample_stride = -(SIDE * 4 - 4);
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].sample_stride = PTRDIFF_MAX & ~(ptrdiff_t)3;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].sample_stride = PTRDIFF_MIN;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].sample_stride = PTRDIFF_MAX / (GN_SAMPLES - 1) & ~(ptrdiff_t)3;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].sample_stride = (PTRDIFF_MAX - PIXELS * 4) / (GN_SAMPLES - 1) & ~(ptrdiff_t)3;
    assert_int_equal(gn_target_check(&t), GN_OK);
    t.color[0].sample_stride = -PIXELS * 4;
    assert_int_equal(gn_target_check(&t), GN_OK);
}

/* Samples follow one another without overlap, otherwise the target is refused. */
static void long_rows_do_not_overlap(void **state)
{
    (void)state;
    const ptrdiff_t stride = (PTRDIFF_MAX / GN_MAX_SIZE + 16) & ~(ptrdiff_t)15;
    gn_target t = sampled_target();
    gn_surface image = t.color[0];

    image.samples = 0;
    image.height = 2;
    image.row_stride = stride;
    assert_true(gn_surface_multisampled(&image).sample_stride == 2 * stride);
    image.row_stride = -stride;
    assert_true(gn_surface_multisampled(&image).sample_stride == 2 * stride);
    image.row_stride = PTRDIFF_MIN;
    t.color[0] = gn_surface_multisampled(&image);
    assert_int_equal(gn_clear_color(&t.color[0], 0, 0, 0, 0), GN_INVALID_STRIDE);
}

static void clears_fill_every_sample(void **state)
{
    (void)state;
    const gn_target t = sampled_target();

    assert_int_equal(gn_clear_color(&t.color[0], 1, 1, 1, 1), GN_OK);
    assert_int_equal(gn_clear_depth(&t.depth, 0.25f), GN_OK);
    for (int i = 0; i < GN_SAMPLES * PIXELS; ++i) {
        assert_int_equal(colors[PAD + i], UINT32_MAX);
        assert_true(depths[i] == 0.25f);
    }
    for (int i = 0; i < PAD; ++i) {
        assert_int_equal(colors[i], 0);
        assert_int_equal(colors[PAD + GN_SAMPLES * PIXELS + i], 0);
    }
}

/* The shader of draw_strip besides writing white: red shows the mask that it reads, in steps; the
 * mask that it writes leaves samples 1 and 2. */
static bool reads_mask, writes_mask, alpha_covers;
static float strip_alpha = 1.0f;
static uint32_t colors_written;
static uint32_t mask_bits = 6;

static void show_masks(const void *uniforms, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)uniforms;
    assert_int_equal(in->sample_mask != NULL, reads_mask);
    assert_int_equal(out->sample_mask != NULL, writes_mask);
    for (int l = 0; l < GN_LANES; ++l) {
        out->color[0][l] = in->sample_mask ? (float)in->sample_mask[l] / 255.0f : 1.0f;
        for (int c = 1; c < 4; ++c)
            out->color[c][l] = 1.0f;
        if (in->sample_mask && !(in->coverage >> l & 1))
            assert_int_equal(in->sample_mask[l], 0);
        if (out->sample_mask) {
            assert_int_equal(out->sample_mask[l], UINT32_MAX);
            out->sample_mask[l] = mask_bits;
        }
    }
}

/* Draws white from x = 0 to `right` pixels, over the whole height. */
static uint64_t draw_strip(const gn_target *t, float right, gn_status wanted)
{
    static unsigned char memory[65536];
    const float x = right / (0.5f * SIDE) - 1.0f;
    const float position[6][2] = {{-1, -1}, {x, -1}, {x, 1}, {-1, -1}, {x, 1}, {-1, 1}};
    const float middle_left[12] = {-1, 0};
    const float white[4] = {1, 1, 1, strip_alpha};
    gn_color_uniforms uniforms;
    gn_pipeline pipeline;
    gn_mesh mesh;
    gn_workspace workspace;
    uint64_t passed = 0;

    memset(&pipeline, 0, sizeof pipeline);
    memset(&mesh, 0, sizeof mesh);
    memset(&workspace, 0, sizeof workspace);
    mesh.vertex_count = 6;
    mesh.count = 6;
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &uniforms), GN_OK);
    mesh.attribute[GN_ATTRIBUTE_POSITION].data = &position[0][0];
    mesh.attribute[GN_ATTRIBUTE_POSITION].components = 2;
    mesh.attribute[GN_ATTRIBUTE_COLOR].data = white;
    mesh.attribute[GN_ATTRIBUTE_COLOR].components = 4;
    mesh.attribute[GN_ATTRIBUTE_COLOR].divisor = 1;
    pipeline.samples.alpha_to_coverage = alpha_covers;
    pipeline.program.color_count = colors_written;
    pipeline.program.fragment_reads_sample_mask = reads_mask;
    pipeline.program.fragment_writes_sample_mask = writes_mask;
    if (reads_mask || writes_mask) { /* a point, because triangles would share pixels */
        pipeline.program.fragment_shader = show_masks;
        pipeline.depth.test = true;
        pipeline.raster.topology = GN_POINTS;
        pipeline.raster.point_size = 2.0f * right;
        mesh.attribute[GN_ATTRIBUTE_POSITION].data = &middle_left[0];
        mesh.count = 1;
    }
    workspace.memory = memory;
    workspace.size = sizeof memory;
    workspace.samples_passed = &passed;
    assert_int_equal(gn_draw(t, &pipeline, &mesh, &workspace), wanted);
    return passed;
}

/* Samples lie at x = 0.375, 0.875, 0.125 and 0.625 of a pixel. */
static void coverage_is_of_samples(void **state)
{
    (void)state;
    static const struct {
        float right;
        int covered[GN_SAMPLES]; /* pixels of a row */
    } cases[] = {
        {0.125f, {0, 0, 0, 0}}, {0.25f, {0, 0, 1, 0}}, {0.5f, {1, 0, 1, 0}}, {0.75f, {1, 0, 1, 1}},
        {1.0f, {1, 1, 1, 1}},   {3.5f, {4, 3, 4, 3}},  {6.0f, {6, 6, 6, 6}},
    };

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const gn_target t = sampled_target();
        uint64_t wanted = 0;

        for (int n = 0; n < GN_SAMPLES; ++n)
            wanted += (uint64_t)cases[i].covered[n] * SIDE;
        assert_int_equal(draw_strip(&t, cases[i].right, GN_OK), wanted);
        for (int n = 0; n < GN_SAMPLES; ++n) {
            for (int p = 0; p < PIXELS; ++p)
                assert_int_equal(colors[PAD + n * PIXELS + p],
                                 p % SIDE < cases[i].covered[n] ? UINT32_MAX : 0);
        }
    }
}

/* A strip to the middle of pixel 3 covers samples 0 and 2 of that pixel. */
static void masks_are_of_samples(void **state)
{
    (void)state;
    for (int what = 1; what < 6; ++what) {
        const gn_target t = sampled_target();
        uint64_t wanted = 0;

        reads_mask = what != 2 && what != 4;
        writes_mask = what != 1;
        mask_bits = what > 3 ? 0x7FFFFFF6 : 6;
        assert_int_equal(gn_clear_depth(&t.depth, 1.0f), GN_OK);
        for (int p = 0; p < SIDE; ++p) /* sample 3 of some pixels fails the depth test */
            depths[3 * PIXELS + p] = 0.25f;
        const uint64_t passed = draw_strip(&t, 3.5f, GN_OK);
        for (int n = 0; n < GN_SAMPLES; ++n) {
            for (int p = 0; p < PIXELS; ++p) {
                const uint32_t mask = p % SIDE < 3 ? 15 : p % SIDE == 3 ? 5 : 0;
                const uint32_t left = writes_mask ? mask & 6 : mask;
                const bool drawn = left >> n & 1 && !(n == 3 && p < SIDE);

                assert_int_equal(colors[PAD + n * PIXELS + p],
                                 drawn ? 0xFFFFFF00 | (reads_mask ? mask : 255) : 0);
                assert_true((depths[n * PIXELS + p] == 0.5f) == drawn);
                wanted += drawn;
            }
        }
        assert_int_equal(passed, wanted);
    }
    reads_mask = writes_mask = false;
}

/* A mask that the shader writes does not change this. */
static void one_sample_has_mask_1(void **state)
{
    (void)state;
    gn_target t;

    memset(&t, 0, sizeof t);
    memset(colors, 0, sizeof colors);
    t.color[0] = gn_surface_bottom_up(colors + PAD, GN_FORMAT_RGBA8, SIDE, SIDE);
    reads_mask = writes_mask = true;
    assert_int_equal(draw_strip(&t, 3.0f, GN_OK), 3 * SIDE);
    reads_mask = writes_mask = false;
    for (int p = 0; p < PIXELS; ++p)
        assert_int_equal(colors[PAD + p], p % SIDE < 3 ? 0xFFFFFF01 : 0);
}

/* A sample stays unless alpha is at most s / 4; with NaN all samples stay. */
static void alpha_covers_samples(void **state)
{
    (void)state;
    static const struct {
        float alpha;
        uint32_t samples;
    } cases[] = {{-1.0f, 0},  {0.0f, 0},  {0.125f, 1},  {0.25f, 1}, {0.375f, 3}, {0.5f, 3},
                 {0.625f, 7}, {0.75f, 7}, {0.875f, 15}, {1.0f, 15}, {NAN, 15},   {-NAN, 15}};

    alpha_covers = true;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const gn_target t = sampled_target();

        strip_alpha = cases[i].alpha;
        draw_strip(&t, SIDE, GN_OK);
        for (int n = 0; n < GN_SAMPLES; ++n)
            for (int p = 0; p < PIXELS; ++p)
                assert_int_equal((colors[PAD + n * PIXELS + p] & 255) != 0,
                                 cases[i].samples >> n & 1);
    }
    alpha_covers = false;
    strip_alpha = 1.0f;
}

/* The alpha is that of the first colour, whether or not the target has it. */
static void alpha_covers_samples_of_other_colors(void **state)
{
    (void)state;
    gn_target t = sampled_target();

    t.color[1] = t.color[0];
    memset(&t.color[0], 0, sizeof t.color[0]);
    alpha_covers = true;
    strip_alpha = 0.375f;
    colors_written = 2;
    assert_int_equal(draw_strip(&t, SIDE, GN_OK), 2 * PIXELS);
    alpha_covers = false;
    strip_alpha = 1.0f;
    colors_written = 0;
}

/* Without a fragment shader there is no alpha, and all samples stay. */
static void depths_alone_have_no_alpha(void **state)
{
    (void)state;
    static unsigned char memory[GN_WORKSPACE_SIZE(4, GN_SHADER_VARYINGS)];
    static const float square[8] = {-1, -1, 1, -1, -1, 1, 1, 1};
    const gn_mesh mesh = {
        .attribute = {[GN_ATTRIBUTE_POSITION] = {.data = square, .components = 2}},
        .vertex_count = 4,
        .count = 4};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_target t = sampled_target();
    gn_color_uniforms uniforms;
    gn_pipeline pipeline;

    memset(&pipeline, 0, sizeof pipeline);
    memset(&t.color[0], 0, sizeof t.color[0]);
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_depth_only(&pipeline, &uniforms), GN_OK);
    assert_int_equal(gn_clear_depth(&t.depth, 1.0f), GN_OK);
    pipeline.raster.topology = GN_TRIANGLE_STRIP;
    pipeline.depth.test = true;
    pipeline.samples.alpha_to_coverage = true;
    pipeline.samples.shading = true;
    pipeline.samples.least_shading = 1.0f;
    assert_int_equal(gn_draw(&t, &pipeline, &mesh, &workspace), GN_OK);
    for (int i = 0; i < GN_SAMPLES * PIXELS; ++i)
        assert_true(depths[i] == 0.5f);
}

/* The sample planes in any order in memory, and rows of the samples side by side. */
static void strides_of_samples_are_free(void **state)
{
    (void)state;
    gn_target t = sampled_target();

    memset(&t.depth, 0, sizeof t.depth);
    t.color[0].pixels = colors + PAD + 3 * PIXELS;
    t.color[0].sample_stride = -PIXELS * 4;
    draw_strip(&t, 0.25f, GN_OK);
    assert_int_equal(colors[PAD + 3 * PIXELS], 0);
    assert_int_equal(colors[PAD + PIXELS], UINT32_MAX);

    t = sampled_target();
    memset(&t.depth, 0, sizeof t.depth);
    t.color[0].row_stride = GN_SAMPLES * SIDE * 4;
    t.color[0].sample_stride = SIDE * 4;
    draw_strip(&t, 0.25f, GN_OK);
    for (int i = 0; i < GN_SAMPLES * PIXELS; ++i)
        assert_int_equal(colors[PAD + i], i % (GN_SAMPLES * SIDE) == 2 * SIDE ? UINT32_MAX : 0);
}

static void resolving_averages(void **state)
{
    (void)state;
    static const uint32_t red[GN_SAMPLES] = {0, 0, 40, 164};
    gn_target t = sampled_target();
    uint32_t out[PIXELS];
    float depth[PIXELS];
    gn_surface to = gn_surface_bottom_up(out, GN_FORMAT_RGBA8, SIDE, SIDE);

    for (int n = 0; n < GN_SAMPLES; ++n) {
        for (int p = 0; p < PIXELS; ++p) {
            colors[PAD + n * PIXELS + p] = red[n] | 0xFF000000;
            depths[n * PIXELS + p] = 0.125f * (float)(n + 1);
        }
    }
    assert_int_equal(gn_resolve(&to, &t.color[0]), GN_OK);
    for (int p = 0; p < PIXELS; ++p)
        assert_int_equal(out[p], 51u | 0xFF000000);
    to = gn_surface_bottom_up(depth, GN_FORMAT_D32F, SIDE, SIDE);
    assert_int_equal(gn_resolve(&to, &t.depth), GN_OK);
    for (int p = 0; p < PIXELS; ++p)
        assert_true(depth[p] == 0.125f);

    assert_int_equal(gn_resolve(NULL, &t.depth), GN_NULL_POINTER);
    assert_int_equal(gn_resolve(&to, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_resolve(&t.depth, &t.depth), GN_INVALID_SAMPLES);
    assert_int_equal(gn_resolve(&to, &t.color[0]), GN_INVALID_FORMAT);
    to.width = SIDE - 1;
    assert_int_equal(gn_resolve(&to, &t.depth), GN_SIZE_MISMATCH);
    to.width = 0;
    assert_int_equal(gn_resolve(&to, &t.depth), GN_INVALID_SIZE);
}

/* A triangle from w = 1 at x = 0.5 to `w` at its right edge, x = 8.25. 1/w falls along x; for w =
 * 32 it is 0 at the centre of pixel 8, whose sample 2 is covered. Red is 1, green falls from 1 to 0
 * and blue rises from 0 to 1, all smooth. Returns the colour of that sample. */
static void color_beyond_an_edge(gn_format format, float w, gn_backend backend, void *color)
{
    static unsigned char memory[65536];
    static uint32_t pixels[GN_SAMPLES * 16 * 16 * 4];
    const float place[3][2] = {{0.5f, 0.25f}, {8.25f, 0.25f}, {8.25f, 8.25f}};
    const float rgb[9] = {1, 1, 0, 1, 0, 1, 1, 0, 1};
    const gn_surface image = gn_surface_bottom_up(pixels, format, 16, 16);
    const size_t size = format == GN_FORMAT_RGBA32F ? 16 : format == GN_FORMAT_RGBA16 ? 8 : 4;
    float position[3][4];
    gn_color_uniforms uniforms;
    gn_pipeline pipeline;
    gn_mesh mesh;
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .backend = backend};
    gn_target t;

    memset(pixels, 0, sizeof pixels);
    memset(&t, 0, sizeof t);
    memset(&pipeline, 0, sizeof pipeline);
    memset(&mesh, 0, sizeof mesh);
    t.color[0] = gn_surface_multisampled(&image);
    for (int i = 0; i < 3; ++i) {
        const float own = i == 0 ? 1.0f : w;

        for (int n = 0; n < 2; ++n)
            position[i][n] = (place[i][n] / 8.0f - 1.0f) * own;
        position[i][2] = 0.0f;
        position[i][3] = own;
    }
    mesh.vertex_count = 3;
    mesh.count = 3;
    mesh.attribute[GN_ATTRIBUTE_POSITION].data = &position[0][0];
    mesh.attribute[GN_ATTRIBUTE_POSITION].components = 4;
    mesh.attribute[GN_ATTRIBUTE_COLOR].data = rgb;
    mesh.attribute[GN_ATTRIBUTE_COLOR].components = 3;
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &uniforms), GN_OK);
    assert_int_equal(gn_draw(&t, &pipeline, &mesh, &workspace), GN_OK);
    memcpy(color, (const char *)pixels + (size_t)(2 * 16 * 16 + 2 * 16 + 8) * size, size);
}

/* The reference's results, expected of every back end (reference/RULES.md). */
static void varyings_are_those_of_the_centre(void **state)
{
    (void)state;
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        const gn_backend backend = (gn_backend)b;
        float color[4];
        uint16_t words[4];
        uint32_t bytes;

        if (!gn_backend_available(backend))
            continue;
        /* 1/w is negative at the centre: the plane continues beyond the range of the vertices. */
        color_beyond_an_edge(GN_FORMAT_RGBA32F, 33.0f, backend, color);
        assert_true(fabsf(color[0] - 1.0f) < 1e-3f && fabsf(color[1] - 33.0f) < 1e-2f &&
                    fabsf(color[2] + 32.0f) < 1e-2f);
        color_beyond_an_edge(GN_FORMAT_RGBA8, 33.0f, backend, &bytes);
        assert_int_equal(bytes, 0xFF00FFFFu);

        /* 1/w is 0 at the centre: infinity or NaN, and what formats store for them. */
        color_beyond_an_edge(GN_FORMAT_RGBA32F, 32.0f, backend, color);
        assert_true(isnan(color[0]) && color[1] == -INFINITY && color[2] == INFINITY);
        color_beyond_an_edge(GN_FORMAT_RGBA16, 32.0f, backend, words);
        assert_true(words[0] == 0 && words[1] == 0 && words[2] == 65535 && words[3] == 0);
        color_beyond_an_edge(GN_FORMAT_RGBA8, 32.0f, backend, &bytes);
        assert_int_equal(bytes, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surfaces_and_views),
        cmocka_unit_test(faults),
        cmocka_unit_test(long_rows_do_not_overlap),
        cmocka_unit_test(clears_fill_every_sample),
        cmocka_unit_test(coverage_is_of_samples),
        cmocka_unit_test(depths_alone_have_no_alpha),
        cmocka_unit_test(strides_of_samples_are_free),
        cmocka_unit_test(resolving_averages),
        cmocka_unit_test(masks_are_of_samples),
        cmocka_unit_test(one_sample_has_mask_1),
        cmocka_unit_test(alpha_covers_samples),
        cmocka_unit_test(alpha_covers_samples_of_other_colors),
        cmocka_unit_test(varyings_are_those_of_the_centre),
    };
    return cmocka_run_group_tests_name("samples", tests, NULL, NULL);
}
