/* Lesson 2: a model as lines. A model is a list of triangles, and a triangle is three corners. Drop
 * the z of each corner, map x and y to the window, and join the corners by the lines of lesson 1.
 */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 02_wireframe [MODEL.obj [PICTURE.tga]]\n"
                           "Draws the edges of a model's triangles.\n";

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 2, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));

    /* The box -wide..wide, -high..high of the model becomes the window. The 4:3 of the window is
     * also that of the box, so that a square stays a square. */
    gn_transform clip_from_model;
    const float high = lesson_slider("half the height of the box", 1.1f, 0.2f, 4);
    const float stretch = lesson_slider("stretch of the box", 1, 0.4f, 2.5f);
    const float near_plane =
        lesson_slider("near plane", -2, -2, 0.9f); /* cuts off what is before it */
    const float wide = stretch * high * WIDTH / HEIGHT;
    lesson_check(gn_orthographic_rh_no(-wide, wide, -high, high, near_plane, 2, &clip_from_model));

    /* A mesh without vertex colours is white. */
    gn_color_uniforms uniforms = {clip_from_model.matrix};
    gn_pipeline pipeline = {
        .raster = {.polygon_mode_front = GN_POLYGON_LINE, .polygon_mode_back = GN_POLYGON_LINE}};
    lesson_check(gn_use_vertex_color(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)}, {0}};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));
    printf("%u triangles\n", (unsigned)model.count / 3);

    tga_write(lesson_argument(argc, argv, 2, "build/examples/02_wireframe.tga"), color, WIDTH,
              HEIGHT);
    free(model.corner);
    return 0;
}
