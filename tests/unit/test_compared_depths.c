/* Compared depth textures, worked by hand: every function, reference values beyond the format's
 * range and NaN, and filters over the results. */
#include <math.h>
#include <string.h>

#include "unit.h"

enum { FUNCTIONS = GN_ALWAYS };

static gn_sampler compares(gn_compare function, bool is_linear)
{
    gn_sampler s;

    memset(&s, 0, sizeof s);
    s.wrap_s = s.wrap_t = GN_WRAP_CLAMP_TO_EDGE;
    s.magnify = is_linear ? GN_MAGNIFY_LINEAR : GN_MAGNIFY_NEAREST;
    s.minify = is_linear ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST;
    s.compare = function;
    return s;
}

/* The result at (s, 0.5). */
static float compared(const gn_texture *t, const gn_sampler *sampler, float s, float reference)
{
    const float at[3] = {s, 0.5f, 0.0f};
    float texel[4];

    gn_sample_at(t, sampler, at, 0.0f, reference, texel);
    assert_true(texel[1] == 0.0f && texel[2] == 0.0f && texel[3] == 1.0f);
    return texel[0];
}

static void functions(void **state)
{
    (void)state;
    static const float depth[1] = {0.5f};
    static const struct {
        float reference;
        int holds[FUNCTIONS]; /* never, <, =, <=, >, not =, >=, always */
    } cases[] = {{0.25f, {0, 1, 0, 1, 0, 1, 0, 1}},
                 {0.5f, {0, 0, 1, 1, 0, 0, 1, 1}},
                 {0.75f, {0, 0, 0, 0, 1, 1, 1, 1}},
                 {INFINITY, {0, 0, 0, 0, 1, 1, 1, 1}},
                 {NAN, {0, 0, 0, 0, 0, 1, 0, 1}}};
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, 1, 1, 0, 1, depth, &t),
                     GN_OK);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        for (int f = 0; f < FUNCTIONS; ++f) {
            const gn_sampler s = compares((gn_compare)(f + 1), false);

            assert_true(compared(&t, &s, 0.5f, cases[i].reference) == (float)cases[i].holds[f]);
        }
    }
}

/* For normalized formats, reference values are clamped to 0..1 and NaN becomes 1; for formats of
 * floats they are not. */
static void references(void **state)
{
    (void)state;
    static const uint16_t fractions[2] = {0, 65535};
    static const float floats[2] = {0.0f, 1.0f};
    const gn_sampler equal = compares(GN_EQUAL, false);
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D16, 2, 1, 0, 1, fractions, &t),
                     GN_OK);
    assert_true(compared(&t, &equal, 0.25f, -2.0f) == 1.0f);
    assert_true(compared(&t, &equal, 0.75f, -2.0f) == 0.0f);
    assert_true(compared(&t, &equal, 0.75f, 2.0f) == 1.0f);
    assert_true(compared(&t, &equal, 0.75f, NAN) == 1.0f);
    assert_true(compared(&t, &equal, 0.25f, NAN) == 0.0f);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, 2, 1, 0, 1, floats, &t),
                     GN_OK);
    assert_true(compared(&t, &equal, 0.25f, -2.0f) == 0.0f);
    assert_true(compared(&t, &equal, 0.75f, 2.0f) == 0.0f);
    assert_true(compared(&t, &equal, 0.75f, 1.0f) == 1.0f);
}

/* Only the second of the depths 0.25 and 0.75 is at least 0.5: the filter mixes results, not
 * depths. */
static void linear(void **state)
{
    (void)state;
    static const float depths[2] = {0.25f, 0.75f};
    const gn_sampler farther = compares(GN_LESS_OR_EQUAL, true);
    const gn_sampler nearer = compares(GN_GREATER_OR_EQUAL, true);
    const gn_sampler none = compares(GN_COMPARE_DEFAULT, true);
    gn_sampler never = compares(GN_NEVER, true);
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, 2, 1, 0, 1, depths, &t),
                     GN_OK);
    assert_true(compared(&t, &farther, 0.625f, 0.5f) == 0.75f);
    assert_true(compared(&t, &nearer, 0.625f, 0.5f) == 0.25f);
    assert_true(compared(&t, &farther, 0.625f, 0.125f) == 1.0f);
    assert_true(compared(&t, &none, 0.625f, 0.5f) == 0.625f);
    never.wrap_s = GN_WRAP_REPEAT; /* where the weight is NaN */
    assert_true(compared(&t, &never, INFINITY, 0.5f) == 0.0f);
}

/* Only the face +z is nearer than the reference value: a gather, an edge and a corner. */
static void cubes(void **state)
{
    (void)state;
    float depths[6 * 4], at[3][GN_LANES], reference[GN_LANES], texel[4][GN_LANES];
    const gn_sampler farther = compares(GN_LESS, true);
    const float edge[3] = {1.0f, 0.0f, 1.0f}, corner[3] = {1.0f, 1.0f, 1.0f};
    float one[4];
    gn_lookup lookup;
    gn_texture t;

    for (int i = 0; i < 6 * 4; ++i)
        depths[i] = i / 4 == 4 ? 0.25f : 0.75f;
    assert_int_equal(gn_texture_packed(GN_TEXTURE_CUBE, GN_FORMAT_D32F, 2, 2, 0, 1, depths, &t),
                     GN_OK);
    gn_sample_at(&t, &farther, edge, 0.0f, 0.5f, one);
    assert_true(one[0] == 0.5f);
    gn_sample_at(&t, &farther, corner, 0.0f, 0.5f, one);
    assert_true(fabsf(one[0] - 2.0f / 3.0f) < 1e-6f);
    memset(&lookup, 0, sizeof lookup);
    for (int n = 0; n < 3; ++n) {
        for (int l = 0; l < GN_LANES; ++l) {
            at[n][l] = edge[n];
            reference[l] = 0.5f;
        }
        lookup.coordinate[n] = at[n];
    }
    lookup.reference = reference;
    gn_gather(&t, &farther, &lookup, 3, texel);
    for (int i = 0; i < 4; ++i) /* the middle two are +x */
        assert_true(texel[i][5] == (i == 1 || i == 2 ? 1.0f : 0.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(functions),
        cmocka_unit_test(references),
        cmocka_unit_test(linear),
        cmocka_unit_test(cubes),
    };
    return cmocka_run_group_tests_name("compared depths", tests, NULL, NULL);
}
