/* Cubes: the face and texel that a direction meets, filters and comparisons over edges and corners,
 * gathers there, and levels of detail. Expected values come from OpenGL 4.5 table 8.19 and are
 * worked by hand. tests/property tests the centres of texels, tests/parity/textures compares with
 * the reference. */
#include <math.h>

#include "float_bits.h"
#include "lookups.h"

/* Texel (x, y) of face f is 100 f + 10 y + x. */
enum { SIDE = 4 };

static gn_texture numbered(void)
{
    static float texels[6 * SIDE * SIDE];

    for (int i = 0; i < 6 * SIDE * SIDE; ++i)
        texels[i] = (float)(100 * (i / 16) + 10 * (i / 4 % 4) + i % 4);
    return texture_of(GN_TEXTURE_CUBE, GN_FORMAT_R32F, SIDE, SIDE, 1, 1, texels);
}

static gn_sampler filtered(bool is_linear)
{
    return sampler_of(GN_WRAP_REPEAT, is_linear ? GN_MAGNIFY_LINEAR : GN_MAGNIFY_NEAREST,
                      is_linear ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST);
}

static float sampled(bool is_linear, const float direction[3])
{
    const gn_texture t = numbered();
    const gn_sampler s = filtered(is_linear);
    float texel[4];

    gn_texture_lookup_at(&t, &s, direction, 0, 0, texel);
    return texel[0];
}

#define NEAR(a, b) assert_true(fabsf((a) - (b)) < 1e-3f)

static void directions(void **state)
{
    static const struct {
        bool is_linear;
        float direction[3], expected;
    } cases[] = {
        /* texel (3, 0) of each face */
        {false, {1, 0.75f, -0.75f}, 3},
        {false, {-1, 0.75f, 0.75f}, 103},
        {false, {0.75f, 1, -0.75f}, 203},
        {false, {0.75f, -1, 0.75f}, 303},
        {false, {0.75f, 0.75f, 1}, 403},
        {false, {-0.75f, 0.75f, -1}, 503},
        {false, {-6, 6, -8}, 503},
        /* in ties z wins, then y; the zero vector meets the middle of +z or -z */
        {false, {1, 1, 1}, 403},
        {false, {-1, 1, -1}, 503},
        {false, {1, 0, -1}, 520},
        {false, {1, 1, 0.5f}, 233},
        {false, {1, -1, 0}, 323},
        {false, {0, 0, 0}, 422},
        {false, {0, 0, -0.0f}, 522},
        /* NaN in x or z wins too, and meets the first texel of the negative face */
        {false, {1, 0, NAN}, 500},
        {false, {NAN, 1, 0.5f}, 100},
        /* within a face: (1, 1) to (2, 2); s 0.5625, t 0.375: (1.75, 1); s 0.4375: (1.25, 1) */
        {true, {0, 0, 1}, 416.5f},
        {true, {1, 0.25f, -0.125f}, 11.75f},
        {true, {-0.125f, -1, 0.25f}, 311.25f},
        /* edges: +x, column 0, and +z, column 3, row 0; +y, row 3, and +z, row 0; at a sixteenth
         * from the edge 3/8 of the result is the neighbour's */
        {true, {1, 0.75f, 1}, 0.5f * (0 + 403)},
        {true, {-0.25f, 1, 1}, 0.5f * (231 + 401)},
        {true, {1, 0.75f, 0.9375f}, 0.625f * 0 + 0.375f * 403},
        {true, {-1, -0.9375f, 0.75f}, 0.625f * 133 + 0.375f * 300},
        /* corners: three texels meet, each with a weight of a third */
        {true, {1, 1, 1}, (403 + 0 + 233) / 3.0f},
        {true, {-1, -1, -1}, (533 + 130 + 330) / 3.0f},
    };

    for (size_t i = 0; i < COUNT(cases); ++i)
        if (!(fabsf(sampled(cases[i].is_linear, cases[i].direction) - cases[i].expected) < 1e-3f))
            fail_msg("case %zu: %g", i, (double)sampled(cases[i].is_linear, cases[i].direction));
    /* Processors differ in the sign of a NaN that they compute. The face does not depend on it. */
    for (int axis = 0; axis < 3; ++axis) {
        float d[2][3] = {{0.5f, 0.25f, 0.125f}, {0.5f, 0.25f, 0.125f}};

        d[0][axis] = from_bits(0xFFC00000);
        d[1][axis] = from_bits(0x7FC00000);
        assert_true(sampled(false, d[0]) == sampled(false, d[1]));
    }
}

/* In the order from the upper left round. The missing texel at a corner is the mean of the
 * others. */
static void gathers(void **state)
{
    static const float at[3][3] = {{0, 0, 1}, {1, 1, 1}, {1, 0, 1}};
    static const float expected[3][4] = {
        {421, 422, 412, 411}, {403, 0, 212, 233}, {423, 20, 10, 413}};
    const gn_texture t = numbered();
    const gn_sampler s = filtered(true);

    for (int i = 0; i < 3; ++i) {
        const places p = places_at(at[i][0], at[i][1], at[i][2]);
        const gn_lookup lookup = lookup_of(&p, GN_LOD_IMPLICIT);
        float texel[4][GN_LANES];

        gn_texture_gather(&t, &s, &lookup, 0, texel);
        for (int k = 0; k < 4; ++k)
            NEAR(texel[k][9], expected[i][k]);
    }
}

/* Only the face +z is nearer than the reference value: an edge, a corner and a gather, whose middle
 * two texels are of +x. */
static void compared_depths(void **state)
{
    static const float edge[3] = {1, 0, 1}, corner[3] = {1, 1, 1};
    float depths[6 * 4], one[4], texel[4][GN_LANES];
    gn_sampler s = filtered(true);
    places p = places_at(1, 0, 1);
    const gn_lookup lookup = lookup_of(&p, GN_LOD_IMPLICIT);

    for (int i = 0; i < 6 * 4; ++i)
        depths[i] = i / 4 == 4 ? 0.25f : 0.75f;
    const gn_texture t = texture_of(GN_TEXTURE_CUBE, GN_FORMAT_D32F, 2, 2, 1, 1, depths);
    s.compare = GN_LESS;
    gn_texture_lookup_at(&t, &s, edge, 0, 0.5f, one);
    assert_true(one[0] == 0.5f);
    gn_texture_lookup_at(&t, &s, corner, 0, 0.5f, one);
    assert_true(fabsf(one[0] - 2.0f / 3) < 1e-6f);
    set_lanes(p.reference, 0.5f);
    gn_texture_gather(&t, &s, &lookup, 3, texel);
    for (int i = 0; i < 4; ++i)
        assert_true(texel[i][5] == (i == 1 || i == 2 ? 1 : 0));
}

/* All texels of level n of a cube of 8x8 are n. s = (sc / ma + 1) / 2. So if a direction changes
 * along sc, s moves by half of the change; along ma by sc / 2 in the opposite direction; in units
 * of ma. Here that is 2 texels of 8, or 4 for a length of 2 and so on. */
static void levels(void **state)
{
    static const struct {
        float at[3], gradient[3], level;
    } cases[] = {{{0, 0, 1}, {0.5f, 0, 0}, 1},       {{0, 0, -1}, {0, 1, 0}, 2},
                 {{0.5f, 0, 1}, {0, 0, 1}, 1},       {{-1, 0, 0.5f}, {2, 0, 0}, 2},
                 {{0, 4, 2}, {0, 0, 2}, 1},          {{0.25f, -1, 0}, {1, 0, 0}, 2},
                 {{0.25f, -1, 0}, {0, 2, 0}, 1},     {{1, 0, 0}, {5, 0, 0}, 0},
                 {{0, 0, 1}, {0.5f, 0.5f, 0}, 1.5f}, {{0, 0, 1}, {INFINITY, 0, 0}, 0}};
    float texels[6 * (64 + 16 + 4 + 1)], texel[4], lanes[4][GN_LANES];
    gn_sampler s = filtered(false);
    places p;

    for (int i = 0; i < 6 * 85; ++i)
        texels[i] = i < 6 * 64 ? 0 : i < 6 * 80 ? 1 : i < 6 * 84 ? 2 : 3;
    const gn_texture t = texture_of(GN_TEXTURE_CUBE, GN_FORMAT_R32F, 8, 8, 1, 4, texels);
    s.minify = GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        p = places_at(cases[i].at[0], cases[i].at[1], cases[i].at[2]);
        for (int n = 0; n < 3; ++n)
            set_lanes(i % 2 ? p.y[n] : p.x[n], cases[i].gradient[n]);
        lookup_each(&t, &s, &p, GN_LOD_GRADIENTS, texel);
        NEAR(texel[0], cases[i].level);
    }
    /* Differences are those of each lane's row and column: 2 texels in the right column of a quad,
     * 1 in the left one. */
    p = places_at(0, 0, 2);
    for (int l = 0; l < GN_LANES; ++l)
        p.at[1][l] = (l & 4 ? 1.0f : 0.0f) * (l & 1 ? 1.0f : 0.5f);
    const gn_lookup lookup = lookup_of(&p, GN_LOD_IMPLICIT);
    gn_texture_lookup(&t, &s, &lookup, lanes);
    for (int l = 0; l < GN_LANES; ++l)
        NEAR(lanes[0][l], l & 1 ? 1.0f : 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(directions),
        cmocka_unit_test(gathers),
        cmocka_unit_test(compared_depths),
        cmocka_unit_test(levels),
    };
    return cmocka_run_group_tests_name("cubes", tests, NULL, NULL);
}
