/* Lesson 13: Phong. What Gouraud computes at corners, Phong computes at every pixel, with the
 * interpolated normal. Then highlights stay round and sharp, and each pixel can take its colour
 * from a diffuse map. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 13_phong [MODEL.obj [DIFFUSE.tga [PICTURE.tga]]]\n"
                           "Draws a model, lit at every pixel, with a diffuse map.\n";

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 3, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));
    tga_image image = tga_read(lesson_argument(argc, argv, 2, "build/examples/teapot_diffuse.tga"));
    gn_texture diffuse;
    lesson_check(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, image.width, image.height, 1, 1,
                                   image.pixel, &diffuse));

    const int exponent = lesson_slider_int("exponent of the highlight", 40, 1, 400);
    const float specular = lesson_slider("strength of the highlight", 0.6f, 0, 1);
    const float light = lesson_slider("turn of the light", 0, -3.14f, 3.14f);
    const gn_vec3 eye = {0, 1, 3};
    gn_transform view, projection, clip_from_world, world_from_model, clip_from_model;
    lesson_check(gn_look_at_rh(eye, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(0.7f, (float)WIDTH / HEIGHT, 0.1f, 10, &projection));
    lesson_check(gn_transform_compose(&projection, &view, &clip_from_world));
    lesson_check(gn_rotate_y(-0.4f, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));

    /* map * (ambient + diffuse * max(N . L, 0)) + specular * max(R . V, 0)^exponent */
    gn_lit_uniforms uniforms = {
        .clip_from_model = clip_from_model.matrix,
        .world_from_model = world_from_model.matrix,
        .eye = eye,
        .light = {.direction = lesson_turned((gn_vec3){0.6f, 0.64f, 0.48f}, light),
                  .ambient = {0.2f, 0.2f, 0.25f},
                  .diffuse = {0.9f, 0.85f, 0.8f}},
        .material = {.diffuse_map = &diffuse,
                     .specular = {specular, specular, specular},
                     .exponent = (uint32_t)exponent},
    };
    uniforms.material.sampler.minify = GN_MINIFY_LINEAR;
    gn_transform_normal_matrix(&world_from_model, &uniforms.normal_matrix);
    gn_pipeline pipeline = {.depth.test_enabled = true};
    lesson_check(gn_use_phong(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    tga_write(lesson_argument(argc, argv, 3, "build/examples/13_phong.tga"), color, WIDTH, HEIGHT);
    free(image.pixel);
    free(model.corner);
    return 0;
}
