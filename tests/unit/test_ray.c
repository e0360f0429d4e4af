/* Rays against triangles and boxes, and barycentric coordinates: values worked by hand, statuses,
 * results left untouched. test_project.c has rays through pixels, tests/property bounds. */
#include <float.h>
#include <stdbool.h>

#include "near.h"
#include "untouched.h"

/* The triangle (0,0,0), (2,0,0), (0,4,0), counterclockwise seen from +z. */
static const gn_vec3 tri_a = {0, 0, 0}, tri_b = {2, 0, 0}, tri_c = {0, 4, 0};

static void triangles_by_hand(void **state)
{
    const struct {
        gn_ray ray;
        bool hits, front;
        float t, u, v;
    } cases[] = {
        {{{0.5f, 1, 3}, {0, 0, -1}}, true, true, 3, 0.25f, 0.25f},
        {{{0.5f, 1, 3}, {0, 0, -6}}, true, true, 0.5f, 0.25f, 0.25f},
        {{{0.5f, 1, -3}, {0, 0, 1}}, true, false, 3, 0.25f, 0.25f}, /* from the back */
        {{{0.5f, 1, 3}, {0, 0, 1}}, false, false, 0, 0, 0},         /* behind the origin */
        {{{0.5f, 1, 0}, {0, 0, -1}}, true, true, 0, 0.25f, 0.25f},  /* from its plane */
        {{{0, 0, 2}, {0.25f, 0.5f, -1}}, true, true, 2, 0.25f, 0.25f},
        {{{0, 0, 1}, {0, 0, -1}}, true, true, 1, 0, 0}, /* corners */
        {{{2, 0, 1}, {0, 0, -1}}, true, true, 1, 1, 0},
        {{{0, 4, 1}, {0, 0, -1}}, true, true, 1, 0, 1},
        {{{1, 2, 1}, {0, 0, -1}}, true, true, 1, 0.5f, 0.5f}, /* the side b c */
        {{{-0.1f, 1, 1}, {0, 0, -1}}, false, false, 0, 0, 0}, /* past each side */
        {{{0.5f, -0.1f, 1}, {0, 0, -1}}, false, false, 0, 0, 0},
        {{{1.1f, 2, 1}, {0, 0, -1}}, false, false, 0, 0, 0},
        {{{-1, 1, 0}, {1, 0, 0}}, false, false, 0, 0, 0}, /* in its plane */
        {{{0.5f, 1, 1}, {1, 0, 0}}, false, false, 0, 0, 0},
        {{{0.5f, 1, 3}, {0, 0, 0}}, false, false, 0, 0, 0},
        {{{0.5f, NAN, 3}, {0, 0, -1}}, false, false, 0, 0, 0},
        {{{0.5f, 1, INFINITY}, {0, 0, -1}}, false, false, 0, 0, 0},
        {{{0.5f, 1, 3}, {0, NAN, -1}}, false, false, 0, 0, 0},
        {{{0.5f, 1, 3}, {0, 0, -INFINITY}}, false, false, 0, 0, 0},
        {{{0.5f, 1, 1e38f}, {0, 0, -0.01f}}, false, false, 0, 0, 0}, /* t overflows */
    };
    for (size_t i = 0; i < COUNT(cases); ++i) {
        gn_ray_hit hit = {-1, -1, -1}, front = hit;
        if (gn_ray_hits_triangle(&cases[i].ray, tri_a, tri_b, tri_c, &hit) != cases[i].hits ||
            gn_ray_hits_triangle_front(&cases[i].ray, tri_a, tri_b, tri_c, &front) !=
                cases[i].front)
            fail_msg("case %zu", i);
        if (cases[i].hits)
            assert_true(hit.t == cases[i].t && hit.u == cases[i].u && hit.v == cases[i].v);
        else
            assert_true(hit.t == -1 && hit.u == -1 && hit.v == -1);
        if (cases[i].front)
            assert_memory_equal(&hit, &front, sizeof hit);
        else
            assert_true(front.t == -1);
    }
}

/* Corners in a line or at one place, and corners that are not finite. */
static void degenerate_triangles_are_missed(void **state)
{
    static const gn_vec3 corners[][3] = {
        {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}},   {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {{0, 0, 0}, {2, 0, 0}, {0, NAN, 0}}, {{0, 0, 0}, {0, NAN, 0}, {0, 4, 0}},
        {{0, NAN, 0}, {2, 0, 0}, {0, 4, 0}}, {{0, INFINITY, 0}, {2, 0, 0}, {0, 4, 0}}};
    const gn_ray ray = {{0, 0, 1}, {0, 0, -1}};
    gn_ray_hit hit;

    mark(hit);
    for (size_t i = 0; i < COUNT(corners); ++i)
        assert_false(gn_ray_hits_triangle(&ray, corners[i][0], corners[i][1], corners[i][2], &hit));
    assert_untouched(hit);
}

/* A box; empty ones; a half space, all space and a point; and a box so far away that the
 * differences between its bounds and an origin are no floats, but their quotients are. */
static const gn_box boxes[] = {
    {{1, 1, 1}, {3, 3, 3}},
    {{0, 1, 0}, {1, 0, 1}},
    {{0, 0, 0}, {1, NAN, 1}},
    {{2, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}},
    {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}},
    {{1, 2, 4}, {1, 2, 4}},
    {{-0x1.8p127f, -0x1p127f, -1}, {-0x1p127f, 0x1.8p127f, 1}},
};

static void boxes_by_hand(void **state)
{
    static const struct {
        int box;
        gn_ray ray;
        bool hits;
        float enter, leave;
    } cases[] = {
        {0, {{0, 2, 2}, {1, 0, 0}}, true, 1, 3},
        {0, {{0, 2, 2}, {0.5f, -0.0f, 0}}, true, 2, 6},
        {0, {{4, 2, 2}, {-1, 0, 0}}, true, 1, 3},
        {0, {{0, 2, 2}, {-1, 0, 0}}, false, 0, 0}, /* behind */
        {0, {{2, 2, 2}, {0, 0, -2}}, true, 0, 0.5f},
        {0, {{0, 1, 2}, {1, 0, 0}}, true, 1, 3}, /* along a face */
        {0, {{0, 3, 3}, {1, 0, 0}}, true, 1, 3}, /* along an edge */
        {0, {{0, 3.001f, 2}, {1, 0, 0}}, false, 0, 0},
        {0, {{0, 0.999f, 2}, {1, 0, -0.0f}}, false, 0, 0},
        {0, {{0, 0, 0}, {1, 1, 1}}, true, 1, 3}, /* the diagonal */
        {0, {{0, 2, 4}, {1, 0, -1}}, true, 1, 3},
        {0, {{0, 2, 2}, {1, 1, 0}}, true, 1, 1},        /* the edge y = 3 of the face x = 1 */
        {0, {{0, 2.01f, 2}, {1, 1, 0}}, false, 0, 0},   /* past it */
        {0, {{3, 2, 2}, {1, 0, 0}}, true, 0, 0},        /* leaves where it begins */
        {0, {{2, 2, 2}, {0, 0, 0}}, true, 0, INFINITY}, /* a point */
        {0, {{0, 2, 2}, {0, 0, 0}}, false, 0, 0},
        {0, {{0, 2, NAN}, {1, 0, 0}}, false, 0, 0},
        {0, {{NAN, 2, 2}, {1, 0, 0}}, false, 0, 0},
        {0, {{2, 2, 2}, {0, NAN, 0}}, false, 0, 0},
        {0, {{0, 2, 2}, {INFINITY, 0, 0}}, false, 0, 0},
        {1, {{0, 0, 0}, {1, 2, 4}}, false, 0, 0},
        {2, {{0, 0, 0}, {1, 2, 4}}, false, 0, 0},
        {3, {{0, 0, 0}, {1, 2, 4}}, true, 2, INFINITY},
        {4, {{0, 0, 0}, {1, 2, 4}}, true, 0, INFINITY},
        {5, {{0, 0, 0}, {1, 2, 4}}, true, 1, 1},
        {6, {{0x1p127f, 0x1p126f, 0}, {-0x1p126f, -0x1p125f, 0}}, true, 4, 5},
        {6, {{-0x1p127f, -0x1p127f, 0}, {-0x1p123f, 0x1p126f, 0}}, true, 0, 5},
    };

    for (size_t i = 0; i < COUNT(cases); ++i) {
        gn_ray_span span;

        mark(span);
        if (gn_ray_hits_box(&cases[i].ray, &boxes[cases[i].box], &span) != cases[i].hits)
            fail_msg("case %zu", i);
        if (cases[i].hits)
            assert_true(span.enter == cases[i].enter && span.leave == cases[i].leave);
        else
            assert_untouched(span);
    }
}

/* In the plane of the triangle (0, 0), (4, 0), (0, 8), with every corner first. */
static void barycentric_in_the_plane(void **state)
{
    static const struct {
        gn_vec2 point;
        float a, b, c;
    } cases[] = {{{0, 0}, 1, 0, 0},           {{4, 0}, 0, 1, 0},  {{0, 8}, 0, 0, 1},
                 {{2, 0}, 0.5f, 0.5f, 0},     {{4, 8}, -1, 1, 1}, {{-4, 0}, 2, -1, 0},
                 {{1, 2}, 0.5f, 0.25f, 0.25f}};
    const gn_vec2 a = {0, 0}, b = {4, 0}, c = {0, 8};
    gn_vec3 w;

    for (size_t i = 0; i < COUNT(cases); ++i) {
        assert_int_equal(gn_barycentric_2d(cases[i].point, a, b, c, &w), GN_OK);
        assert_vec3(w, cases[i].a, cases[i].b, cases[i].c, 4e-7f);
        assert_int_equal(gn_barycentric_2d(cases[i].point, b, a, c, &w), GN_OK);
        assert_vec3(w, cases[i].b, cases[i].a, cases[i].c, 4e-7f);
        assert_int_equal(gn_barycentric_2d(cases[i].point, c, a, b, &w), GN_OK);
        assert_vec3(w, cases[i].c, cases[i].a, cases[i].b, 4e-7f);
    }
    assert_int_equal(gn_barycentric_2d(a, a, b, c, NULL), GN_NULL_POINTER);
}

/* In the plane z = 1, beside it, and in a triangle that is parallel to no coordinate plane, with
 * normal (1, 1, 1). */
static void barycentric_in_space(void **state)
{
    const gn_vec3 a = {0, 0, 1}, b = {4, 0, 1}, c = {0, 8, 1}, x = {1, 0, 0}, y = {0, 1, 0};
    const gn_vec3 z = {0, 0, 1}, in = {1, 2, 1};
    const struct {
        gn_vec3 point, a, b, c, weights;
    } cases[] = {{in, a, b, c, {0.5f, 0.25f, 0.25f}},
                 {{1, 2, 9}, a, b, c, {0.5f, 0.25f, 0.25f}},
                 {{1, 2, -1000}, a, c, b, {0.5f, 0.25f, 0.25f}},
                 {{4, 8, 5}, a, b, c, {-1, 1, 1}},
                 {{0.5f, 0.25f, 0.25f}, x, y, z, {0.5f, 0.25f, 0.25f}},
                 {{0, 0, 0}, x, y, z, {1.0f / 3, 1.0f / 3, 1.0f / 3}}};
    gn_vec3 w;

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const gn_vec3 expected = cases[i].weights;
        assert_int_equal(gn_barycentric_3d(cases[i].point, cases[i].a, cases[i].b, cases[i].c, &w),
                         GN_OK);
        assert_vec3(w, expected.x, expected.y, expected.z, 4e-7f);
    }
    assert_int_equal(gn_barycentric_3d(in, a, b, c, NULL), GN_NULL_POINTER);
}

static gn_status in_plane(const float *f, gn_vec3 *w)
{
    return gn_barycentric_2d((gn_vec2){f[0], f[1]}, (gn_vec2){f[2], f[3]}, (gn_vec2){f[4], f[5]},
                             (gn_vec2){f[6], f[7]}, w);
}

static gn_status in_space(const float *f, gn_vec3 *w)
{
    return gn_barycentric_3d((gn_vec3){f[0], f[1], f[2]}, (gn_vec3){f[3], f[4], f[5]},
                             (gn_vec3){f[6], f[7], f[8]}, (gn_vec3){f[9], f[10], f[11]}, w);
}

/* Corners in a line and at one place; an area that overflows, or a sum of its terms where it is 0;
 * coordinates that overflow; triangles that are too thin and too small. Every number must be
 * finite. */
static void barycentric_that_cannot_be(void **state)
{
    static const struct {
        gn_status (*function)(const float *, gn_vec3 *);
        gn_status status;
        float numbers[12];
    } cases[] = {
        {in_plane, GN_OK, {0.25f, 0.25f, 0, 0, 1, 0, 0, 1}},
        {in_plane, GN_OK, {1e30f, 0, 0, 0, 4, 0, 0, 8}},
        {in_plane, GN_DEGENERATE, {0, 0, 0, 0, 4, 0, 8, 0}},
        {in_plane, GN_DEGENERATE, {0, 0, 4, 0, 4, 0, 0, 8}},
        {in_plane, GN_DEGENERATE, {0}},
        {in_plane, GN_DEGENERATE, {0, 0, 0, 0, 1e-20f, 0, 0, 1e-20f}},
        {in_plane, GN_OUT_OF_RANGE, {0, 0, 0, 0, 1e30f, 0, 0, 1e30f}},
        {in_plane, GN_OUT_OF_RANGE, {0, 0, 0, 0, 0x1p63f, 0x1p64f, 0x1p63f, 0x1p64f}},
        {in_plane, GN_OUT_OF_RANGE, {1e30f, 0, 0, 0, 1e-10f, 0, 0, 8}},
        {in_space, GN_OK, {0.25f, 0.25f, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0}},
        {in_space, GN_DEGENERATE, {0, 0, 1, 0, 0, 1, 4, 0, 1, 8, 0, 1}},
        {in_space, GN_DEGENERATE, {0}},
        {in_space, GN_DEGENERATE, {0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1 + 0x1p-20f, 0}},
        {in_space, GN_DEGENERATE, {0, 0, 0, 0, 0, 0, 0x1p-64f, 0, 0, 0, 0x1p-64f, 0}},
        {in_space, GN_OUT_OF_RANGE, {0, 0, 1, 0, 0, 1, 1e30f, 0, 1, 0, 1e30f, 1}},
    };

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const int count = cases[i].function == in_plane ? 8 : 12;
        gn_vec3 w;

        mark(w);
        if (cases[i].function(cases[i].numbers, &w) != cases[i].status)
            fail_msg("case %zu", i);
        if (cases[i].status != GN_OK)
            assert_untouched(w);
        mark(w);
        for (int n = 0; n < 3 * count; ++n) {
            static const float bad[3] = {NAN, INFINITY, -INFINITY};
            float numbers[12];

            memcpy(numbers, cases[i].numbers, sizeof numbers);
            numbers[n / 3] = bad[n % 3];
            assert_int_equal(cases[i].function(numbers, &w), GN_NOT_FINITE);
        }
        assert_untouched(w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_by_hand),    cmocka_unit_test(degenerate_triangles_are_missed),
        cmocka_unit_test(boxes_by_hand),        cmocka_unit_test(barycentric_in_the_plane),
        cmocka_unit_test(barycentric_in_space), cmocka_unit_test(barycentric_that_cannot_be),
    };
    return cmocka_run_group_tests_name("rays", tests, NULL, NULL);
}
