/* Planes of a view volume; boxes and spheres against these planes; transformed boxes: values worked
 * by hand, statuses, results left untouched. cglm is a second source for planes and boxes.
 * tests/property tests bounds. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#define HALF 0.70710678f /* 1 / sqrt(2) */

/* A right angle of view from the origin along -z, from 1 to 3: x' = x, y' = y,
 * z' = -2 z - 3, w' = -z. */
static const gn_mat4 camera_no = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -2, -1}, {0, 0, -3, 0}}};

/* The camera above, with z' = -1.5 z - 1.5. */
static const gn_mat4 camera_zo = {
    {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1.5f, -1}, {0, 0, -1.5f, 0}}};

static void assert_plane(const gn_plane *plane, float x, float y, float z, float offset)
{
    assert_float_equal(plane->normal.x, x, 1e-7f);
    assert_float_equal(plane->normal.y, y, 1e-7f);
    assert_float_equal(plane->normal.z, z, 1e-7f);
    assert_float_equal(plane->offset, offset, 5e-7f);
}

static void assert_sides(const gn_plane planes[GN_PLANE_COUNT])
{
    assert_plane(&planes[GN_PLANE_LEFT], HALF, 0, -HALF, 0);
    assert_plane(&planes[GN_PLANE_RIGHT], -HALF, 0, -HALF, 0);
    assert_plane(&planes[GN_PLANE_BOTTOM], 0, HALF, -HALF, 0);
    assert_plane(&planes[GN_PLANE_TOP], 0, -HALF, -HALF, 0);
}

static void planes_of_both_depths(void **state)
{
    (void)state;
    gn_plane planes[GN_PLANE_COUNT];
    for (int zero_to_one = 0; zero_to_one < 2; ++zero_to_one) {
        assert_int_equal(zero_to_one ? gn_frustum_planes_zo(&camera_zo, planes)
                                     : gn_frustum_planes_no(&camera_no, planes),
                         GN_OK);
        assert_sides(planes);
        assert_plane(&planes[GN_PLANE_NEAR], 0, 0, -1, -1);
        assert_plane(&planes[GN_PLANE_FAR], 0, 0, 1, 3);
    }
}

/* The camera above, at (5, 0, 0), looking along +x: its right is +z, and view = (z, y, -x + 5). */
static void planes_in_the_world(void **state)
{
    (void)state;
    const gn_vec3 eye = {5, 0, 0}, ahead = {1, 0, 0}, up = {0, 1, 0};
    gn_transform view;
    gn_mat4 both;
    gn_plane planes[GN_PLANE_COUNT];
    assert_int_equal(gn_look_to_rh(eye, ahead, up, &view), GN_OK);
    gn_mat4_multiply(&camera_no, &view.matrix, &both);
    assert_int_equal(gn_frustum_planes_no(&both, planes), GN_OK);
    assert_plane(&planes[GN_PLANE_LEFT], HALF, 0, HALF, -5 * HALF);
    assert_plane(&planes[GN_PLANE_RIGHT], HALF, 0, -HALF, -5 * HALF);
    assert_plane(&planes[GN_PLANE_NEAR], 1, 0, 0, -6);
    assert_plane(&planes[GN_PLANE_FAR], -1, 0, 0, 8);
}

/* Left-handed and reversed matrices of the constructors have equal volumes. */
static void planes_of_every_convention(void **state)
{
    (void)state;
    gn_transform t;
    gn_plane p[GN_PLANE_COUNT];
    assert_int_equal(gn_frustum_lh_zo(-1, 1, -1, 1, 1, 3, &t), GN_OK);
    assert_int_equal(gn_frustum_planes_zo(&t.matrix, p), GN_OK);
    assert_plane(&p[GN_PLANE_LEFT], HALF, 0, HALF, 0);
    assert_plane(&p[GN_PLANE_NEAR], 0, 0, 1, -1);
    assert_plane(&p[GN_PLANE_FAR], 0, 0, -1, 3);
    assert_int_equal(gn_frustum_rh_zo_reversed(-1, 1, -1, 1, 1, 3, &t), GN_OK);
    assert_int_equal(gn_frustum_planes_zo(&t.matrix, p), GN_OK);
    assert_sides(p);
    assert_plane(&p[GN_PLANE_FAR], 0, 0, -1, -1);
    assert_plane(&p[GN_PLANE_NEAR], 0, 0, 1, 3);
    assert_int_equal(gn_orthographic_lh_no(-2, 2, -3, 3, 4, 8, &t), GN_OK);
    assert_int_equal(gn_frustum_planes_no(&t.matrix, p), GN_OK);
    assert_plane(&p[GN_PLANE_LEFT], 1, 0, 0, 2);
    assert_plane(&p[GN_PLANE_TOP], 0, -1, 0, 3);
    assert_plane(&p[GN_PLANE_NEAR], 0, 0, 1, -4);
    assert_plane(&p[GN_PLANE_FAR], 0, 0, -1, 8);
}

static void infinite_projections_have_no_far_plane(void **state)
{
    (void)state;
    const gn_vec3 far_off = {0, 0, -1e30f}, behind = {0, 0, 1};
    gn_transform t;
    gn_plane p[GN_PLANE_COUNT];
    assert_int_equal(gn_frustum_rh_no_infinite(-1, 1, -1, 1, 1, &t), GN_OK);
    assert_int_equal(gn_frustum_planes_no(&t.matrix, p), GN_OK);
    assert_plane(&p[GN_PLANE_FAR], 0, 0, 0, 1);
    assert_plane(&p[GN_PLANE_NEAR], 0, 0, -1, -1);
    assert_int_equal(gn_cull_sphere(p, far_off, 2.0f), GN_INSIDE);
    assert_int_equal(gn_cull_sphere(p, behind, 1.9f), GN_OUTSIDE);
    assert_int_equal(gn_frustum_rh_zo_infinite_reversed(-1, 1, -1, 1, 1, &t), GN_OK);
    assert_int_equal(gn_frustum_planes_zo(&t.matrix, p), GN_OK);
    assert_plane(&p[GN_PLANE_NEAR], 0, 0, 0, 1);
    assert_plane(&p[GN_PLANE_FAR], 0, 0, -1, -1);
    assert_int_equal(gn_cull_sphere(p, far_off, 2.0f), GN_INSIDE);
    assert_int_equal(gn_cull_sphere(p, behind, 1.9f), GN_OUTSIDE);
}

/* Bounds without a normal: z' is -5, or 0, for every point. */
static void bounds_may_hold_no_point(void **state)
{
    (void)state;
    gn_mat4 m = camera_zo;
    gn_plane p[GN_PLANE_COUNT];
    const gn_vec3 inside = {0, 0, -2};
    const gn_box box = {{-0.1f, -0.1f, -2.1f}, {0.1f, 0.1f, -2.0f}};
    m.m[2][2] = 0.0f;
    m.m[3][2] = -5.0f;
    assert_int_equal(gn_frustum_planes_zo(&m, p), GN_OK);
    assert_plane(&p[GN_PLANE_NEAR], 0, 0, 0, -1);
    assert_int_equal(gn_cull_sphere(p, inside, 0.25f), GN_OUTSIDE);
    assert_int_equal(gn_cull_sphere(p, inside, 100.0f), GN_OUTSIDE);
    assert_int_equal(gn_cull_box(p, &box), GN_OUTSIDE);
    m.m[3][2] = 0.0f;
    assert_int_equal(gn_frustum_planes_zo(&m, p), GN_OK);
    assert_plane(&p[GN_PLANE_NEAR], 0, 0, 0, 0);
    assert_int_equal(gn_cull_sphere(p, inside, 0.25f), GN_INTERSECTING);
    assert_int_equal(gn_cull_box(p, &box), GN_INTERSECTING);
}

/* z' >= 0 is z' alone: that w' + z' overflows does not matter, as it does for -w' <= z'. */
static void near_plane_of_large_numbers(void **state)
{
    (void)state;
    gn_plane p[GN_PLANE_COUNT];
    gn_mat4 m = camera_zo;
    for (int column = 0; column < 4; ++column)
        m.m[column][2] = m.m[column][3] = column == 2 ? -2e38f : 0.0f;
    assert_int_equal(gn_frustum_planes_no(&m, p), GN_OUT_OF_RANGE);
    m.m[2][2] = m.m[2][3] = -8e37f;
    assert_int_equal(gn_frustum_planes_zo(&m, p), GN_OK);
    assert_plane(&p[GN_PLANE_NEAR], 0, 0, -1, 0);
}

static void bad_matrices_are_named(void **state)
{
    (void)state;
    gn_plane planes[GN_PLANE_COUNT], before[GN_PLANE_COUNT];
    gn_mat4 m = camera_no;
    memset(planes, 0x5A, sizeof planes);
    memcpy(before, planes, sizeof before);
    assert_int_equal(gn_frustum_planes_no(NULL, planes), GN_NULL_POINTER);
    assert_int_equal(gn_frustum_planes_no(&m, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_frustum_planes_zo(NULL, planes), GN_NULL_POINTER);
    m.m[3][0] = NAN;
    assert_int_equal(gn_frustum_planes_no(&m, planes), GN_NOT_FINITE);
    m.m[3][0] = INFINITY;
    assert_int_equal(gn_frustum_planes_zo(&m, planes), GN_NOT_FINITE);
    m = camera_no;
    m.m[0][0] = FLT_MAX; /* its length is a normal float, the reciprocal is not */
    assert_int_equal(gn_frustum_planes_no(&m, planes), GN_OUT_OF_RANGE);
    m = camera_no;
    m.m[3][1] = m.m[3][3] = FLT_MAX; /* the sum of the two */
    assert_int_equal(gn_frustum_planes_no(&m, planes), GN_OUT_OF_RANGE);
    m = camera_zo;
    m.m[2][2] = 0x1p-127f;
    assert_int_equal(gn_frustum_planes_zo(&m, planes), GN_OUT_OF_RANGE);
    m.m[2][2] = 0x1p-126f; /* 1.5 * 2^126 away: a float */
    assert_int_equal(gn_frustum_planes_zo(&m, planes + 0), GN_OK);
    memcpy(planes, before, sizeof planes);
    m.m[3][2] = 4.0f; /* 2^128 away */
    assert_int_equal(gn_frustum_planes_zo(&m, planes), GN_OUT_OF_RANGE);
    assert_memory_equal(planes, before, sizeof before);
}

static gn_containment box_is(gn_vec3 min, gn_vec3 max)
{
    gn_plane planes[GN_PLANE_COUNT];
    const gn_box box = {min, max};
    assert_int_equal(gn_frustum_planes_no(&camera_no, planes), GN_OK);
    return gn_cull_box(planes, &box);
}

/* The volume's section at z = -2 is -2..2 in x and y. */
static void boxes_by_hand(void **state)
{
    (void)state;
    const struct {
        gn_vec3 min, max;
        gn_containment answer;
    } cases[] = {
        {{-1, -1, -2.5f}, {1, 1, -1.5f}, GN_INSIDE},
        {{-9, -9, -9}, {9, 9, 9}, GN_INTERSECTING}, /* around the whole volume */
        {{1, -1, -2.5f}, {3, 1, -1.5f}, GN_INTERSECTING},
        {{-1, -1, -2}, {1, 1, 0}, GN_INTERSECTING},  /* through the near plane */
        {{-1, -1, -4}, {1, 1, -2}, GN_INTERSECTING}, /* through the far plane */
        {{2.6f, -1, -2.5f}, {3, 1, -2}, GN_OUTSIDE}, /* to the right */
        {{-3, -1, -2.5f}, {-2.6f, 1, -2}, GN_OUTSIDE},
        {{-1, 2.6f, -2.5f}, {1, 3, -2}, GN_OUTSIDE},
        {{-1, -3, -2.5f}, {1, -2.6f, -2}, GN_OUTSIDE},
        {{-1, -1, -0.99f}, {1, 1, 1}, GN_OUTSIDE}, /* in front of the near plane */
        {{-1, -1, -4}, {1, 1, -3.01f}, GN_OUTSIDE},
        {{2.5f, -1, -2.5f}, {3, 1, -2}, GN_INTERSECTING},    /* an edge on the right plane */
        {{-1, -1, -1}, {1, 1, 1}, GN_INTERSECTING},          /* a face on the near plane */
        {{-1, -1, -4}, {1, 1, -3}, GN_INTERSECTING},         /* a face on the far plane */
        {{0, 0, -2}, {0, 0, -2}, GN_INSIDE},                 /* a point */
        {{3.5f, -3, -4.2f}, {4, 3, -2.9f}, GN_INTERSECTING}, /* past the edge of right and far */
        {{1, 0, -2}, {-1, 1, -2}, GN_INTERSECTING},          /* no box */
        {{NAN, 9, 9}, {9, 9, 9}, GN_INTERSECTING},
        {{9, 9, 9}, {9, INFINITY, 9}, GN_INTERSECTING},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
        if (box_is(cases[i].min, cases[i].max) != cases[i].answer)
            fail_msg("case %zu", i);
}

static void spheres_by_hand(void **state)
{
    (void)state;
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
    (void)state;
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

/* cglm's planes, which are right for OpenGL's depth, and its box test, which has no tolerance. */
static void cglm_agrees(void **state)
{
    (void)state;
    const gn_vec3 eye = {3, 4, 5}, target = {-1, 0.5f, 2}, up = {0.2f, 1, 0};
    gn_transform view, projection;
    gn_mat4 m;
    gn_plane planes[GN_PLANE_COUNT];
    vec4 expected[6];
    int outside = 0, within = 0;
    assert_int_equal(gn_look_at_rh(eye, target, up, &view), GN_OK);
    assert_int_equal(gn_perspective_rh_no(1.0f, 1.5f, 0.5f, 20.0f, &projection), GN_OK);
    gn_mat4_multiply(&projection.matrix, &view.matrix, &m);
    assert_int_equal(gn_frustum_planes_no(&m, planes), GN_OK);
    glm_frustum_planes(m.m, expected); /* left, right, bottom, top, near, far */
    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        const float *e = expected[i];
        const float scale = 1.0f / sqrtf(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
        assert_float_equal(planes[i].normal.x, e[0] * scale, 1e-6f);
        assert_float_equal(planes[i].normal.y, e[1] * scale, 1e-6f);
        assert_float_equal(planes[i].normal.z, e[2] * scale, 1e-6f);
        assert_float_equal(planes[i].offset, e[3] * scale, 1e-4f);
    }
    for (int i = 0; i < 1000; ++i) {
        const gn_vec3 min = {(float)(i % 10) * 2.3f - 12.0f, (float)(i / 10 % 10) * 2.1f - 10.0f,
                             (float)(i / 100) * 2.7f - 14.0f};
        const gn_box box = {min, {min.x + 1.7f, min.y + 0.9f, min.z + 2.2f}};
        vec3 corners[2] = {{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}};
        const bool seen = glm_aabb_frustum(corners, expected);
        const gn_containment answer = gn_cull_box(planes, &box);
        assert_int_equal(answer != GN_OUTSIDE, seen);
        outside += answer == GN_OUTSIDE;
        within += answer == GN_INSIDE;
    }
    assert_true(outside > 100 && within > 3);
}

/* A quarter turn about z, twice as large, at (10, 20, 30): (x, y, z) to
 * (10 - 2 y, 20 + 2 x, 30 + 2 z). */
static void transformed_boxes(void **state)
{
    (void)state;
    const gn_mat4 m = {{{0, 2, 0, 0}, {-2, 0, 0, 0}, {0, 0, 2, 0}, {10, 20, 30, 1}}};
    gn_box box = {{1, 2, 3}, {4, 8, -3 + 8}}, result;
    assert_int_equal(gn_mat4_transform_box(&m, &box, &result), GN_OK);
    const float got[6] = {result.min.x, result.min.y, result.min.z,
                          result.max.x, result.max.y, result.max.z};
    const float exact[6] = {-6, 22, 36, 6, 28, 40};
    for (int i = 0; i < 6; ++i) {
        assert_float_equal(got[i], exact[i], 40 * 12 * 0x1p-24f);
        assert_true(i < 3 ? got[i] < exact[i] : got[i] > exact[i]);
    }
    assert_int_equal(gn_mat4_transform_box(&m, &box, &box), GN_OK);
    assert_memory_equal(&box, &result, sizeof box);

    /* 0.75 * 2^-149 and its negative are not floats. */
    const gn_mat4 tiny = {
        {{0x1.8p-75f, 0, 0, 0}, {0, -0x1.8p-75f, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}}};
    const gn_box small = {{0x1p-75f, 0x1p-75f, 0}, {0x1p-75f, 0x1p-75f, 0}};
    assert_int_equal(gn_mat4_transform_box(&tiny, &small, &result), GN_OK);
    assert_true(result.min.x <= 0 && result.max.x > 0 && result.min.y < 0 && result.max.y >= 0);

    vec3 corners[2] = {{-1, -2, -3}, {3, 2, 1}}, expected[2];
    const gn_vec3 axis = {1, 2, -2};
    const gn_box other = {{-1, -2, -3}, {3, 2, 1}};
    gn_transform turn;
    assert_int_equal(gn_rotate_axis(axis, 0.7f, &turn), GN_OK);
    glm_aabb_transform(corners, turn.matrix.m, expected);
    assert_int_equal(gn_mat4_transform_box(&turn.matrix, &other, &result), GN_OK);
    assert_float_equal(result.min.x, expected[0][0], 1e-5f);
    assert_float_equal(result.min.y, expected[0][1], 1e-5f);
    assert_float_equal(result.min.z, expected[0][2], 1e-5f);
    assert_float_equal(result.max.x, expected[1][0], 1e-5f);
    assert_float_equal(result.max.y, expected[1][1], 1e-5f);
    assert_float_equal(result.max.z, expected[1][2], 1e-5f);
}

static void bad_boxes_are_named(void **state)
{
    (void)state;
    const gn_box good = {{0, 0, 0}, {1, 1, 1}}, empty = {{0, 2, 0}, {1, 1, 1}};
    const gn_box nan = {{0, NAN, 0}, {1, 1, 1}}, infinite = {{0, 0, 0}, {1, 1, INFINITY}};
    const gn_box huge = {{0, 0, 0}, {FLT_MAX, 1, 1}};
    gn_box result, before;
    gn_mat4 m;
    memset(&result, 0x5A, sizeof result);
    before = result;
    gn_mat4_identity(&m);
    assert_int_equal(gn_mat4_transform_box(NULL, &good, &result), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_transform_box(&m, NULL, &result), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_transform_box(&m, &good, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_transform_box(&m, &nan, &result), GN_NOT_FINITE);
    assert_int_equal(gn_mat4_transform_box(&m, &infinite, &result), GN_NOT_FINITE);
    assert_int_equal(gn_mat4_transform_box(&m, &empty, &result), GN_OUT_OF_RANGE);
    m.m[0][0] = 2.0f;
    assert_int_equal(gn_mat4_transform_box(&m, &huge, &result), GN_OUT_OF_RANGE);
    m.m[0][0] = NAN;
    assert_int_equal(gn_mat4_transform_box(&m, &good, &result), GN_NOT_FINITE);
    assert_memory_equal(&result, &before, sizeof before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_of_both_depths),
        cmocka_unit_test(planes_in_the_world),
        cmocka_unit_test(planes_of_every_convention),
        cmocka_unit_test(infinite_projections_have_no_far_plane),
        cmocka_unit_test(bounds_may_hold_no_point),
        cmocka_unit_test(near_plane_of_large_numbers),
        cmocka_unit_test(bad_matrices_are_named),
        cmocka_unit_test(boxes_by_hand),
        cmocka_unit_test(spheres_by_hand),
        cmocka_unit_test(underflow_decides_nothing),
        cmocka_unit_test(cglm_agrees),
        cmocka_unit_test(transformed_boxes),
        cmocka_unit_test(bad_boxes_are_named),
    };
    return cmocka_run_group_tests_name("culling", tests, NULL, NULL);
}
