/* Planes of a view volume; boxes and spheres against these planes; transformed boxes: values worked
 * by hand, statuses, results left untouched. tests/property compares all of them with exact
 * values. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

#define HALF 0.70710678f /* 1 / sqrt(2) */

/* A right angle of view from the origin along -z, from 1 to 3: x' = x, y' = y,
 * z' = -2 z - 3, w' = -z. */
static const gn_mat4 camera_no = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -2, -1}, {0, 0, -3, 0}}};

/* The camera above, with z' = -1.5 z - 1.5. */
static const gn_mat4 camera_zo = {
    {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1.5f, -1}, {0, 0, -1.5f, 0}}};

static gn_status planes_of(bool zero_to_one, const gn_mat4 *m, gn_plane planes[GN_PLANE_COUNT])
{
    return zero_to_one ? gn_frustum_planes_zo(m, planes) : gn_frustum_planes_no(m, planes);
}

static void assert_plane(const gn_plane *plane, const float expected[4])
{
    assert_float_equal(plane->normal.x, expected[0], 1e-7f);
    assert_float_equal(plane->normal.y, expected[1], 1e-7f);
    assert_float_equal(plane->normal.z, expected[2], 1e-7f);
    assert_float_equal(plane->offset, expected[3], 5e-7f);
}

/* The sides of these cameras. */
#define SIDES                                                                                      \
    {HALF, 0, -HALF, 0}, {-HALF, 0, -HALF, 0}, {0, HALF, -HALF, 0},                                \
    {                                                                                              \
        0, -HALF, -HALF, 0                                                                         \
    }

/* An infinite volume has no plane at its far end. */
static void planes_of_both_conventions(void **state)
{
    gn_transform far_off[2];

    assert_int_equal(gn_frustum_rh_no_infinite(-1, 1, -1, 1, 1, &far_off[0]), GN_OK);
    assert_int_equal(gn_frustum_rh_zo_infinite_reversed(-1, 1, -1, 1, 1, &far_off[1]), GN_OK);
    const struct {
        const gn_mat4 *m;
        float planes[GN_PLANE_COUNT][4];
    } cases[] = {{&camera_no, {SIDES, {0, 0, -1, -1}, {0, 0, 1, 3}}},
                 {&camera_zo, {SIDES, {0, 0, -1, -1}, {0, 0, 1, 3}}},
                 {&far_off[0].matrix, {SIDES, {0, 0, -1, -1}, {0, 0, 0, 1}}},
                 {&far_off[1].matrix, {SIDES, {0, 0, 0, 1}, {0, 0, -1, -1}}}};

    for (int i = 0; i < 4; ++i) {
        gn_plane p[GN_PLANE_COUNT];

        assert_int_equal(planes_of(i % 2, cases[i].m, p), GN_OK);
        for (int n = 0; n < GN_PLANE_COUNT; ++n)
            assert_plane(&p[n], cases[i].planes[n]);
        assert_int_equal(gn_cull_sphere(p, (gn_vec3){0, 0, -1e30f}, 2.0f),
                         i < 2 ? GN_OUTSIDE : GN_INSIDE);
        assert_int_equal(gn_cull_sphere(p, (gn_vec3){0, 0, 1}, 1.9f), GN_OUTSIDE);
    }
}

/* Bounds without a normal: z' is -5, or 0, for every point. */
static void bounds_may_hold_no_point(void **state)
{
    gn_mat4 m = camera_zo;
    gn_plane p[GN_PLANE_COUNT];
    const gn_vec3 inside = {0, 0, -2};
    const gn_box box = {{-0.1f, -0.1f, -2.1f}, {0.1f, 0.1f, -2.0f}};

    m.m[2][2] = 0.0f;
    for (int zero = 0; zero < 2; ++zero) {
        const gn_containment expected = zero ? GN_INTERSECTING : GN_OUTSIDE;

        m.m[3][2] = zero ? 0.0f : -5.0f;
        assert_int_equal(gn_frustum_planes_zo(&m, p), GN_OK);
        assert_plane(&p[GN_PLANE_NEAR], (const float[4]){0, 0, 0, zero ? 0.0f : -1.0f});
        assert_int_equal(gn_cull_sphere(p, inside, 0.25f), expected);
        assert_int_equal(gn_cull_sphere(p, inside, 100.0f), expected);
        assert_int_equal(gn_cull_box(p, &box), expected);
    }
}

/* z' >= 0 is z' alone: that w' + z' overflows does not matter, as it does for -w' <= z'. */
static void near_plane_of_large_numbers(void **state)
{
    gn_plane p[GN_PLANE_COUNT];
    gn_mat4 m = camera_zo;

    for (int column = 0; column < 4; ++column)
        m.m[column][2] = m.m[column][3] = column == 2 ? -2e38f : 0.0f;
    assert_int_equal(gn_frustum_planes_no(&m, p), GN_OUT_OF_RANGE);
    m.m[2][2] = m.m[2][3] = -8e37f;
    assert_int_equal(gn_frustum_planes_zo(&m, p), GN_OK);
    assert_plane(&p[GN_PLANE_NEAR], (const float[4]){0, 0, -1, 0});
}

static void bad_matrices_are_named(void **state)
{
    gn_plane planes[GN_PLANE_COUNT], before[GN_PLANE_COUNT];
    static const struct {
        bool zero_to_one;
        int column, row;
        float entry;
        gn_status status;
    } cases[] = {
        {false, 3, 0, NAN, GN_NOT_FINITE},
        {true, 3, 0, INFINITY, GN_NOT_FINITE},
        {false, 0, 0, FLT_MAX, GN_OUT_OF_RANGE}, /* its length is a float, the reciprocal is not */
        {true, 2, 2, 0x1p-127f, GN_OUT_OF_RANGE},
        {true, 2, 2, 0x1p-126f, GN_OK}, /* 1.5 * 2^126 away: a float */
    };
    gn_mat4 m = camera_no;

    memset(before, 0x5A, sizeof before);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        m = cases[i].zero_to_one ? camera_zo : camera_no;
        m.m[cases[i].column][cases[i].row] = cases[i].entry;
        memcpy(planes, before, sizeof planes);
        assert_int_equal(planes_of(cases[i].zero_to_one, &m, planes), cases[i].status);
        assert_int_equal(memcmp(planes, before, sizeof before) != 0, cases[i].status == GN_OK);
    }
    memcpy(planes, before, sizeof planes);
    m.m[3][2] = 4.0f; /* 2^128 away */
    assert_int_equal(gn_frustum_planes_zo(&m, planes), GN_OUT_OF_RANGE);
    m = camera_no;
    m.m[3][1] = m.m[3][3] = FLT_MAX; /* the sum of the two */
    assert_int_equal(gn_frustum_planes_no(&m, planes), GN_OUT_OF_RANGE);
    assert_int_equal(gn_frustum_planes_no(NULL, planes), GN_NULL_POINTER);
    assert_int_equal(gn_frustum_planes_no(&m, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_frustum_planes_zo(NULL, planes), GN_NULL_POINTER);
    assert_memory_equal(planes, before, sizeof before);
}

/* The volume's section at z = -2 is -2..2 in x and y. */
static void boxes_by_hand(void **state)
{
    const struct {
        gn_vec3 min, max;
        gn_containment answer;
    } cases[] = {
        {{-1, -1, -2.5f}, {1, 1, -1.5f}, GN_INSIDE},
        {{-9, -9, -9}, {9, 9, 9}, GN_INTERSECTING},          /* around the whole volume */
        {{2.6f, -1, -2.5f}, {3, 1, -2}, GN_OUTSIDE},         /* to the right */
        {{-1, -1, -0.99f}, {1, 1, 1}, GN_OUTSIDE},           /* in front of the near plane */
        {{2.5f, -1, -2.5f}, {3, 1, -2}, GN_INTERSECTING},    /* an edge on the right plane */
        {{-1, -1, -1}, {1, 1, 1}, GN_INTERSECTING},          /* a face on the near plane */
        {{0, 0, -2}, {0, 0, -2}, GN_INSIDE},                 /* a point */
        {{3.5f, -3, -4.2f}, {4, 3, -2.9f}, GN_INTERSECTING}, /* past the edge of right and far */
        {{1, 0, -2}, {-1, 1, -2}, GN_INTERSECTING},          /* no box */
        {{NAN, 9, 9}, {9, 9, 9}, GN_INTERSECTING},
        {{9, 9, 9}, {9, INFINITY, 9}, GN_INTERSECTING},
    };
    gn_plane planes[GN_PLANE_COUNT];

    assert_int_equal(gn_frustum_planes_no(&camera_no, planes), GN_OK);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
        if (gn_cull_box(planes, &(const gn_box){cases[i].min, cases[i].max}) != cases[i].answer)
            fail_msg("case %zu", i);
}

static void spheres_by_hand(void **state)
{
    const struct {
        gn_vec3 center;
        float radius;
        gn_containment answer;
    } cases[] = {
        {{0, 0, -2}, 0.99f, GN_INSIDE},      /* near and far are 1 away, the sides sqrt(2) */
        {{0, 0, -2}, 1.0f, GN_INTERSECTING}, /* touches both from inside */
        {{0, 0, -2}, 0.0f, GN_INSIDE},        {{0, 0, 1}, 1.99f, GN_OUTSIDE},
        {{0, 0, 1}, 2.0f, GN_INTERSECTING}, /* touches the near plane */
        {{0, 0, -5}, 1.99f, GN_OUTSIDE},      {{0, 0, -5}, 2.0f, GN_INTERSECTING},
        {{4, 0, -2}, 1.41f, GN_OUTSIDE}, /* (4 - 2) / sqrt(2) = 1.4142 from the right plane */
        {{4, 0, -2}, 1.42f, GN_INTERSECTING}, {{0, -4, -2}, 1.41f, GN_OUTSIDE},
        {{0, 0, 5}, -1.0f, GN_INTERSECTING}, /* no spheres */
        {{0, 0, 5}, NAN, GN_INTERSECTING},    {{0, 0, 5}, INFINITY, GN_INTERSECTING},
        {{0, NAN, 5}, 1.0f, GN_INTERSECTING}, {{0, 0, FLT_MAX}, FLT_MAX, GN_INTERSECTING},
        {{0, 0, FLT_MAX}, 0.0f, GN_OUTSIDE},
    };
    gn_plane planes[GN_PLANE_COUNT];
    assert_int_equal(gn_frustum_planes_no(&camera_no, planes), GN_OK);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
        if (gn_cull_sphere(planes, cases[i].center, cases[i].radius) != cases[i].answer)
            fail_msg("case %zu", i);
}

/* The stored normal is (0.75 * 2^-149, 0, 1) with x rounded to 2^-149. At x = 2^127 the distance is
 * (0.75 - 0.875) * 2^-22, but the sum of the stored numbers is (1 - 0.875) * 2^-22. The other five
 * bounds are far away. */
static void underflow_decides_nothing(void **state)
{
    const gn_mat4 m = {
        {{0, 0, 0x1.8p-75f, 0}, {0, 0, 0, 0}, {0, 0, 0x1p75f, 0}, {0, 0, -0x1.cp52f, 0x1p100f}}};
    const gn_vec3 point = {0x1p127f, 0, 0};
    const gn_box box = {point, point};
    gn_plane planes[GN_PLANE_COUNT];
    assert_int_equal(gn_frustum_planes_zo(&m, planes), GN_OK);
    assert_true(planes[GN_PLANE_NEAR].normal.x == 0x1p-149f);
    assert_true(planes[GN_PLANE_NEAR].offset == -0x1.cp-23f);
    assert_int_equal(gn_cull_box(planes, &box), GN_INTERSECTING);
    assert_int_equal(gn_cull_sphere(planes, point, 0.0f), GN_INTERSECTING);
}

/* A quarter turn about z, twice as large, at (10, 20, 30): (x, y, z) to
 * (10 - 2 y, 20 + 2 x, 30 + 2 z). */
static void transformed_boxes(void **state)
{
    const gn_mat4 m = {{{0, 2, 0, 0}, {-2, 0, 0, 0}, {0, 0, 2, 0}, {10, 20, 30, 1}}};
    gn_box box = {{1, 2, 3}, {4, 8, 5}}, result;

    assert_int_equal(gn_mat4_transform_box(&m, &box, &result), GN_OK);
    assert_float_equal(result.min.x, -6, 1e-4f);
    assert_float_equal(result.max.z, 40, 1e-4f);
    assert_int_equal(gn_mat4_transform_box(&m, &box, &box), GN_OK);
    assert_memory_equal(&box, &result, sizeof box);

    /* 0.75 * 2^-149 and its negative are not floats. */
    const gn_mat4 tiny = {
        {{0x1.8p-75f, 0, 0, 0}, {0, -0x1.8p-75f, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}}};
    const gn_box small = {{0x1p-75f, 0x1p-75f, 0}, {0x1p-75f, 0x1p-75f, 0}};
    assert_int_equal(gn_mat4_transform_box(&tiny, &small, &result), GN_OK);
    assert_true(result.min.x <= 0 && result.max.x > 0 && result.min.y < 0 && result.max.y >= 0);
}

static void bad_boxes_are_named(void **state)
{
    static const struct {
        float entry;
        gn_box box;
        gn_status status;
    } cases[] = {{1, {{0, NAN, 0}, {1, 1, 1}}, GN_NOT_FINITE},
                 {1, {{0, 0, 0}, {1, 1, INFINITY}}, GN_NOT_FINITE},
                 {1, {{0, 2, 0}, {1, 1, 1}}, GN_OUT_OF_RANGE}, /* empty */
                 {2, {{0, 0, 0}, {FLT_MAX, 1, 1}}, GN_OUT_OF_RANGE},
                 {NAN, {{0, 0, 0}, {1, 1, 1}}, GN_NOT_FINITE}};
    gn_box result, before;
    gn_mat4 m;

    memset(&result, 0x5A, sizeof result);
    before = result;
    gn_mat4_identity(&m);
    assert_int_equal(gn_mat4_transform_box(NULL, &before, &result), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_transform_box(&m, NULL, &result), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_transform_box(&m, &before, NULL), GN_NULL_POINTER);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        m.m[0][0] = cases[i].entry;
        assert_int_equal(gn_mat4_transform_box(&m, &cases[i].box, &result), cases[i].status);
    }
    assert_memory_equal(&result, &before, sizeof before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_of_both_conventions),
        cmocka_unit_test(bounds_may_hold_no_point),
        cmocka_unit_test(near_plane_of_large_numbers),
        cmocka_unit_test(bad_matrices_are_named),
        cmocka_unit_test(boxes_by_hand),
        cmocka_unit_test(spheres_by_hand),
        cmocka_unit_test(underflow_decides_nothing),
        cmocka_unit_test(transformed_boxes),
        cmocka_unit_test(bad_boxes_are_named),
    };
    return cmocka_run_group_tests_name("culling", tests, NULL, NULL);
}
