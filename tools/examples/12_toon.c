/* Lesson 12: toon. A cartoon has few colours: the brightness of a pixel is not drawn, but picks one
 * of the user's colours. This is the first shader of our own: two C functions. */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480, MOST_BANDS = 8 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];

static const char help[] =
    "usage: 12_toon [MODEL.obj [PICTURE.tga [COLOUR {THRESHOLD COLOUR}...]]]\n"
    "Draws a model in up to 8 colours, RRGGBB in hexadecimal, from dark to bright. A threshold\n"
    "from 0 to 1 is the brightness from which on the colour behind it is drawn.\n"
    "for example: 12_toon head.obj toon.tga 402030 0.25 a05040 0.7 f0c080\n";

typedef struct toon_uniforms {
    gn_mat4 clip_from_model;
    gn_mat3 normal_matrix;
    gn_vec3 to_light; /* of length 1 */
    int bands;
    float threshold[MOST_BANDS]; /* of band i; that of band 0 is 0 */
    gn_vec4 color[MOST_BANDS];
} toon_uniforms;

/* What the vertex function hands to the fragment function, interpolated in between. */
typedef struct toon_varyings {
    gn_vec3 normal;
} toon_varyings;

static gn_vec4 toon_vertex(const toon_uniforms *u, gn_vertex *vertex, toon_varyings *out)
{
    const gn_vec3 normal = gn_xyz4(vertex->attribute[GN_ATTRIBUTE_NORMAL]);

    out->normal = gn_normalize3(gn_multiply_mat3(&u->normal_matrix, normal));
    return gn_multiply_mat4(&u->clip_from_model, vertex->attribute[GN_ATTRIBUTE_POSITION]);
}

/* The last band whose threshold the brightness reaches. (Between vertices an interpolated normal is
 * shorter than 1, so it is normalized again.) */
static gn_vec4 toon_fragment(const toon_uniforms *u, const toon_varyings *in, gn_fragment *fragment)
{
    const float brightness = gn_dot3(gn_normalize3(in->normal), u->to_light);
    gn_vec4 result = u->color[0];

    (void)fragment;
    for (int i = 1; i < u->bands; ++i)
        result = gn_select4(brightness >= u->threshold[i], u->color[i], result);
    return result;
}

GN_SHADERS(use_toon, toon_uniforms, toon_varyings, toon_vertex, toon_fragment);

static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_VARYING_COUNT(toon_varyings))];

static bool read_color(const char *text, gn_vec4 *result)
{
    char *end;
    const unsigned long rgb = strtoul(text, &end, 16);

    *result = (gn_vec4){(float)(rgb >> 16 & 255) / 255, (float)(rgb >> 8 & 255) / 255,
                        (float)(rgb & 255) / 255, 1};
    return strlen(text) == 6 && *end == '\0';
}

/* Reads COLOUR {THRESHOLD COLOUR}; returns false if something else is there. */
static bool read_bands(int count, char **words, toon_uniforms *u)
{
    char *end;

    u->bands = (count + 1) / 2;
    if (count % 2 == 0 || u->bands > MOST_BANDS || !read_color(words[0], &u->color[0]))
        return false;
    for (int i = 1; i < u->bands; ++i) {
        u->threshold[i] = strtof(words[2 * i - 1], &end);
        if (*end || !(u->threshold[i] >= u->threshold[i - 1] && u->threshold[i] <= 1) ||
            !read_color(words[2 * i], &u->color[i]))
            return false;
    }
    return true;
}

int main(int argc, char **argv)
{
    static char *const bands[] = {"3a1f38", "0.15", "8a3b3b", "0.5", "d98a4b", "0.85", "fff0c0"};
    lesson_help(argc, argv, 2 + 2 * MOST_BANDS - 1, help);
    const float light = lesson_slider("turn of the light", 0, -3.14f, 3.14f);
    toon_uniforms uniforms = {.to_light = lesson_turned((gn_vec3){0.6f, 0.64f, 0.48f}, light)};
    const int words = lesson_words(argc, argv);
    if (!read_bands(words > 3 ? words - 3 : 7, words > 3 ? argv + 3 : (char **)bands, &uniforms)) {
        fputs("12_toon: not COLOUR THRESHOLD COLOUR ..., with growing thresholds up to 1\n",
              stderr);
        return 2;
    }
    float *threshold = uniforms.threshold;
    threshold[1] = lesson_slider("threshold of the second colour", threshold[1], -1, 1);
    threshold[3] = lesson_slider("threshold of the fourth colour", threshold[3], 0, 1);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));

    gn_transform view, projection, clip_from_world, world_from_model, clip_from_model;
    lesson_check(gn_look_at_rh((gn_vec3){0, 1, 3}, (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(0.7f, (float)WIDTH / HEIGHT, 0.1f, 10, &projection));
    lesson_check(gn_transform_compose(&projection, &view, &clip_from_world));
    lesson_check(gn_rotate_y(-0.4f, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));
    uniforms.clip_from_model = clip_from_model.matrix;
    gn_transform_normal_matrix(&world_from_model, &uniforms.normal_matrix);
    gn_pipeline pipeline = {.depth.test_enabled = true};
    lesson_check(use_toon(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = lesson_mesh(&model);
    gn_clear_color(&target.color[0], 1, 1, 1, 1);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));

    tga_write(lesson_argument(argc, argv, 2, "build/examples/12_toon.tga"), color, WIDTH, HEIGHT);
    free(model.corner);
    return 0;
}
