/* Cubes: the face and texel that a direction meets, filters over edges and corners, gathers there,
 * and levels of detail. Expected values come from OpenGL 4.5 table 8.19, written out, and from
 * cases worked by hand. */
#include <math.h>
#include <string.h>

#include "float_bits.h"

/* Texel (x, y) of face f is 100 f + 10 y + x. */
enum { SIDE = 4 };

static gn_texture numbered(void)
{
    static float texels[6][SIDE][SIDE];
    gn_texture t;

    for (int f = 0; f < 6; ++f) {
        for (int y = 0; y < SIDE; ++y)
            for (int x = 0; x < SIDE; ++x)
                texels[f][y][x] = (float)(100 * f + 10 * y + x);
    }
    assert_int_equal(
        gn_texture_packed(GN_TEXTURE_CUBE, GN_FORMAT_R32F, SIDE, SIDE, 0, 1, texels, &t), GN_OK);
    return t;
}

static gn_sampler filtered(bool is_linear)
{
    gn_sampler s;

    memset(&s, 0, sizeof s);
    s.magnify = is_linear ? GN_MAGNIFY_LINEAR : GN_MAGNIFY_NEAREST;
    s.minify = is_linear ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST;
    return s;
}

static float sampled(bool is_linear, float x, float y, float z)
{
    const gn_texture t = numbered();
    const gn_sampler s = filtered(is_linear);
    const float direction[3] = {x, y, z};
    float texel[4];

    gn_sample_at(&t, &s, direction, 0.0f, 0.0f, texel);
    return texel[0];
}

/* The direction with sc and tc, -1 to 1, on a face: table 8.19 solved for the direction. */
static void direction_of(int face, float sc, float tc, float d[3])
{
    const float directions[6][3] = {{1, -tc, -sc}, {-1, -tc, sc}, {sc, 1, tc},
                                    {sc, -1, -tc}, {sc, -tc, 1},  {-sc, -tc, -1}};

    memcpy(d, directions[face], sizeof directions[face]);
}

/* The value of the texel that a direction meets, by the table. */
static float texel_towards(const float d[3])
{
    const float x = fabsf(d[0]), y = fabsf(d[1]), z = fabsf(d[2]);
    const float major = fmaxf(x, fmaxf(y, z));
    const int face = major == z    ? d[2] > 0.0f ? 4 : 5
                     : major == y  ? d[1] > 0.0f ? 2 : 3
                     : d[0] > 0.0f ? 0
                                   : 1;
    const float sc[6] = {-d[2], d[2], d[0], d[0], d[0], -d[0]};
    const float tc[6] = {-d[1], -d[1], d[2], -d[2], -d[1], -d[1]};
    const float column = floorf((sc[face] / major + 1.0f) * 0.5f * SIDE);
    const float row = floorf((tc[face] / major + 1.0f) * 0.5f * SIDE);

    return 100.0f * (float)face + 10.0f * fminf(row, SIDE - 1) + fminf(column, SIDE - 1);
}

#define NEAR(a, b) assert_true(fabsf((a) - (b)) < 1e-3f)

/* A direction of any length finds texel (3, 0) of each face. */
static void faces(void **state)
{
    (void)state;
    for (float length = 0.125f; length < 9.0f; length *= 8.0f) {
        const float one = length, most = 0.75f * length;

        NEAR(sampled(false, one, most, -most), 3.0f);
        NEAR(sampled(false, -one, most, most), 103.0f);
        NEAR(sampled(false, most, one, -most), 203.0f);
        NEAR(sampled(false, most, -one, most), 303.0f);
        NEAR(sampled(false, most, most, one), 403.0f);
        NEAR(sampled(false, -most, most, -one), 503.0f);
    }
}

/* The centre of every texel: s and t of each face are those of the table, row 0 first. */
static void every_texel_of_every_face(void **state)
{
    (void)state;
    for (int face = 0; face < 6; ++face) {
        for (int row = 0; row < SIDE; ++row) {
            for (int column = 0; column < SIDE; ++column) {
                const float sc = (float)(2 * column + 1) / SIDE - 1.0f;
                const float tc = (float)(2 * row + 1) / SIDE - 1.0f;
                const float number = (float)(100 * face + 10 * row + column);
                float d[3];

                direction_of(face, sc, tc, d);
                assert_true(texel_towards(d) == number);
                NEAR(sampled(false, d[0], d[1], d[2]), number);
                NEAR(sampled(true, d[0], d[1], d[2]), number);
            }
        }
    }
}

/* In ties z wins, then y. The zero vector meets the middle of +z or -z. NaN in x or z wins too, and
 * meets the first texel of the negative face. */
static void ties(void **state)
{
    (void)state;
    NEAR(sampled(false, 1.0f, 1.0f, 1.0f), 403.0f);
    NEAR(sampled(false, -1.0f, 1.0f, -1.0f), 503.0f);
    NEAR(sampled(false, 1.0f, 0.0f, -1.0f), 520.0f);
    NEAR(sampled(false, 1.0f, 1.0f, 0.5f), 233.0f);
    NEAR(sampled(false, 1.0f, -1.0f, 0.0f), 323.0f);
    NEAR(sampled(false, 0.0f, 0.0f, 0.0f), 422.0f);
    NEAR(sampled(false, 0.0f, 0.0f, -0.0f), 522.0f);
    NEAR(sampled(false, 1.0f, 0.0f, NAN), 500.0f);
    NEAR(sampled(false, NAN, 1.0f, 0.5f), 100.0f);
}

/* Processors differ in the sign of a NaN that they compute. The face does not depend on it. */
static void directions_of_nan(void **state)
{
    (void)state;
    const float minus = from_bits(0xFFC00000u), plus = from_bits(0x7FC00000u);

    for (int axis = 0; axis < 3; ++axis) {
        float d[2][3] = {{0.5f, 0.25f, 0.125f}, {0.5f, 0.25f, 0.125f}};

        d[0][axis] = minus;
        d[1][axis] = plus;
        assert_true(sampled(false, d[0][0], d[0][1], d[0][2]) ==
                    sampled(false, d[1][0], d[1][1], d[1][2]));
    }
}

static void linear_within_a_face(void **state)
{
    (void)state;
    NEAR(sampled(true, 0.0f, 0.0f, 1.0f), 416.5f);       /* (1, 1) to (2, 2) */
    NEAR(sampled(true, 1.0f, 0.25f, -0.125f), 11.75f);   /* s 0.5625, t 0.375: (1.75, 1) */
    NEAR(sampled(true, -0.125f, -1.0f, 0.25f), 311.25f); /* s 0.4375, t 0.375: (1.25, 1) */
}

/* A sixteenth from each edge of each face, at every texel along the edge: 3/8 of the result is the
 * neighbour's texel. */
static void edges(void **state)
{
    (void)state;
    for (int face = 0; face < 6; ++face) {
        for (int edge = 0; edge < 4; ++edge) {
            for (int i = 0; i < SIDE; ++i) {
                const float along = -0.75f + 0.5f * (float)i, side = edge % 2 ? 1.0f : -1.0f;
                const float at = 0.9375f * side, beyond = 1.0625f * side;
                float d[3], neighbour[3];

                direction_of(face, edge < 2 ? at : along, edge < 2 ? along : at, d);
                direction_of(face, edge < 2 ? beyond : along, edge < 2 ? along : beyond, neighbour);
                NEAR(sampled(true, d[0], d[1], d[2]),
                     0.625f * texel_towards(d) + 0.375f * texel_towards(neighbour));
            }
        }
    }
    /* Worked by hand: between +x, column 0, and +z, column 3, row 0; +y, row 3, and +z, row 0. */
    NEAR(sampled(true, 1.0f, 0.75f, 1.0f), 0.5f * (0.0f + 403.0f));
    NEAR(sampled(true, -0.25f, 1.0f, 1.0f), 0.5f * (231.0f + 401.0f));
}

/* Three texels meet, each with a weight of a third. */
static void corners(void **state)
{
    (void)state;
    NEAR(sampled(true, 1.0f, 1.0f, 1.0f), (403.0f + 0.0f + 233.0f) / 3.0f);
    NEAR(sampled(true, -1.0f, -1.0f, -1.0f), (533.0f + 130.0f + 330.0f) / 3.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const float d[3] = {corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f,
                            corner & 4 ? 1.0f : -1.0f};
        float sum = 0.0f;

        for (int axis = 0; axis < 3; ++axis) {
            float towards[3] = {d[0], d[1], d[2]};

            towards[axis] *= 1.125f;
            sum += texel_towards(towards);
        }
        NEAR(sampled(true, d[0], d[1], d[2]), sum / 3.0f);
    }
}

/* In the order from the upper left round. The missing texel at a corner is the mean of the
 * others. */
static void gathers(void **state)
{
    (void)state;
    static const float expected[3][4] = {
        {421, 422, 412, 411}, {403, 0, 212, 233}, {423, 20, 10, 413}};
    const float directions[3][3] = {{0, 0, 1}, {1, 1, 1}, {1, 0, 1}};
    const gn_texture t = numbered();
    const gn_sampler s = filtered(true);

    for (int i = 0; i < 3; ++i) {
        float at[3][GN_LANES], texel[4][GN_LANES];
        gn_lookup lookup;

        memset(&lookup, 0, sizeof lookup);
        for (int n = 0; n < 3; ++n) {
            for (int l = 0; l < GN_LANES; ++l)
                at[n][l] = directions[i][n];
            lookup.coordinate[n] = at[n];
        }
        gn_gather(&t, &s, &lookup, 0, texel);
        for (int k = 0; k < 4; ++k)
            NEAR(texel[k][9], expected[i][k]);
    }
}

/* All texels of level n of a cube of 8x8 are n. */
static gn_texture levelled(void)
{
    enum { LARGEST = 8, LEVELS = 4 };
    static float texels[6 * (64 + 16 + 4 + 1)];
    gn_texture t;
    size_t used = 0;

    for (int n = 0; n < LEVELS; ++n)
        for (int i = 0; i < 6 * (LARGEST >> n) * (LARGEST >> n); ++i)
            texels[used++] = (float)n;
    assert_int_equal(
        gn_texture_packed(GN_TEXTURE_CUBE, GN_FORMAT_R32F, LARGEST, LARGEST, 0, LEVELS, texels, &t),
        GN_OK);
    return t;
}

/* s = (sc / ma + 1) / 2. So if a direction changes along sc, s moves by half of the change; along
 * ma by sc / 2 in the opposite direction; in units of ma. Here that is 2 texels of 8, or 4 for a
 * length of 2 and so on. */
static void levels_of_gradients(void **state)
{
    (void)state;
    static const struct {
        float at[3], gradient[3], level;
    } cases[] = {{{0, 0, 1}, {0.5f, 0, 0}, 1},       {{0, 0, -1}, {0, 1, 0}, 2},
                 {{0.5f, 0, 1}, {0, 0, 1}, 1},       {{-1, 0, 0.5f}, {2, 0, 0}, 2},
                 {{0, 4, 2}, {0, 0, 2}, 1},          {{0.25f, -1, 0}, {1, 0, 0}, 2},
                 {{0.25f, -1, 0}, {0, 2, 0}, 1},     {{1, 0, 0}, {5, 0, 0}, 0},
                 {{0, 0, 1}, {0.5f, 0.5f, 0}, 1.5f}, {{0, 0, 1}, {INFINITY, 0, 0}, 0}};
    const gn_texture t = levelled();
    gn_sampler s = filtered(false);

    s.minify = GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        float at[3][GN_LANES], gradient[3][GN_LANES], texel[4][GN_LANES];
        static const float none[GN_LANES];
        gn_lookup lookup;

        memset(&lookup, 0, sizeof lookup);
        lookup.lod_source = GN_LOD_GRADIENTS;
        for (int n = 0; n < 3; ++n) {
            for (int l = 0; l < GN_LANES; ++l) {
                at[n][l] = cases[i].at[n];
                gradient[n][l] = cases[i].gradient[n];
            }
            lookup.coordinate[n] = at[n];
            lookup.gradient_x[n] = i % 2 ? none : gradient[n];
            lookup.gradient_y[n] = i % 2 ? gradient[n] : none;
        }
        gn_sample(&t, &s, &lookup, texel);
        NEAR(texel[0][6], cases[i].level);
    }
}

/* Differences are those of each lane's row and column: 2 texels in the right column of a quad, 1 in
 * the left one. */
static void levels_of_differences(void **state)
{
    (void)state;
    const gn_texture t = levelled();
    gn_sampler s = filtered(false);
    float at[3][GN_LANES], texel[4][GN_LANES];
    gn_lookup lookup;

    memset(&lookup, 0, sizeof lookup);
    s.minify = GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    for (int l = 0; l < GN_LANES; ++l) {
        at[0][l] = 0.0f;
        at[1][l] = (l & 4 ? 1.0f : 0.0f) * (l & 1 ? 1.0f : 0.5f);
        at[2][l] = 2.0f;
    }
    for (int n = 0; n < 3; ++n)
        lookup.coordinate[n] = at[n];
    gn_sample(&t, &s, &lookup, texel);
    for (int l = 0; l < GN_LANES; ++l)
        NEAR(texel[0][l], l & 1 ? 1.0f : 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faces),
        cmocka_unit_test(every_texel_of_every_face),
        cmocka_unit_test(ties),
        cmocka_unit_test(directions_of_nan),
        cmocka_unit_test(linear_within_a_face),
        cmocka_unit_test(edges),
        cmocka_unit_test(corners),
        cmocka_unit_test(gathers),
        cmocka_unit_test(levels_of_gradients),
        cmocka_unit_test(levels_of_differences),
    };
    return cmocka_run_group_tests_name("cubes", tests, NULL, NULL);
}
