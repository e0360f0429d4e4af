/* Lesson 11: flat. One normal for each whole triangle shows the triangles as they are. The model
 * needs no normals: the cross product of two edges is one. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 11_flat [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model, lit with one normal for each triangle.\n";

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 2, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));

    const float turn = lesson_slider("turn of the model", -0.4f, -3.14f, 3.14f);
    const float light = lesson_slider("turn of the light", 0, -3.14f, 3.14f);
    const float fov = lesson_slider("field of view", 0.7f, 0.05f, 2);
    gn_transform view, projection, clip_from_world, world_from_model, clip_from_model;
    lesson_check(gn_look_at_rh((gn_vec3){0, 1, 3}, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(fov, (float)WIDTH / HEIGHT, 0.1f, 10, &projection));
    lesson_check(gn_transform_compose(&projection, &view, &clip_from_world));
    lesson_check(gn_rotate_y(turn, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));

    /* The shader asks how the place changes from a pixel to its neighbours to the right and above.
     * Both changes lie in the triangle, so their cross product is its normal. */
    gn_lit_uniforms uniforms = {
        .clip_from_model = clip_from_model.matrix,
        .world_from_model = world_from_model.matrix,
        .light = {.direction = lesson_turned((gn_vec3){0.6f, 0.64f, 0.48f}, light),
                  .ambient = {0.1f, 0.1f, 0.15f},
                  .diffuse = {0.9f, 0.8f, 0.6f}}};
    gn_pipeline pipeline = {.depth.test_enabled = true};
    lesson_check(gn_use_flat(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    tga_write(lesson_argument(argc, argv, 2, "build/examples/11_flat.tga"), color, WIDTH, HEIGHT);
    free(model.corner);
    return 0;
}
