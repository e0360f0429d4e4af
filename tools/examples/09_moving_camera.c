/* Lesson 9: a moving camera. To move the camera to the right is to move the world to the left: the
 * view is the inverse of the camera's own place in the world. Twelve views from a circle. */
#include "lesson.h"

enum { COLUMNS = 4, ROWS = 3, VIEW_WIDTH = 160, VIEW_HEIGHT = 160 };
enum { WIDTH = COLUMNS * VIEW_WIDTH, HEIGHT = ROWS * VIEW_HEIGHT };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 09_moving_camera [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model as a camera sees it that walks around it.\n";

/* The camera on its walk, a little above the model and looking at its middle. gn_look_at_rh writes
 * the view, and as its inverse the camera's place: the columns are what the camera calls right, up
 * and back, and its position. */
static gn_transform view_at(float angle, float distance, float height)
{
    const gn_vec3 eye = {distance * gn_sin(angle), height, distance * gn_cos(angle)};
    gn_transform view;

    lesson_check(gn_look_at_rh(eye, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    return view;
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 2, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));

    const float distance = lesson_slider("distance of the camera", 3, 1.2f, 8);
    const float height = lesson_slider("height of the camera", 1.2f, -4, 4);
    const float fov = lesson_slider("field of view", 0.62f, 0.1f, 2);
    gn_transform projection;
    lesson_check(gn_perspective_rh_no(fov, (float)VIEW_WIDTH / VIEW_HEIGHT, 0.1f, 10, &projection));
    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    for (int i = 0; i < COLUMNS * ROWS; ++i) {
        const gn_transform view =
            view_at((float)i / (COLUMNS * ROWS) * 2 * GN_PI, distance, height);
        const int x = i % COLUMNS * VIEW_WIDTH, y = (ROWS - 1 - i / COLUMNS) * VIEW_HEIGHT;
        gn_transform clip;
        lesson_check(gn_transform_compose(&projection, &view, &clip));

        /* The light stays where it is in the world while the camera moves. */
        gn_lit_uniforms uniforms = {.clip_from_model = clip.matrix,
                                    .light = {.direction = {0.6f, 0.64f, 0.48f},
                                              .ambient = {0.25f, 0.25f, 0.3f},
                                              .diffuse = {0.75f, 0.65f, 0.45f}}};
        gn_mat4_identity(&uniforms.world_from_model);
        gn_mat3_identity(&uniforms.normal_matrix);
        gn_pipeline pipeline = {.depth.test_enabled = true};
        pipeline.raster.viewport = (gn_viewport){true, (float)x, (float)y, VIEW_WIDTH, VIEW_HEIGHT};
        lesson_check(gn_use_gouraud(&pipeline, &uniforms));
        lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));
    }
    tga_write(lesson_argument(argc, argv, 2, "build/examples/09_moving_camera.tga"), color, WIDTH,
              HEIGHT);
    free(model.corner);
    return 0;
}
