/* Rays through pixels, rays against triangles and boxes, and barycentric coordinates: values worked
 * by hand, statuses, results left untouched. tests/property tests bounds. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

static void assert_vec3(gn_vec3 got, float x, float y, float z)
{
    assert_float_equal(got.x, x, 2e-7f * (1.0f + fabsf(x)));
    assert_float_equal(got.y, y, 2e-7f * (1.0f + fabsf(y)));
    assert_float_equal(got.z, z, 2e-7f * (1.0f + fabsf(z)));
}

/* A right angle of view, near plane 1 and far plane 3, in a window of 2x2 pixels, whose centres are
 * at -0.5 and 0.5 of -1..1: directions (+-0.5, +-0.5, +-1) / sqrt(1.5). */
#define ACROSS 0.40824829f
#define AHEAD 0.81649658f

static void pixels_of_opengl(void **state)
{
    (void)state;
    gn_transform projection, view, window;
    gn_ray ray;
    assert_int_equal(gn_transform_identity(&view), GN_OK);
    assert_int_equal(gn_viewport_no(0, 0, 2, 2, 0, 1, &window), GN_OK);
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 1, 3, &projection), GN_OK);
    assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &window, 0, 0, &ray), GN_OK);
    assert_vec3(ray.origin, -0.5f, -0.5f, -1);
    assert_vec3(ray.direction, -ACROSS, -ACROSS, -AHEAD);
    assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &window, 1, 0, &ray), GN_OK);
    assert_vec3(ray.origin, 0.5f, -0.5f, -1);
    assert_vec3(ray.direction, ACROSS, -ACROSS, -AHEAD);
    /* Between four pixels. */
    assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &window, 0.5f, 0.5f, &ray), GN_OK);
    assert_vec3(ray.direction, 0, 0, -1);

    assert_int_equal(gn_frustum_rh_no_infinite(-1, 1, -1, 1, 1, &projection), GN_OK);
    assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &window, 1, 1, &ray), GN_OK);
    assert_vec3(ray.origin, 0.5f, 0.5f, -1);
    assert_vec3(ray.direction, ACROSS, ACROSS, -AHEAD);

    assert_int_equal(gn_orthographic_rh_no(-4, 4, -4, 4, 1, 3, &projection), GN_OK);
    assert_int_equal(gn_ray_through_pixel_no(&projection, &view, &window, 0, 1, &ray), GN_OK);
    assert_vec3(ray.origin, -2, 2, -1);
    assert_vec3(ray.direction, 0, 0, -1);
}

static void pixels_of_direct3d(void **state)
{
    (void)state;
    /* At (0, 0, 5), looking along -x; z is to the right. */
    const gn_vec3 eye = {0, 0, 5}, ahead = {-1, 0, 0}, up = {0, 1, 0};
    gn_transform projection, view, window;
    gn_ray ray;
    assert_int_equal(gn_look_to_lh(eye, ahead, up, &view), GN_OK);
    assert_int_equal(gn_viewport_zo_y_down(0, 0, 2, 2, 0, 1, &window), GN_OK);
    assert_int_equal(gn_frustum_lh_zo(-1, 1, -1, 1, 1, 3, &projection), GN_OK);
    assert_int_equal(gn_ray_through_pixel_zo(&projection, &view, &window, 1, 0, &ray), GN_OK);
    assert_vec3(ray.origin, -1, 0.5f, 5.5f);
    assert_vec3(ray.direction, -AHEAD, ACROSS, ACROSS);
    assert_int_equal(gn_orthographic_lh_zo(-4, 4, -4, 4, 1, 3, &projection), GN_OK);
    assert_int_equal(gn_ray_through_pixel_zo(&projection, &view, &window, 1, 0, &ray), GN_OK);
    assert_vec3(ray.origin, -1, 2, 7);
    assert_vec3(ray.direction, -1, 0, 0);
}

/* Reversed depth, y down in clip space and on the screen. */
static void pixels_of_vulkan(void **state)
{
    (void)state;
    gn_transform projection, flip, view, window;
    gn_ray ray;
    assert_int_equal(gn_transform_identity(&view), GN_OK);
    assert_int_equal(gn_viewport_zo(0, 0, 2, 2, 0, 1, &window), GN_OK);
    assert_int_equal(gn_flip_y(&flip), GN_OK);
    for (int infinite = 0; infinite < 2; ++infinite) {
        assert_int_equal(infinite ? gn_frustum_rh_zo_infinite_reversed(-1, 1, -1, 1, 1, &projection)
                                  : gn_frustum_rh_zo_reversed(-1, 1, -1, 1, 1, 3, &projection),
                         GN_OK);
        assert_int_equal(gn_transform_compose(&flip, &projection, &projection), GN_OK);
        assert_int_equal(gn_ray_through_pixel_reversed(&projection, &view, &window, 0, 0, &ray),
                         GN_OK);
        assert_vec3(ray.origin, -0.5f, 0.5f, -1);
        assert_vec3(ray.direction, -ACROSS, ACROSS, -AHEAD);
    }
}

static void impossible_pixels_are_named(void **state)
{
    (void)state;
    gn_transform projection, view, window, bad;
    gn_ray ray, before;
    memset(&ray, 0x5A, sizeof ray);
    before = ray;
    assert_int_equal(gn_transform_identity(&view), GN_OK);
    assert_int_equal(gn_viewport_no(0, 0, 2, 2, 0, 1, &window), GN_OK);
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 1, 3, &projection), GN_OK);
    gn_status (*const f)(const gn_transform *, const gn_transform *, const gn_transform *, float,
                         float, gn_ray *) = gn_ray_through_pixel_no;
    assert_int_equal(f(NULL, &view, &window, 0, 0, &ray), GN_NULL_POINTER);
    assert_int_equal(f(&projection, NULL, &window, 0, 0, &ray), GN_NULL_POINTER);
    assert_int_equal(f(&projection, &view, NULL, 0, 0, &ray), GN_NULL_POINTER);
    assert_int_equal(f(&projection, &view, &window, 0, 0, NULL), GN_NULL_POINTER);
    assert_int_equal(f(&projection, &view, &window, NAN, 0, &ray), GN_NOT_FINITE);
    assert_int_equal(f(&projection, &view, &window, 0, INFINITY, &ray), GN_NOT_FINITE);
    for (int i = 0; i < 3; ++i) {
        bad = i == 0 ? projection : i == 1 ? view : window;
        bad.inverse.m[3][1] = NAN;
        assert_int_equal(f(i == 0 ? &bad : &projection, i == 1 ? &bad : &view,
                           i == 2 ? &bad : &window, 0, 0, &ray),
                         GN_NOT_FINITE);
    }
    bad = projection;
    bad.inverse.m[2][3] = bad.inverse.m[3][3] = -1.0f; /* h.w = -1 at depth 0 */
    assert_int_equal(gn_ray_through_pixel_zo(&bad, &view, &window, 0, 0, &ray), GN_BEHIND_EYE);
    bad.inverse.m[3][3] = 0.0f;
    assert_int_equal(gn_ray_through_pixel_zo(&bad, &view, &window, 0, 0, &ray), GN_OUT_OF_RANGE);
    /* h.w overflows: (x, y, z) over infinity would be a point. */
    bad = projection;
    bad.inverse.m[3][0] = bad.inverse.m[3][3] = 0x1p127f;
    bad.inverse.m[2][3] = -0x1p127f;
    assert_int_equal(f(&bad, &view, &window, 0, 0, &ray), GN_OUT_OF_RANGE);
    bad = view;
    bad.inverse.m[0][0] = bad.inverse.m[1][1] = bad.inverse.m[2][2] = 0.0f;
    assert_int_equal(f(&projection, &bad, &window, 0, 0, &ray), GN_DEGENERATE);
    assert_memory_equal(&ray, &before, sizeof ray);
}

/* The triangle (0,0,0), (2,0,0), (0,4,0), counterclockwise seen from +z. */
static const gn_vec3 tri_a = {0, 0, 0}, tri_b = {2, 0, 0}, tri_c = {0, 4, 0};

static void triangles_by_hand(void **state)
{
    (void)state;
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
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
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

static void degenerate_triangles_are_missed(void **state)
{
    (void)state;
    const gn_ray ray = {{0, 0, 1}, {0, 0, -1}};
    const gn_vec3 far_c = {4, 0, 0}, nan = {0, NAN, 0}, infinite = {0, INFINITY, 0};
    gn_ray_hit hit = {-1, -1, -1};
    assert_false(gn_ray_hits_triangle(&ray, tri_a, tri_b, far_c, &hit));
    assert_false(gn_ray_hits_triangle(&ray, tri_a, tri_a, tri_a, &hit));
    assert_false(gn_ray_hits_triangle(&ray, tri_a, tri_b, nan, &hit));
    assert_false(gn_ray_hits_triangle(&ray, tri_a, nan, tri_c, &hit));
    assert_false(gn_ray_hits_triangle(&ray, nan, tri_b, tri_c, &hit));
    assert_false(gn_ray_hits_triangle(&ray, infinite, tri_b, tri_c, &hit));
    assert_true(hit.t == -1 && hit.u == -1 && hit.v == -1);
}

/* The box 1..3, 1..3, 1..3. */
static void boxes_by_hand(void **state)
{
    (void)state;
    const gn_box box = {{1, 1, 1}, {3, 3, 3}};
    const struct {
        gn_ray ray;
        bool hits;
        float enter, leave;
    } cases[] = {
        {{{0, 2, 2}, {1, 0, 0}}, true, 1, 3},
        {{{0, 2, 2}, {0.5f, -0.0f, 0}}, true, 2, 6},
        {{{4, 2, 2}, {-1, 0, 0}}, true, 1, 3},
        {{{0, 2, 2}, {-1, 0, 0}}, false, 0, 0}, /* behind */
        {{{2, 2, 2}, {0, 0, -2}}, true, 0, 0.5f},
        {{{0, 1, 2}, {1, 0, 0}}, true, 1, 3}, /* along a face */
        {{{0, 3, 3}, {1, 0, 0}}, true, 1, 3}, /* along an edge */
        {{{0, 3.001f, 2}, {1, 0, 0}}, false, 0, 0},
        {{{0, 0.999f, 2}, {1, 0, -0.0f}}, false, 0, 0},
        {{{0, 0, 0}, {1, 1, 1}}, true, 1, 3}, /* the diagonal */
        {{{0, 2, 4}, {1, 0, -1}}, true, 1, 3},
        {{{0, 2, 2}, {1, 1, 0}}, true, 1, 1},        /* the edge y = 3 of the face x = 1 */
        {{{0, 2.01f, 2}, {1, 1, 0}}, false, 0, 0},   /* past it */
        {{{3, 2, 2}, {1, 0, 0}}, true, 0, 0},        /* leaves where it begins */
        {{{2, 2, 2}, {0, 0, 0}}, true, 0, INFINITY}, /* a point */
        {{{0, 2, 2}, {0, 0, 0}}, false, 0, 0},
        {{{0, 2, NAN}, {1, 0, 0}}, false, 0, 0},
        {{{NAN, 2, 2}, {1, 0, 0}}, false, 0, 0},
        {{{2, 2, 2}, {0, NAN, 0}}, false, 0, 0},
        {{{0, 2, 2}, {INFINITY, 0, 0}}, false, 0, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        gn_ray_span span = {-1, -1};
        if (gn_ray_hits_box(&cases[i].ray, &box, &span) != cases[i].hits)
            fail_msg("case %zu", i);
        if (cases[i].hits)
            assert_true(span.enter == cases[i].enter && span.leave == cases[i].leave);
        else
            assert_true(span.enter == -1 && span.leave == -1);
    }
}

static void unusual_boxes(void **state)
{
    (void)state;
    const gn_ray ray = {{0, 0, 0}, {1, 2, 4}};
    const gn_box half = {{2, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
    const gn_box all = {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
    const gn_box empty = {{0, 1, 0}, {1, 0, 1}}, nan = {{0, 0, 0}, {1, NAN, 1}};
    const gn_box point = {{1, 2, 4}, {1, 2, 4}};
    gn_ray_span span = {-1, -1};
    assert_false(gn_ray_hits_box(&ray, &empty, &span));
    assert_false(gn_ray_hits_box(&ray, &nan, &span));
    assert_true(span.enter == -1 && span.leave == -1);
    assert_true(gn_ray_hits_box(&ray, &half, &span));
    assert_true(span.enter == 2 && span.leave == INFINITY);
    assert_true(gn_ray_hits_box(&ray, &all, &span));
    assert_true(span.enter == 0 && span.leave == INFINITY);
    assert_true(gn_ray_hits_box(&ray, &point, &span));
    assert_true(span.enter == 1 && span.leave == 1);

    /* The differences between bounds and origin are no floats, but their quotients are. */
    const gn_box far_apart = {{-0x1.8p127f, -0x1p127f, -1}, {-0x1p127f, 0x1.8p127f, 1}};
    const gn_ray from_far = {{0x1p127f, 0x1p126f, 0}, {-0x1p126f, -0x1p125f, 0}};
    const gn_ray from_afar = {{-0x1p127f, -0x1p127f, 0}, {-0x1p123f, 0x1p126f, 0}};
    assert_true(gn_ray_hits_box(&from_far, &far_apart, &span));
    assert_true(span.enter == 4 && span.leave == 5);
    assert_true(gn_ray_hits_box(&from_afar, &far_apart, &span));
    assert_true(span.enter == 0 && span.leave == 5);
}

static void barycentric_in_the_plane(void **state)
{
    (void)state;
    const gn_vec2 a = {0, 0}, b = {4, 0}, c = {0, 8}, line = {8, 0}, nan = {NAN, 0};
    const struct {
        gn_vec2 point;
        gn_vec3 weights;
    } cases[] = {
        {{0, 0}, {1, 0, 0}},
        {{4, 0}, {0, 1, 0}},
        {{0, 8}, {0, 0, 1}},
        {{2, 0}, {0.5f, 0.5f, 0}},
        {{1, 2}, {0.5f, 0.25f, 0.25f}},
        {{4, 8}, {-1, 1, 1}},
        {{-4, 0}, {2, -1, 0}},
    };
    gn_vec3 w = {9, 9, 9};
    assert_int_equal(gn_barycentric_2d(a, a, b, c, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_barycentric_2d(a, a, b, line, &w), GN_DEGENERATE);
    assert_int_equal(gn_barycentric_2d(a, b, b, c, &w), GN_DEGENERATE);
    assert_int_equal(gn_barycentric_2d(a, a, a, a, &w), GN_DEGENERATE);
    for (int i = 0; i < 4; ++i)
        assert_int_equal(gn_barycentric_2d(i == 0 ? nan : a, i == 1 ? nan : a, i == 2 ? nan : b,
                                           i == 3 ? nan : c, &w),
                         GN_NOT_FINITE);
    const gn_vec2 huge_b = {1e30f, 0}, huge_c = {0, 1e30f}, off = {1e30f, 0};
    const gn_vec2 small_b = {1e-20f, 0}, small_c = {0, 1e-20f}, tiny_b = {1e-10f, 0};
    assert_int_equal(gn_barycentric_2d(a, a, huge_b, huge_c, &w), GN_OUT_OF_RANGE);
    assert_int_equal(gn_barycentric_2d(off, a, b, c, &w), GN_OK);
    assert_int_equal(gn_barycentric_2d(off, a, tiny_b, c, &w), GN_OUT_OF_RANGE);
    assert_int_equal(gn_barycentric_2d(a, a, small_b, small_c, &w), GN_DEGENERATE);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        /* In both windings, and with every corner first. */
        assert_int_equal(gn_barycentric_2d(cases[i].point, a, b, c, &w), GN_OK);
        assert_vec3(w, cases[i].weights.x, cases[i].weights.y, cases[i].weights.z);
        assert_int_equal(gn_barycentric_2d(cases[i].point, b, a, c, &w), GN_OK);
        assert_vec3(w, cases[i].weights.y, cases[i].weights.x, cases[i].weights.z);
        assert_int_equal(gn_barycentric_2d(cases[i].point, c, a, b, &w), GN_OK);
        assert_vec3(w, cases[i].weights.z, cases[i].weights.x, cases[i].weights.y);
    }
}

/* In the plane z = 1, and a triangle that is parallel to no coordinate plane, with normal (1, 1,
 * 1). */
static void barycentric_in_space(void **state)
{
    (void)state;
    const gn_vec3 a = {0, 0, 1}, b = {4, 0, 1}, c = {0, 8, 1}, line = {8, 0, 1};
    const gn_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1}, nan = {0, 0, NAN};
    const gn_vec3 in = {1, 2, 1}, above = {1, 2, 9}, below = {1, 2, -1000}, out = {4, 8, 5};
    const gn_vec3 zero = {0, 0, 0}, third = {0.5f, 0.25f, 0.25f};
    gn_vec3 w = {9, 9, 9};
    assert_int_equal(gn_barycentric_3d(a, a, b, c, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_barycentric_3d(a, a, b, line, &w), GN_DEGENERATE);
    assert_int_equal(gn_barycentric_3d(a, a, a, a, &w), GN_DEGENERATE);
    for (int i = 0; i < 4; ++i)
        assert_int_equal(gn_barycentric_3d(i == 0 ? nan : a, i == 1 ? nan : a, i == 2 ? nan : b,
                                           i == 3 ? nan : c, &w),
                         GN_NOT_FINITE);
    const gn_vec3 huge_b = {1e30f, 0, 1}, huge_c = {0, 1e30f, 1};
    assert_int_equal(gn_barycentric_3d(a, a, huge_b, huge_c, &w), GN_OUT_OF_RANGE);
    assert_true(w.x == 9 && w.y == 9 && w.z == 9);
    assert_int_equal(gn_barycentric_3d(in, a, b, c, &w), GN_OK);
    assert_vec3(w, 0.5f, 0.25f, 0.25f);
    assert_int_equal(gn_barycentric_3d(above, a, b, c, &w), GN_OK);
    assert_vec3(w, 0.5f, 0.25f, 0.25f);
    assert_int_equal(gn_barycentric_3d(below, a, c, b, &w), GN_OK);
    assert_vec3(w, 0.5f, 0.25f, 0.25f);
    assert_int_equal(gn_barycentric_3d(out, a, b, c, &w), GN_OK);
    assert_vec3(w, -1, 1, 1);
    assert_int_equal(gn_barycentric_3d(third, x, y, z, &w), GN_OK);
    assert_vec3(w, 0.5f, 0.25f, 0.25f);
    assert_int_equal(gn_barycentric_3d(zero, x, y, z, &w), GN_OK);
    assert_vec3(w, 1.0f / 3, 1.0f / 3, 1.0f / 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pixels_of_opengl),
        cmocka_unit_test(pixels_of_direct3d),
        cmocka_unit_test(pixels_of_vulkan),
        cmocka_unit_test(impossible_pixels_are_named),
        cmocka_unit_test(triangles_by_hand),
        cmocka_unit_test(degenerate_triangles_are_missed),
        cmocka_unit_test(boxes_by_hand),
        cmocka_unit_test(unusual_boxes),
        cmocka_unit_test(barycentric_in_the_plane),
        cmocka_unit_test(barycentric_in_space),
    };
    return cmocka_run_group_tests_name("rays", tests, NULL, NULL);
}
