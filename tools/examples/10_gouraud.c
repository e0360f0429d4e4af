/* Lesson 10: Gouraud. A surface is the brighter the more it faces the light. Gouraud computes this
 * at the corners of each triangle, with the corners' normals, and interpolates the colours. Small
 * triangles look round then, although each is flat. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 10_gouraud [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model, lit at the corners of its triangles.\n";

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 2, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));

    const float turn = lesson_slider("turn of the model", -0.4f, -3.14f, 3.14f);
    const float light = lesson_slider("turn of the light", 0, -3.14f, 3.14f);
    const float stretch = lesson_slider("stretch of the model", 1, 0.1f, 2);
    gn_transform view, projection, turned, scaled;
    gn_transform clip_from_world, world_from_model, clip_from_model;
    lesson_check(gn_look_at_rh((gn_vec3){0, 1, 3}, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(0.7f, (float)WIDTH / HEIGHT, 0.1f, 10, &projection));
    lesson_check(gn_transform_compose(&projection, &view, &clip_from_world));
    lesson_check(gn_rotate_y(turn, &turned));
    lesson_check(gn_scale((gn_vec3){1, stretch, 1}, &scaled));
    lesson_check(gn_transform_compose(&turned, &scaled, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));

    /* color = ambient + diffuse * max(N . L, 0). If a model is stretched, its normals must not be:
     * they take another matrix, the transposed inverse, which costs nothing here. */
    gn_lit_uniforms uniforms = {
        .clip_from_model = clip_from_model.matrix,
        .world_from_model = world_from_model.matrix,
        .light = {.direction = lesson_turned((gn_vec3){0.6f, 0.64f, 0.48f}, light),
                  .ambient = {0.1f, 0.1f, 0.15f},
                  .diffuse = {0.9f, 0.8f, 0.6f}}};
    gn_transform_normal_matrix(&world_from_model, &uniforms.normal_matrix);
    gn_pipeline pipeline = {.depth.test_enabled = true};
    lesson_check(gn_use_gouraud(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    tga_write(lesson_argument(argc, argv, 2, "build/examples/10_gouraud.tga"), color, WIDTH,
              HEIGHT);
    free(model.corner);
    return 0;
}
