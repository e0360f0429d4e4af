/* Lesson 8: perspective. What is twice as far away looks half as large: x and y are divided by the
 * distance. Left: an orthographic projection, which divides by nothing; right: a perspective one.
 */
#include "lesson.h"

enum { WIDTH = 800, HEIGHT = 400 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 08_perspective [MODEL.obj [TEXTURE.tga [PICTURE.tga]]]\n"
                           "Draws a model with an orthographic and a perspective projection.\n";

/* The eye stands at the origin and looks along -z; the model is moved in front of it. A corner at
 * distance d = -z is drawn at x / (d tan(fov / 2)), y / (d tan(fov / 2)). A matrix cannot divide.
 * It writes d into w, and after the vertex shader everything is divided by w. */
static void make_projections(float eye_distance, float near_plane, gn_transform result[2])
{
    const float aspect = 0.5f * WIDTH / HEIGHT, wide = 1.15f, high = wide / aspect;
    const float fov_y = 2 * gn_atan(high / eye_distance); /* both see as much of the middle */

    lesson_check(gn_orthographic_rh_no(-wide, wide, -high, high, near_plane, 10, &result[0]));
    lesson_check(gn_perspective_rh_no(fov_y, aspect, near_plane, 10, &result[1]));
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 3, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));
    tga_image image = tga_read(lesson_argument(argc, argv, 2, "build/examples/teapot_diffuse.tga"));
    gn_texture texture;
    lesson_check(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, image.width, image.height, 1, 1,
                                   image.pixel, &texture));

    const float eye_distance = lesson_slider("distance of the eye", 2.2f, 1.2f, 8);
    const float near_plane = lesson_slider("near plane", 0.1f, 0.1f, 4);
    const float turn = lesson_slider("turn of the model", -0.9f, -3.14f, 3.14f);
    gn_transform projection[2], turned, moved, view_from_model, clip_from_model;
    make_projections(eye_distance, near_plane, projection);
    lesson_check(gn_rotate_y(turn, &turned));
    lesson_check(gn_translate((gn_vec3){0, 0, -eye_distance}, &moved));
    lesson_check(gn_transform_compose(&moved, &turned, &view_from_model));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    for (int half = 0; half < 2; ++half) {
        lesson_check(gn_transform_compose(&projection[half], &view_from_model, &clip_from_model));
        gn_unlit_uniforms uniforms = {.clip_from_model = clip_from_model.matrix, .map = &texture};
        gn_pipeline pipeline = {.depth.test_enabled = true};

        uniforms.sampler.minify = GN_MINIFY_LINEAR;
        pipeline.raster.viewport =
            (gn_viewport){true, half * WIDTH / 2.0f, 0, WIDTH / 2.0f, HEIGHT};
        lesson_check(gn_use_unlit(&pipeline, &uniforms));
        lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));
    }
    tga_write(lesson_argument(argc, argv, 3, "build/examples/08_perspective.tga"), color, WIDTH,
              HEIGHT);
    free(image.pixel);
    free(model.corner);
    return 0;
}
