/* Draws with the examples in the preface of gnomon/shader_functions.h and compares with the
 * ready-made shaders that do the same: every bit of colour and depth. Compiles as C99 and as C++98.
 * Not alone: shader_examples.sh includes it behind the examples, which it draws with. */
#ifndef SHADER_EXAMPLES_MAIN_H
#define SHADER_EXAMPLES_MAIN_H

#include <gnomon.h>

#include <stdio.h>
#include <string.h>

enum { SIDE = 64, TEXTURE_SIDE = 16, RINGS = 12, SECTORS = 16 };
enum { VERTICES = (RINGS + 1) * (SECTORS + 1), INDICES = RINGS * SECTORS * 6 };

/* A unit sphere at distance 2 is seen at 30 degrees to each side, in a view of 0.65 to each side.
 */
#define SPHERE_RADIUS (gn_tan(GN_PI / 6) / gn_tan(0.65f))

typedef struct frame {
    uint32_t color[SIDE * SIDE], depth[SIDE * SIDE];
} frame;

static uint32_t texels[TEXTURE_SIDE * TEXTURE_SIDE];
static float position[VERTICES][3], texcoord[VERTICES][2], color[VERTICES][3];
static uint32_t indices[INDICES];
static unsigned char memory[GN_WORKSPACE_SIZE(VERTICES, GN_SHADER_VARYINGS)];

/* A unit sphere, whose positions are its normals. */
static void make_sphere(void)
{
    uint32_t n = 0;

    for (int ring = 0; ring <= RINGS; ++ring) {
        for (int sector = 0; sector <= SECTORS; ++sector, ++n) {
            const float up = (float)ring / RINGS * GN_PI,
                        around = (float)sector / SECTORS * 2 * GN_PI;

            position[n][0] = gn_sin(up) * gn_cos(around);
            position[n][1] = -gn_cos(up);
            position[n][2] = gn_sin(up) * gn_sin(around);
            texcoord[n][0] = 3.0f * (float)sector / SECTORS;
            texcoord[n][1] = 2.0f * (float)ring / RINGS;
            for (int c = 0; c < 3; ++c)
                color[n][c] = 0.5f + 0.5f * position[n][c];
        }
    }
    n = 0;
    for (uint32_t ring = 0; ring < RINGS; ++ring) {
        for (uint32_t sector = 0; sector < SECTORS; ++sector) {
            const uint32_t a = ring * (SECTORS + 1) + sector, b = a + SECTORS + 1;
            const uint32_t square[6] = {a, b, a + 1, a + 1, b, b + 1};

            for (int i = 0; i < 6; ++i)
                indices[n++] = square[i];
        }
    }
    for (uint32_t i = 0; i < TEXTURE_SIDE * TEXTURE_SIDE; ++i)
        texels[i] = 0xFF000000u | i * 2654435761u >> 8;
}

static void set_array(gn_attribute *attribute, const float *data, uint32_t components)
{
    attribute->data = data;
    attribute->components = components;
}

/* The frame, and how many of its pixels are not the background's. */
static int draw(const gn_pipeline *pipeline, frame *out)
{
    gn_target target;
    gn_mesh mesh;
    gn_workspace workspace;
    int drawn = 0;

    memset(&target, 0, sizeof target);
    memset(&mesh, 0, sizeof mesh);
    memset(&workspace, 0, sizeof workspace);
    target.color[0] = gn_surface_bottom_up(out->color, GN_FORMAT_RGBA8, SIDE, SIDE);
    target.depth = gn_surface_bottom_up(out->depth, GN_FORMAT_D24, SIDE, SIDE);
    gn_clear_color(&target.color[0], 0, 0, 0, 0);
    gn_clear_depth(&target.depth, 1);
    set_array(&mesh.attribute[GN_ATTRIBUTE_POSITION], position[0], 3);
    set_array(&mesh.attribute[GN_ATTRIBUTE_NORMAL], position[0], 3);
    set_array(&mesh.attribute[GN_ATTRIBUTE_TEXCOORD], texcoord[0], 2);
    set_array(&mesh.attribute[GN_ATTRIBUTE_COLOR], color[0], 3);
    mesh.vertex_count = VERTICES;
    mesh.count = INDICES;
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT32;
    workspace.memory = memory;
    workspace.size = sizeof memory;
    if (gn_draw(&target, pipeline, &mesh, &workspace) != GN_OK)
        return 0;
    for (int i = 0; i < SIDE * SIDE; ++i)
        drawn += out->color[i] != 0;
    return drawn;
}

static int failed;

/* The outline is a circle of that radius in NDC, of which the flat triangles leave a little out. */
static void compare(const char *name, float radius, const gn_pipeline *example,
                    const gn_pipeline *ready_made)
{
    static frame ours, theirs;
    int differing = 0;
    const int drawn = draw(example, &ours);
    const float expected = GN_PI * radius * radius / 4 * SIDE * SIDE;

    draw(ready_made, &theirs);
    for (int i = 0; i < SIDE * SIDE; ++i)
        differing += ours.color[i] != theirs.color[i] || ours.depth[i] != theirs.depth[i];
    printf("%s: %d pixels drawn, %d differ from the ready-made shader's\n", name, drawn, differing);
    failed |= differing > 0 || (float)drawn > expected || (float)drawn < 0.95f * expected;
}

static gn_pipeline new_pipeline(void)
{
    gn_pipeline pipeline;

    memset(&pipeline, 0, sizeof pipeline);
    pipeline.depth.test_enabled = true;
    return pipeline;
}

static void draw_colors(void)
{
    gn_pipeline example = new_pipeline(), ready_made = new_pipeline();
    gn_color_uniforms uniforms;

    gn_mat4_identity(&uniforms.clip_from_model);
    use_colors(&example, NULL);
    gn_use_vertex_color(&ready_made, &uniforms);
    compare("example 1", 1.0f, &example, &ready_made);
}

static void draw_texture(const gn_transform *clip_from_world)
{
    gn_pipeline example = new_pipeline(), ready_made = new_pipeline();
    map_uniforms ours;
    gn_unlit_uniforms theirs;

    memset(&ours, 0, sizeof ours);
    memset(&theirs, 0, sizeof theirs);
    ours.clip_from_model = theirs.clip_from_model = clip_from_world->matrix;
    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, TEXTURE_SIDE, TEXTURE_SIDE, 1, 1, texels,
                      &ours.texture);
    ours.sampler.minify = theirs.sampler.minify = GN_MINIFY_LINEAR;
    theirs.map = &ours.texture;
    use_map(&example, &ours);
    gn_use_unlit(&ready_made, &theirs);
    /* The ready-made shader multiplies by the vertex colour. */
    for (int i = 0; i < VERTICES; ++i)
        color[i][0] = color[i][1] = color[i][2] = 1.0f;
    compare("example 2", SPHERE_RADIUS, &example, &ready_made);
}

/* In the space of the eye, so that the eye is at 0, 0, 0. */
static void draw_phong(const gn_transform *eye_from_world, const gn_transform *clip_from_eye)
{
    const gn_vec3 light = {2, 3, 1}, ambient = {0.1f, 0.2f, 0.1f}, diffuse = {0.7f, 0.6f, 0.5f};
    const gn_vec3 specular = {0.5f, 0.4f, 0.3f};
    gn_pipeline example = new_pipeline(), ready_made = new_pipeline();
    phong_uniforms ours;
    gn_lit_uniforms theirs;

    memset(&theirs, 0, sizeof theirs);
    gn_mat4_multiply(&clip_from_eye->matrix, &eye_from_world->matrix, &ours.clip_from_model);
    theirs.clip_from_model = ours.clip_from_model;
    ours.eye_from_model = theirs.world_from_model = eye_from_world->matrix;
    gn_transform_normal_matrix(eye_from_world, &ours.normal_matrix);
    theirs.normal_matrix = ours.normal_matrix;
    ours.light = theirs.light.position = light;
    theirs.light.kind = GN_LIGHT_POINT;
    ours.ambient = theirs.light.ambient = ambient;
    ours.diffuse = theirs.light.diffuse = diffuse;
    ours.specular = theirs.material.specular = specular;
    ours.exponent = theirs.material.exponent = 20;
    use_phong(&example, &ours);
    gn_use_phong(&ready_made, &theirs);
    compare("example 3", SPHERE_RADIUS, &example, &ready_made);
}

int main(void)
{
    const gn_vec3 eye = {0, 0, 2}, centre = {0, 0, 0}, up = {0, 1, 0};
    gn_transform view, projection, both;

    make_sphere();
    gn_look_at_rh(eye, centre, up, &view);
    gn_perspective_rh_no(1.3f, 1, 0.5f, 10, &projection);
    gn_transform_compose(&projection, &view, &both);
    draw_colors();
    draw_phong(&view, &projection);
    draw_texture(&both);
    return failed;
}

#endif
