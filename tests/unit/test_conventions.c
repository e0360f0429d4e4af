/* Projections, viewports and views in every convention: entries worked by hand, comparison with
 * cglm for others, statuses; and the transforms from one convention to another. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>
#include <cglm/clipspace/ortho_lh_no.h>
#include <cglm/clipspace/ortho_lh_zo.h>
#include <cglm/clipspace/ortho_rh_no.h>
#include <cglm/clipspace/ortho_rh_zo.h>
#include <cglm/clipspace/persp_lh_no.h>
#include <cglm/clipspace/persp_lh_zo.h>
#include <cglm/clipspace/persp_rh_no.h>
#include <cglm/clipspace/persp_rh_zo.h>
#include <cglm/clipspace/view_lh.h>
#include <cglm/clipspace/view_rh.h>

typedef gn_status six_planes(float, float, float, float, float, float, gn_transform *);
typedef gn_status five_planes(float, float, float, float, float, gn_transform *);
typedef gn_status symmetric(float, float, float, float, gn_transform *);
typedef gn_status symmetric_infinite(float, float, float, gn_transform *);
typedef gn_status view_function(gn_vec3, gn_vec3, gn_vec3, gn_transform *);

/* Rows and columns as they are written on paper. */
static void assert_entries(const gn_mat4 *m, const float rows[4][4], float tolerance)
{
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            assert_float_equal(m->m[column][row], rows[row][column], tolerance);
}

static void assert_near(const gn_mat4 *got, float expected[4][4])
{
    for (int i = 0; i < 16; ++i) {
        const float e = expected[i / 4][i % 4];
        assert_float_equal(got->m[i / 4][i % 4], e, 2e-6f * (1.0f + fabsf(e)));
    }
}

static gn_transform marked(void)
{
    gn_transform transform;
    memset(&transform, 0x5A, sizeof transform);
    return transform;
}

static void assert_untouched(const gn_transform *transform)
{
    gn_transform expected = marked();
    assert_memory_equal(transform, &expected, sizeof expected);
}

/* For near 1 and far 3, clip z = a t + b at the distance t. Depths at t = 1 and t = 3 are a + b and
 * (3 a + b) / 3, the two ends of the range. */
static const struct named {
    six_planes *box, *pyramid;
    five_planes *endless_pyramid;
    symmetric *view;
    symmetric_infinite *endless_view;
    float hand;
    float box_scale, box_offset, a, b, endless_a, endless_b;
} all[8] = {
    {gn_orthographic_rh_no, gn_frustum_rh_no, gn_frustum_rh_no_infinite, gn_perspective_rh_no,
     gn_perspective_rh_no_infinite, -1, 1, -2, 2, -3, 1, -2},
    {gn_orthographic_lh_no, gn_frustum_lh_no, gn_frustum_lh_no_infinite, gn_perspective_lh_no,
     gn_perspective_lh_no_infinite, 1, 1, -2, 2, -3, 1, -2},
    {gn_orthographic_rh_zo, gn_frustum_rh_zo, gn_frustum_rh_zo_infinite, gn_perspective_rh_zo,
     gn_perspective_rh_zo_infinite, -1, 0.5f, -0.5f, 1.5f, -1.5f, 1, -1},
    {gn_orthographic_lh_zo, gn_frustum_lh_zo, gn_frustum_lh_zo_infinite, gn_perspective_lh_zo,
     gn_perspective_lh_zo_infinite, 1, 0.5f, -0.5f, 1.5f, -1.5f, 1, -1},
    {gn_orthographic_rh_no_reversed, gn_frustum_rh_no_reversed, gn_frustum_rh_no_infinite_reversed,
     gn_perspective_rh_no_reversed, gn_perspective_rh_no_infinite_reversed, -1, -1, 2, -2, 3, -1,
     2},
    {gn_orthographic_lh_no_reversed, gn_frustum_lh_no_reversed, gn_frustum_lh_no_infinite_reversed,
     gn_perspective_lh_no_reversed, gn_perspective_lh_no_infinite_reversed, 1, -1, 2, -2, 3, -1, 2},
    {gn_orthographic_rh_zo_reversed, gn_frustum_rh_zo_reversed, gn_frustum_rh_zo_infinite_reversed,
     gn_perspective_rh_zo_reversed, gn_perspective_rh_zo_infinite_reversed, -1, -0.5f, 1.5f, -0.5f,
     1.5f, 0, 1},
    {gn_orthographic_lh_zo_reversed, gn_frustum_lh_zo_reversed, gn_frustum_lh_zo_infinite_reversed,
     gn_perspective_lh_zo_reversed, gn_perspective_lh_zo_infinite_reversed, 1, -0.5f, 1.5f, -0.5f,
     1.5f, 0, 1},
};

static void boxes_by_hand(void **state)
{
    (void)state;
    for (size_t i = 0; i < 8; ++i) {
        const struct named *n = &all[i];
        const float expected[4][4] = {{0.5f, 0, 0, -0.5f},
                                      {0, 2, 0, 1},
                                      {0, 0, n->hand * n->box_scale, n->box_offset},
                                      {0, 0, 0, 1}};
        const float inverse[4][4] = {
            {2, 0, 0, 1},
            {0, 0.5f, 0, -0.5f},
            {0, 0, n->hand / n->box_scale, -n->box_offset / (n->hand * n->box_scale)},
            {0, 0, 0, 1}};
        gn_transform t;
        assert_int_equal(n->box(-1, 3, -1, 0, 1, 3, &t), GN_OK);
        assert_entries(&t.matrix, expected, 0.0f);
        assert_entries(&t.inverse, inverse, 0.0f);
    }
}

/* Planes -1..3 and -1..0 at distance 1: scales 2/4 and 2/1, skews 2/4 and -1/1. */
static void pyramids_by_hand(void **state)
{
    (void)state;
    for (size_t i = 0; i < 8; ++i) {
        const struct named *n = &all[i];
        for (int endless = 0; endless < 2; ++endless) {
            const float h = n->hand, a = endless ? n->endless_a : n->a;
            const float b = endless ? n->endless_b : n->b;
            const float expected[4][4] = {
                {0.5f, 0, -h * 0.5f, 0}, {0, 2, h * 1, 0}, {0, 0, h * a, b}, {0, 0, h, 0}};
            const float inverse[4][4] = {
                {2, 0, 0, 1}, {0, 0.5f, 0, -0.5f}, {0, 0, 0, h}, {0, 0, 1 / b, -a / b}};
            gn_transform t;
            assert_int_equal(endless ? n->endless_pyramid(-1, 3, -1, 0, 1, &t)
                                     : n->pyramid(-1, 3, -1, 0, 1, 3, &t),
                             GN_OK);
            assert_entries(&t.matrix, expected, 0.0f);
            assert_entries(&t.inverse, inverse, 0.0f);
        }
    }
}

/* A right angle, and a picture twice as wide as high. */
static void perspectives_by_hand(void **state)
{
    (void)state;
    for (size_t i = 0; i < 8; ++i) {
        const struct named *n = &all[i];
        for (int endless = 0; endless < 2; ++endless) {
            const float a = endless ? n->endless_a : n->a, b = endless ? n->endless_b : n->b;
            const float expected[4][4] = {
                {0.5f, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, n->hand * a, b}, {0, 0, n->hand, 0}};
            gn_transform t;
            assert_int_equal(endless ? n->endless_view(0.5f * GN_PI, 2, 1, &t)
                                     : n->view(0.5f * GN_PI, 2, 1, 3, &t),
                             GN_OK);
            assert_entries(&t.matrix, expected, 2e-7f);
            for (int k = 0; k < 16; ++k) { /* no negative zero */
                const float entry = t.matrix.m[k / 4][k % 4], other = t.inverse.m[k / 4][k % 4];
                assert_false((entry == 0.0f && signbit(entry)) ||
                             (other == 0.0f && signbit(other)));
            }
        }
    }
}

/* Without the skew of left-handed frusta: cglm 0.8 gives them the sign of right-handed ones, and so
 * takes the point (left, bottom, near) of a frustum to the opposite side of the axis. */
static void cglm_agrees(void **state)
{
    (void)state;
    static void (*const boxes[4])(float, float, float, float, float, float, mat4) = {
        glm_ortho_rh_no, glm_ortho_lh_no, glm_ortho_rh_zo, glm_ortho_lh_zo};
    static void (*const pyramids[4])(float, float, float, float, float, float, mat4) = {
        glm_frustum_rh_no, glm_frustum_lh_no, glm_frustum_rh_zo, glm_frustum_lh_zo};
    static void (*const views[4])(float, float, float, float, mat4) = {
        glm_perspective_rh_no, glm_perspective_lh_no, glm_perspective_rh_zo, glm_perspective_lh_zo};
    uint32_t random = 12345;
    for (int trial = 0; trial < 400; ++trial) {
        float f[6];
        for (int i = 0; i < 6; ++i) {
            random = random * 1664525u + 1013904223u;
            f[i] = 0.25f + (float)(random >> 8) * 0x1p-22f;
        }
        const float left = -f[0], right = f[1], bottom = f[2] - 3.0f, top = bottom + f[3];
        const float z_near = f[4], z_far = f[4] + f[5], fov_y = 0.7f * f[0];
        for (int i = 0; i < 4; ++i) {
            gn_transform t;
            mat4 expected;
            boxes[i](left, right, bottom, top, z_near, z_far, expected);
            assert_int_equal(all[i].box(left, right, bottom, top, z_near, z_far, &t), GN_OK);
            assert_near(&t.matrix, expected);
            pyramids[i](left, right, bottom, top, z_near, z_far, expected);
            expected[2][0] *= -all[i].hand;
            expected[2][1] *= -all[i].hand;
            assert_int_equal(all[i].pyramid(left, right, bottom, top, z_near, z_far, &t), GN_OK);
            assert_near(&t.matrix, expected);
            views[i](fov_y, f[1], z_near, z_far, expected);
            assert_int_equal(all[i].view(fov_y, f[1], z_near, z_far, &t), GN_OK);
            assert_near(&t.matrix, expected);
        }
    }
}

static void bad_volumes(void **state)
{
    (void)state;
    const float bad[3] = {NAN, INFINITY, -INFINITY};
    gn_transform t = marked();
    for (size_t k = 0; k < 8; ++k) {
        const struct named *n = &all[k];
        for (int i = 0; i < 6; ++i) {
            for (int j = 0; j < 3; ++j) {
                float v[6] = {-1, 1, -1, 1, 1, 10}, p[4] = {1, 1, 1, 10};
                v[i] = p[i % 4] = bad[j];
                assert_int_equal(n->box(v[0], v[1], v[2], v[3], v[4], v[5], &t), GN_NOT_FINITE);
                assert_int_equal(n->pyramid(v[0], v[1], v[2], v[3], v[4], v[5], &t), GN_NOT_FINITE);
                assert_int_equal(n->view(p[0], p[1], p[2], p[3], &t), GN_NOT_FINITE);
                if (i < 5)
                    assert_int_equal(n->endless_pyramid(v[0], v[1], v[2], v[3], v[4], &t),
                                     GN_NOT_FINITE);
                if (i % 4 < 3)
                    assert_int_equal(n->endless_view(p[0], p[1], p[2], &t), GN_NOT_FINITE);
            }
        }
        assert_int_equal(n->box(2, 2, -1, 1, 1, 10, &t), GN_SINGULAR);
        assert_int_equal(n->box(-1, 1, 3, 3, 1, 10, &t), GN_SINGULAR);
        assert_int_equal(n->box(-1, 1, -1, 1, 3, 3, &t), GN_SINGULAR);
        assert_int_equal(n->pyramid(2, 2, -1, 1, 1, 10, &t), GN_SINGULAR);
        assert_int_equal(n->pyramid(-1, 1, 3, 3, 1, 10, &t), GN_SINGULAR);
        assert_int_equal(n->pyramid(-1, 1, -1, 1, 3, 3, &t), GN_SINGULAR);
        assert_int_equal(n->pyramid(-1, 1, -1, 1, 0, 3, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->pyramid(-1, 1, -1, 1, 1, -3, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->endless_pyramid(2, 2, -1, 1, 1, &t), GN_SINGULAR);
        assert_int_equal(n->endless_pyramid(-1, 1, 3, 3, 1, &t), GN_SINGULAR);
        assert_int_equal(n->endless_pyramid(-1, 1, -1, 1, 0, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->endless_pyramid(-1, 1, -1, 1, 1e-45f, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->view(1, 1, 3, 3, &t), GN_SINGULAR);
        assert_int_equal(n->view(0, 1, 1, 3, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->view(GN_PI, 1, 1, 3, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->view(1, 0, 1, 3, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->view(1, 1, -1, 3, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->view(1, 1, 1, 0, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->endless_view(0, 1, 1, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->endless_view(1, 0, 1, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->endless_view(1, 1, 0, &t), GN_OUT_OF_RANGE);
        assert_int_equal(n->box(-1, 1, -1, 1, 1, 10, NULL), GN_NULL_POINTER);
        assert_int_equal(n->pyramid(-1, 1, -1, 1, 1, 10, NULL), GN_NULL_POINTER);
        assert_int_equal(n->endless_pyramid(-1, 1, -1, 1, 1, NULL), GN_NULL_POINTER);
        assert_int_equal(n->view(1, 1, 1, 10, NULL), GN_NULL_POINTER);
        assert_int_equal(n->endless_view(1, 1, 1, NULL), GN_NULL_POINTER);
    }
    assert_untouched(&t);
}

/* For 640 x 480 pixels at (10, 20), the point (1/2, 1/2, 1/2) is three quarters to the right and
 * up. Its depth is 3/4 or 1/2 of the range 0.25 .. 0.75. */
static void viewports(void **state)
{
    (void)state;
    static six_planes *const functions[4] = {gn_viewport_no, gn_viewport_no_y_down, gn_viewport_zo,
                                             gn_viewport_zo_y_down};
    static const float expected[4][3] = {
        {490, 380, 0.625f}, {490, 140, 0.625f}, {490, 380, 0.5f}, {490, 140, 0.5f}};
    const gn_vec3 ndc = {0.5f, 0.5f, 0.5f};
    gn_transform t = marked();
    for (int i = 0; i < 4; ++i) {
        assert_int_equal(functions[i](0, 0, 8, 8, 0.5f, 0.5f, &t), GN_SINGULAR);
        assert_int_equal(functions[i](0, 0, 0, 8, 0, 1, &t), GN_INVALID_VIEWPORT);
        assert_int_equal(functions[i](0, 0, 8, -1, 0, 1, &t), GN_INVALID_VIEWPORT);
        assert_int_equal(functions[i](0, 0, 8, 1, 0, NAN, &t), GN_NOT_FINITE);
        assert_int_equal(functions[i](INFINITY, 0, 8, 1, 0, 1, &t), GN_NOT_FINITE);
        assert_int_equal(functions[i](0, 0, 1e-44f, 1, 0, 1, &t), GN_OUT_OF_RANGE);
        assert_int_equal(functions[i](0, 0, 8, 8, 0, 1, NULL), GN_NULL_POINTER);
        assert_untouched(&t);
    }
    for (int i = 0; i < 4; ++i) {
        assert_int_equal(functions[i](10, 20, 640, 480, 0.25f, 0.75f, &t), GN_OK);
        gn_vec3 window = gn_mat4_transform_point(&t.matrix, ndc);
        assert_true(window.x == expected[i][0] && window.y == expected[i][1] &&
                    window.z == expected[i][2]);
        gn_vec3 back = gn_mat4_transform_point(&t.inverse, window);
        assert_float_equal(back.x, 0.5f, 1e-6f);
        assert_float_equal(back.y, 0.5f, 1e-6f);
        assert_float_equal(back.z, 0.5f, 1e-6f);
    }
}

static void assert_seen(const gn_transform *view, gn_vec3 from, float x, float y, float z)
{
    gn_vec3 seen = gn_mat4_transform_point(&view->matrix, from);
    assert_true(seen.x == x && seen.y == y && seen.z == z);
    gn_vec3 back = gn_mat4_transform_point(&view->inverse, seen);
    assert_true(back.x == from.x && back.y == from.y && back.z == from.z);
}

/* The direction ahead of a camera becomes -z or +z, and the direction to its right +x. For a camera
 * that looks along x with y up, the right is +z in a right-handed world and -z in a left-handed
 * one. */
static void views_by_hand(void **state)
{
    (void)state;
    const gn_vec3 eye = {1, 2, 3}, target = {5, 2, 3}, along = {2, 0, 0}, up = {0, 3, 0};
    const gn_vec3 seen = {8, 4, 2};
    gn_transform t;
    assert_int_equal(gn_look_at_rh(eye, target, up, &t), GN_OK);
    assert_seen(&t, seen, -1, 2, -7);
    assert_int_equal(gn_look_to_rh(eye, along, up, &t), GN_OK);
    assert_seen(&t, seen, -1, 2, -7);
    assert_int_equal(gn_look_at_lh(eye, target, up, &t), GN_OK);
    assert_seen(&t, seen, 1, 2, 7);
    assert_int_equal(gn_look_to_lh(eye, along, up, &t), GN_OK);
    assert_seen(&t, seen, 1, 2, 7);
    /* A camera that already is at the origin gives the identity. */
    const gn_vec3 origin = {0, 0, 0}, ahead = {0, 0, 1};
    assert_int_equal(gn_look_to_lh(origin, ahead, up, &t), GN_OK);
    gn_mat4 one;
    gn_mat4_identity(&one);
    assert_near(&t.matrix, one.m);
    assert_near(&t.inverse, one.m);
}

static void cglm_agrees_on_views(void **state)
{
    (void)state;
    static view_function *const views[4] = {gn_look_at_rh, gn_look_at_lh, gn_look_to_rh,
                                            gn_look_to_lh};
    static void (*const others[4])(vec3, vec3, vec3, mat4) = {glm_lookat_rh, glm_lookat_lh,
                                                              glm_look_rh, glm_look_lh};
    uint32_t random = 54321;
    for (int trial = 0; trial < 400; ++trial) {
        float f[9];
        for (int i = 0; i < 9; ++i) {
            random = random * 1664525u + 1013904223u;
            f[i] = (float)(random >> 8) * 0x1p-21f - 4.0f;
        }
        const gn_vec3 eye = {f[0], f[1], f[2]}, way = {f[3] + 9, f[4], f[5]};
        const gn_vec3 up = {f[6] * 0.1f, f[7] + 8, f[8]};
        for (int i = 0; i < 4; ++i) {
            vec3 cglm_eye = {eye.x, eye.y, eye.z}, cglm_way = {way.x, way.y, way.z};
            vec3 cglm_up = {up.x, up.y, up.z};
            gn_transform t;
            mat4 expected;
            others[i](cglm_eye, cglm_way, cglm_up, expected);
            assert_int_equal(views[i](eye, way, up, &t), GN_OK);
            for (int k = 0; k < 16; ++k)
                assert_float_equal(t.matrix.m[k / 4][k % 4], expected[k / 4][k % 4], 2e-5f);
        }
    }
}

static void views_that_cannot_be(void **state)
{
    (void)state;
    static view_function *const at[2] = {gn_look_at_rh, gn_look_at_lh};
    static view_function *const to[2] = {gn_look_to_rh, gn_look_to_lh};
    const gn_vec3 eye = {1, 2, 3}, target = {2, 4, 6}, up = {0, 1, 0}, zero = {0, 0, 0};
    const gn_vec3 nan = {0, NAN, 0}, infinite = {0, 0, INFINITY}, against = {-0.5f, -1, -1.5f};
    const gn_vec3 left = {-FLT_MAX, 0, 0}, right = {FLT_MAX, 0, 0};
    const gn_vec3 distant = {FLT_MAX, FLT_MAX, FLT_MAX}, diagonal = {-1, -1, -1};
    gn_transform t = marked();
    for (int i = 0; i < 2; ++i) {
        assert_int_equal(at[i](eye, eye, up, &t), GN_DEGENERATE);
        assert_int_equal(at[i](eye, target, zero, &t), GN_DEGENERATE);
        assert_int_equal(at[i](eye, target, against, &t), GN_DEGENERATE);
        assert_int_equal(at[i](left, right, up, &t), GN_OUT_OF_RANGE);
        assert_int_equal(to[i](eye, zero, up, &t), GN_DEGENERATE);
        assert_int_equal(to[i](eye, up, zero, &t), GN_DEGENERATE);
        assert_int_equal(to[i](zero, eye, eye, &t), GN_DEGENERATE);
        assert_int_equal(to[i](zero, eye, against, &t), GN_DEGENERATE);
        assert_int_equal(to[i](distant, diagonal, up, &t), GN_OUT_OF_RANGE);
        for (int k = 0; k < 2; ++k) {
            view_function *const look = k ? to[i] : at[i];
            assert_int_equal(look(nan, target, up, &t), GN_NOT_FINITE);
            assert_int_equal(look(eye, infinite, up, &t), GN_NOT_FINITE);
            assert_int_equal(look(eye, target, nan, &t), GN_NOT_FINITE);
            assert_int_equal(look(eye, target, up, NULL), GN_NULL_POINTER);
        }
    }
    assert_untouched(&t);
}

static void conversions(void **state)
{
    (void)state;
    static gn_status (*const functions[5])(gn_transform *) = {
        gn_clip_no_to_zo, gn_clip_zo_to_no, gn_clip_reverse_zo, gn_flip_y, gn_flip_z};
    /* (2, 3, 1, 2) becomes these; z = -w and z = w become the ends of the range. */
    static const float expected[5][2] = {{3, 1.5f}, {3, 0}, {3, 1}, {-3, 1}, {3, -1}};
    static const float ends[5][2] = {{0, 2}, {-6, 2}, {4, 0}, {-2, 2}, {2, -2}};
    const gn_vec4 v = {2, 3, 1, 2}, lower = {0, 0, -2, 2}, upper = {0, 0, 2, 2};
    for (int i = 0; i < 5; ++i) {
        gn_transform t;
        gn_mat4 one, product;
        gn_mat4_identity(&one);
        assert_int_equal(functions[i](NULL), GN_NULL_POINTER);
        assert_int_equal(functions[i](&t), GN_OK);
        gn_vec4 moved = gn_mat4_multiply_vec4(&t.matrix, v);
        assert_true(moved.x == 2 && moved.y == expected[i][0] && moved.z == expected[i][1] &&
                    moved.w == 2);
        assert_true(gn_mat4_multiply_vec4(&t.matrix, lower).z == ends[i][0]);
        assert_true(gn_mat4_multiply_vec4(&t.matrix, upper).z == ends[i][1]);
        gn_mat4_multiply(&t.matrix, &t.inverse, &product);
        assert_near(&product, one.m);
        gn_mat4_multiply(&t.inverse, &t.matrix, &product);
        assert_near(&product, one.m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_by_hand),        cmocka_unit_test(pyramids_by_hand),
        cmocka_unit_test(perspectives_by_hand), cmocka_unit_test(cglm_agrees),
        cmocka_unit_test(bad_volumes),          cmocka_unit_test(viewports),
        cmocka_unit_test(views_by_hand),        cmocka_unit_test(cglm_agrees_on_views),
        cmocka_unit_test(views_that_cannot_be), cmocka_unit_test(conversions),
    };
    return cmocka_run_group_tests_name("conventions", tests, NULL, NULL);
}
