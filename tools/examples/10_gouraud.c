/* Lesson 10: Gouraud. The more a surface faces the light, the brighter it is. Gouraud computes this
 * at the corners of each triangle, with the corners' normals, and mixes the colours in between. So
 * a model of small flat triangles looks round. The lesson does this in one loop by hand, then with
 * Gnomon, and compares the colours. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static uint32_t by_hand[WIDTH * HEIGHT];
static double nearest[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 10_gouraud [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model, lit at the corners of its triangles.\n";

/* A corner after lighting: its place in the window, its distance w, and its colour, from 0 to 1. */
typedef struct lit_corner {
    gn_vec3 window;
    double w;
    gn_vec3 color;
} lit_corner;

static lit_corner light_corner(const obj_corner *corner, const gn_lit_uniforms *u)
{
    const gn_vec3 p = corner->position;
    const gn_vec4 clip = gn_mat4_multiply_vec4(&u->clip_from_model, (gn_vec4){p.x, p.y, p.z, 1});
    const gn_vec3 window = {lesson_rounded((clip.x / clip.w + 1) / 2 * WIDTH),
                            lesson_rounded((clip.y / clip.w + 1) / 2 * HEIGHT), clip.z / clip.w};
    gn_vec3 normal = gn_mat3_multiply_vec3(&u->normal_matrix, corner->normal);

    gn_vec3_normalize(normal, &normal);
    const float lambert = gn_maximum1(gn_vec3_dot(normal, u->light.direction), 0);
    return (lit_corner){window, clip.w,
                        gn_vec3_add(u->light.ambient, gn_vec3_scale(u->light.diffuse, lambert))};
}

/* Draws by hand: the z-buffer of lesson 6, the division of lesson 8, and colours instead of s and
 * t. */
static void draw_by_hand(const obj_model *model, const gn_lit_uniforms *uniforms)
{
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        nearest[i] = 1;
        by_hand[i] = 0;
    }
    for (uint32_t t = 0; t + 2 < model->count; t += 3) {
        lit_corner c[3];
        gn_vec3 p[3];
        double weight[3];

        for (int k = 0; k < 3; ++k) {
            c[k] = light_corner(&model->corner[t + k], uniforms);
            p[k] = c[k].window;
        }
        const gn_vec3 low = gn_vec3_minimum(gn_vec3_minimum(p[0], p[1]), p[2]);
        const gn_vec3 high = gn_vec3_maximum(gn_vec3_maximum(p[0], p[1]), p[2]);
        for (int y = (int)gn_maximum1(low.y, 0); y <= (int)high.y && y < HEIGHT; ++y)
            for (int x = (int)gn_maximum1(low.x, 0); x <= (int)high.x && x < WIDTH; ++x) {
                double sum[3] = {0, 0, 0}, one_over_w = 0;

                if (!lesson_barycentric(p, x + 0.5, y + 0.5, weight))
                    continue;
                const double z = weight[0] * p[0].z + weight[1] * p[1].z + weight[2] * p[2].z;
                if (z >= nearest[y * WIDTH + x])
                    continue;
                nearest[y * WIDTH + x] = z;
                for (int k = 0; k < 3; ++k) {
                    const double share = weight[k] / c[k].w;

                    one_over_w += share;
                    sum[0] += share * c[k].color.x;
                    sum[1] += share * c[k].color.y;
                    sum[2] += share * c[k].color.z;
                }
                by_hand[y * WIDTH + x] = 0xFF000000u;
                for (int i = 0; i < 3; ++i) {
                    const double v = sum[i] / one_over_w;

                    by_hand[y * WIDTH + x] |= (uint32_t)(255 * (v < 1 ? v : 1) + 0.5) << 8 * i;
                }
            }
    }
}

/* Counts the pixels that the loop has drawn, and those of them whose colours differ from Gnomon's
 * by more than one step of 255. */
static void compare(void)
{
    int drawn = 0, differing = 0;

    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        bool differs = false;

        for (int shift = 0; shift < 24; shift += 8)
            differs = differs ||
                      abs((int)(by_hand[i] >> shift & 255) - (int)(color[i] >> shift & 255)) > 1;
        drawn += by_hand[i] != 0;
        differing += by_hand[i] != 0 && differs;
    }
    printf("colours: %d of %d pixels differ from those by hand\n", differing, drawn);
}

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

    /* color = ambient + diffuse * max(N . L, 0). Normals take another matrix than points, the
     * transposed inverse: otherwise the normals of a stretched model would not be perpendicular. */
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

    draw_by_hand(&model, &uniforms);
    compare();
    tga_write(lesson_argument(argc, argv, 2, "build/examples/10_gouraud.tga"), color, WIDTH,
              HEIGHT);
    free(model.corner);
    return 0;
}
