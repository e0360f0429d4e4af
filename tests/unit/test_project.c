/* Points to the window and back, and rays through pixels: worked by hand in each convention, the
 * half-pixel rule, the bits and depths of draws, every status, results left untouched. */
#include <float.h>

#include "canvas.h"
#include "near.h"
#include "untouched.h"

/* OpenGL, Direct3D, and Vulkan, whose depth is reversed and whose y is down in clip space and on
 * the screen. */
enum api { OPENGL, DIRECT3D, VULKAN };
enum shape { PYRAMID, ENDLESS, BOX };

static const struct convention {
    gn_status (*pyramid)(float, float, float, float, float, float, gn_transform *);
    gn_status (*endless)(float, float, float, float, float, gn_transform *);
    gn_status (*box)(float, float, float, float, float, float, gn_transform *);
    gn_status (*viewport)(float, float, float, float, float, float, gn_transform *);
    gn_status (*ray)(const gn_transform *, const gn_transform *, const gn_transform *, float, float,
                     gn_ray *);
} conventions[] = {
    {gn_frustum_rh_no, gn_frustum_rh_no_infinite, gn_orthographic_rh_no, gn_viewport_no,
     gn_ray_through_pixel_no},
    {gn_frustum_lh_zo, gn_frustum_lh_zo_infinite, gn_orthographic_lh_zo, gn_viewport_zo_y_down,
     gn_ray_through_pixel_zo},
    {gn_frustum_rh_zo_reversed, gn_frustum_rh_zo_infinite_reversed, gn_orthographic_rh_zo_reversed,
     gn_viewport_zo, gn_ray_through_pixel_reversed},
};

/* Makes the projection of the planes -w..w and -h..h at distance 1, which may end at distance 3. */
static gn_transform projection_of(enum api api, enum shape shape, float w, float h)
{
    const struct convention *const used = &conventions[api];
    gn_transform projection, flip;

    assert_int_equal(shape == ENDLESS ? used->endless(-w, w, -h, h, 1, &projection)
                                      : (shape == BOX ? used->box : used->pyramid)(-w, w, -h, h, 1,
                                                                                   3, &projection),
                     GN_OK);
    assert_int_equal(gn_flip_y(&flip), GN_OK);
    if (api == VULKAN)
        assert_int_equal(gn_transform_compose(&flip, &projection, &projection), GN_OK);
    return projection;
}

/* On 8 x 4 pixels, a point 2 ahead, 1 to the right and 1/2 up is a quarter of the way from the
 * middle to the border. So it is at x = 4 + 1, y = 2 + 1/2 from the bottom; its depth is (1 - 1/2)
 * / (1 - 1/3) = 3/4. Pixel (4, 2) has its centre at (4.5, 2.5): an eighth and a quarter of the way
 * to the border, which is 4 and 2 away at distance 2. */
static void points_in_each_convention(void **state)
{
    static const struct {
        enum api api;
        gn_vec3 point, window;
    } cases[] = {{OPENGL, {1, 0.5f, -2}, {5, 2.5f, 0.75f}},
                 {OPENGL, {0.5f, 0.5f, -2}, {4.5f, 2.5f, 0.75f}},
                 {DIRECT3D, {1, 0.5f, 2}, {5, 1.5f, 0.75f}},
                 {VULKAN, {1, 0.5f, -2}, {5, 1.5f, 0.25f}}};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const gn_vec3 p = cases[i].point, w = cases[i].window;
        const gn_transform projection = projection_of(cases[i].api, PYRAMID, 2, 1);
        gn_transform viewport;
        gn_vec3 window, point;

        assert_int_equal(conventions[cases[i].api].viewport(0, 0, 8, 4, 0, 1, &viewport), GN_OK);
        assert_int_equal(gn_project(&projection, &viewport, p, &window), GN_OK);
        assert_vec3(window, w.x, w.y, w.z, 1e-6f);
        assert_int_equal(gn_unproject(&projection, &viewport, w, &point), GN_OK);
        assert_vec3(point, p.x, p.y, p.z, 2e-6f);
    }
}

/* The direction (1/2, 1/2, 1) normalized. */
#define ACROSS 0.40824829f
#define AHEAD 0.81649658f

/* In a window of 2x2 pixels, whose centres are at -0.5 and 0.5 of -1..1. Direct3D's camera is at
 * (0, 0, 5) and looks along -x, so that z is to the right. */
static void rays_in_each_convention(void **state)
{
    static const struct {
        enum api api;
        enum shape shape;
        float side, x, y;
        gn_vec3 origin, direction;
    } cases[] = {
        {OPENGL, PYRAMID, 1, 0, 0, {-0.5f, -0.5f, -1}, {-ACROSS, -ACROSS, -AHEAD}},
        {OPENGL, PYRAMID, 1, 1, 0, {0.5f, -0.5f, -1}, {ACROSS, -ACROSS, -AHEAD}},
        {OPENGL, PYRAMID, 1, 0.5f, 0.5f, {0, 0, -1}, {0, 0, -1}}, /* between four pixels */
        {OPENGL, ENDLESS, 1, 1, 1, {0.5f, 0.5f, -1}, {ACROSS, ACROSS, -AHEAD}},
        {OPENGL, BOX, 4, 0, 1, {-2, 2, -1}, {0, 0, -1}},
        {DIRECT3D, PYRAMID, 1, 1, 0, {-1, 0.5f, 5.5f}, {-AHEAD, ACROSS, ACROSS}},
        {DIRECT3D, BOX, 4, 1, 0, {-1, 2, 7}, {-1, 0, 0}},
        {VULKAN, PYRAMID, 1, 0, 0, {-0.5f, 0.5f, -1}, {-ACROSS, ACROSS, -AHEAD}},
        {VULKAN, ENDLESS, 1, 0, 0, {-0.5f, 0.5f, -1}, {-ACROSS, ACROSS, -AHEAD}},
    };

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const struct convention *const used = &conventions[cases[i].api];
        const gn_vec3 origin = cases[i].origin, direction = cases[i].direction;
        const gn_transform projection =
            projection_of(cases[i].api, cases[i].shape, cases[i].side, cases[i].side);
        const gn_vec3 eye = {0, 0, 5}, ahead = {-1, 0, 0}, up = {0, 1, 0};
        gn_transform view, window;
        gn_ray ray;

        assert_int_equal(cases[i].api == DIRECT3D ? gn_look_to_lh(eye, ahead, up, &view)
                                                  : gn_transform_identity(&view),
                         GN_OK);
        assert_int_equal(used->viewport(0, 0, 2, 2, 0, 1, &window), GN_OK);
        assert_int_equal(used->ray(&projection, &view, &window, cases[i].x, cases[i].y, &ray),
                         GN_OK);
        assert_vec3(ray.origin, origin.x, origin.y, origin.z, 1e-6f);
        assert_vec3(ray.direction, direction.x, direction.y, direction.z, 4e-7f);
    }
}

static void points_without_a_window(void **state)
{
    const gn_vec3 behind = {0, 0, 1}, last = {4, 2, 1}, large = {0x1p126f, 0x1p126f, 0x1p126f};
    const gn_vec3 four = {4, 4, 4};
    gn_transform projection, viewport, huge, bad;
    gn_vec3 result;
    const struct {
        gn_status status;
        gn_transform *projection, *viewport;
        gn_vec3 point;
    } to_window[] =
        {
            {GN_BEHIND_EYE, &projection, &viewport, behind},
            {GN_BEHIND_EYE, &projection, &viewport, {3, 4, 0}},
            {GN_BEHIND_EYE, &projection, &viewport, {0, 0, 0}},
            {GN_NOT_FINITE, &projection, &viewport, {0, NAN, -2}},
            {GN_OUT_OF_RANGE, &projection, &viewport, {1e30f, 0, -1e-30f}},
            {GN_OUT_OF_RANGE, &projection, &viewport, {3e38f, 3e38f, -0.5f}},
            {GN_OUT_OF_RANGE, &huge, &viewport, four},
            {GN_OUT_OF_RANGE, &viewport, &huge, four},
            {GN_NOT_FINITE, &bad, &viewport, behind},
            {GN_NOT_FINITE, &projection, &bad, behind},
            {GN_NULL_POINTER, NULL, &viewport, behind},
            {GN_NULL_POINTER, &projection, NULL, behind},
        },
      from_window[] = {
          {GN_BEHIND_EYE, &projection, &viewport, {4, 2, 1.25f}},
          {GN_BEHIND_EYE, &projection, &viewport, last},
          {GN_NOT_FINITE, &projection, &viewport, {4, -INFINITY, 0.5f}},
          {GN_OUT_OF_RANGE, &huge, &viewport, large},
          {GN_OUT_OF_RANGE, &projection, &huge, four},
          {GN_NOT_FINITE, &bad, &viewport, last},
          {GN_NOT_FINITE, &projection, &bad, last},
          {GN_NULL_POINTER, NULL, &viewport, last},
          {GN_NULL_POINTER, &projection, NULL, last},
      };

    assert_int_equal(gn_perspective_rh_zo_infinite(0.5f * GN_PI, 2, 1, &projection), GN_OK);
    assert_int_equal(gn_viewport_zo(0, 0, 8, 4, 0, 1, &viewport), GN_OK);
    assert_int_equal(gn_scale(large, &huge), GN_OK);
    bad = projection;
    bad.matrix.m[1][1] = bad.inverse.m[1][1] = NAN;
    mark(result);
    for (size_t i = 0; i < COUNT(to_window); ++i)
        assert_int_equal(
            gn_project(to_window[i].projection, to_window[i].viewport, to_window[i].point, &result),
            to_window[i].status);
    assert_int_equal(gn_transform_invert(&huge, &huge), GN_OK);
    bad.inverse.m[1][1] = INFINITY;
    for (size_t i = 0; i < COUNT(from_window); ++i)
        assert_int_equal(gn_unproject(from_window[i].projection, from_window[i].viewport,
                                      from_window[i].point, &result),
                         from_window[i].status);
    assert_untouched(result);
    assert_int_equal(gn_project(&projection, &viewport, behind, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_unproject(&projection, &viewport, last, NULL), GN_NULL_POINTER);
    /* In an infinite projection the depth 1/2 is at twice the near distance. */
    assert_int_equal(gn_unproject(&projection, &viewport, (gn_vec3){4, 2, 0.5f}, &result), GN_OK);
    assert_vec3(result, 0, 0, -2, 1e-6f);
}

static void division(void **state)
{
    static const struct {
        gn_vec4 clip;
        gn_status status;
    } cases[] = {{{1, 1, 1, -1}, GN_BEHIND_EYE},          {{1, 1, 1, 0}, GN_BEHIND_EYE},
                 {{0, 0, 0, -0.0f}, GN_BEHIND_EYE},       {{1, 1, 1, NAN}, GN_NOT_FINITE},
                 {{INFINITY, 1, 1, 1}, GN_NOT_FINITE},    {{1, 0, 0, 1e-45f}, GN_OUT_OF_RANGE},
                 {{FLT_MAX, 0, 0, 0.5f}, GN_OUT_OF_RANGE}};
    gn_vec3 ndc;

    mark(ndc);
    for (size_t i = 0; i < COUNT(cases); ++i)
        assert_int_equal(gn_clip_to_ndc(cases[i].clip, &ndc), cases[i].status);
    assert_untouched(ndc);
    assert_int_equal(gn_clip_to_ndc((gn_vec4){2, -4, 1, 2}, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_clip_to_ndc((gn_vec4){2, -4, 1, 2}, &ndc), GN_OK);
    assert_vec3(ndc, 1, -2, 0.5f, 0);
}

/* Every operation is rounded as reference/RULES.md says (Vertices, Viewport). */
static void windows_by_the_rule(void **state)
{
    gn_transform projection, viewport;

    assert_int_equal(gn_frustum_rh_no(-0.3f, 0.4f, -0.2f, 0.35f, 0.5f, 20, &projection), GN_OK);
    assert_int_equal(gn_viewport_no(3.25f, 7, 641, 479, 0.1f, 0.9f, &viewport), GN_OK);
    for (float step = 0; step < 10; step += 0.0371f) {
        const gn_vec3 point = {step - 3.7f, 1.3f - step, -0.1f - step};
        const gn_vec4 clip =
            gn_mat4_multiply_vec4(&projection.matrix, (gn_vec4){point.x, point.y, point.z, 1});
        const float one_over_w = 1 / clip.w, from[3] = {clip.x, clip.y, clip.z};
        gn_vec3 window;

        assert_int_equal(gn_project(&projection, &viewport, point, &window), GN_OK);
        for (int i = 0; i < 3; ++i)
            assert_true((&window.x)[i] ==
                        from[i] * one_over_w * viewport.matrix.m[i][i] + viewport.matrix.m[3][i]);
    }
}

/* A point is drawn at the pixel that holds its window coordinates, which drawing rounds to a 256th,
 * with its depth to the last bit. A point outside of the picture or of the depths is not drawn. */
static void points_are_drawn_where_projected(void **state)
{
    int drawn = 0;

    for (int i = 0; i < 2 * 270; ++i) {
        const float step = 0.0037f * (float)(i / 2),
                    position[4] = {3 * step - 0.5f, 0.7f - 2 * step, -0.4f - 20 * step, 1};
        gn_transform projection, viewport;
        gn_vec3 window;

        assert_int_equal((i % 2 ? gn_perspective_rh_zo : gn_perspective_rh_no)(1.3f, 1.3f, 0.5f, 20,
                                                                               &projection),
                         GN_OK);
        assert_int_equal(
            (i % 2 ? gn_viewport_zo : gn_viewport_no)(0, 0, SIZE, SIZE, 0.1f, 0.9f, &viewport),
            GN_OK);
        const gn_color_uniforms uniforms = {projection.matrix};
        reset(position, 1, GN_POINTS);
        c.target.depth.format = GN_FORMAT_D32F;
        c.pipeline =
            (gn_pipeline){.raster.topology = GN_POINTS,
                          .depth = {.test_enabled = true,
                                    .function = GN_ALWAYS,
                                    .range = {true, 0.1f, 0.9f},
                                    .clip_depth = i % 2 ? GN_ZERO_TO_ONE : GN_NEGATIVE_ONE_TO_ONE}};
        memset(&c.target.color[0], 0, sizeof c.target.color[0]);
        assert_int_equal(gn_use_depth_only(&c.pipeline, &uniforms), GN_OK);
        assert_int_equal(gn_clear_depth(&c.target.depth, 1), GN_OK);
        assert_int_equal(draw(), GN_OK);
        assert_int_equal(gn_project(&projection, &viewport,
                                    (gn_vec3){position[0], position[1], position[2]}, &window),
                         GN_OK);
        const bool is_inside = window.x > 0 && window.x < SIZE && window.y > 0 && window.y < SIZE &&
                               window.z > 0.1f && window.z < 0.9f;
        int pixels = 0;
        for (int k = 0; k < SIZE * SIZE; ++k) {
            float depth;
            memcpy(&depth, &c.depth[k], sizeof depth);
            if (depth == 1)
                continue;
            ++pixels;
            assert_true(depth == window.z);
            assert_true(fabsf((float)(k % SIZE) + 0.5f - window.x) <= 0.5f + 1.0f / 512);
            assert_true(fabsf((float)(k / SIZE) + 0.5f - window.y) <= 0.5f + 1.0f / 512);
        }
        assert_int_equal(pixels, is_inside);
        drawn += pixels;
    }
    assert_true(drawn > 400 && drawn < 2 * 265);
}

/* The projection, the view and the window of rays that cannot be; made good again after each. */
static gn_transform good[3], bad[3];
static gn_ray ray;

static void refuses(gn_status status, enum api api, float x, float y)
{
    mark(ray);
    assert_int_equal(conventions[api].ray(&bad[0], &bad[1], &bad[2], x, y, &ray), status);
    assert_untouched(ray);
    memcpy(bad, good, sizeof bad);
}

static void rays_that_cannot_be(void **state)
{
    assert_int_equal(gn_frustum_rh_no(-1, 1, -1, 1, 1, 3, &good[0]), GN_OK);
    assert_int_equal(gn_transform_identity(&good[1]), GN_OK);
    assert_int_equal(gn_viewport_no(0, 0, 2, 2, 0, 1, &good[2]), GN_OK);
    memcpy(bad, good, sizeof bad);
    for (int i = 0; i < 3; ++i) {
        const gn_transform *const some[3] = {i == 0 ? NULL : &good[0], i == 1 ? NULL : &good[1],
                                             i == 2 ? NULL : &good[2]};
        assert_int_equal(gn_ray_through_pixel_no(some[0], some[1], some[2], 0, 0, &ray),
                         GN_NULL_POINTER);
        bad[i].inverse.m[3][1] = NAN;
        refuses(GN_NOT_FINITE, OPENGL, 0, 0);
    }
    assert_int_equal(gn_ray_through_pixel_no(&good[0], &good[1], &good[2], 0, 0, NULL),
                     GN_NULL_POINTER);
    refuses(GN_NOT_FINITE, OPENGL, NAN, 0);
    refuses(GN_NOT_FINITE, OPENGL, 0, INFINITY);
    bad[0].inverse.m[2][3] = bad[0].inverse.m[3][3] = -1; /* h.w = -1 at depth 0 */
    refuses(GN_BEHIND_EYE, DIRECT3D, 0, 0);
    bad[0].inverse.m[2][3] = -1;
    bad[0].inverse.m[3][3] = 0;
    refuses(GN_OUT_OF_RANGE, DIRECT3D, 0, 0);
    for (int column = 0; column < 4; ++column) /* no point there */
        bad[0].inverse.m[column][3] = 0;
    refuses(GN_OUT_OF_RANGE, OPENGL, 0, 0);
    /* h.w overflows: (x, y, z) over infinity would be a point. */
    bad[0].inverse.m[3][0] = bad[0].inverse.m[3][3] = 0x1p127f;
    bad[0].inverse.m[2][3] = -0x1p127f;
    refuses(GN_OUT_OF_RANGE, OPENGL, 0, 0);
    bad[1].inverse.m[0][0] = bad[1].inverse.m[1][1] = bad[1].inverse.m[2][2] = 0;
    refuses(GN_DEGENERATE, OPENGL, 0, 0);
    /* In each coordinate the origin overflows, or the direction, or both in the camera's space. */
    for (int row = 0; row < 3; ++row) {
        bad[1].inverse.m[2][row] = FLT_MAX;
        bad[1].inverse.m[3][row] = -FLT_MAX;
        refuses(GN_OUT_OF_RANGE, OPENGL, 0.5f, 0.5f);
        assert_int_equal(gn_perspective_rh_no(2.9f, 1, 0.01f, 10, &bad[0]), GN_OK);
        bad[1].inverse.m[0][row] = FLT_MAX / 2;
        refuses(GN_OUT_OF_RANGE, OPENGL, 1, 0.5f);
        assert_int_equal(gn_transform_identity(&bad[0]), GN_OK);
        bad[0].inverse.m[2][3] = 4;
        bad[0].inverse.m[3][3] = 5;
        bad[0].inverse.m[3][row] = FLT_MAX / 2;
        refuses(GN_OUT_OF_RANGE, OPENGL, 0.5f, 0.5f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_in_each_convention),
        cmocka_unit_test(rays_in_each_convention),
        cmocka_unit_test(points_without_a_window),
        cmocka_unit_test(division),
        cmocka_unit_test(windows_by_the_rule),
        cmocka_unit_test(points_are_drawn_where_projected),
        cmocka_unit_test(rays_that_cannot_be),
    };
    return cmocka_run_group_tests_name("project", tests, NULL, NULL);
}
