/* Lesson 4: back faces. The corners of a triangle are listed counterclockwise as seen from outside
 * the model. If they appear clockwise in the window, the triangle is seen from inside: it is on the
 * far side of the model and need not be drawn. Left: without this rule; right: with it. */
#include "lesson.h"

enum { WIDTH = 800, HEIGHT = 400 };

static uint32_t color[WIDTH * HEIGHT];
static unsigned char memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];

static const char help[] = "usage: 04_back_faces [MODEL.obj [PICTURE.tga]]\n"
                           "Draws a model's triangles with and without those seen from behind.\n";

/* Each triangle gets one brightness: how much it faces the light (Lambert's cosine law). The light
 * stands where the viewer stands, so what faces away would be dark; its magnitude makes back faces
 * as bright as front faces, to show what is wrong. */
static gn_vec3 *face_colors(const obj_model *model, gn_vec3 to_light)
{
    gn_vec3 *colors = malloc(model->count * sizeof *colors);

    for (uint32_t i = 0; colors && i < model->count; ++i) {
        const obj_corner *t = &model->corner[i - i % 3];
        gn_vec3 normal = gn_vec3_cross(gn_vec3_subtract(t[1].position, t[0].position),
                                       gn_vec3_subtract(t[2].position, t[0].position));
        gn_vec3_normalize(normal, &normal); /* leaves a normal of length 0 as it is */
        const float cosine = gn_vec3_dot(normal, to_light);
        colors[i] = cosine > 0 ? (gn_vec3){cosine, cosine, cosine}
                               : (gn_vec3){-cosine, -0.4f * cosine, -0.3f * cosine};
    }
    return colors;
}

int main(int argc, char **argv)
{
    lesson_help(argc, argv, 2, help);
    obj_model model = lesson_model(lesson_argument(argc, argv, 1, "build/examples/teapot.obj"));

    gn_transform clip_from_world, world_from_model, clip_from_model;
    const float side = 1.1f; /* each half of the window is a square */
    const float tilt = lesson_slider("tilt of the model", 0.5f, -3.14f, 3.14f);
    const float near_plane = lesson_slider("near plane", -2, -2, 0.9f); /* cuts the model open */
    const float light = lesson_slider("turn of the light", 0, -3.14f, 3.14f);
    lesson_check(gn_orthographic_rh_no(-side, side, -side, side, near_plane, 2, &clip_from_world));
    lesson_check(gn_rotate_x(tilt, &world_from_model));
    lesson_check(gn_transform_compose(&clip_from_world, &world_from_model, &clip_from_model));

    /* The light's direction in the space of the model: the inverse takes it there. */
    const gn_vec3 to_light = gn_mat4_transform_direction(&world_from_model.inverse,
                                                         lesson_turned((gn_vec3){0, 0, 1}, light));
    gn_vec3 *colors = face_colors(&model, to_light);
    gn_mesh mesh = lesson_mesh(&model);
    mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){&colors->x, 3, 0, 0};

    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)}, {0}};
    gn_color_uniforms uniforms = {clip_from_model.matrix};
    gn_pipeline pipeline = {.depth.test_enabled = false};
    lesson_check(gn_use_vertex_color(&pipeline, &uniforms));
    gn_clear_color(&target.color[0], 0.1f, 0.1f, 0.12f, 1);
    for (int half = 0; half < 2; ++half) {
        gn_draw_statistics counts = {0};
        gn_workspace workspace = {.memory = memory, .size = sizeof memory, .statistics = &counts};

        pipeline.raster.viewport =
            (gn_viewport){true, half * WIDTH / 2.0f, 0, WIDTH / 2.0f, HEIGHT};
        pipeline.raster.cull = half == 0 ? GN_CULL_NONE : GN_CULL_BACK;
        lesson_check(gn_draw(&target, &pipeline, &mesh, &workspace));
        printf("%s: %u triangles drawn, %u culled\n", half == 0 ? "left" : "right",
               (unsigned)counts.drawn, (unsigned)counts.culled);
    }
    tga_write(lesson_argument(argc, argv, 2, "build/examples/04_back_faces.tga"), color, WIDTH,
              HEIGHT);
    free(colors);
    free(model.corner);
    return 0;
}
