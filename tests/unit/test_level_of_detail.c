/* Levels of detail and anisotropic lookups, with cases worked by hand: levels from a number, from
 * differences and from gradients, their bias and limits, mixtures of levels; the number of
 * anisotropic samples, their level and places; and what takes one sample, which equals a lookup
 * without anisotropy. */
#include <math.h>

#include "lookups.h"

enum { SIZE = 16, LEVELS = 5, LAYERS = 6 };

/* Level n has green n/255; red is the column, blue the row, alpha the layer, all in 1/255. */
static uint32_t image[LEVELS][LAYERS * SIZE * SIZE];

static gn_texture numbered(gn_texture_target target)
{
    gn_texture t = {.target = target,
                    .format = GN_FORMAT_RGBA8,
                    .width = SIZE,
                    .height = target == GN_TEXTURE_1D ? 1 : SIZE,
                    .depth = target == GN_TEXTURE_3D ? 4 : LAYERS,
                    .level_count = LEVELS};

    for (uint32_t n = 0; n < LEVELS; ++n) {
        const uint32_t size = SIZE >> n;

        for (uint32_t i = 0; i < LAYERS * size * size; ++i)
            image[n][i] = i % size | n << 8 | i / size % size << 16 | i / (size * size) << 24;
        t.level[n].texels = image[n];
        t.level[n].row_stride = (ptrdiff_t)size * 4;
        t.level[n].layer_stride = (ptrdiff_t)(size * size) * 4;
    }
    return t;
}

static gn_sampler nearest(gn_minify minify)
{
    return sampler_of(GN_WRAP_REPEAT, GN_MAGNIFY_NEAREST, minify);
}

#define NEAR(a, b) assert_float_equal(a, (b), 1e-4f)

static void explicit_levels(void **state)
{
    static const struct {
        gn_minify minify;
        float lod, bias, limits[2], expected;
    } cases[] = {
        {GN_MINIFY_NEAREST, 2, 0, {0}, 0}, /* the filter has no levels */
        {GN_MINIFY_NEAREST_MIPMAP_NEAREST, -5, 0, {0}, 0},
        {GN_MINIFY_NEAREST_MIPMAP_NEAREST, 1.4f, 0, {0}, 1},
        {GN_MINIFY_NEAREST_MIPMAP_NEAREST, 1.6f, 0, {0}, 2},
        {GN_MINIFY_NEAREST_MIPMAP_NEAREST, 50, 0, {0}, 4},
        {GN_MINIFY_NEAREST_MIPMAP_LINEAR, 1.25f, 0, {0}, 1.25f},
        {GN_MINIFY_NEAREST_MIPMAP_LINEAR, 2.75f, 0, {0}, 2.75f},
        {GN_MINIFY_NEAREST_MIPMAP_LINEAR, 4.75f, 0, {0}, 4},
        {GN_MINIFY_NEAREST_MIPMAP_LINEAR, 1.25f, 0.5f, {0}, 1.75f},
        /* biases are multiples of 1/256 */
        {GN_MINIFY_NEAREST_MIPMAP_LINEAR, 1.25f, 0.5f + 1 / 1024.0f, {0}, 1.75f},
        {GN_MINIFY_NEAREST_MIPMAP_LINEAR, 0, 0, {0.75f, 1.5f}, 0.75f},
        {GN_MINIFY_NEAREST_MIPMAP_LINEAR, 3, 0, {0.75f, 1.5f}, 1.5f},
        {GN_MINIFY_NEAREST_MIPMAP_LINEAR, 0, 0, {2.25f, 2.25f}, 2.25f},
    };
    const gn_texture t = numbered(GN_TEXTURE_2D);

    for (size_t i = 0; i < COUNT(cases); ++i) {
        gn_sampler s = nearest(cases[i].minify);
        places p = places_at(0.3f, 0.25f, 0);
        float sixteen[4], one[4];

        s.lod_bias = cases[i].bias;
        s.min_lod = cases[i].limits[0];
        s.max_lod = cases[i].limits[1];
        s.lod_clamp_enabled = s.max_lod > 0;
        set_lanes(p.lod, cases[i].lod);
        lookup_each(&t, &s, &p, GN_LOD_EXPLICIT, sixteen);
        gn_texture_lookup_at(&t, &s, (const float[]){0.3f, 0.25f, 0}, cases[i].lod, 0, one);
        assert_memory_equal(one, sixteen, sizeof one);
        NEAR(one[1] * 255.0f, cases[i].expected);
    }
}

/* For the largest texture a limit between its last two levels has an effect. */
static void limits_of_the_last_levels(void **state)
{
    static float texels[2 * GN_MAX_SIZE - 1];
    gn_sampler s = nearest(GN_MINIFY_NEAREST_MIPMAP_LINEAR);
    size_t used = 0;

    for (int n = 0; n < GN_MAX_LEVELS; ++n)
        for (int i = 0; i < GN_MAX_SIZE >> n; ++i)
            texels[used++] = (float)n;
    const gn_texture t =
        texture_of(GN_TEXTURE_1D, GN_FORMAT_R32F, GN_MAX_SIZE, 1, 1, GN_MAX_LEVELS, texels);
    s.lod_clamp_enabled = true;
    for (s.max_lod = 13.5f; s.max_lod < 14.5f; s.max_lod += 0.5f) {
        float texel[4];

        gn_texture_lookup_at(&t, &s, (const float[]){0.5f, 0, 0}, 20, 0, texel);
        NEAR(texel[0], s.max_lod);
    }
}

/* Halfway between two levels, the nearest one is the even one if a limit counts, otherwise the
 * larger number (reference/RULES.md, Level of detail). Limits from the number of levels on do not
 * count. */
static void upper_limits_that_count(void **state)
{
    static const float limits[] = {13.5f, 14.0f, 14.5f, 15.0f, 1000.0f};
    const gn_texture t = numbered(GN_TEXTURE_2D);
    gn_sampler s = nearest(GN_MINIFY_NEAREST_MIPMAP_NEAREST);
    places p = places_at(0, 0, 0);
    const gn_lookup lookup = lookup_of(&p, GN_LOD_IMPLICIT);
    float texel[4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l) /* a texel along s and t: a half level */
        p.at[0][l] = p.at[1][l] = (float)(l % 4) / SIZE;
    s.lod_clamp_enabled = true;
    s.min_lod = -1000;
    for (size_t i = 0; i < COUNT(limits); ++i) {
        s.max_lod = limits[i];
        gn_texture_lookup(&t, &s, &lookup, texel);
        NEAR(texel[1][5] * 255.0f, limits[i] < 15 ? 0.0f : 1.0f);
    }
}

/* A level of detail of either zero mixes with a weight of +0, which turns a texel of -0 into +0 if
 * the next level is larger. */
static void levels_of_either_zero(void **state)
{
    static const float texels[5][4] = {{-0.0f, -0.0f, -0.0f, -0.0f},
                                       {-0.0f, -0.0f, -0.0f, -0.0f},
                                       {-0.0f, -0.0f, -0.0f, -0.0f},
                                       {-0.0f, -0.0f, -0.0f, -0.0f},
                                       {1, 1, 1, 1}};
    const gn_texture t = texture_of(GN_TEXTURE_2D, GN_FORMAT_RGBA32F, 2, 2, 1, 2, texels);
    const gn_sampler s = nearest(GN_MINIFY_NEAREST_MIPMAP_LINEAR);
    places p = places_at(0.25f, 0.25f, 0);
    const gn_lookup lookup = lookup_of(&p, GN_LOD_EXPLICIT);
    float texel[4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l)
        p.lod[l] = l % 4 == 0 ? -0.0f : l % 4 == 2 ? 0.0f : 0.5f; /* every quad mixes */
    gn_texture_lookup(&t, &s, &lookup, texel);
    for (int l = 0; l < GN_LANES; ++l)
        assert_true(texel[0][l] == (l % 2 ? 0.5f : 0.0f) && !signbit(texel[0][l]));
}

/* A texture of one level has no filter between levels, which would turn infinite texels into NaN,
 * even if lanes of a quad need different filters. */
static void one_level_is_not_mixed(void **state)
{
    static const float texels[2][4] = {{1}, {INFINITY}};
    const gn_texture t = texture_of(GN_TEXTURE_1D, GN_FORMAT_RGBA32F, 2, 1, 1, 1, texels);
    const gn_sampler s =
        sampler_of(GN_WRAP_CLAMP_TO_EDGE, GN_MAGNIFY_NEAREST, GN_MINIFY_LINEAR_MIPMAP_LINEAR);
    places p = places_at(0.5f, 0, 0);
    float texel[4];

    set_lanes(p.lod, 1.5f);
    lookup_each(&t, &s, &p, GN_LOD_EXPLICIT, texel);
    assert_true(texel[0] == INFINITY);
}

/* Steps of 2 and 4 texels ask for levels 1 and 2, from differences and from gradients; the shader's
 * bias is added. Steps of half a texel magnify, with another filter. In one dimension the nearest
 * level is the second for steps of sqrt 2 texels and more. */
static void levels_of_footprints(void **state)
{
    static const float line[7] = {0, 0, 0, 0, 1, 1, 2};
    const gn_texture t = numbered(GN_TEXTURE_2D);
    const gn_texture one = texture_of(GN_TEXTURE_1D, GN_FORMAT_R32F, 4, 1, 1, 3, line);
    gn_sampler s = nearest(GN_MINIFY_NEAREST_MIPMAP_LINEAR);
    places p = places_at(0, 0, 0);
    gn_lookup lookup;
    float texel[4][GN_LANES];

    set_lanes(p.lod, 0.5f);
    for (int level = 1; level <= 2; ++level) {
        const float step = (float)(1 << level) / SIZE;

        for (int l = 0; l < GN_LANES; ++l) {
            p.at[0][l] = step * (float)(l % 4);
            p.at[1][l] = 0.5f * step * (float)(l / 4);
        }
        set_lanes(p.x[1], -0.5f * step);
        set_lanes(p.y[0], step);
        lookup = lookup_of(&p, GN_LOD_IMPLICIT);
        gn_texture_lookup(&t, &s, &lookup, texel);
        NEAR(texel[1][5] * 255.0f, (float)level);
        lookup.lod = p.lod;
        gn_texture_lookup(&t, &s, &lookup, texel);
        NEAR(texel[1][5] * 255.0f, (float)level + 0.5f);
        lookup = lookup_of(&p, GN_LOD_GRADIENTS);
        gn_texture_lookup(&t, &s, &lookup, texel);
        NEAR(texel[1][5] * 255.0f, (float)level);
    }
    s.magnify = GN_MAGNIFY_LINEAR;
    s.minify = GN_MINIFY_NEAREST;
    for (int minified = 0; minified < 2; ++minified) {
        for (int l = 0; l < GN_LANES; ++l) {
            p.at[0][l] = 0.5f + (minified ? 2.0f : 0.5f) / SIZE * (float)(l % 4);
            p.at[1][l] = 0.5f;
        }
        gn_texture_lookup_2d(&t, &s, p.at[0], p.at[1], texel);
        NEAR(texel[0][0] * 255.0f, minified ? 8.0f : 7.5f);
    }
    s = nearest(GN_MINIFY_NEAREST_MIPMAP_NEAREST);
    lookup = lookup_of(&p, GN_LOD_IMPLICIT);
    for (int i = 0; i < 2; ++i) {
        for (int l = 0; l < GN_LANES; ++l)
            p.at[0][l] = (i ? 1.42f : 1.41f) * 0.25f * (float)(l % 2);
        gn_texture_lookup(&one, &s, &lookup, texel);
        NEAR(texel[0][0], (float)i);
    }
}

/* ---- Anisotropy ---- */

static gn_sampler anisotropic(gn_minify minify, uint32_t most)
{
    const bool is_nearest = minify == GN_MINIFY_NEAREST ||
                            minify == GN_MINIFY_NEAREST_MIPMAP_NEAREST ||
                            minify == GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    gn_sampler s =
        sampler_of(GN_WRAP_REPEAT, is_nearest ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR, minify);

    s.max_anisotropy = most;
    return s;
}

typedef struct vector {
    float v[3];
} vector;

/* A lookup at equal places, whose result is in 1/255. Gradients are in texels of level 0. */
static void look(const gn_texture *t, const gn_sampler *s, vector at, vector along_x,
                 vector along_y, float texel[4])
{
    places p = places_at(at.v[0], at.v[1], at.v[2]);

    for (int n = 0; n < 3; ++n) {
        const float size = t->target == GN_TEXTURE_CUBE ? SIZE / 2.0f
                           : n == 2                     ? (float)t->depth
                                                        : (float)SIZE;
        set_lanes(p.x[n], along_x.v[n] / size);
        set_lanes(p.y[n], along_y.v[n] / size);
    }
    lookup_each(t, s, &p, GN_LOD_GRADIENTS, texel);
    for (int c = 0; c < 4; ++c)
        texel[c] *= 255.0f;
}

/* The level of the samples if s changes by `along` texels and t by `across`, or t and s. Four
 * samples may be three texels apart; the logarithm is linear between powers of two. */
static void levels_of_samples(void **state)
{
    static const struct {
        float along, across;
        uint32_t most;
        float level;
    } cases[] = {{8, 8, 16, 3},
                 {8, 4, 16, 2},
                 {8, 2, 16, 1},
                 {8, 1, 16, 0},
                 {8, 0.25f, 16, 0},
                 {8, 1, 2, 2},
                 {8, 1, 4, 1},
                 {8, 7.99f, 16, 2},
                 {12, 4.001f, 16, 2},
                 {16, 0, 16, 0},
                 {12, 3.999f, 16, 1.5625f},
                 {16, 0, 8, 1}};
    const gn_texture t = numbered(GN_TEXTURE_2D);

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const gn_sampler s = anisotropic(GN_MINIFY_NEAREST_MIPMAP_LINEAR, cases[i].most);
        const vector at = {{0.5f, 0.5f}}, x = {{cases[i].along}}, y = {{0, cases[i].across}};
        float one[4], other[4];

        look(&t, &s, at, x, y, one);
        look(&t, &s, at, y, x, other);
        assert_float_equal(one[1], cases[i].level, 1e-5f);
        assert_true(one[1] == other[1]);
    }
}

/* Four samples of a footprint of four texels, at 1/5, 2/5, 3/5 and 4/5 of its length. An array's
 * layer does not change, and samples of a cube may leave the face of the direction. */
static void places_of_samples(void **state)
{
    static const struct {
        gn_texture_target target;
        vector at, x, y;
        int channel;
        float mean;
    } cases[] = {
        /* columns 3.05, 3.85, 4.65, 5.45; rows 8.7, 7.9, 7.1, 6.3 */
        {GN_TEXTURE_2D, {{4.25f / SIZE, 7.5f / SIZE}}, {{4}}, {{0, 0.5f}}, 0, 3.75f},
        {GN_TEXTURE_2D, {{4.25f / SIZE, 7.5f / SIZE}}, {{4}}, {{0, 0.5f}}, 2, 7},
        {GN_TEXTURE_2D, {{4.25f / SIZE, 7.5f / SIZE}}, {{0, 0.5f}}, {{4, -4}}, 0, 3.75f},
        {GN_TEXTURE_2D, {{4.25f / SIZE, 7.5f / SIZE}}, {{0, 0.5f}}, {{4, -4}}, 2, 7},
        /* both gradients are equally long */
        {GN_TEXTURE_2D, {{4.25f / SIZE, 7.5f / SIZE}}, {{4, -4}}, {{4, -4}}, 0, 4},
        {GN_TEXTURE_2D_ARRAY, {{0.5f, 0.5f, 2}}, {{4, 0, 4}}, {{0, 0.5f}}, 3, 2},
        /* two samples on +z, layer 4; two on +x, layer 0 */
        {GN_TEXTURE_CUBE, {{1, 0, 1.01f}}, {{8}}, {{0, 0.5f}}, 3, 2},
    };
    const gn_sampler s = anisotropic(GN_MINIFY_NEAREST, 4);

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const gn_texture t = numbered(cases[i].target);
        float texel[4];

        look(&t, &s, cases[i].at, cases[i].x, cases[i].y, texel);
        NEAR(texel[cases[i].channel], cases[i].mean);
    }
}

/* A texture that changes only across the footprint stays as sharp as in level 0; level 3 has two
 * columns. */
static void stripes_stay_sharp(void **state)
{
    const gn_texture t = numbered(GN_TEXTURE_2D);
    const gn_sampler sharp = anisotropic(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 8);
    const gn_sampler isotropic = anisotropic(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 0);
    const vector x = {{1}}, y = {{0, 8}};

    for (int column = 0; column < SIZE; ++column) {
        const vector at = {{((float)column + 0.5f) / SIZE, 0.5f}};
        float texel[4];

        look(&t, &sharp, at, x, y, texel);
        NEAR(texel[0], (float)column);
        look(&t, &isotropic, at, x, y, texel);
        assert_true(texel[0] <= 1);
    }
}

static void expect_isotropic(gn_texture_target target, vector at, vector x, vector y)
{
    const gn_texture t = numbered(target);

    for (int minify = 0; minify < 6; ++minify) {
        gn_sampler s = anisotropic((gn_minify)minify, 16);
        float sixteen[4], one[4];

        s.magnify = (gn_magnify)(minify % 2);
        look(&t, &s, at, x, y, sixteen);
        s.max_anisotropy = 1;
        look(&t, &s, at, x, y, one);
        assert_memory_equal(sixteen, one, sizeof one);
    }
}

/* Gradients of equal lengths; one dimension, and three; a magnified texture; no gradients, and some
 * that are not finite or too large. */
static void what_is_isotropic(void **state)
{
    static const struct {
        gn_texture_target target;
        vector at, x, y;
    } cases[] = {
        {GN_TEXTURE_2D, {{0.3f, 0.7f, 1}}, {{1.7f, 2.9f}}, {{-2.9f, 1.7f}}},
        {GN_TEXTURE_2D_ARRAY, {{0.3f, 0.7f, 1}}, {{1.7f, 2.9f}}, {{-2.9f, 1.7f}}},
        {GN_TEXTURE_3D, {{0.3f, 0.7f, 1}}, {{1.7f, 2.9f}}, {{-2.9f, 1.7f}}},
        {GN_TEXTURE_CUBE, {{0.3f, 0.7f, 2}}, {{3}}, {{0, -3}}},
        {GN_TEXTURE_1D, {{0.3f, 0.7f, 1}}, {{8}}, {{0, 1}}},
        {GN_TEXTURE_3D, {{0.3f, 0.7f, 1}}, {{8}}, {{0, 1}}},
        {GN_TEXTURE_2D, {{0.3f, 0.7f, 1}}, {{1}}, {{0, 0.01f}}},
        {GN_TEXTURE_2D, {{0.3f, 0.7f, 1}}, {{0}}, {{0}}},
        {GN_TEXTURE_2D, {{INFINITY, 0.7f, 1}}, {{INFINITY}}, {{INFINITY}}},
    };
    const vector at = {{0.3f, 0.7f, 1}}, x = {{8}}, y = {{0, 1}}, nan = {{NAN, 1}};
    const vector infinite = {{INFINITY}}, large = {{1e30f, -1e30f}};

    for (size_t i = 0; i < COUNT(cases); ++i)
        expect_isotropic(cases[i].target, cases[i].at, cases[i].x, cases[i].y);
    for (int target = 0; target < 5; ++target) {
        expect_isotropic((gn_texture_target)target, at, nan, y);
        expect_isotropic((gn_texture_target)target, at, x, nan);
        expect_isotropic((gn_texture_target)target, at, infinite, y);
        expect_isotropic((gn_texture_target)target, at, y, large);
    }
}

/* An explicit level has no footprint, and gathers have none. */
static void explicit_levels_and_gathers_are_isotropic(void **state)
{
    const gn_texture t = numbered(GN_TEXTURE_2D);
    const gn_sampler one = anisotropic(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 1);
    const gn_sampler many = anisotropic(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 16);
    places p = places_at(0, 0, 0);
    const gn_lookup lookup = lookup_of(&p, GN_LOD_EXPLICIT);
    float found[2][4][GN_LANES], expected[2][4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l) {
        p.at[0][l] = (float)(l % 4) * 0.37f;
        p.at[1][l] = (float)(l / 4) * 0.01f;
        p.lod[l] = 0.3f * (float)l;
    }
    gn_texture_lookup(&t, &many, &lookup, found[0]);
    gn_texture_lookup(&t, &one, &lookup, expected[0]);
    gn_texture_gather(&t, &many, &lookup, 0, found[1]);
    gn_texture_gather(&t, &one, &lookup, 0, expected[1]);
    assert_memory_equal(found, expected, sizeof found);
}

/* A place returns one result, whether the places beside it have fewer, more or equally many
 * samples. All places of a quad use the differences of the lower left one. */
static void places_beside_others(void **state)
{
    static const float quad[4][2] = {{4, 6}, {8, 7}, {4.5f, 7}, {4.75f, 13}};
    const gn_texture t = numbered(GN_TEXTURE_2D);
    const gn_sampler s = anisotropic(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 16);
    places p = places_at(0.4f, 0.4f, 0);
    gn_lookup lookup = lookup_of(&p, GN_LOD_GRADIENTS);
    float texels[4][GN_LANES], same[4][GN_LANES], alone[4];

    set_lanes(p.x[0], 16.0f / SIZE);
    for (int l = 0; l < GN_LANES; ++l)
        p.y[1][l] = 16.0f / (float)(l + 1) / SIZE;
    gn_texture_lookup(&t, &s, &lookup, texels);
    for (int l = 0; l < GN_LANES; ++l) {
        const vector at = {{0.4f, 0.4f}}, x = {{16}}, y = {{0, 16.0f / (float)(l + 1)}};

        look(&t, &s, at, x, y, alone);
        for (int c = 0; c < 4; ++c)
            assert_true(texels[c][l] * 255.0f == alone[c]);
    }
    for (int l = 0; l < GN_LANES; ++l) {
        p.at[0][l] = 0.25f + (float)(l % 4) * 4.0f / SIZE;
        p.at[1][l] = 0.4f + (float)(l / 4) * 1.0f / SIZE;
    }
    lookup = lookup_of(&p, GN_LOD_IMPLICIT);
    gn_texture_lookup(&t, &s, &lookup, texels);
    for (int l = 0; l < GN_LANES; ++l)
        assert_true(texels[1][l] == 0); /* level 0: 4 texels by 1 */
    gn_texture_lookup_2d(&t, &s, p.at[0], p.at[1], same);
    assert_memory_equal(same, texels, sizeof same);

    for (uint32_t i = 0; i < SIZE * SIZE; ++i) /* not linear: all means would be equal */
        image[0][i] = i * 2654435761u;
    for (int i = 0; i < 2 * GN_LANES; ++i)
        p.at[i % 2][i / 2] = quad[i / 8 % 2 * 2 + i / 2 % 2][i % 2] / SIZE;
    gn_texture_lookup_2d(&t, &s, p.at[0], p.at[1], texels);
    for (int l = 0; l < GN_LANES; ++l) {
        const vector at = {{p.at[0][l], p.at[1][l]}}, x = {{4, 1}}, y = {{0.5f, 1}};

        look(&t, &s, at, x, y, alone);
        for (int c = 0; c < 4; ++c)
            assert_true(texels[c][l] * 255.0f == alone[c]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(explicit_levels),
        cmocka_unit_test(limits_of_the_last_levels),
        cmocka_unit_test(upper_limits_that_count),
        cmocka_unit_test(levels_of_either_zero),
        cmocka_unit_test(one_level_is_not_mixed),
        cmocka_unit_test(levels_of_footprints),
        cmocka_unit_test(levels_of_samples),
        cmocka_unit_test(places_of_samples),
        cmocka_unit_test(stripes_stay_sharp),
        cmocka_unit_test(what_is_isotropic),
        cmocka_unit_test(explicit_levels_and_gathers_are_isotropic),
        cmocka_unit_test(places_beside_others),
    };
    return cmocka_run_group_tests_name("level of detail", tests, NULL, NULL);
}
