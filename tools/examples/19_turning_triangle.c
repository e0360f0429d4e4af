/* Lesson 19: a triangle turns about the axis (1, 1, 0) in 101 frames of 700x700 pixels. Frame 0 and
 * frame 100 are the same picture, so that the animation can be repeated without a jump. */
#include "lesson.h"

enum { SIDE = 700, FRAMES = 101, SHOWN = 3, SMALL = 210 };

static uint32_t color[SIDE * SIDE], depth[SIDE * SIDE];
static uint32_t sheet[SHOWN * SMALL * SHOWN * SMALL];
static unsigned char memory[GN_WORKSPACE_SIZE(3, GN_SHADER_VARYINGS)];

static const char help[] =
    "usage: 19_turning_triangle [PICTURE.tga [DIRECTORY]]\n"
    "Draws 101 frames; nine of them make the picture. If there is a directory, writes all of\n"
    "them there, frame-000.tga to frame-100.tga (148 MB).\n";

/* Rodrigues: about the axis a of length 1, by the angle t,
 *     R = cos t I + (1 - cos t) a a^T + sin t [a]x
 * gn_rotate_axis normalizes the axis and writes R, and R transposed as its inverse. */
static void draw_frame(int frame, gn_vec3 axis, float fov, const gn_target *target)
{
    static const gn_vec3 position[3] = {{-0.8f, -0.6f, 0}, {0.8f, -0.6f, 0}, {0, 0.8f, 0}};
    static const gn_vec3 colors[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const gn_mesh mesh = {.attribute = {[GN_ATTRIBUTE_POSITION] = {&position[0].x, 3, 0, 0},
                                        [GN_ATTRIBUTE_COLOR] = {&colors[0].x, 3, 0, 0}},
                          .vertex_count = 3,
                          .count = 3};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_pipeline pipeline = {.depth.test_enabled =
                                true}; /* nothing is culled: the back is seen too */
    gn_transform turned, view, projection, clip;

    lesson_check(gn_rotate_axis(axis, 2 * GN_PI * (float)frame / (FRAMES - 1), &turned));
    lesson_check(gn_look_at_rh((gn_vec3){0, 0, 3}, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(fov, 1, 0.1f, 10, &projection));
    lesson_check(gn_transform_compose(&view, &turned, &clip));
    lesson_check(gn_transform_compose(&projection, &clip, &clip));
    const gn_color_uniforms uniforms = {clip.matrix};
    lesson_check(gn_use_vertex_color(&pipeline, &uniforms));

    gn_clear_color(&target->color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target->depth, 1);
    lesson_check(gn_draw(target, &pipeline, &mesh, &workspace));
}

/* Every twelfth frame becomes a small picture of the sheet, from the upper left on. */
static void add_to_sheet(int frame, const gn_surface *from)
{
    const gn_surface to =
        gn_surface_bottom_up(sheet, GN_FORMAT_RGBA8, SHOWN * SMALL, SHOWN * SMALL);
    const int n = frame / 12, x = n % SHOWN * SMALL, y = (SHOWN - 1 - n / SHOWN) * SMALL;
    const gn_rectangle there = {x, y, x + SMALL, y + SMALL};
    const gn_blit_options options = {.filter = GN_BLIT_LINEAR};

    if (frame % 12 == 0)
        lesson_check(gn_blit(&to, &there, from, NULL, &options));
}

int main(int argc, char **argv)
{
    char path[4096];

    lesson_help(argc, argv, 2, help);
    const gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, SIDE, SIDE)},
                              gn_surface_bottom_up(depth, GN_FORMAT_D24, SIDE, SIDE)};
    const float y = lesson_slider("y of the axis", 1, -1, 1);
    const float z = lesson_slider("z of the axis", 0, -1, 1);
    const float fov = lesson_slider("field of view", 0.8f, 0.3f, 2.5f);
    const gn_vec3 axis = {1, y, z};
    for (int frame = 0; frame < FRAMES; ++frame) {
        draw_frame(frame, axis, fov, &target);
        if (frame < 12 * SHOWN * SHOWN)
            add_to_sheet(frame, &target.color[0]);
        if (lesson_words(argc, argv) > 2) {
            snprintf(path, sizeof path, "%s/frame-%03d.tga", argv[2], frame);
            tga_write(path, color, SIDE, SIDE);
        }
    }
    tga_write(lesson_argument(argc, argv, 1, "build/examples/19_turning_triangle.tga"), sheet,
              SHOWN * SMALL, SHOWN * SMALL);
    return 0;
}
