/* Anisotropic lookups, with cases worked by hand: the number of samples, their level, and their
 * places; and lookups with one sample, which equal lookups without anisotropy. */
#include <math.h>
#include <string.h>

#include "unit.h"

enum { SIZE = 16, LEVELS = 5, LAYERS = 6 };

/* Level n has green n/255; red is the column, blue the row, alpha the layer, all in 1/255. */
static uint32_t image[LEVELS][LAYERS * SIZE * SIZE];

static gn_texture texture_of(gn_texture_target target)
{
    gn_texture t;

    memset(&t, 0, sizeof t);
    t.target = target;
    t.format = GN_FORMAT_RGBA8;
    t.width = SIZE;
    t.height = target == GN_TEXTURE_1D ? 1 : SIZE;
    t.depth = target == GN_TEXTURE_3D ? 4 : LAYERS;
    t.level_count = LEVELS;
    for (uint32_t n = 0; n < LEVELS; ++n) {
        const uint32_t size = SIZE >> n;

        for (uint32_t i = 0; i < LAYERS * size * size; ++i)
            image[n][i] = i % size | n << 8 | (i / size % size) << 16 | (i / (size * size)) << 24;
        t.level[n].texels = image[n];
        t.level[n].row_stride = (ptrdiff_t)size * 4;
        t.level[n].layer_stride = (ptrdiff_t)(size * size) * 4;
    }
    return t;
}

static gn_sampler sampler_of(gn_minify minify, uint32_t max_anisotropy)
{
    gn_sampler s;

    memset(&s, 0, sizeof s);
    s.minify = minify;
    s.magnify = minify == GN_MINIFY_NEAREST || minify == GN_MINIFY_NEAREST_MIPMAP_NEAREST ||
                        minify == GN_MINIFY_NEAREST_MIPMAP_LINEAR
                    ? GN_MAGNIFY_NEAREST
                    : GN_MAGNIFY_LINEAR;
    s.max_anisotropy = max_anisotropy;
    return s;
}

/* A lookup at 16 equal places, whose result is in 1/255. Gradients are in texels of level 0. */
static void look_up(const gn_texture *t, const gn_sampler *s, const float at[3],
                    const float along_x[3], const float along_y[3], float texel[4])
{
    float place[3][GN_LANES], x[3][GN_LANES], y[3][GN_LANES], texels[4][GN_LANES];
    gn_lookup lookup;

    memset(&lookup, 0, sizeof lookup);
    lookup.lod_source = GN_LOD_GRADIENTS;
    for (int n = 0; n < 3; ++n) {
        const float size = t->target == GN_TEXTURE_CUBE ? SIZE / 2.0f
                           : n == 2                     ? (float)t->depth
                                                        : (float)SIZE;

        for (int l = 0; l < GN_LANES; ++l) {
            place[n][l] = at[n];
            x[n][l] = along_x[n] / size;
            y[n][l] = along_y[n] / size;
        }
        lookup.coordinate[n] = place[n];
        lookup.gradient_x[n] = x[n];
        lookup.gradient_y[n] = y[n];
    }
    gn_sample(t, s, &lookup, texels);
    for (int c = 0; c < 4; ++c) {
        for (int l = 0; l < GN_LANES; ++l)
            assert_memory_equal(&texels[c][l], &texels[c][0], sizeof(float));
        texel[c] = texels[c][0] * 255.0f;
    }
}

/* The level of the samples if s changes by `along` texels and t by `across`. */
static float level_of(float along, float across, uint32_t max_anisotropy)
{
    const gn_texture t = texture_of(GN_TEXTURE_2D);
    const gn_sampler s = sampler_of(GN_MINIFY_NEAREST_MIPMAP_LINEAR, max_anisotropy);
    const float at[3] = {0.5f, 0.5f, 0.0f};
    const float x[3] = {along, 0.0f, 0.0f}, y[3] = {0.0f, across, 0.0f};
    float one[4], other[4];

    look_up(&t, &s, at, x, y, one);
    look_up(&t, &s, at, y, x, other);
    assert_float_equal(one[1], other[1], 0.0);
    return one[1];
}

static void test_levels(void **state)
{
    (void)state;
    assert_float_equal(level_of(8.0f, 8.0f, 16), 3.0, 1e-5);
    assert_float_equal(level_of(8.0f, 4.0f, 16), 2.0, 1e-5);
    assert_float_equal(level_of(8.0f, 2.0f, 16), 1.0, 1e-5);
    assert_float_equal(level_of(8.0f, 1.0f, 16), 0.0, 1e-5);
    assert_float_equal(level_of(8.0f, 0.25f, 16), 0.0, 1e-5);
    assert_float_equal(level_of(8.0f, 1.0f, 2), 2.0, 1e-5);
    assert_float_equal(level_of(8.0f, 1.0f, 4), 1.0, 1e-5);
    assert_float_equal(level_of(8.0f, 7.99f, 16), 2.0, 1e-5); /* two samples */
    assert_float_equal(level_of(12.0f, 4.001f, 16), 2.0, 1e-5);
    /* Four samples, three texels apart; the logarithm is linear between powers of two. */
    assert_float_equal(level_of(12.0f, 3.999f, 16), 1.5625, 1e-5);
    assert_float_equal(level_of(16.0f, 0.0f, 16), 0.0, 1e-5);
    assert_float_equal(level_of(16.0f, 0.0f, 8), 1.0, 1e-5);
}

/* Four samples of a footprint of four texels, at 1/5, 2/5, 3/5 and 4/5 of its length. */
static void test_places(void **state)
{
    const gn_texture t = texture_of(GN_TEXTURE_2D);
    const gn_sampler s = sampler_of(GN_MINIFY_NEAREST, 4);
    const float at[3] = {4.25f / SIZE, 7.5f / SIZE, 0.0f};
    const float x[3] = {4.0f, 0.0f, 0.0f}, y[3] = {0.0f, 0.5f, 0.0f};
    const float diagonal[3] = {4.0f, -4.0f, 0.0f};
    float texel[4];

    (void)state;
    look_up(&t, &s, at, x, y, texel); /* columns 3.05, 3.85, 4.65, 5.45 */
    assert_float_equal(texel[0], 3.75, 1e-4);
    assert_float_equal(texel[2], 7.0, 1e-4);
    look_up(&t, &s, at, y, diagonal, texel); /* rows 8.7, 7.9, 7.1, 6.3 */
    assert_float_equal(texel[0], 3.75, 1e-4);
    assert_float_equal(texel[2], 7.0, 1e-4);
    look_up(&t, &s, at, diagonal, diagonal, texel); /* both gradients are equally long */
    assert_float_equal(texel[0], 4.0, 1e-4);
}

/* A texture that changes only across the footprint stays as sharp as in level 0. */
static void test_stripes_stay_sharp(void **state)
{
    const gn_texture t = texture_of(GN_TEXTURE_2D);
    const gn_sampler s = sampler_of(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 8);
    const gn_sampler isotropic = sampler_of(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 0);
    const float x[3] = {1.0f, 0.0f, 0.0f}, y[3] = {0.0f, 8.0f, 0.0f};

    (void)state;
    for (int column = 0; column < SIZE; ++column) {
        const float at[3] = {((float)column + 0.5f) / SIZE, 0.5f, 0.0f};
        float texel[4];

        look_up(&t, &s, at, x, y, texel);
        assert_float_equal(texel[0], column, 1e-4);
        look_up(&t, &isotropic, at, x, y, texel);
        assert_true(texel[0] <= 1.0f); /* level 3 has two columns */
    }
}

static void expect_isotropic(gn_texture_target target, const float at[3], const float x[3],
                             const float y[3])
{
    const gn_texture t = texture_of(target);

    for (int minify = 0; minify < 6; ++minify) {
        gn_sampler s = sampler_of((gn_minify)minify, 16);
        float anisotropic[4], isotropic[4];

        s.magnify = (gn_magnify)(minify % 2);
        look_up(&t, &s, at, x, y, anisotropic);
        s.max_anisotropy = 1;
        look_up(&t, &s, at, x, y, isotropic);
        assert_memory_equal(anisotropic, isotropic, sizeof isotropic);
    }
}

static void test_equal_lengths_are_isotropic(void **state)
{
    const float x[3] = {1.7f, 2.9f, 0.0f}, y[3] = {-2.9f, 1.7f, 0.0f};
    const float on_face_x[3] = {3.0f, 0.0f, 0.0f}, on_face_y[3] = {0.0f, -3.0f, 0.0f};
    const float at[3] = {0.3f, 0.7f, 1.0f}, forward[3] = {0.3f, 0.7f, 2.0f};

    (void)state;
    expect_isotropic(GN_TEXTURE_2D, at, x, y);
    expect_isotropic(GN_TEXTURE_2D_ARRAY, at, x, y);
    expect_isotropic(GN_TEXTURE_3D, at, x, y);
    expect_isotropic(GN_TEXTURE_CUBE, forward, on_face_x, on_face_y);
}

static void test_what_takes_one_sample_is_isotropic(void **state)
{
    const float at[3] = {0.3f, 0.7f, 1.0f}, far[3] = {INFINITY, 0.7f, 1.0f};
    const float x[3] = {8.0f, 0.0f, 0.0f}, y[3] = {0.0f, 1.0f, 0.0f};
    const float small_x[3] = {1.0f, 0.0f, 0.0f}, small_y[3] = {0.0f, 0.01f, 0.0f};
    const float none[3] = {0.0f, 0.0f, 0.0f}, not_a_number[3] = {NAN, 1.0f, 0.0f};
    const float infinite[3] = {INFINITY, 0.0f, 0.0f}, large[3] = {1e30f, -1e30f, 0.0f};

    (void)state;
    expect_isotropic(GN_TEXTURE_1D, at, x, y);
    expect_isotropic(GN_TEXTURE_3D, at, x, y);
    expect_isotropic(GN_TEXTURE_2D, at, small_x, small_y); /* magnified */
    expect_isotropic(GN_TEXTURE_2D, at, none, none);
    for (int target = 0; target < 5; ++target) {
        expect_isotropic((gn_texture_target)target, at, not_a_number, y);
        expect_isotropic((gn_texture_target)target, at, x, not_a_number);
        expect_isotropic((gn_texture_target)target, at, infinite, y);
        expect_isotropic((gn_texture_target)target, at, y, large);
    }
    expect_isotropic(GN_TEXTURE_2D, far, infinite, infinite);
}

/* An array's layer does not change, and samples of a cube may leave the face of the direction. */
static void test_targets(void **state)
{
    const gn_sampler s = sampler_of(GN_MINIFY_NEAREST, 4);
    const gn_texture array = texture_of(GN_TEXTURE_2D_ARRAY), cube = texture_of(GN_TEXTURE_CUBE);
    const float at[3] = {0.5f, 0.5f, 2.0f};
    const float x[3] = {4.0f, 0.0f, 4.0f}, y[3] = {0.0f, 0.5f, 0.0f};
    const float edge[3] = {1.0f, 0.0f, 1.01f}, across[3] = {8.0f, 0.0f, 0.0f};
    float texel[4];

    (void)state;
    look_up(&array, &s, at, x, y, texel);
    assert_float_equal(texel[3], 2.0, 1e-5);
    look_up(&cube, &s, edge, across, y, texel); /* two samples on +z, layer 4; two on +x, layer 0 */
    assert_float_equal(texel[3], 2.0, 1e-5);
}

/* An explicit level has no footprint, and gathers have none. */
static void test_explicit_levels(void **state)
{
    const gn_texture t = texture_of(GN_TEXTURE_2D);
    const gn_sampler one = sampler_of(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 1);
    const gn_sampler many = sampler_of(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 16);
    float s[GN_LANES], u[GN_LANES], lod[GN_LANES], found[4][GN_LANES], expected[4][GN_LANES];
    gn_lookup lookup;

    (void)state;
    memset(&lookup, 0, sizeof lookup);
    lookup.coordinate[0] = s;
    lookup.coordinate[1] = u;
    lookup.lod_source = GN_LOD_EXPLICIT;
    lookup.lod = lod;
    for (int l = 0; l < GN_LANES; ++l) {
        s[l] = (float)(l % 4) * 0.37f;
        u[l] = (float)(l / 4) * 0.01f;
        lod[l] = 0.3f * (float)l;
    }
    gn_sample(&t, &many, &lookup, found);
    gn_sample(&t, &one, &lookup, expected);
    assert_memory_equal(found, expected, sizeof found);
    gn_gather(&t, &many, &lookup, 0, found);
    gn_gather(&t, &one, &lookup, 0, expected);
    assert_memory_equal(found, expected, sizeof found);
}

/* A place returns one result, whether the places beside it have fewer, more or equally many
 * samples. */
static void test_places_beside_others(void **state)
{
    const gn_texture t = texture_of(GN_TEXTURE_2D);
    const gn_sampler s = sampler_of(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 16);
    float place[2][GN_LANES], x[2][GN_LANES], y[2][GN_LANES], texels[4][GN_LANES];
    float same[4][GN_LANES];
    gn_lookup lookup;

    (void)state;
    memset(&lookup, 0, sizeof lookup);
    for (int n = 0; n < 2; ++n) {
        lookup.coordinate[n] = place[n];
        lookup.gradient_x[n] = x[n];
        lookup.gradient_y[n] = y[n];
    }
    for (int l = 0; l < GN_LANES; ++l) {
        place[0][l] = place[1][l] = 0.4f;
        x[0][l] = 16.0f / SIZE;
        x[1][l] = y[0][l] = 0.0f;
        y[1][l] = 16.0f / (float)(l + 1) / SIZE;
    }
    lookup.lod_source = GN_LOD_GRADIENTS;
    gn_sample(&t, &s, &lookup, texels);
    for (int l = 0; l < GN_LANES; ++l) {
        const float at[3] = {0.4f, 0.4f, 0.0f}, along[3] = {16.0f, 0.0f, 0.0f};
        const float across[3] = {0.0f, 16.0f / (float)(l + 1), 0.0f};
        float alone[4];

        look_up(&t, &s, at, along, across, alone);
        for (int c = 0; c < 4; ++c)
            assert_float_equal(texels[c][l] * 255.0f, alone[c], 0.0);
    }
    for (int l = 0; l < GN_LANES; ++l) {
        place[0][l] = 0.25f + (float)(l % 4) * 4.0f / SIZE;
        place[1][l] = 0.4f + (float)(l / 4) * 1.0f / SIZE;
    }
    lookup.lod_source = GN_LOD_IMPLICIT;
    gn_sample(&t, &s, &lookup, texels);
    for (int l = 0; l < GN_LANES; ++l)
        assert_float_equal(texels[1][l], 0.0, 0.0); /* level 0: 4 texels by 1 */
    gn_sample_2d(&t, &s, place[0], place[1], same);
    assert_memory_equal(same, texels, sizeof same);
}

/* All places of a quad use the differences of the lower left one. */
static void test_quads_share_their_samples(void **state)
{
    const gn_texture t = texture_of(GN_TEXTURE_2D);
    const gn_sampler s = sampler_of(GN_MINIFY_LINEAR_MIPMAP_LINEAR, 16);
    const float along_x[3] = {4.0f, 1.0f, 0.0f}, along_y[3] = {0.5f, 1.0f, 0.0f};
    const float quad[4][2] = {{4.0f, 6.0f}, {8.0f, 7.0f}, {4.5f, 7.0f}, {4.75f, 13.0f}};
    float place[2][GN_LANES], texels[4][GN_LANES];

    (void)state;
    for (uint32_t i = 0; i < SIZE * SIZE;
         ++i) /* not linear, because then all means would be equal */
        image[0][i] = i * 2654435761u;
    for (int l = 0; l < GN_LANES; ++l)
        for (int n = 0; n < 2; ++n)
            place[n][l] = quad[l / 4 % 2 * 2 + l % 2][n] / SIZE;
    gn_sample_2d(&t, &s, place[0], place[1], texels);
    for (int l = 0; l < GN_LANES; ++l) {
        const float at[3] = {place[0][l], place[1][l], 0.0f};
        float alone[4];

        look_up(&t, &s, at, along_x, along_y, alone);
        for (int c = 0; c < 4; ++c)
            assert_float_equal(texels[c][l] * 255.0f, alone[c], 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_levels),
        cmocka_unit_test(test_places),
        cmocka_unit_test(test_stripes_stay_sharp),
        cmocka_unit_test(test_equal_lengths_are_isotropic),
        cmocka_unit_test(test_what_takes_one_sample_is_isotropic),
        cmocka_unit_test(test_targets),
        cmocka_unit_test(test_explicit_levels),
        cmocka_unit_test(test_places_beside_others),
        cmocka_unit_test(test_quads_share_their_samples),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
