/* Sampling: every fault of a sampler as status and text; wraps, borders, gathers, levels and the
 * sources of the level of detail, with cases worked by hand; one place compared with sixteen. */
#include <math.h>
#include <string.h>

#include "unit.h"

/* Texel (x, y) of the image is (x, y, 0, 1) in 1/255, eight columns and two rows. */
enum { WIDTH = 8, HEIGHT = 2, LEVELS = 4 };

static uint32_t image[WIDTH * HEIGHT];

static gn_texture columns(void)
{
    gn_texture t;

    memset(&t, 0, sizeof t);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; ++i)
        image[i] = i % WIDTH | i / WIDTH << 8 | 0xFF000000u;
    t.format = GN_FORMAT_RGBA8;
    t.width = WIDTH;
    t.height = HEIGHT;
    t.level[0].texels = image;
    t.level[0].row_stride = WIDTH * 4;
    return t;
}

/* All texels of level n have red n/255. */
static gn_texture levels(void)
{
    static uint32_t texels[LEVELS][WIDTH * WIDTH];
    gn_texture t;

    memset(&t, 0, sizeof t);
    t.format = GN_FORMAT_RGBA8;
    t.width = t.height = WIDTH;
    t.level_count = LEVELS;
    for (uint32_t n = 0; n < LEVELS; ++n) {
        for (int i = 0; i < WIDTH * WIDTH; ++i)
            texels[n][i] = n | 0xFF000000u;
        t.level[n].texels = texels[n];
        t.level[n].row_stride = (ptrdiff_t)(WIDTH >> n) * 4;
    }
    return t;
}

static gn_sampler nearest(gn_wrap wrap)
{
    gn_sampler s;

    memset(&s, 0, sizeof s);
    s.wrap_s = s.wrap_t = s.wrap_r = wrap;
    s.magnify = GN_MAGNIFY_NEAREST;
    s.minify = GN_MINIFY_NEAREST;
    return s;
}

static void expect_fault(const gn_sampler *s, gn_status status, const char *word)
{
    const char *const text = gn_sampler_fault(s);

    assert_int_equal(gn_sampler_check(s), status);
    assert_non_null(text);
    assert_non_null(strstr(text, word));
}

static void faults(void **state)
{
    (void)state;
    const gn_sampler good = nearest(GN_WRAP_MIRROR_CLAMP_TO_EDGE);
    gn_sampler s = good;

    assert_int_equal(gn_sampler_check(&s), GN_OK);
    assert_null(gn_sampler_fault(&s));
    expect_fault(NULL, GN_NULL_POINTER, "null");
    s.wrap_s = (gn_wrap)5;
    expect_fault(&s, GN_INVALID_ENUM, "wrap_s");
    s = good;
    s.wrap_t = (gn_wrap)-1;
    expect_fault(&s, GN_INVALID_ENUM, "wrap_t");
    s = good;
    s.wrap_r = (gn_wrap)5;
    expect_fault(&s, GN_INVALID_ENUM, "wrap_r");
    s = good;
    s.magnify = (gn_magnify)2;
    expect_fault(&s, GN_INVALID_ENUM, "magnify");
    s = good;
    s.minify = (gn_minify)6;
    expect_fault(&s, GN_INVALID_ENUM, "minify");
    s = good;
    s.compare = (gn_compare)9;
    expect_fault(&s, GN_INVALID_ENUM, "compare");
    s = good;
    s.lod_bias = INFINITY;
    expect_fault(&s, GN_NOT_FINITE, "lod_bias");
    s = good;
    s.min_lod = NAN;
    assert_int_equal(gn_sampler_check(&s), GN_OK);
    s.lod_clamped = true;
    expect_fault(&s, GN_NOT_FINITE, "min_lod");
    s.min_lod = 0.0f;
    s.max_lod = -INFINITY;
    expect_fault(&s, GN_NOT_FINITE, "max_lod");
    s.max_lod = -1.0f;
    expect_fault(&s, GN_OUT_OF_RANGE, "min_lod");
    s = good;
    s.max_anisotropy = GN_MAX_ANISOTROPY;
    assert_int_equal(gn_sampler_check(&s), GN_OK);
    s.max_anisotropy = GN_MAX_ANISOTROPY + 1;
    expect_fault(&s, GN_OUT_OF_RANGE, "max_anisotropy");
    s = good;
    s.border[3] = NAN;
    expect_fault(&s, GN_NOT_FINITE, "border");
    s.border[3] = INFINITY;
    assert_int_equal(gn_sampler_check(&s), GN_OK);
}

/* Red in 1/255 at (s, 0.25), looked up at one place and at sixteen. */
static float red_at(const gn_texture *t, const gn_sampler *sampler, float s, float lod)
{
    const float at[3] = {s, 0.25f, 0.0f};
    float x[GN_LANES], y[GN_LANES], lods[GN_LANES], one[4], block[4][GN_LANES];
    gn_lookup lookup;

    memset(&lookup, 0, sizeof lookup);
    lookup.coordinate[0] = x;
    lookup.coordinate[1] = y;
    lookup.lod_source = GN_LOD_EXPLICIT;
    lookup.lod = lods;
    for (int l = 0; l < GN_LANES; ++l) {
        x[l] = s;
        y[l] = 0.25f;
        lods[l] = lod;
    }
    assert_int_equal(gn_texture_check(t), GN_OK);
    assert_int_equal(gn_sampler_check(sampler), GN_OK);
    gn_sample_at(t, sampler, at, lod, 0.0f, one);
    gn_sample(t, sampler, &lookup, block);
    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 4; ++c)
            assert_memory_equal(&block[c][l], &one[c], sizeof one[c]);
    return one[0] * 255.0f;
}

#define NEAR(a, b) assert_true(fabsf((a) - (b)) < 1e-4f)

/* Columns by the nearest filter at -1.3, -0.2, 0.3, 1.2, 2.2: texels -10.4, -1.6, 2.4, 9.6, 17.6.
 */
static void wraps(void **state)
{
    (void)state;
    static const float at[5] = {-1.3f, -0.2f, 0.3f, 1.2f, 2.2f};
    static const float expected[5][5] = {{5, 6, 2, 1, 1},     /* repeat */
                                         {0, 0, 2, 7, 7},     /* clamp to edge */
                                         {5, 1, 2, 6, 1},     /* mirrored */
                                         {99, 99, 2, 99, 99}, /* border */
                                         {7, 1, 2, 7, 7}};    /* mirrored once */
    const gn_texture t = columns();

    for (int wrap = 0; wrap < 5; ++wrap) {
        gn_sampler s = nearest((gn_wrap)wrap);

        s.border[0] = 99.0f / 255.0f;
        for (int i = 0; i < 5; ++i)
            NEAR(red_at(&t, &s, at[i], 0.0f), expected[wrap][i]);
    }
}

/* Columns by the linear filter at -0.3, -0.05, 0.3, 1.05, 1.3: s * 8 - 0.5 is -2.9, -0.9, 1.9, 7.9,
 * 9.9. */
static void linear_wraps(void **state)
{
    (void)state;
    static const float at[5] = {-0.3f, -0.05f, 0.3f, 1.05f, 1.3f};
    static const float expected[5][5] = {{5.1f, 6.3f, 1.9f, 0.7f, 1.9f},     /* repeat */
                                         {0.0f, 0.0f, 1.9f, 7.0f, 7.0f},     /* clamp to edge */
                                         {1.9f, 0.0f, 1.9f, 7.0f, 5.1f},     /* mirrored */
                                         {99.0f, 89.1f, 1.9f, 89.8f, 99.0f}, /* border */
                                         {1.9f, 0.0f, 1.9f, 7.0f, 7.0f}};    /* mirrored once */
    const gn_texture t = columns();

    for (int wrap = 0; wrap < 5; ++wrap) {
        gn_sampler s = nearest((gn_wrap)wrap);

        s.magnify = GN_MAGNIFY_LINEAR;
        s.minify = GN_MINIFY_LINEAR;
        s.border[0] = 99.0f / 255.0f;
        s.wrap_t = GN_WRAP_CLAMP_TO_EDGE;
        for (int i = 0; i < 5; ++i)
            NEAR(red_at(&t, &s, at[i], 0.0f), expected[wrap][i]);
    }
}

/* The border is clamped for a normalized format; at the edge half of it is mixed in. */
static void borders(void **state)
{
    (void)state;
    const gn_texture t = columns();
    gn_sampler s = nearest(GN_WRAP_CLAMP_TO_BORDER);

    s.wrap_t = GN_WRAP_REPEAT;
    s.border[0] = 2.0f;
    NEAR(red_at(&t, &s, -1.0f, 0.0f), 255.0f);
    s.border[0] = -2.0f;
    NEAR(red_at(&t, &s, 9.0f, 0.0f), 0.0f);
    s.border[0] = 1.0f;
    s.magnify = GN_MAGNIFY_LINEAR;
    s.minify = GN_MINIFY_LINEAR;
    NEAR(red_at(&t, &s, 0.0f, 0.0f), 127.5f);
    NEAR(red_at(&t, &s, 1.0f, 0.0f), 0.5f * (7.0f + 255.0f));
    NEAR(red_at(&t, &s, 0.5f, 0.0f), 3.5f);
}

/* Floats without sign have no border below 0, and no upper limit. */
static void borders_of_unsigned_floats(void **state)
{
    (void)state;
    gn_texture t = columns();
    gn_sampler s = nearest(GN_WRAP_CLAMP_TO_BORDER);

    t.format = GN_FORMAT_R11F_G11F_B10F;
    s.border[0] = 3.0f;
    NEAR(red_at(&t, &s, -1.0f, 0.0f), 3.0f * 255.0f);
    s.border[0] = -2.0f;
    NEAR(red_at(&t, &s, -1.0f, 0.0f), 0.0f);
    t.format = GN_FORMAT_RG16F;
    NEAR(red_at(&t, &s, -1.0f, 0.0f), -2.0f * 255.0f);
}

static void explicit_levels(void **state)
{
    (void)state;
    const gn_texture t = levels();
    gn_sampler s = nearest(GN_WRAP_REPEAT);

    NEAR(red_at(&t, &s, 0.3f, 2.0f), 0.0f); /* the filter has no levels */
    s.minify = GN_MINIFY_NEAREST_MIPMAP_NEAREST;
    NEAR(red_at(&t, &s, 0.3f, -5.0f), 0.0f);
    NEAR(red_at(&t, &s, 0.3f, 1.4f), 1.0f);
    NEAR(red_at(&t, &s, 0.3f, 1.6f), 2.0f);
    NEAR(red_at(&t, &s, 0.3f, 50.0f), 3.0f);
    s.minify = GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    NEAR(red_at(&t, &s, 0.3f, 1.25f), 1.25f);
    NEAR(red_at(&t, &s, 0.3f, 2.75f), 2.75f);
    NEAR(red_at(&t, &s, 0.3f, 3.75f), 3.0f);
    s.lod_bias = 0.5f;
    NEAR(red_at(&t, &s, 0.3f, 1.25f), 1.75f);
    s.lod_bias = 0.5f + 1.0f / 1024.0f; /* biases are multiples of 1/256 */
    NEAR(red_at(&t, &s, 0.3f, 1.25f), 1.75f);
    s.lod_bias = 0.0f;
    s.lod_clamped = true;
    s.min_lod = 0.75f;
    s.max_lod = 1.5f;
    NEAR(red_at(&t, &s, 0.3f, 0.0f), 0.75f);
    NEAR(red_at(&t, &s, 0.3f, 3.0f), 1.5f);
    s.min_lod = s.max_lod = 2.25f;
    NEAR(red_at(&t, &s, 0.3f, 0.0f), 2.25f);
}

/* For the largest texture a limit between its last two levels has an effect. */
static void limits_of_the_last_levels(void **state)
{
    (void)state;
    static float texels[2 * GN_MAX_SIZE - 1];
    gn_sampler s = nearest(GN_WRAP_CLAMP_TO_EDGE);
    size_t used = 0;
    gn_texture t;

    for (int n = 0; n < GN_MAX_LEVELS; ++n)
        for (int i = 0; i < GN_MAX_SIZE >> n; ++i)
            texels[used++] = (float)n;
    assert_int_equal(gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_R32F, GN_MAX_SIZE, 1, 0,
                                       GN_MAX_LEVELS, texels, &t),
                     GN_OK);
    s.minify = GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    s.lod_clamped = true;
    s.max_lod = 13.5f;
    NEAR(red_at(&t, &s, 0.5f, 20.0f), 13.5f * 255.0f);
    s.max_lod = 14.0f;
    NEAR(red_at(&t, &s, 0.5f, 20.0f), 14.0f * 255.0f);
}

/* Halfway between two levels, the nearest one is the even one if a limit counts, otherwise the
 * larger number (reference/RULES.md, Level of detail). Limits from the number of levels on do not
 * count. */
static void upper_limits_that_count(void **state)
{
    (void)state;
    static const struct {
        float most;
        int level;
    } cases[] = {{13.5f, 0}, {14.0f, 0}, {14.5f, 0}, {15.0f, 1}, {1000.0f, 1}};
    const gn_texture t = levels();
    gn_sampler s = nearest(GN_WRAP_REPEAT);
    float at[GN_LANES], texel[4][GN_LANES];
    gn_lookup lookup;

    memset(&lookup, 0, sizeof lookup);
    for (int l = 0; l < GN_LANES; ++l)
        at[l] = (float)(l % 4) / WIDTH; /* a texel along s and t: a half level */
    lookup.coordinate[0] = lookup.coordinate[1] = at;
    s.minify = GN_MINIFY_NEAREST_MIPMAP_NEAREST;
    s.lod_clamped = true;
    s.min_lod = -1000.0f;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        s.max_lod = cases[i].most;
        gn_sample(&t, &s, &lookup, texel);
        NEAR(texel[0][5] * 255.0f, (float)cases[i].level);
    }
}

/* A level of detail of either zero mixes with a weight of +0, which turns a texel of -0 into +0
 * if the next level is larger. */
static void levels_of_either_zero(void **state)
{
    (void)state;
    static const float zeros[4] = {-0.0f, -0.0f, -0.0f, -0.0f}, ones[4] = {1, 1, 1, 1};
    static float texels[2][4][4];
    gn_sampler s = nearest(GN_WRAP_REPEAT);
    float at[GN_LANES], lod[GN_LANES], texel[4][GN_LANES];
    gn_lookup lookup;
    gn_texture t;

    memset(&t, 0, sizeof t);
    memset(&lookup, 0, sizeof lookup);
    t.format = GN_FORMAT_RGBA32F;
    t.width = t.height = 2;
    t.level_count = 2;
    for (int i = 0; i < 4; ++i) {
        memcpy(texels[0][i], zeros, sizeof zeros);
        memcpy(texels[1][i], ones, sizeof ones);
    }
    for (int n = 0; n < 2; ++n) {
        t.level[n].texels = texels[n];
        t.level[n].row_stride = (2 >> n) * (ptrdiff_t)sizeof zeros;
    }
    for (int l = 0; l < GN_LANES; ++l) {
        at[l] = 0.25f;
        lod[l] = l % 4 == 0 ? -0.0f : l % 4 == 2 ? 0.0f : 0.5f; /* every quad mixes */
    }
    lookup.coordinate[0] = lookup.coordinate[1] = at;
    lookup.lod_source = GN_LOD_EXPLICIT;
    lookup.lod = lod;
    s.minify = GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    gn_sample(&t, &s, &lookup, texel);
    for (int l = 0; l < GN_LANES; ++l) {
        assert_true(texel[0][l] == (l % 2 ? 0.5f : 0.0f));
        assert_false(signbit(texel[0][l]));
    }
}

/* A texture of one level has no filter between levels, which would turn infinite texels into NaN,
 * even if lanes of a quad need different filters. */
static void one_level_is_not_mixed(void **state)
{
    (void)state;
    static const float texels[2][4] = {{1.0f}, {INFINITY}};
    gn_sampler s = nearest(GN_WRAP_CLAMP_TO_EDGE);
    gn_texture t;

    memset(&t, 0, sizeof t);
    t.target = GN_TEXTURE_1D;
    t.format = GN_FORMAT_RGBA32F;
    t.width = 2;
    t.height = 1;
    t.level[0].texels = texels;
    t.level[0].row_stride = sizeof texels;
    s.minify = GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    assert_true(red_at(&t, &s, 0.5f, 1.5f) == INFINITY);
}

/* Steps of 2 and 4 texels ask for levels 1 and 2, from differences and from gradients; the shader's
 * bias is added. */
static void levels_of_footprints(void **state)
{
    (void)state;
    const gn_texture t = levels();
    gn_sampler s = nearest(GN_WRAP_REPEAT);
    float at[2][GN_LANES], dx[2][GN_LANES], dy[2][GN_LANES], bias[GN_LANES], texel[4][GN_LANES];
    gn_lookup lookup;

    s.minify = GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    for (int level = 1; level <= 2; ++level) {
        const float step = (float)(1 << level) / WIDTH;

        memset(&lookup, 0, sizeof lookup);
        for (int l = 0; l < GN_LANES; ++l) {
            at[0][l] = step * (float)(l % 4);
            at[1][l] = 0.5f * step * (float)(l / 4);
            dx[0][l] = 0.0f;
            dx[1][l] = -0.5f * step;
            dy[0][l] = step;
            dy[1][l] = 0.0f;
            bias[l] = 0.5f;
        }
        lookup.coordinate[0] = at[0];
        lookup.coordinate[1] = at[1];
        gn_sample(&t, &s, &lookup, texel);
        NEAR(texel[0][5] * 255.0f, (float)level);
        lookup.lod = bias;
        gn_sample(&t, &s, &lookup, texel);
        NEAR(texel[0][5] * 255.0f, (float)level + 0.5f);
        lookup.lod_source = GN_LOD_GRADIENTS;
        for (int n = 0; n < 2; ++n) {
            lookup.gradient_x[n] = dx[n];
            lookup.gradient_y[n] = dy[n];
        }
        gn_sample(&t, &s, &lookup, texel);
        NEAR(texel[0][5] * 255.0f, (float)level);
    }
}

/* In one dimension the nearest level is the second for steps of sqrt 2 texels and more. */
static void nearest_levels_of_one_dimension(void **state)
{
    (void)state;
    static const float texels[7] = {0, 0, 0, 0, 1, 1, 2};
    gn_sampler s = nearest(GN_WRAP_REPEAT);
    float at[GN_LANES], texel[4][GN_LANES];
    gn_lookup lookup;
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_R32F, 4, 1, 0, 3, texels, &t),
                     GN_OK);
    s.minify = GN_MINIFY_NEAREST_MIPMAP_NEAREST;
    memset(&lookup, 0, sizeof lookup);
    lookup.coordinate[0] = at;
    for (int i = 0; i < 2; ++i) {
        for (int l = 0; l < GN_LANES; ++l)
            at[l] = (i ? 1.42f : 1.41f) * 0.25f * (float)(l % 2);
        gn_sample(&t, &s, &lookup, texel);
        NEAR(texel[0][0], (float)i);
    }
}

/* Around (0.5, 0.5) are columns 3 and 4, rows 0 and 1, in the order from the upper left round. */
static void gathers(void **state)
{
    (void)state;
    static const float columns_found[4] = {3, 4, 4, 3}, rows_found[4] = {1, 1, 0, 0};
    const gn_texture t = columns();
    const gn_sampler s = nearest(GN_WRAP_CLAMP_TO_EDGE);
    float half[GN_LANES], texel[4][GN_LANES];
    gn_lookup lookup;

    memset(&lookup, 0, sizeof lookup);
    lookup.coordinate[0] = lookup.coordinate[1] = half;
    for (int l = 0; l < GN_LANES; ++l)
        half[l] = 0.5f;
    gn_gather(&t, &s, &lookup, 0, texel);
    for (int i = 0; i < 4; ++i)
        NEAR(texel[i][7] * 255.0f, columns_found[i]);
    gn_gather(&t, &s, &lookup, 1, texel);
    for (int i = 0; i < 4; ++i)
        NEAR(texel[i][7] * 255.0f, rows_found[i]);
    gn_gather(&t, &s, &lookup, 3, texel);
    for (int i = 0; i < 4; ++i)
        NEAR(texel[i][7], 1.0f);
}

/* For every coordinate a nearest filter returns a column of the texture or the border. */
static void no_coordinate_is_outside(void **state)
{
    (void)state;
    static const float far[] = {1e30f,     -1e30f, 3e9f,  -3e9f, INFINITY,
                                -INFINITY, NAN,    -0.0f, 1e-30f};
    const gn_texture t = columns();

    for (int wrap = 0; wrap < 5; ++wrap) {
        gn_sampler s = nearest((gn_wrap)wrap);

        s.border[0] = 99.0f / 255.0f;
        for (size_t i = 0; i < sizeof far / sizeof *far; ++i) {
            const float red = red_at(&t, &s, far[i], 0.0f);

            assert_true(fabsf(red - roundf(red)) < 1e-4f);
            assert_true((red >= 0.0f && red < WIDTH) ||
                        (wrap == GN_WRAP_CLAMP_TO_BORDER && fabsf(red - 99.0f) < 1e-4f));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults),
        cmocka_unit_test(wraps),
        cmocka_unit_test(linear_wraps),
        cmocka_unit_test(borders),
        cmocka_unit_test(borders_of_unsigned_floats),
        cmocka_unit_test(explicit_levels),
        cmocka_unit_test(limits_of_the_last_levels),
        cmocka_unit_test(upper_limits_that_count),
        cmocka_unit_test(levels_of_either_zero),
        cmocka_unit_test(one_level_is_not_mixed),
        cmocka_unit_test(levels_of_footprints),
        cmocka_unit_test(nearest_levels_of_one_dimension),
        cmocka_unit_test(gathers),
        cmocka_unit_test(no_coordinate_is_outside),
    };
    return cmocka_run_group_tests_name("sampling", tests, NULL, NULL);
}
