/* Lesson 7: a texture is an image that is wrapped around a model. Each corner of a triangle has
 * texture coordinates s and t, which say where in the image the corner lies. Between the corners
 * they are interpolated, and every pixel takes the colour that lies there in the image. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 07_texture [MODEL.obj [TEXTURE.tga [PICTURE.tga]]]\n"
                           "Draws a model with a texture.\n";

/* Far away, many texels fall into one pixel, and picking one of them makes the picture flicker. So
 * a texture also has smaller versions of itself, its levels: each half as large as the one before.
 * The levels after the first need memory, which the caller frees. */
static void *make_levels(gn_texture *texture)
{
    uint32_t levels = 1;

    while ((texture->width | texture->height) >> levels)
        ++levels;
    const size_t size = gn_texture_memory_size(GN_TEXTURE_2D, texture->format, texture->width,
                                               texture->height, 1, levels);
    void *smaller = malloc(size);
    lesson_check(gn_texture_generate_levels(texture, smaller, size));
    return smaller;
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 3, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));
    tga_image image = tga_read(lesson_argument(argc, argv, 2, "build/examples/teapot_diffuse.tga"));

    /* The image becomes a texture without a copy: the library reads the caller's memory. */
    gn_texture texture;
    lesson_check(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, image.width, image.height, 1, 1,
                                   image.pixel, &texture));
    void *levels = make_levels(&texture);

    /* Coordinates beyond 1 find the image again: it is repeated without end. */
    const float repeat = lesson_slider("repetitions of the image", 1, 0.25f, 12);
    const float shift = lesson_slider("shift of the image", 0, -1, 1);
    for (uint32_t i = 0; i < model.count; ++i) {
        model.corner[i].texcoord = gn_vec3_scale(model.corner[i].texcoord, repeat);
        model.corner[i].texcoord.x += shift;
    }

    gn_transform clip_from_model;
    const float high = lesson_slider("half the height of the box", 1.1f, 0.2f, 12);
    const float wide = high * WIDTH / HEIGHT;
    lesson_check(gn_orthographic_rh_no(-wide, wide, -high, high, -2, 2, &clip_from_model));

    gn_unlit_uniforms uniforms = {.clip_from_model = clip_from_model.matrix, .map = &texture};
    uniforms.sampler.minify = GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    gn_pipeline pipeline = {.depth.test_enabled = true};
    lesson_check(gn_use_unlit(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    tga_write(lesson_argument(argc, argv, 3, "build/examples/07_texture.tga"), color, WIDTH,
              HEIGHT);
    free(levels);
    free(image.pixel);
    free(model.corner);
    return 0;
}
