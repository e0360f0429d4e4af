/* Lesson 16: a shadow map. A place is in shadow if the light does not see it. So the scene is drawn
 * twice. The first time it is drawn from the light, and only the z-buffer is kept. The second time
 * it is drawn from the camera: each pixel compares its distance from the light with this z-buffer.
 */
#include "lesson.h"

enum { WIDTH = 640, HEIGHT = 480, MOST_TEXELS = 1024 };

static uint32_t color[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
static float light_depth[MOST_TEXELS * MOST_TEXELS];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 16_shadow_map [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model that throws a shadow on the floor and on itself.\n";

/* A floor of two triangles under the model. */
static obj_model make_floor(const obj_model *model, obj_corner corners[6])
{
    static const gn_vec3 place[6] = {{-4, 0, 4}, {4, 0, 4},  {4, 0, -4},
                                     {-4, 0, 4}, {4, 0, -4}, {-4, 0, -4}};
    float lowest = 0;

    for (uint32_t i = 0; i < model->count; ++i)
        lowest = gn_minimum1(lowest, model->corner[i].position.y);
    for (int i = 0; i < 6; ++i)
        corners[i] = (obj_corner){{place[i].x, lowest, place[i].z}, {0, 0, 0}, {0, 1, 0}};
    return (obj_model){corners, 6};
}

/* Returns a camera in the place of the light. The sun is so far away that its rays are parallel, so
 * the projection is orthographic. */
static gn_transform light_camera(gn_vec3 to_light)
{
    gn_transform view, projection, clip;

    lesson_check(
        gn_look_at_rh(gn_vec3_scale(to_light, 5), (gn_vec3){0, 0, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_orthographic_rh_no(-2, 2, -2, 2, 1, 12, &projection));
    lesson_check(gn_transform_compose(&projection, &view, &clip));
    return clip;
}

/* The sampler compares a place's depth with four texels and mixes the four answers, so that edges
 * are a little soft. Outside the map the border's depth is 1, so places there are lit. */
static const gn_sampler comparing = {.wrap_s = GN_WRAP_CLAMP_TO_BORDER,
                                     .wrap_t = GN_WRAP_CLAMP_TO_BORDER,
                                     .minify = GN_MINIFY_LINEAR,
                                     .compare = GN_LESS_OR_EQUAL,
                                     .border = {1, 1, 1, 1}};

/* The polygon offset moves the depths a little away from the light. Without it a surface would
 * throw a shadow on itself, since a texel's depth is that of its middle, and rounded. */
static void draw_light_depth(const gn_mesh *mesh, const gn_transform *light, uint32_t texels,
                             float offset)
{
    const gn_target target = {{{0}},
                              gn_surface_bottom_up(light_depth, GN_FORMAT_D32F, texels, texels)};
    gn_color_uniforms uniforms = {light->matrix};
    gn_pipeline pipeline = {.depth.test_enabled = true,
                            .raster.polygon_offset = {true, .factor = offset, .units = 2 * offset}};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};

    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_use_depth_only(&pipeline, &uniforms));
    lesson_check(gn_draw(&target, &pipeline, mesh, &workspace));
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 2, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));
    obj_corner corners[6];
    obj_model floor = make_floor(&model, corners);
    gn_mesh meshes[2] = {lesson_mesh(&model), lesson_mesh(&floor)};

    const int side = lesson_slider_int("texels of a side of the map", MOST_TEXELS, 16, MOST_TEXELS);
    const float offset = lesson_slider("polygon offset", 2, 0, 40);
    const float light_turn = lesson_slider("turn of the light", 0, -3.14f, 3.14f);

    const uint32_t texels = (uint32_t)side;
    const gn_vec3 to_light = lesson_turned((gn_vec3){-0.48f, 0.8f, 0.36f}, light_turn);
    gn_transform light = light_camera(to_light);
    draw_light_depth(&meshes[0], &light, texels, offset);
    gn_texture map; /* the z-buffer of the first pass, as it is */
    lesson_check(
        gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, texels, texels, 1, 1, light_depth, &map));

    const gn_vec3 eye = {0.8f, 1.3f, 3};
    gn_transform view, projection, clip;
    lesson_check(gn_look_at_rh(eye, (gn_vec3){0, -0.1f, 0}, (gn_vec3){0, 1, 0}, &view));
    lesson_check(gn_perspective_rh_no(0.7f, (float)WIDTH / HEIGHT, 0.1f, 20, &projection));
    lesson_check(gn_transform_compose(&projection, &view, &clip));
    gn_lit_uniforms uniforms = {
        .clip_from_model = clip.matrix,
        .eye = eye,
        .light = {.direction = to_light,
                  .ambient = {0.2f, 0.22f, 0.28f},
                  .diffuse = {0.75f, 0.68f, 0.55f}},
        .material = {.specular = {0.3f, 0.3f, 0.3f}, .exponent = 30},
        .shadow = {.map = &map, .sampler = comparing, .clip_from_world = light.matrix},
    };
    gn_mat4_identity(&uniforms.world_from_model);
    gn_mat3_identity(&uniforms.normal_matrix);
    gn_pipeline pipeline = {.depth.test_enabled = true};
    lesson_check(gn_use_phong(&pipeline, &uniforms));

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    gn_clear_depth(&target.depth, 1);
    for (int i = 0; i < 2; ++i)
        lesson_check(gn_draw(&target, &pipeline, &meshes[i], &workspace));

    tga_write(lesson_argument(argc, argv, 2, "build/examples/16_shadow_map.tga"), color, WIDTH,
              HEIGHT);
    free(model.corner);
    return 0;
}
