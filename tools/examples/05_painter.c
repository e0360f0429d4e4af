/* Lesson 5: faces without a z-buffer. Whatever is drawn last lies on top, near or far. Left: the
 * triangles in the order of the file, which is wrong. Right: the farthest triangle first, as a
 * painter paints a landscape. That is better, but not right; lesson 6 says what is. */
#include "lesson.h"

enum { WIDTH = 800, HEIGHT = 400 };

static uint32_t color[WIDTH * HEIGHT], true_color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 05_painter [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model's triangles in the order of the file, and sorted.\n";

static const gn_mat4 *sorted_for; /* qsort's function has no argument for it */

static float distance(const obj_corner triangle[3])
{
    float z = 0;

    for (int i = 0; i < 3; ++i)
        z += gn_mat4_transform_point(sorted_for, triangle[i].position).z;
    return z; /* three times that of the triangle's middle; a greater z is nearer */
}

/* For qsort. At equal distances any order will do, as long as every machine takes the same one. */
static int farthest_first(const void *a, const void *b)
{
    const float za = distance(a), zb = distance(b);

    return za != zb ? (za > zb) - (za < zb) : memcmp(a, b, 3 * sizeof(obj_corner));
}

/* Draws the model into the left (0) or right half, in the order in which its triangles are now. */
static void draw_half(int half, const gn_target *target, gn_pipeline *pipeline,
                      const obj_model *model)
{
    const gn_mesh mesh = lesson_mesh(model);
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};

    pipeline->raster.viewport = (gn_viewport){true, half * WIDTH / 2.0f, 0, WIDTH / 2.0f, HEIGHT};
    lesson_check(gn_draw(target, pipeline, &mesh, &workspace));
}

static void count_wrong_pixels(void)
{
    unsigned wrong[2] = {0, 0};

    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        wrong[i % WIDTH >= WIDTH / 2] += color[i] != true_color[i];
    printf("wrong pixels: %u in the order of the file, %u sorted\n", wrong[0], wrong[1]);
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 2, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));

    gn_transform clip_from_world, world_from_model, clip_from_model;
    const float turn = lesson_slider("turn of the model", 1.1f, -3.14f, 3.14f);
    const float side = lesson_slider("half the side of the box", 1.1f, 0.2f, 3);
    lesson_check(gn_orthographic_rh_no(-side, side, -side, side, -2, 2, &clip_from_world));
    lesson_check(gn_rotate_y(turn, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));
    sorted_for = &world_from_model.matrix;

    gn_lit_uniforms uniforms = {.clip_from_model = clip_from_model.matrix,
                                .world_from_model = world_from_model.matrix,
                                .light = {.direction = {0, 0.6f, 0.8f},
                                          .ambient = {0.2f, 0.2f, 0.25f},
                                          .diffuse = {0.8f, 0.7f, 0.5f}}};
    gn_pipeline pipeline = {.raster.cull = GN_CULL_BACK};
    lesson_check(gn_use_flat(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)}, {0}};
    gn_target with_depth = {{gn_surface_bottom_up(true_color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                            gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_color(&with_depth.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&with_depth.depth, 1);
    draw_half(0, &target, &pipeline, &model);
    qsort(model.corner, model.count / 3, 3 * sizeof *model.corner, farthest_first);
    draw_half(1, &target, &pipeline, &model);

    /* What is right, by the means of the next lesson, to count what is wrong. */
    pipeline.depth.test_enabled = true;
    draw_half(0, &with_depth, &pipeline, &model);
    draw_half(1, &with_depth, &pipeline, &model);
    count_wrong_pixels();

    tga_write(lesson_argument(argc, argv, 2, "build/examples/05_painter.tga"), color, WIDTH,
              HEIGHT);
    free(model.corner);
    return 0;
}
