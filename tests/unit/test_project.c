/* Points to the window and back: one worked by hand in each convention, the half-pixel rule, points
 * without window coordinates, comparison with cglm. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>
#include <cglm/clipspace/project_no.h>
#include <cglm/clipspace/project_zo.h>

static void assert_vector(gn_vec3 got, float x, float y, float z, float tolerance)
{
    assert_float_equal(got.x, x, tolerance);
    assert_float_equal(got.y, y, tolerance);
    assert_float_equal(got.z, z, tolerance);
}

static const float right_angle = 0.5f * GN_PI;

/* A camera at the origin sees a right angle upwards and twice as much across, from 1 to 3, on 8 x 4
 * pixels. A point 2 ahead, 1 to the right and 1/2 up is a quarter of the way from the middle to the
 * border. So it is at x = 4 + 1, y = 2 + 1/2 from the bottom; its depth is (1 - 1/2) / (1 - 1/3) =
 * 3/4. */
static void in_each_convention(void **state)
{
    (void)state;
    const gn_vec3 ahead = {1, 0.5f, -2}, mirrored = {1, 0.5f, 2};
    gn_transform projection, viewport, flip;
    gn_vec3 window, point;

    assert_int_equal(gn_perspective_rh_no(right_angle, 2, 1, 3, &projection), GN_OK); /* OpenGL */
    assert_int_equal(gn_viewport_no(0, 0, 8, 4, 0, 1, &viewport), GN_OK);
    assert_int_equal(gn_project(&projection, &viewport, ahead, &window), GN_OK);
    assert_vector(window, 5, 2.5f, 0.75f, 1e-6f);
    assert_int_equal(gn_unproject(&projection, &viewport, window, &point), GN_OK);
    assert_vector(point, 1, 0.5f, -2, 2e-6f);

    assert_int_equal(gn_perspective_lh_zo(right_angle, 2, 1, 3, &projection), GN_OK); /* Direct3D */
    assert_int_equal(gn_viewport_zo_y_down(0, 0, 8, 4, 0, 1, &viewport), GN_OK);
    assert_int_equal(gn_project(&projection, &viewport, mirrored, &window), GN_OK);
    assert_vector(window, 5, 1.5f, 0.75f, 1e-6f);
    assert_int_equal(gn_unproject(&projection, &viewport, window, &point), GN_OK);
    assert_vector(point, 1, 0.5f, 2, 2e-6f);

    assert_int_equal(gn_perspective_rh_zo(right_angle, 2, 1, 3, &projection), GN_OK); /* Vulkan */
    assert_int_equal(gn_flip_y(&flip), GN_OK);
    assert_int_equal(gn_transform_compose(&flip, &projection, &projection), GN_OK);
    assert_int_equal(gn_viewport_zo(0, 0, 8, 4, 0, 1, &viewport), GN_OK);
    assert_int_equal(gn_project(&projection, &viewport, ahead, &window), GN_OK);
    assert_vector(window, 5, 1.5f, 0.75f, 1e-6f);
    assert_int_equal(gn_unproject(&projection, &viewport, window, &point), GN_OK);
    assert_vector(point, 1, 0.5f, -2, 2e-6f);
}

/* Pixel (4, 2) of the 8 x 4 has its centre at (4.5, 2.5): an eighth and a quarter of the way from
 * the middle to the border. The border is 4 and 2 away at distance 2. */
static void pixel_centres(void **state)
{
    (void)state;
    const gn_vec3 centre = {4 + 0.5f, 2 + 0.5f, 0.75f};
    gn_transform projection, viewport;
    gn_vec3 point, window;
    assert_int_equal(gn_perspective_rh_no(right_angle, 2, 1, 3, &projection), GN_OK);
    assert_int_equal(gn_viewport_no(0, 0, 8, 4, 0, 1, &viewport), GN_OK);
    assert_int_equal(gn_unproject(&projection, &viewport, centre, &point), GN_OK);
    assert_vector(point, 0.5f, 0.5f, -2, 2e-6f);
    assert_int_equal(gn_project(&projection, &viewport, point, &window), GN_OK);
    assert_true(floorf(window.x) == 4 && floorf(window.y) == 2);
}

static void points_without_a_window(void **state)
{
    (void)state;
    const gn_vec3 behind = {0, 0, 1}, beside = {3, 4, 0}, eye = {0, 0, 0};
    const gn_vec3 nan = {0, NAN, -2}, close = {1e30f, 0, -1e-30f}, huge = {3e38f, 3e38f, -0.5f};
    const gn_vec3 beyond = {4, 2, 1.25f}, last = {4, 2, 1}, infinite = {4, -INFINITY, 0.5f};
    gn_transform projection, viewport, bad;
    gn_vec3 result = {7, 7, 7}, at_depth;
    assert_int_equal(gn_perspective_rh_zo_infinite(right_angle, 2, 1, &projection), GN_OK);
    assert_int_equal(gn_viewport_zo(0, 0, 8, 4, 0, 1, &viewport), GN_OK);
    assert_int_equal(gn_project(&projection, &viewport, behind, &result), GN_BEHIND_EYE);
    assert_int_equal(gn_project(&projection, &viewport, beside, &result), GN_BEHIND_EYE);
    assert_int_equal(gn_project(&projection, &viewport, eye, &result), GN_BEHIND_EYE);
    assert_int_equal(gn_project(&projection, &viewport, nan, &result), GN_NOT_FINITE);
    assert_int_equal(gn_project(&projection, &viewport, close, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_project(&projection, &viewport, huge, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_unproject(&projection, &viewport, beyond, &result), GN_BEHIND_EYE);
    assert_int_equal(gn_unproject(&projection, &viewport, last, &result), GN_BEHIND_EYE);
    assert_int_equal(gn_unproject(&projection, &viewport, infinite, &result), GN_NOT_FINITE);
    const gn_vec3 large = {0x1p126f, 0x1p126f, 0x1p126f}, four = {4, 4, 4};
    assert_int_equal(gn_scale(large, &bad), GN_OK);
    assert_int_equal(gn_project(&bad, &viewport, four, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_project(&viewport, &bad, four, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_transform_invert(&bad, &bad), GN_OK);
    assert_int_equal(gn_unproject(&bad, &viewport, large, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_unproject(&projection, &bad, four, &result), GN_OUT_OF_RANGE);
    bad = projection;
    bad.matrix.m[1][1] = bad.inverse.m[1][1] = NAN;
    assert_int_equal(gn_project(&bad, &viewport, behind, &result), GN_NOT_FINITE);
    assert_int_equal(gn_unproject(&bad, &viewport, last, &result), GN_NOT_FINITE);
    bad = viewport;
    bad.matrix.m[1][1] = bad.inverse.m[1][1] = INFINITY;
    assert_int_equal(gn_project(&projection, &bad, behind, &result), GN_NOT_FINITE);
    assert_int_equal(gn_unproject(&projection, &bad, last, &result), GN_NOT_FINITE);
    assert_int_equal(gn_project(NULL, &viewport, behind, &result), GN_NULL_POINTER);
    assert_int_equal(gn_project(&projection, NULL, behind, &result), GN_NULL_POINTER);
    assert_int_equal(gn_project(&projection, &viewport, behind, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_unproject(NULL, &viewport, last, &result), GN_NULL_POINTER);
    assert_int_equal(gn_unproject(&projection, NULL, last, &result), GN_NULL_POINTER);
    assert_int_equal(gn_unproject(&projection, &viewport, last, NULL), GN_NULL_POINTER);
    assert_vector(result, 7, 7, 7, 0);
    /* In an infinite projection the depth 1/2 is at twice the near distance. */
    const gn_vec3 middle = {4, 2, 0.5f};
    assert_int_equal(gn_unproject(&projection, &viewport, middle, &at_depth), GN_OK);
    assert_vector(at_depth, 0, 0, -2, 1e-6f);
}

static void division(void **state)
{
    (void)state;
    const gn_vec4 clip = {2, -4, 1, 2}, behind = {1, 1, 1, -1}, zero = {1, 1, 1, 0};
    const gn_vec4 minus_zero = {0, 0, 0, -0.0f}, nan = {1, 1, 1, NAN},
                  infinite = {INFINITY, 1, 1, 1};
    const gn_vec4 tiny = {1, 0, 0, 1e-45f}, huge = {FLT_MAX, 0, 0, 0.5f};
    gn_vec3 ndc = {7, 7, 7};
    assert_int_equal(gn_clip_to_ndc(behind, &ndc), GN_BEHIND_EYE);
    assert_int_equal(gn_clip_to_ndc(zero, &ndc), GN_BEHIND_EYE);
    assert_int_equal(gn_clip_to_ndc(minus_zero, &ndc), GN_BEHIND_EYE);
    assert_int_equal(gn_clip_to_ndc(nan, &ndc), GN_NOT_FINITE);
    assert_int_equal(gn_clip_to_ndc(infinite, &ndc), GN_NOT_FINITE);
    assert_int_equal(gn_clip_to_ndc(tiny, &ndc), GN_OUT_OF_RANGE);
    assert_int_equal(gn_clip_to_ndc(huge, &ndc), GN_OUT_OF_RANGE);
    assert_vector(ndc, 7, 7, 7, 0);
    assert_int_equal(gn_clip_to_ndc(clip, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_clip_to_ndc(clip, &ndc), GN_OK);
    assert_vector(ndc, 1, -2, 0.5f, 0);
}

/* The expression of the rasterizer (src/geometry/viewport.h). */
static void bits_of_the_rasterizer(void **state)
{
    (void)state;
    gn_transform projection, viewport;
    assert_int_equal(gn_frustum_rh_no(-0.3f, 0.4f, -0.2f, 0.35f, 0.5f, 20, &projection), GN_OK);
    assert_int_equal(gn_viewport_no(3.25f, 7, 641, 479, 0.1f, 0.9f, &viewport), GN_OK);
    for (float step = 0.0f; step < 10.0f; step += 0.0371f) {
        const gn_vec3 point = {step - 3.7f, 1.3f - step, -0.1f - step};
        const gn_vec4 homogeneous = {point.x, point.y, point.z, 1.0f};
        const gn_vec4 clip = gn_mat4_multiply_vec4(&projection.matrix, homogeneous);
        const float one_over_w = 1.0f / clip.w, c[3] = {clip.x, clip.y, clip.z};
        gn_vec3 window;
        assert_int_equal(gn_project(&projection, &viewport, point, &window), GN_OK);
        const float got[3] = {window.x, window.y, window.z};
        for (int i = 0; i < 3; ++i)
            assert_true(got[i] ==
                        c[i] * one_over_w * viewport.matrix.m[i][i] + viewport.matrix.m[3][i]);
    }
}

/* Draws the point into a picture of D32F, and returns the one depth that it wrote; 2 if none. */
static float drawn_depth(const gn_mat4 *clip_from_model, gn_vec3 point, bool zero_to_one)
{
    static float pixels[16 * 12];
    static unsigned char memory[GN_WORKSPACE_SIZE(1, 4)];
    const gn_target target = {.depth = gn_surface_bottom_up(pixels, GN_FORMAT_D32F, 16, 12)};
    const gn_mesh mesh = {
        .attribute = {[GN_ATTRIBUTE_POSITION] = {.data = &point.x, .components = 3}},
        .vertex_count = 1,
        .count = 1};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_pipeline pipeline = {
        .raster.topology = GN_POINTS,
        .depth = {.test = true,
                  .function = GN_ALWAYS,
                  .range = {true, 0.1f, 0.9f},
                  .clip_depth = zero_to_one ? GN_ZERO_TO_ONE : GN_NEGATIVE_ONE_TO_ONE}};
    const gn_color_uniforms uniforms = {*clip_from_model};

    for (int i = 0; i < 16 * 12; ++i)
        pixels[i] = 2;
    assert_int_equal(gn_use_depth_only(&pipeline, &uniforms), GN_OK);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    for (int i = 0; i < 16 * 12; ++i)
        if (pixels[i] != 2)
            return pixels[i];
    return 2;
}

static void depths_of_drawn_points(void **state)
{
    (void)state;
    for (int zero_to_one = 0; zero_to_one < 2; ++zero_to_one) {
        gn_transform projection, viewport;
        int drawn = 0;
        assert_int_equal((zero_to_one ? gn_perspective_rh_zo
                                      : gn_perspective_rh_no)(1.3f, 1.3f, 0.5f, 20, &projection),
                         GN_OK);
        assert_int_equal(
            (zero_to_one ? gn_viewport_zo : gn_viewport_no)(0, 0, 16, 12, 0.1f, 0.9f, &viewport),
            GN_OK);
        for (float step = 0.0f; step < 1.0f; step += 0.0037f) {
            const gn_vec3 point = {step - 0.5f, 0.5f - step, -0.6f - 18 * step};
            const float depth = drawn_depth(&projection.matrix, point, zero_to_one);
            gn_vec3 window;
            assert_int_equal(gn_project(&projection, &viewport, point, &window), GN_OK);
            assert_true(depth == 2 || depth == window.z);
            drawn += depth != 2;
        }
        assert_true(drawn > 200);
    }
}

static void cglm_agrees(void **state)
{
    (void)state;
    const gn_vec3 eye = {3, -2, 5}, target = {-1, 4, 0.5f}, up = {0.1f, 2, -0.3f};
    vec4 cglm_viewport = {10, 20, 640, 480};
    for (int zero_to_one = 0; zero_to_one < 2; ++zero_to_one) {
        gn_transform view, projection, viewport, to_clip;
        mat4 matrix, inverse;
        assert_int_equal(gn_look_at_rh(eye, target, up, &view), GN_OK);
        assert_int_equal((zero_to_one ? gn_perspective_rh_zo
                                      : gn_perspective_rh_no)(1, 1.5f, 0.5f, 20, &projection),
                         GN_OK);
        assert_int_equal(
            (zero_to_one ? gn_viewport_zo : gn_viewport_no)(10, 20, 640, 480, 0, 1, &viewport),
            GN_OK);
        assert_int_equal(gn_transform_compose(&projection, &view, &to_clip), GN_OK);
        memcpy(matrix, to_clip.matrix.m, sizeof matrix);
        memcpy(inverse, to_clip.inverse.m, sizeof inverse);
        for (float step = 0.0f; step < 1.0f; step += 0.1f) {
            const gn_vec3 point = {step, 2.0f - step, 1.0f + step};
            vec3 cglm_point = {point.x, point.y, point.z}, cglm_window, cglm_back;
            gn_vec3 window, back;
            (zero_to_one ? glm_project_zo : glm_project_no)(cglm_point, matrix, cglm_viewport,
                                                            cglm_window);
            (zero_to_one ? glm_unprojecti_zo : glm_unprojecti_no)(cglm_window, inverse,
                                                                  cglm_viewport, cglm_back);
            assert_int_equal(gn_project(&to_clip, &viewport, point, &window), GN_OK);
            assert_vector(window, cglm_window[0], cglm_window[1], cglm_window[2], 2e-4f);
            assert_int_equal(gn_unproject(&to_clip, &viewport, window, &back), GN_OK);
            assert_vector(back, cglm_back[0], cglm_back[1], cglm_back[2], 2e-5f);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_each_convention),
        cmocka_unit_test(pixel_centres),
        cmocka_unit_test(points_without_a_window),
        cmocka_unit_test(division),
        cmocka_unit_test(bits_of_the_rasterizer),
        cmocka_unit_test(depths_of_drawn_points),
        cmocka_unit_test(cglm_agrees),
    };
    return cmocka_run_group_tests_name("project", tests, NULL, NULL);
}
