/* Lesson 15: a specular map as exponent. Skin shines otherwise than lips: the exponent of the
 * highlight comes from an image. A large exponent makes the highlight small. No ready-made shader
 * does this, so we write one: a vertex function, a function that names the texels, a fragment
 * function. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];

static const char help[] =
    "usage: 15_specular_map [MODEL.obj [DIFFUSE.tga SPECULAR.tga [PICTURE.tga]]]\n"
    "Draws a model whose specular map holds exponents, 0 to 255.\n";

typedef struct shiny_uniforms {
    gn_mat4 clip_from_model, world_from_model;
    gn_mat3 normal_matrix;
    gn_vec3 eye, to_light; /* to_light has length 1 */
    gn_vec3 ambient, diffuse, specular;
    gn_texture diffuse_map, specular_map;
    gn_sampler sampler;
} shiny_uniforms;

typedef struct shiny_varyings {
    gn_vec3 normal, place; /* in the world */
    gn_vec2 texcoord;
} shiny_varyings;

static gn_vec4 shiny_vertex(const shiny_uniforms *u, gn_vertex *vertex, shiny_varyings *out)
{
    const gn_vec4 position = vertex->attribute[GN_ATTRIBUTE_POSITION];

    out->normal =
        gn_multiply_mat3(&u->normal_matrix, gn_xyz4(vertex->attribute[GN_ATTRIBUTE_NORMAL]));
    out->place = gn_xyz4(gn_multiply_mat4(&u->world_from_model, position));
    out->texcoord = gn_xy4(vertex->attribute[GN_ATTRIBUTE_TEXCOORD]);
    return gn_multiply_mat4(&u->clip_from_model, position);
}

static void shiny_lookups(const shiny_uniforms *u, const shiny_varyings *in,
                          gn_texel_lookup *lookup)
{
    lookup[0] = gn_lookup_2d(&u->diffuse_map, &u->sampler, in->texcoord);
    lookup[1] = gn_lookup_2d(&u->specular_map, &u->sampler, in->texcoord);
}

static gn_vec4 shiny_fragment(const shiny_uniforms *u, const shiny_varyings *in,
                              gn_fragment *fragment)
{
    const gn_vec3 n = gn_normalize3(in->normal);
    const gn_vec3 to_eye = gn_normalize3(gn_subtract3(u->eye, in->place));
    const float cosine = gn_dot3(n, u->to_light);
    const gn_vec3 mirrored = gn_subtract3(gn_scale3(n, 2.0f * cosine), u->to_light);
    const float toward_eye = gn_maximum1(gn_dot3(mirrored, to_eye), 0.0f);

    /* The map's red, 0 to 1, as the whole number 0 to 255 that the file holds, at least 1. */
    const uint32_t exponent = (uint32_t)gn_maximum1(fragment->texel[1].x * 255.0f + 0.5f, 1.0f);
    const float shine = gn_power1(toward_eye, exponent);

    const gn_vec3 lit = gn_add3(u->ambient, gn_scale3(u->diffuse, gn_maximum1(cosine, 0.0f)));
    const gn_vec3 highlight = gn_scale3(u->specular, gn_select1(cosine > 0.0f, shine, 0.0f));
    return gn_extend3(gn_add3(gn_multiply3(gn_xyz4(fragment->texel[0]), lit), highlight), 1.0f);
}

GN_TEXTURED_SHADERS(use_shiny, shiny_uniforms, shiny_varyings, shiny_vertex, 2, shiny_lookups,
                    shiny_fragment);

static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_VARYING_COUNT(shiny_varyings))];

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
    tga_image diffuse =
        tga_read(lesson_argument(argc, argv, 2, "build/examples/teapot_diffuse.tga"));
    tga_image specular =
        tga_read(lesson_argument(argc, argv, 3, "build/examples/teapot_specular.tga"));

    const float turn = lesson_slider("turn of the model", -0.4f, -3.14f, 3.14f);
    const float light = lesson_slider("turn of the light", 0, -3.14f, 3.14f);
    const float shine = lesson_slider("strength of the highlight", 0.6f, 0, 1);
    const gn_vec3 eye = {0, 1, 3};
    gn_transform view, projection, clip_from_world, world_from_model, clip_from_model;
    lesson_check(gn_look_at_rh(eye, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(0.7f, (float)WIDTH / HEIGHT, 0.1f, 10, &projection));
    lesson_check(gn_transform_compose(&projection, &view, &clip_from_world));
    lesson_check(gn_rotate_y(turn, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));

    shiny_uniforms uniforms = {.clip_from_model = clip_from_model.matrix,
                               .world_from_model = world_from_model.matrix,
                               .eye = eye,
                               .to_light = lesson_turned((gn_vec3){0.6f, 0.64f, 0.48f}, light),
                               .ambient = {0.2f, 0.2f, 0.25f},
                               .diffuse = {0.9f, 0.85f, 0.8f},
                               .specular = {shine, shine, shine},
                               .diffuse_map = texture_of(&diffuse),
                               .specular_map = texture_of(&specular),
                               .sampler = {.minify = GN_MINIFY_LINEAR}};
    gn_transform_normal_matrix(&world_from_model, &uniforms.normal_matrix);
    gn_pipeline pipeline = {.depth.test_enabled = true};
    lesson_check(use_shiny(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    tga_write(lesson_argument(argc, argv, 4, "build/examples/15_specular_map.tga"), color, WIDTH,
              HEIGHT);
    free(specular.pixel);
    free(diffuse.pixel);
    free(model.corner);
    return 0;
}
