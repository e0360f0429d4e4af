/* Lesson 14: a normal map. The model stays as it is, but each pixel takes its normal from an image,
 * and looks dented. The image holds normals relative to the surface: red along the tangent, green
 * along the bitangent, blue along the normal. This lesson computes the tangents. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] =
    "usage: 14_normal_map [MODEL.obj [DIFFUSE.tga NORMAL.tga [PICTURE.tga]]]\n"
    "Draws a model with a diffuse map and a normal map of tangent space.\n";

/* The direction in a triangle in which s grows. The edges are e1 = d1.x T + d1.y B and
 * e2 = d2.x T + d2.y B, where d.x and d.y are the changes of s and t along the edge. These two
 * equations in the unknown vectors T and B give T. The fourth number says on which side of
 * normal x T the bitangent B lies. */
static gn_vec4 tangent_of(const obj_corner triangle[3])
{
    const gn_vec3 e1 = gn_vec3_subtract(triangle[1].position, triangle[0].position);
    const gn_vec3 e2 = gn_vec3_subtract(triangle[2].position, triangle[0].position);
    const gn_vec3 d1 = gn_vec3_subtract(triangle[1].texcoord, triangle[0].texcoord);
    const gn_vec3 d2 = gn_vec3_subtract(triangle[2].texcoord, triangle[0].texcoord);
    const float determinant = d1.x * d2.y - d2.x * d1.y; /* below 0: the image is mirrored */
    const float side = determinant < 0 ? -1.0f : 1.0f;
    const gn_vec3 t = gn_vec3_subtract(gn_vec3_scale(e1, d2.y), gn_vec3_scale(e2, d1.y));

    return gn_extend3(gn_vec3_scale(t, side), side);
}

/* A corner's tangent: its triangle's, without the part along the corner's normal (Gram-Schmidt). */
static gn_vec4 *make_tangents(const obj_model *model)
{
    gn_vec4 *tangents = malloc(model->count * sizeof *tangents);

    for (uint32_t i = 0; tangents && i < model->count; ++i) {
        const gn_vec3 n = model->corner[i].normal;
        const gn_vec4 of_triangle = tangent_of(&model->corner[i - i % 3]);
        gn_vec3 t = gn_xyz4(of_triangle);

        t = gn_vec3_subtract(t, gn_vec3_scale(n, gn_vec3_dot(n, t) / gn_vec3_dot(n, n)));
        if (gn_vec3_normalize(t, &t) != GN_OK) /* no area in the image: any tangent will do */
            gn_vec3_normalize(gn_vec3_cross(n, (gn_vec3){n.y, n.z, n.x}), &t);
        tangents[i] = gn_extend3(t, of_triangle.w);
    }
    return tangents;
}

static gn_texture texture_of(const tga_image *image)
{
    gn_texture texture;

    lesson_check(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, image->width, image->height, 1,
                                   1, image->pixel, &texture));
    return texture;
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 4, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));
    tga_image image = tga_read(lesson_argument(argc, argv, 2, "build/examples/teapot_diffuse.tga"));
    tga_image normals =
        tga_read(lesson_argument(argc, argv, 3, "build/examples/teapot_normal.tga"));
    const gn_texture diffuse = texture_of(&image), normal = texture_of(&normals);
    gn_vec4 *tangents = make_tangents(&model);

    const float turn = lesson_slider("turn of the model", -0.4f, -3.14f, 3.14f);
    const float light = lesson_slider("turn of the light", 0, -3.14f, 3.14f);
    const int exponent = lesson_slider_int("exponent of the highlight", 30, 1, 400);
    const gn_vec3 eye = {0, 1, 3};
    gn_transform view, projection, clip_from_world, world_from_model, clip_from_model;
    lesson_check(gn_look_at_rh(eye, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(0.7f, (float)WIDTH / HEIGHT, 0.1f, 10, &projection));
    lesson_check(gn_transform_compose(&projection, &view, &clip_from_world));
    lesson_check(gn_rotate_y(turn, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));

    gn_lit_uniforms uniforms = {
        .clip_from_model = clip_from_model.matrix,
        .world_from_model = world_from_model.matrix,
        .eye = eye,
        .light = {.direction = lesson_turned((gn_vec3){0.6f, 0.64f, 0.48f}, light),
                  .ambient = {0.2f, 0.2f, 0.25f},
                  .diffuse = {0.9f, 0.85f, 0.8f}},
        .material = {.diffuse_map = &diffuse,
                     .normal_map = &normal,
                     .normal_space = GN_NORMAL_OF_TANGENTS,
                     .specular = {0.4f, 0.4f, 0.4f},
                     .exponent = (uint32_t)exponent},
    };
    uniforms.material.sampler.minify = GN_MINIFY_LINEAR;
    gn_transform_normal_matrix(&world_from_model, &uniforms.normal_matrix);
    gn_pipeline pipeline = {.depth.test_enabled = true};
    lesson_check(gn_use_phong(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    mesh.attribute[GN_ATTRIBUTE_TANGENT] = (gn_attribute){&tangents->x, 4, 0, 0};
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    tga_write(lesson_argument(argc, argv, 4, "build/examples/14_normal_map.tga"), color, WIDTH,
              HEIGHT);
    free(tangents);
    free(normals.pixel);
    free(image.pixel);
    free(model.corner);
    return 0;
}
