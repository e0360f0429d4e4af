/* Lesson 18: a head with its eyes, through exactly the matrices of lesson 17: the model's T R S,
 * the view as the inverse of the camera's T R S, the squeeze, the orthographic projection. Head and
 * eyes are two models with a texture each, drawn one after the other; the z-buffer puts the eyes
 * into their sockets. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 18_head [HEAD.obj HEAD.tga [EYES.obj EYES.tga [PICTURE.tga]]]\n"
                           "Draws a textured head of the size -1 to 1, and its eyes.\n";

static gn_mat4 product(const gn_mat4 *a, const gn_mat4 *b)
{
    gn_mat4 m;

    gn_mat4_multiply(a, b, &m);
    return m;
}

/* T R S, and beside it S^-1 R^-1 T^-1: gn_trs writes both. Neither is ever inverted with numbers.
 */
static gn_transform place(gn_vec3 position, float turn_y, float size)
{
    gn_transform rotation, result;
    gn_mat3 r;

    lesson_check(gn_rotate_y(turn_y, &rotation));
    gn_mat4_upper_left(&rotation.matrix, &r);
    lesson_check(gn_trs(position, &r, (gn_vec3){size, size, size}, &result));
    return result;
}

/* orthographic * squeeze of lesson 17; `high` is half the height of what is seen at distance n. */
static gn_mat4 perspective(float high, float n, float f)
{
    const float squeeze_rows[16] = {n, 0, 0, 0, 0, n, 0, 0, 0, 0, n + f, n * f, 0, 0, -1, 0};
    gn_mat4 squeeze;
    gn_transform box;

    gn_mat4_from_rows(squeeze_rows, &squeeze);
    lesson_check(gn_orthographic_rh_no(-high * WIDTH / HEIGHT, high * WIDTH / HEIGHT, -high, high,
                                       n, f, &box));
    return product(&box.matrix, &squeeze);
}

/* Draws one model with its texture. Free what is read: nothing of it is needed later. */
static void draw_part(const char *model_path, const char *texture_path, const gn_target *target,
                      gn_lit_uniforms uniforms)
{
    obj_model model = obj_read(model_path);
    tga_image image = tga_read(texture_path);
    gn_texture texture;
    gn_pipeline pipeline = {.depth.test_enabled = true};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};

    lesson_complete_normals(&model);
    lesson_check(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, image.width, image.height, 1, 1,
                                   image.pixel, &texture));
    uniforms.material.diffuse_map = &texture;
    uniforms.material.sampler.minify = GN_MINIFY_LINEAR;
    lesson_check(gn_use_phong(&pipeline, &uniforms));
    const gn_mesh mesh = lesson_mesh(&model);
    lesson_check(gn_draw(target, &pipeline, &mesh, &workspace));
    free(image.pixel);
    free(model.corner);
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 5, help);
    const int words = lesson_words(argc, argv);
    const float turn = lesson_slider("turn of the head", 0.35f, -3.14f, 3.14f);
    const float distance = lesson_slider("distance of the camera", 3.2f, 1.2f, 8);
    const float high = lesson_slider("half the height at the near plane", 0.19f, 0.05f, 1);
    const gn_transform world_from_model = place((gn_vec3){0, 0, 0}, turn, 1);
    const gn_vec3 eye = {0.3f, 0, distance};
    const gn_transform world_from_camera = place(eye, 0.1f, 1);
    const gn_mat4 projection = perspective(high, 0.5f, 10);

    const gn_mat4 view_from_model = product(&world_from_camera.inverse, &world_from_model.matrix);
    gn_lit_uniforms uniforms = {
        .clip_from_model = product(&projection, &view_from_model),
        .world_from_model = world_from_model.matrix,
        .eye = eye,
        .light = {.direction = {0.36f, 0.48f, 0.8f},
                  .ambient = {0.4f, 0.4f, 0.42f},
                  .diffuse = {0.8f, 0.75f, 0.7f}},
        .material = {.specular = {0.15f, 0.15f, 0.15f}, .exponent = 25},
    };
    gn_transform_normal_matrix(&world_from_model, &uniforms.normal_matrix);

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_clear_color(&target.color[0], 0.25f, 0.3f, 0.35f, 1);
    gn_clear_depth(&target.depth, 1);
    draw_part(lesson_argument(argc, argv, 1, "build/examples/head.obj"),
              lesson_argument(argc, argv, 2, "build/examples/head.tga"), &target, uniforms);
    if (words < 2 || words > 3)
        draw_part(lesson_argument(argc, argv, 3, "build/examples/eyes.obj"),
                  lesson_argument(argc, argv, 4, "build/examples/eyes.tga"), &target, uniforms);

    tga_write(lesson_argument(argc, argv, 5, "build/examples/18_head.tga"), color, WIDTH, HEIGHT);
    return 0;
}
