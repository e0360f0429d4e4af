/* Lesson 6: the z-buffer. Beside its colour, every pixel keeps the depth of what it shows. A
 * triangle draws a pixel only where it is nearer than what is there already. The order of the
 * triangles then no longer matters. The right half of the picture shows the depths. */
#include "lesson.h"

enum { WIDTH = 400, HEIGHT = 400 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static uint32_t picture[2 * WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 06_z_buffer [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model with a z-buffer, and beside it the picture of the "
                           "z-buffer: near is bright.\n";

/* A depth of GN_FORMAT_D24 is a number from 0 (near) to 2^24 - 1 (far, as cleared). The nearest one
 * becomes white, the farthest one dark grey, and pixels that nothing was drawn to black. */
static uint32_t grey_of_depth(uint32_t d, uint32_t nearest, uint32_t farthest)
{
    const uint32_t range = farthest > nearest ? farthest - nearest : 1;
    const uint32_t grey = d > farthest ? 0 : 255 - (uint32_t)(215ull * (d - nearest) / range);

    return grey | grey << 8 | grey << 16 | 0xFF000000u;
}

static void put_side_by_side(void)
{
    const uint32_t cleared = 0xFFFFFF;
    uint32_t nearest = cleared, farthest = 0;

    for (uint32_t i = 0; i < WIDTH * HEIGHT; ++i) {
        nearest = depth[i] < nearest ? depth[i] : nearest;
        farthest = depth[i] < cleared && depth[i] > farthest ? depth[i] : farthest;
    }
    for (uint32_t y = 0; y < HEIGHT; ++y) {
        for (uint32_t x = 0; x < WIDTH; ++x) {
            picture[y * 2 * WIDTH + x] = color[y * WIDTH + x];
            picture[y * 2 * WIDTH + WIDTH + x] =
                grey_of_depth(depth[y * WIDTH + x], nearest, farthest);
        }
    }
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 2, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));

    /* Depth 0 lies 1.5 before the middle of the model, depth 1 lies 1.5 behind it. */
    const float near_plane = lesson_slider("near plane", -1.5f, -1.5f, 0.4f);
    const float far_plane = lesson_slider("far plane", 1.5f, 0.5f, 1.5f);
    const float turn = lesson_slider("turn of the model", -0.6f, -3.14f, 3.14f);
    gn_transform clip_from_world, world_from_model, clip_from_model;
    lesson_check(
        gn_orthographic_rh_no(-1.1f, 1.1f, -1.1f, 1.1f, near_plane, far_plane, &clip_from_world));
    lesson_check(gn_rotate_y(turn, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));

    gn_lit_uniforms uniforms = {.clip_from_model = clip_from_model.matrix,
                                .world_from_model = world_from_model.matrix,
                                .light = {.direction = {0, 0, 1}, .diffuse = {1, 0.9f, 0.7f}}};
    gn_pipeline pipeline = {.depth.test_enabled = true}; /* this line is the whole lesson */
    lesson_check(gn_use_flat(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1); /* as far as can be */
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    put_side_by_side();
    tga_write(lesson_argument(argc, argv, 2, "build/examples/06_z_buffer.tga"), picture, 2 * WIDTH,
              HEIGHT);
    free(model.corner);
    return 0;
}
