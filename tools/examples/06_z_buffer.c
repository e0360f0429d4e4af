/* Lesson 6: the z-buffer. Beside its colour, every pixel stores the depth of what it shows. A
 * triangle draws a pixel only where the triangle is nearer than this depth, so the order of the
 * triangles does not matter. The lesson does this in one loop by hand, then with Gnomon, and
 * compares the depths. The right half of the picture shows them. */
#include <math.h>

#include "lesson.h"

enum { WIDTH = 400, HEIGHT = 400 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static double by_hand[WIDTH * HEIGHT]; /* the z-buffer of our own loop */
static uint32_t picture[2 * WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 06_z_buffer [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model with a z-buffer, and beside it the picture of the "
                           "z-buffer: near is bright.\n";

/* Fills the z-buffer by hand. A place in the window has a z too: 0 at the near plane, 1 at the far
 * plane. Inside a triangle z is mixed from the corners as colours are, by the barycentric
 * coordinates of lesson 3. */
static void draw_by_hand(const obj_model *model, const gn_mat4 *clip_from_model)
{
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        by_hand[i] = 1; /* the far plane: nothing is drawn yet */
    for (uint32_t t = 0; t + 2 < model->count; t += 3) {
        gn_vec3 p[3];
        double weight[3];

        for (int k = 0; k < 3; ++k) { /* from NDC to pixels and a depth */
            const gn_vec3 ndc =
                gn_mat4_transform_point(clip_from_model, model->corner[t + k].position);

            p[k] = (gn_vec3){lesson_rounded((ndc.x + 1) / 2 * WIDTH),
                             lesson_rounded((ndc.y + 1) / 2 * HEIGHT), (ndc.z + 1) / 2};
        }
        const gn_vec3 low = gn_vec3_minimum(gn_vec3_minimum(p[0], p[1]), p[2]);
        const gn_vec3 high = gn_vec3_maximum(gn_vec3_maximum(p[0], p[1]), p[2]);
        for (int y = (int)gn_maximum1(low.y, 0); y <= (int)high.y && y < HEIGHT; ++y)
            for (int x = (int)gn_maximum1(low.x, 0); x <= (int)high.x && x < WIDTH; ++x) {
                if (!lesson_barycentric(p, x + 0.5, y + 0.5, weight))
                    continue;
                const double z = weight[0] * p[0].z + weight[1] * p[1].z + weight[2] * p[2].z;

                if (z >= 0 && z < by_hand[y * WIDTH + x])
                    by_hand[y * WIDTH + x] = z; /* the colour would be written here too */
            }
    }
}

/* Counts the pixels where Gnomon's depth differs by more than a thousandth. A few do, where a
 * triangle is seen from the side: its depth then changes much within one pixel.
 */
static int count_differences(void)
{
    int differing = 0;

    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        differing += fabs(by_hand[i] - depth[i] / 16777215.0) > 0.001;
    return differing;
}

/* A depth of GN_FORMAT_D24 is a number from 0 (near) to 2^24 - 1 (far, as cleared). The nearest
 * depth becomes white, the farthest dark grey. Pixels where nothing was drawn become black. */
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

    /* Depth 0 lies 1.5 in front of the middle of the model, depth 1 lies 1.5 behind it. */
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
    gn_clear_depth(&target.depth, 1); /* the far plane */
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    draw_by_hand(&model, &clip_from_model.matrix);
    printf("depths: %d of %d pixels differ from those by hand\n", count_differences(),
           WIDTH * HEIGHT);
    put_side_by_side();
    tga_write(lesson_argument(argc, argv, 2, "build/examples/06_z_buffer.tga"), picture, 2 * WIDTH,
              HEIGHT);
    free(model.corner);
    return 0;
}
