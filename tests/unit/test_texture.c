/* Textures: every fault, wrapping and filtering with cases worked by hand, coordinates that are not
 * finite, and the sampling functions that shaders receive. */
#include <math.h>
#include <string.h>

#include "unit.h"

/* Texel (x, y) of the test image is (x, y, 0, 1) in 1/255. */
enum { WIDTH = 4, HEIGHT = 3 };

static uint32_t image[WIDTH * HEIGHT];

static gn_texture test_texture(void)
{
    gn_texture t = {0};

    for (uint32_t y = 0; y < HEIGHT; ++y)
        for (uint32_t x = 0; x < WIDTH; ++x)
            image[y * WIDTH + x] = x * 10 | y * 10 << 8 | 0xFF000000u;
    t.level[0].texels = image;
    t.level[0].row_stride = WIDTH * 4;
    t.width = WIDTH;
    t.height = HEIGHT;
    t.format = GN_FORMAT_RGBA8;
    return t;
}

static void texture_faults(void **state)
{
    (void)state;
    gn_texture t = test_texture();

    assert_int_equal(gn_texture_check(&t), GN_OK);
    t.level[0].row_stride = -t.level[0].row_stride;
    assert_int_equal(gn_texture_check(&t), GN_OK);
    assert_int_equal(gn_texture_check(NULL), GN_NULL_POINTER);
    t = test_texture();
    t.level[0].texels = NULL;
    assert_int_equal(gn_texture_check(&t), GN_NULL_POINTER);
    t = test_texture();
    t.format = GN_FORMAT_S8;
    assert_int_equal(gn_texture_check(&t), GN_INVALID_FORMAT);
    t = test_texture();
    t.width = 0;
    assert_int_equal(gn_texture_check(&t), GN_INVALID_SIZE);
    t.width = GN_MAX_SIZE + 1;
    assert_int_equal(gn_texture_check(&t), GN_INVALID_SIZE);
    t = test_texture();
    t.height = 0;
    assert_int_equal(gn_texture_check(&t), GN_INVALID_SIZE);
    t = test_texture();
    t.level[0].texels = (const char *)image + 1;
    assert_int_equal(gn_texture_check(&t), GN_MISALIGNED);
    t = test_texture();
    t.level[0].row_stride = 18;
    assert_int_equal(gn_texture_check(&t), GN_MISALIGNED);
    t.level[0].row_stride = 12;
    assert_int_equal(gn_texture_check(&t), GN_INVALID_STRIDE);
}

static void sampler_faults(void **state)
{
    (void)state;
    gn_sampler s = {0};

    assert_int_equal(gn_sampler_check(&s), GN_OK);
    assert_int_equal(gn_sampler_check(NULL), GN_NULL_POINTER);
    s.wrap_s = (gn_wrap)9;
    assert_int_equal(gn_sampler_check(&s), GN_INVALID_ENUM);
    memset(&s, 0, sizeof s);
    s.wrap_t = (gn_wrap)-1;
    assert_int_equal(gn_sampler_check(&s), GN_INVALID_ENUM);
    memset(&s, 0, sizeof s);
    s.magnify = (gn_magnify)2;
    assert_int_equal(gn_sampler_check(&s), GN_INVALID_ENUM);
    memset(&s, 0, sizeof s);
    s.minify = (gn_minify)6;
    assert_int_equal(gn_sampler_check(&s), GN_INVALID_ENUM);
}

/* Red and green of lane 0, in texels of the test image. */
static void sample_one(const gn_sampler *sampler, float s, float t, float *x, float *y)
{
    const gn_texture texture = test_texture();
    float sx[GN_LANES], ty[GN_LANES];
    float texel[4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l) {
        sx[l] = s;
        ty[l] = t;
    }
    gn_sample_2d(&texture, sampler, sx, ty, texel);
    for (int l = 1; l < GN_LANES; ++l)
        assert_true(texel[0][l] == texel[0][0] && texel[1][l] == texel[1][0]);
    assert_true(fabsf(texel[3][0] - 1.0f) < 1e-6f && texel[2][0] == 0.0f);
    *x = texel[0][0] * 25.5f;
    *y = texel[1][0] * 25.5f;
}

static void nearest_repeat_and_clamp(void **state)
{
    (void)state;
    gn_sampler sampler = {0};
    float x, y;

    sampler.magnify = GN_MAGNIFY_NEAREST;
    sampler.minify = GN_MINIFY_NEAREST;
    sample_one(&sampler, 0.30f, 0.40f, &x, &y);
    assert_true(fabsf(x - 1.0f) < 1e-5f && fabsf(y - 1.0f) < 1e-5f);
    sample_one(&sampler, 1.80f, -0.10f, &x, &y);
    assert_true(fabsf(x - 3.0f) < 1e-5f && fabsf(y - 2.0f) < 1e-5f);
    sampler.wrap_s = GN_WRAP_CLAMP_TO_EDGE;
    sampler.wrap_t = GN_WRAP_CLAMP_TO_EDGE;
    sample_one(&sampler, 1.80f, -0.10f, &x, &y);
    assert_true(fabsf(x - 3.0f) < 1e-5f && fabsf(y) < 1e-5f);
}

static void linear_repeat_and_clamp(void **state)
{
    (void)state;
    gn_sampler sampler = {0};
    float x, y;

    /* Between texels 1 and 2 horizontally, on texel 1 vertically. */
    sampler.minify = GN_MINIFY_LINEAR;
    sample_one(&sampler, 0.5f, 0.5f, &x, &y);
    assert_true(fabsf(x - 1.5f) < 1e-5f && fabsf(y - 1.0f) < 1e-5f);
    /* At the seam: half texel 3, half texel 0; vertically a third of the way. */
    sample_one(&sampler, 1.0f, 1.0f, &x, &y);
    assert_true(fabsf(x - 1.5f) < 1e-5f && fabsf(y - 1.0f) < 1e-5f);
    sampler.wrap_s = GN_WRAP_CLAMP_TO_EDGE;
    sampler.wrap_t = GN_WRAP_CLAMP_TO_EDGE;
    sample_one(&sampler, 1.0f, 0.0f, &x, &y);
    assert_true(fabsf(x - 3.0f) < 1e-5f && fabsf(y) < 1e-5f);
}

/* The filters differ, and derivatives choose: half a texel per fragment magnifies, two texels
 * minify. */
static void derivatives_choose_the_filter(void **state)
{
    (void)state;
    const gn_texture texture = test_texture();
    gn_sampler sampler = {0};
    float texel[4][GN_LANES];

    sampler.magnify = GN_MAGNIFY_LINEAR;
    sampler.minify = GN_MINIFY_NEAREST;
    for (int step = 0; step < 2; ++step) {
        const float ds = step ? 2.0f / WIDTH : 0.5f / WIDTH;
        float s[GN_LANES], t[GN_LANES];

        for (int l = 0; l < GN_LANES; ++l) {
            s[l] = 0.5f + ds * (float)(l % 4);
            t[l] = 0.5f;
        }
        gn_sample_2d(&texture, &sampler, s, t, texel);
        assert_true(fabsf(texel[0][0] * 25.5f - (step ? 2.0f : 1.5f)) < 1e-5f);
    }
}

static void negative_stride_flips(void **state)
{
    (void)state;
    gn_texture texture = test_texture();
    gn_sampler sampler = {0};
    float s[GN_LANES], t[GN_LANES], texel[4][GN_LANES];

    sampler.magnify = GN_MAGNIFY_NEAREST;
    texture.level[0].texels = image + WIDTH * (HEIGHT - 1);
    texture.level[0].row_stride = -texture.level[0].row_stride;
    for (int l = 0; l < GN_LANES; ++l)
        s[l] = t[l] = 0.1f;
    gn_sample_2d(&texture, &sampler, s, t, texel);
    assert_true(fabsf(texel[1][0] * 25.5f - 2.0f) < 1e-5f);
}

/* Beyond the integers, repeated power-of-two sizes read texel 0, clamped sizes the texel that
 * RULES.md states. */
static void coordinates_beyond_the_integers(void **state)
{
    (void)state;
    const float far_away[] = {3e9f, -3e9f, 1e30f, -1e30f, INFINITY, -INFINITY};
    gn_sampler sampler = {0};
    float x, y;

    sampler.magnify = GN_MAGNIFY_NEAREST;
    sampler.minify = GN_MINIFY_NEAREST;
    for (size_t i = 0; i < sizeof far_away / sizeof *far_away; ++i) {
        sample_one(&sampler, far_away[i], 0.5f, &x, &y);
        assert_true(x == 0.0f);
    }
    sampler.magnify = GN_MAGNIFY_LINEAR;
    sampler.minify = GN_MINIFY_LINEAR;
    sample_one(&sampler, -3e9f, 0.5f, &x, &y);
    assert_true(x == 0.0f);
    sampler.wrap_s = GN_WRAP_CLAMP_TO_EDGE;
    sample_one(&sampler, -INFINITY, 0.5f, &x, &y);
    assert_true(x == 0.0f);
    sample_one(&sampler, INFINITY, 0.5f, &x, &y);
    assert_true(fabsf(x - 3.0f) < 1e-5f);
}

/* Run under the address sanitizer, this shows that nothing outside is read. */
static void hostile_coordinates_read_inside(void **state)
{
    (void)state;
    const float hostile[] = {NAN,           INFINITY,       -INFINITY,   1e30f,
                             -1e30f,        3e9f,           -3e9f,       1e-45f,
                             -1e-45f,       -0.0f,          0.99999994f, -5e-8f,
                             2147483648.0f, -2147483648.0f, 16777216.0f, 8388607.5f};
    const size_t count = sizeof hostile / sizeof *hostile;

    for (uint32_t size = 1; size <= WIDTH; ++size) {
        gn_texture texture = test_texture();
        texture.width = size;
        for (uint32_t kind = 0; kind < 24; ++kind) {
            gn_sampler sampler = {0};
            float texel[4][GN_LANES];

            sampler.wrap_s = kind & 1 ? GN_WRAP_REPEAT : GN_WRAP_CLAMP_TO_EDGE;
            sampler.wrap_t = kind & 2 ? GN_WRAP_REPEAT : GN_WRAP_CLAMP_TO_EDGE;
            sampler.magnify = kind & 4 ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR;
            sampler.minify = (gn_minify)(kind / 8);
            for (size_t i = 0; i < count; ++i) {
                float s[GN_LANES], t[GN_LANES];

                for (size_t l = 0; l < GN_LANES; ++l) {
                    s[l] = hostile[(i + l) % count];
                    t[l] = hostile[(i * l) % count];
                }
                gn_sample_2d(&texture, &sampler, s, t, texel);
            }
        }
    }
}

/* A shader that samples with both functions and counts the lanes that differ, NaN being equal to
 * NaN. Coordinates are the varyings; every fourth block has hostile ones. */
typedef struct comparison {
    gn_texture texture;
    gn_sampler sampler;
    uint32_t *lanes, *different;
} comparison;

static void pass_attributes(const void *uniforms, const gn_vertex_input *input,
                            gn_vertex_output *output)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 4; ++c)
            output->position[c][l] = input->attribute[0][c][l];
        for (int c = 0; c < 2; ++c)
            output->varying[c][l] = input->attribute[1][c][l];
    }
}

static void compare_samplers(const void *uniforms, const gn_fragment_input *input,
                             gn_fragment_output *output)
{
    static const float hostile[] = {NAN, INFINITY, -INFINITY, 3e9f, -3e9f, 0.0f, -0.0f, 1.0f};
    const comparison *u = uniforms;
    const bool is_hostile = (input->x[0] + input->y[0]) / 4 % 4 == 3;
    float s[GN_LANES], t[GN_LANES], texel[4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l) {
        s[l] = is_hostile ? hostile[l % 8] : input->varying[0][l];
        t[l] = is_hostile ? hostile[(l / 2 + input->y[0] / 4) % 8] : input->varying[1][l];
    }
    gn_sample_2d(&u->texture, &u->sampler, s, t, texel);
    input->sampling->sample_2d(&u->texture, &u->sampler, s, t, output->color);
    for (int l = 0; l < 4 * GN_LANES; ++l) {
        const float a = texel[l / GN_LANES][l % GN_LANES];
        const float b = output->color[l / GN_LANES][l % GN_LANES];
        *u->different += memcmp(&a, &b, sizeof a) != 0 && !(isnan(a) && isnan(b));
    }
    *u->lanes += GN_LANES;
}

static void compare_on(gn_backend backend, const comparison *c)
{
    static const float position[] = {-1, -1, 3, -1, -1, 3};
    static const float coordinates[] = {-1.7f, -0.6f, 5.1f, 0.3f, -1.1f, 3.2f};
    static uint32_t pixels[24 * 24];
    static char memory[16384];
    gn_target target = {0};
    gn_pipeline pipeline = {0};
    gn_mesh mesh = {0};
    gn_workspace workspace = {0};

    target.color[0] = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, 24, 24);
    pipeline.program.vertex_shader = pass_attributes;
    pipeline.program.fragment_shader = compare_samplers;
    pipeline.program.uniforms = c;
    pipeline.program.varying_count = 2;
    mesh.attribute[0].data = position;
    mesh.attribute[0].components = 2;
    mesh.attribute[1].data = coordinates;
    mesh.attribute[1].components = 2;
    mesh.vertex_count = mesh.count = 3;
    workspace.memory = memory;
    workspace.size = sizeof memory;
    workspace.backend = backend;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
}

/* The function that shaders receive equals gn_sample_2d, for every kind of texture and sampler:
 * sizes that are powers of two and others, texels of both formats, rows upside down, and rows whose
 * distance in texels exceeds 16 bits. */
static void shaders_sample_the_same(void **state)
{
    (void)state;
    enum { ROWS = 8, FAR = 70000 };
    static float texels[ROWS * FAR];
    static const uint32_t sizes[][2] = {{8, 4}, {7, 5}, {1, 8}, {16, 3}};
    uint32_t random = 1;

    for (size_t i = 0; i < sizeof texels / sizeof *texels; ++i) {
        random = random * 1664525u + 1013904223u;
        texels[i] = (float)(random >> 8) / 16777216.0f;
    }
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        if (!gn_backend_available((gn_backend)b))
            continue;
        for (uint32_t kind = 0; kind < 24 * 4 * 6; ++kind) {
            const uint32_t shape = kind / 24 % 4;
            const uint32_t layout = kind / 96;
            uint32_t lanes = 0, different = 0;
            comparison c;

            memset(&c, 0, sizeof c);
            c.lanes = &lanes;
            c.different = &different;
            c.sampler.wrap_s = kind & 1 ? GN_WRAP_REPEAT : GN_WRAP_CLAMP_TO_EDGE;
            c.sampler.wrap_t = kind & 2 ? GN_WRAP_REPEAT : GN_WRAP_CLAMP_TO_EDGE;
            c.sampler.magnify = kind & 4 ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR;
            c.sampler.minify = (gn_minify)(kind % 24 / 8);
            c.texture.format = layout & 1 ? GN_FORMAT_RGBA32F : GN_FORMAT_RGBA8;
            c.texture.width = sizes[shape][0];
            c.texture.height = sizes[shape][1];
            c.texture.level[0].row_stride = (layout < 4 ? 100 : FAR) * (ptrdiff_t)sizeof(float);
            c.texture.level[0].texels = texels;
            if (layout / 2 == 1) {
                c.texture.level[0].texels = texels + (c.texture.height - 1) * 100;
                c.texture.level[0].row_stride = -c.texture.level[0].row_stride;
            }
            assert_int_equal(gn_texture_check(&c.texture), GN_OK);
            compare_on((gn_backend)b, &c);
            if (lanes < 24 * 24 || different > 0)
                fail_msg("%s, kind %u: %u lanes, %u channels differ",
                         gn_backend_name((gn_backend)b), kind, lanes, different);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texture_faults),
        cmocka_unit_test(sampler_faults),
        cmocka_unit_test(nearest_repeat_and_clamp),
        cmocka_unit_test(linear_repeat_and_clamp),
        cmocka_unit_test(derivatives_choose_the_filter),
        cmocka_unit_test(negative_stride_flips),
        cmocka_unit_test(coordinates_beyond_the_integers),
        cmocka_unit_test(hostile_coordinates_read_inside),
        cmocka_unit_test(shaders_sample_the_same),
    };
    return cmocka_run_group_tests_name("texture", tests, NULL, NULL);
}
