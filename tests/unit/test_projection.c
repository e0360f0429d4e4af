/* Projections and the viewport: where the corners of the view volume go, there and back, every
 * status, results left untouched. cglm is a second source. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "untouched.h"

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

static void assert_near(const gn_mat4 *got, const gn_mat4 *expected, float tolerance)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            assert_float_equal(got->m[column][row], expected->m[column][row], tolerance);
}

/* The point goes to ndc, and from there, with its w, back to itself. */
static void assert_projected(const gn_transform *transform, float x, float y, float z, float ndc_x,
                             float ndc_y, float ndc_z)
{
    const gn_vec4 point = {x, y, z, 1.0f};
    gn_vec4 clip = gn_mat4_multiply_vec4(&transform->matrix, point);
    assert_float_equal(clip.x / clip.w, ndc_x, 2e-6f);
    assert_float_equal(clip.y / clip.w, ndc_y, 2e-6f);
    assert_float_equal(clip.z / clip.w, ndc_z, 2e-6f);
    gn_vec4 back = gn_mat4_multiply_vec4(&transform->inverse, clip);
    assert_float_equal(back.x, x, 2e-5f);
    assert_float_equal(back.y, y, 2e-5f);
    assert_float_equal(back.z, z, 2e-5f);
    assert_float_equal(back.w, 1.0f, 2e-6f);
}

static void orthographic(void **state)
{
    (void)state;
    gn_mat4 expected;
    gn_transform t;
    assert_int_equal(gn_orthographic_rh_no(-2, 6, -1, 3, 0.5f, 20, &t), GN_OK);
    glm_ortho_rh_no(-2, 6, -1, 3, 0.5f, 20, expected.m);
    assert_near(&t.matrix, &expected, 1e-6f);
    assert_projected(&t, -2, -1, -0.5f, -1, -1, -1);
    assert_projected(&t, 6, 3, -20, 1, 1, 1);
    assert_projected(&t, 2, 1, -10.25f, 0, 0, 0);
    /* Planes in the other order, and planes behind the eye. */
    assert_int_equal(gn_orthographic_rh_no(6, -2, 3, -1, 20, -3, &t), GN_OK);
    assert_projected(&t, 6, 3, -20, -1, -1, -1);
    assert_projected(&t, -2, -1, 3, 1, 1, 1);
    /* Centred: no negative zero in the inverse. */
    assert_int_equal(gn_orthographic_rh_no(-1, 1, -1, 1, -1, 1, &t), GN_OK);
    assert_false(signbit(t.matrix.m[3][0]) || signbit(t.inverse.m[3][0]));
}

static void frustum(void **state)
{
    (void)state;
    gn_mat4 expected;
    gn_transform t;
    assert_int_equal(gn_frustum_rh_no(-0.2f, 0.6f, -0.1f, 0.3f, 0.5f, 20, &t), GN_OK);
    glm_frustum_rh_no(-0.2f, 0.6f, -0.1f, 0.3f, 0.5f, 20, expected.m);
    assert_near(&t.matrix, &expected, 1e-6f);
    assert_projected(&t, -0.2f, -0.1f, -0.5f, -1, -1, -1);
    assert_projected(&t, 0.6f, 0.3f, -0.5f, 1, 1, -1);
    assert_projected(&t, 24, 12, -20, 1, 1, 1);
    /* Depth the other way round. */
    assert_int_equal(gn_frustum_rh_no(-0.2f, 0.6f, -0.1f, 0.3f, 20, 0.5f, &t), GN_OK);
    assert_projected(&t, -0.2f, -0.1f, -20, -1, -1, -1);
    assert_projected(&t, 0.015f, 0.0075f, -0.5f, 1, 1, 1);
}

static void perspective(void **state)
{
    (void)state;
    gn_mat4 expected;
    gn_transform t;
    for (float fov = 0.1f; fov < 3.0f; fov += 0.3f) {
        assert_int_equal(gn_perspective_rh_no(fov, 1.5f, 0.5f, 200, &t), GN_OK);
        glm_perspective_rh_no(fov, 1.5f, 0.5f, 200, expected.m);
        assert_near(&t.matrix, &expected, 3e-6f);
    }
    /* With a right angle from bottom to top, y = z is the border. */
    assert_int_equal(gn_perspective_rh_no(0.5f * GN_PI, 2, 1, 10, &t), GN_OK);
    assert_projected(&t, 2, 1, -1, 1, 1, -1);
    assert_projected(&t, -20, -10, -10, -1, -1, 1);
    assert_int_equal(gn_perspective_rh_no(0.5f * GN_PI, 2, 10, 1, &t), GN_OK);
    assert_projected(&t, 2, 1, -1, 1, 1, 1);
    /* The widest angle that a float represents. */
    assert_int_equal(gn_perspective_rh_no(nextafterf(GN_PI, 0.0f), 1, 1, 10, &t), GN_OK);
}

static void viewport(void **state)
{
    (void)state;
    gn_transform t;
    assert_int_equal(gn_viewport_no(10, 20, 640, 480, 0, 1, &t), GN_OK);
    assert_projected(&t, -1, -1, -1, 10, 20, 0);
    assert_projected(&t, 1, 1, 1, 650, 500, 1);
    assert_projected(&t, 0, 0, 0, 330, 260, 0.5f);
    assert_int_equal(gn_viewport_no(-3.5f, 0, 1, 1, 0.75f, 0.25f, &t), GN_OK);
    assert_projected(&t, -1, 0, -1, -3.5f, 0.5f, 0.75f);
    assert_projected(&t, 1, 0, 1, -2.5f, 0.5f, 0.25f);
}

/* The reference computes 0.5 * (f - n) and 0.5 * (n + f) in double. */
static void viewport_depth_is_the_rasterizers(void **state)
{
    (void)state;
    uint32_t random = 1;
    for (int i = 0; i < 10000; ++i) {
        float range[2];
        for (int j = 0; j < 2; ++j) {
            random = random * 1664525u + 1013904223u;
            range[j] = ldexpf((float)(random >> 8), -24 - (int)(random >> 3 & 31));
        }
        if (range[0] == range[1])
            continue;
        gn_transform t;
        assert_int_equal(gn_viewport_no(0, 0, 5, 3, range[0], range[1], &t), GN_OK);
        assert_true(t.matrix.m[2][2] == (float)(0.5 * ((double)range[1] - (double)range[0])));
        assert_true(t.matrix.m[3][2] == (float)(0.5 * ((double)range[0] + (double)range[1])));
    }
}

static void numbers_must_be_finite(void **state)
{
    (void)state;
    const float bad[3] = {NAN, INFINITY, -INFINITY};
    gn_transform t = marked();
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 3; ++j) {
            float n[6] = {-1, 1, -1, 1, 1, 10}, v[6] = {0, 0, 8, 8, 0, 1};
            float p[4] = {1, 1, 1, 10};
            n[i] = v[i] = p[i % 4] = bad[j];
            assert_int_equal(gn_orthographic_rh_no(n[0], n[1], n[2], n[3], n[4], n[5], &t),
                             GN_NOT_FINITE);
            assert_int_equal(gn_frustum_rh_no(n[0], n[1], n[2], n[3], n[4], n[5], &t),
                             GN_NOT_FINITE);
            assert_int_equal(gn_viewport_no(v[0], v[1], v[2], v[3], v[4], v[5], &t), GN_NOT_FINITE);
            assert_int_equal(gn_perspective_rh_no(p[0], p[1], p[2], p[3], &t), GN_NOT_FINITE);
        }
    }
    assert_untouched(&t);
}

static void volumes_must_have_an_extent(void **state)
{
    (void)state;
    gn_transform t = marked();
    assert_int_equal(gn_orthographic_rh_no(2, 2, -1, 1, 1, 10, &t), GN_SINGULAR);
    assert_int_equal(gn_orthographic_rh_no(-1, 1, 0, -0.0f, 1, 10, &t), GN_SINGULAR);
    assert_int_equal(gn_orthographic_rh_no(-1, 1, -1, 1, 3, 3, &t), GN_SINGULAR);
    assert_int_equal(gn_frustum_rh_no(2, 2, -1, 1, 1, 10, &t), GN_SINGULAR);
    assert_int_equal(gn_frustum_rh_no(-1, 1, 0, -0.0f, 1, 10, &t), GN_SINGULAR);
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 3, 3, &t), GN_SINGULAR);
    assert_int_equal(gn_perspective_rh_no(1, 1, 3, 3, &t), GN_SINGULAR);
    assert_int_equal(gn_viewport_no(0, 0, 8, 8, 0.5f, 0.5f, &t), GN_SINGULAR);
    assert_int_equal(gn_viewport_no(0, 0, 0, 8, 0, 1, &t), GN_INVALID_VIEWPORT);
    assert_int_equal(gn_viewport_no(0, 0, 8, -1, 0, 1, &t), GN_INVALID_VIEWPORT);
    assert_untouched(&t);
}

static void numbers_must_be_in_range(void **state)
{
    (void)state;
    gn_transform t = marked();
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 0, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 1, -10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(0, 1, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(-1, 1, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(GN_PI, 1, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(1, 0, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(1, -2, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(1, 1, 0, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(1, 1, 1, 0, &t), GN_OUT_OF_RANGE);
    /* Overflow in intermediate results, and reciprocals that are not normal floats. */
    assert_int_equal(gn_orthographic_rh_no(-FLT_MAX, FLT_MAX, -1, 1, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_orthographic_rh_no(0, 1e-45f, -1, 1, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_orthographic_rh_no(3e38f, 2e38f, -1, 1, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frustum_rh_no(3e38f, 2e38f, -1, 1, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 3e38f, 2e38f, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 1e-45f, 1, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(1e-44f, 1, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_perspective_rh_no(1, 1e-44f, 1, 10, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_viewport_no(0, 0, 1e-44f, 1, 0, 1, &t), GN_OUT_OF_RANGE);
    assert_int_equal(gn_viewport_no(0, 0, 1, 1, 0, FLT_MAX, &t), GN_OUT_OF_RANGE);
    assert_untouched(&t);
}

/* Planes so far apart that second / (second - first) is no normal float: the depths of the planes
 * keep their bounds. */
static void planes_far_apart(void **state)
{
    static const struct {
        gn_status (*make)(float, float, float, float, gn_transform *);
        float z_near, z_far, depth, depth_far; /* of both planes */
    } some[] = {
        {gn_perspective_rh_zo_reversed, 1e-6f, 1e38f, 1, 0},
        {gn_perspective_rh_no_reversed, 1e-6f, 1e38f, 1, -1},
        {gn_perspective_rh_zo_reversed, 1e-5f, 3e38f, 1, 0},
        {gn_perspective_rh_zo_reversed, 0.1f, 3e38f, 1, 0},
        {gn_perspective_lh_no_reversed, 1e-3f, 3e38f, 1, -1},
        {gn_perspective_rh_zo, 3e38f, 1e-3f, 0, 1},
    };

    (void)state;
    for (size_t i = 0; i < sizeof some / sizeof *some; ++i) {
        gn_transform t;

        assert_int_equal(some[i].make(1, 1, some[i].z_near, some[i].z_far, &t), GN_OK);
        /* depth = (a z + b) / w, and w is the distance */
        const double a = (double)(t.matrix.m[2][3] * t.matrix.m[2][2]),
                     b = (double)t.matrix.m[3][2];
        assert_true(fabs(a + b / (double)some[i].z_near - (double)some[i].depth) < 12 * 0x1p-24);
        assert_true(fabs(a + b / (double)some[i].z_far - (double)some[i].depth_far) < 12 * 0x1p-24);
    }
}

static void results_are_needed(void **state)
{
    (void)state;
    assert_int_equal(gn_orthographic_rh_no(-1, 1, -1, 1, 1, 10, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 1, 10, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_perspective_rh_no(1, 1, 1, 10, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_viewport_no(0, 0, 8, 8, 0, 1, NULL), GN_NULL_POINTER);
}

/* The words name the argument that is wrong. */
static void perspective_faults(void **state)
{
    (void)state;
    static const struct {
        float fov_y, aspect, z_near, z_far;
        const char *words;
    } cases[] = {
        {NAN, 1, 1, 10, "fov_y is not finite"},
        {1, INFINITY, 1, 10, "aspect is not finite"},
        {1, 1, NAN, 10, "z_near is not finite"},
        {1, 1, 1, NAN, "z_far is not finite"},
        {1, 1, 1, -INFINITY, "z_far is not finite"},
        {0, 1, 1, 10, "fov_y is not above 0"},
        {60, 1, 1, 10, "fov_y is not below pi: it is in radians"},
        {1, 0, 1, 10, "aspect is not above 0"},
        {1, 1, 0, 10, "z_near is not above 0"},
        {1, 1, 1, -10, "z_far is not above 0"},
        {1, 1, 1, 1, "z_near equals z_far"},
        {1, 1e-44f, 1, 10, "an entry of the matrix or of its inverse would be no normal float"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const char *const words =
            gn_perspective_fault(cases[i].fov_y, cases[i].aspect, cases[i].z_near, cases[i].z_far);
        assert_non_null(words);
        assert_string_equal(words, cases[i].words);
    }
    assert_null(gn_perspective_fault(1, 1, 1, 10));
    assert_null(gn_perspective_fault(1, 1, 10, 1));
    assert_null(gn_perspective_fault(1, 1, 1, INFINITY));
}

typedef gn_status bounded(float fov_y, float aspect, float z_near, float z_far, gn_transform *t);
typedef gn_status unbounded(float fov_y, float aspect, float z_near, gn_transform *t);

/* One convention that refuses is a fault. The least magnitude of the number b in clip z = a z + b
 * is 2^-126, and exactly b is 2 n f / (f - n) for depths -1 to 1, n f / (f - n) for depths 0 to 1.
 * So it is no normal float for depths 0 to 1 if n is 2^-127, and for all depths if n is 2^-128.
 * Where reversed depths exchange n and f, the intermediate number 2 f overflows if f is 3e38; and
 * the products f / (f - n) * n and n / (f - n) * f may be rounded to either side of 2^-126. */
static void one_convention_is_a_fault(void **state)
{
    (void)state;
    static bounded *const functions[4] = {gn_perspective_rh_no, gn_perspective_rh_zo,
                                          gn_perspective_rh_no_reversed,
                                          gn_perspective_rh_zo_reversed};
    static unbounded *const infinite[4] = {
        gn_perspective_rh_no_infinite, gn_perspective_rh_zo_infinite,
        gn_perspective_rh_no_infinite_reversed, gn_perspective_rh_zo_infinite_reversed};
    static const struct {
        float z_near, z_far;
        bool fits[4];
    } cases[] = {
        {0x1p-126f, 3, {true, true, true, true}},
        {0x1p-126f, 23, {true, true, true, true}},
        {0x1p-126f, 0x1p30f, {true, true, true, true}},
        {0x1p-127f, 1, {true, false, true, false}},
        {10, 3e38f, {true, true, false, true}},
        {0x1.659c88p-127f, 0x1.287cccp-125f, {true, true, true, false}},
        {0x1p-126f, INFINITY, {true, true, true, true}},
        {0x1p-127f, INFINITY, {true, false, true, false}},
        {0x1p-128f, INFINITY, {false, false, false, false}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const float n = cases[i].z_near, f = cases[i].z_far;
        bool all = true;
        for (int k = 0; k < 4; ++k) {
            gn_transform t;
            assert_int_equal(isinf(f) ? infinite[k](1, 1, n, &t) : functions[k](1, 1, n, f, &t),
                             cases[i].fits[k] ? GN_OK : GN_OUT_OF_RANGE);
            all = all && cases[i].fits[k];
        }
        const char *const words = gn_perspective_fault(1, 1, n, f);
        if (all) {
            assert_null(words);
        } else {
            assert_non_null(words);
            assert_string_equal(
                words, "an entry of the matrix or of its inverse would be no normal float");
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orthographic),
        cmocka_unit_test(frustum),
        cmocka_unit_test(perspective),
        cmocka_unit_test(viewport),
        cmocka_unit_test(perspective_faults),
        cmocka_unit_test(one_convention_is_a_fault),
        cmocka_unit_test(viewport_depth_is_the_rasterizers),
        cmocka_unit_test(numbers_must_be_finite),
        cmocka_unit_test(volumes_must_have_an_extent),
        cmocka_unit_test(numbers_must_be_in_range),
        cmocka_unit_test(planes_far_apart),
        cmocka_unit_test(results_are_needed),
    };
    return cmocka_run_group_tests_name("projection", tests, NULL, NULL);
}
