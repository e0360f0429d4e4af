/* The order of varyings that gnomon/shaders.h states: a user's fragment shader reads what each
 * ready-made vertex shader writes. */
#include <string.h>

#include "unit.h"

enum { SIZE = 4, ALL = GN_SHADER_VARYINGS };

static float pixels[ALL / 4][SIZE * SIZE][4];
static unsigned char memory[GN_WORKSPACE_SIZE(3, ALL)];
static const uint32_t texel = 0xFFFFFFFFu;
static gn_color_uniforms color_uniforms;
static gn_unlit_uniforms unlit_uniforms;
static gn_lit_uniforms lit_uniforms;
static gn_metallic_roughness_uniforms metallic_uniforms;
static gn_depth_color_uniforms depth_color_uniforms;
static gn_texture map;
static uint32_t varyings_read;
static bool mesh_has_attributes;

/* One triangle over the whole target. The last vertex is the provoking one. */
static const float positions[9] = {-1, -1, 0, 3, -1, 0, -1, 3, 0.5f};
static const float colors[12] = {9, 8, 7, 6, 5, 4, 3, 2, 0.125f, 0.25f, 0.375f, 0.5f};
static const float normals[9] = {1, 0, 0, 0, 1, 0, 4, -4, 2};
static const float texcoords[6] = {9, 8, 7, 6, 0.625f, 0.75f};
static const float tangents[12] = {0, 1, 0, 1, 0, 0, 1, 1, 4, -8, 8, -1};

/* The values at the last vertex: the matrix moves model x to y, y to z and z to x, doubles them and
 * adds (10, 20, 30). */
static const float documented[ALL] = {0.125f,      0.25f,       0.375f,       0.5f, /* colour */
                                      0.625f,      0.75f,                           /* s, t */
                                      1.0f / 3.0f, 2.0f / 3.0f, -2.0f / 3.0f,       /* normal */
                                      11.0f,       18.0f,       36.0f,              /* position */
                                      2.0f / 3.0f, 1.0f / 3.0f, -2.0f / 3.0f, -1.0f /* tangent */};

/* Without attributes but the position: white, and a missing attribute's 0, 0, 0, 1. */
static const float absent[ALL] = {1, 1, 1, 1, 0, 0, 0, 0, 0, 11, 18, 36, 0, 0, 0, 1};

/* With N.L = 1/3, color * (ambient + diffuse * N.L). */
static const float lit[4] = {0.125f * 0.75f, 0.25f * 0.75f, 0.375f * 1.125f, 0.5f};

/* Varying n as channel n % 4 of attachment n / 4. */
static void show_varyings(const void *uniforms, const gn_fragment_input *in,
                          gn_fragment_output *out)
{
    (void)uniforms;
    for (uint32_t n = 0; n < varyings_read; ++n)
        memcpy(out->color[n], in->varying[n], sizeof out->color[n]);
}

static void turn_by_cycle(float (*columns)[3], float scale)
{
    for (int i = 0; i < 3; ++i)
        columns[i][(i + 1) % 3] = scale;
}

static void reset(void)
{
    float turned[3][3] = {{0}};
    gn_mat4 identity, world;

    mesh_has_attributes = true;
    gn_mat4_identity(&identity);
    gn_mat4_identity(&world);
    turn_by_cycle(turned, 2.0f);
    for (int i = 0; i < 3; ++i) {
        memcpy(world.m[i], turned[i], sizeof turned[i]);
        world.m[3][i] = 10.0f * (float)(i + 1);
    }
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 1, 1, 1, 1, &texel, &map),
                     GN_OK);
    memset(&unlit_uniforms, 0, sizeof unlit_uniforms);
    memset(&lit_uniforms, 0, sizeof lit_uniforms);
    memset(&depth_color_uniforms, 0, sizeof depth_color_uniforms);
    color_uniforms.clip_from_model = identity;
    unlit_uniforms.clip_from_model = identity;
    depth_color_uniforms.clip_from_model = identity;
    lit_uniforms.clip_from_model = identity;
    lit_uniforms.world_from_model = world;
    turn_by_cycle(lit_uniforms.normal_matrix.m, 0.5f);
    memset(&metallic_uniforms, 0, sizeof metallic_uniforms);
    metallic_uniforms.clip_from_model = identity;
    metallic_uniforms.world_from_model = world;
    metallic_uniforms.normal_matrix = lit_uniforms.normal_matrix;
    lit_uniforms.light.direction.x = 1.0f;
    lit_uniforms.light.ambient = (gn_vec3){0.5f, 0.25f, 0.125f};
    lit_uniforms.light.diffuse = (gn_vec3){0.75f, 1.5f, 3.0f};
}

static void add_attribute(gn_mesh *mesh, gn_shader_attribute which, const float *data,
                          uint32_t components)
{
    mesh->attribute[which].data = data;
    mesh->attribute[which].components = components;
}

/* Draws with the pipeline's vertex shader, flat, so that fragments have the last vertex's values,
 * and compares every varying. */
static void assert_varyings(gn_pipeline *pipeline, uint32_t count, const float *expected)
{
    gn_workspace workspace = {0};
    gn_target target;
    gn_mesh mesh;

    assert_int_equal(pipeline->program.varying_count, count);
    varyings_read = count;
    pipeline->program.fragment_shader = show_varyings;
    pipeline->program.color_count = ALL / 4;
    for (uint32_t n = 0; n < count; ++n) {
        assert_int_equal(pipeline->program.interpolation[n], GN_SMOOTH);
        pipeline->program.interpolation[n] = GN_FLAT;
    }
    memset(&target, 0, sizeof target);
    for (int i = 0; i < ALL / 4; ++i) {
        target.color[i] = gn_surface_bottom_up(pixels[i], GN_FORMAT_RGBA32F, SIZE, SIZE);
        assert_int_equal(gn_clear_color(&target.color[i], 77, 77, 77, 77), GN_OK);
    }
    memset(&mesh, 0, sizeof mesh);
    mesh.vertex_count = 3;
    mesh.count = 3;
    add_attribute(&mesh, GN_ATTRIBUTE_POSITION, positions, 3);
    if (mesh_has_attributes) {
        add_attribute(&mesh, GN_ATTRIBUTE_COLOR, colors, 4);
        add_attribute(&mesh, GN_ATTRIBUTE_NORMAL, normals, 3);
        add_attribute(&mesh, GN_ATTRIBUTE_TEXCOORD, texcoords, 2);
        add_attribute(&mesh, GN_ATTRIBUTE_TANGENT, tangents, 4);
    }
    workspace.memory = memory;
    workspace.size = sizeof memory;
    assert_int_equal(gn_draw(&target, pipeline, &mesh, &workspace), GN_OK);
    for (int i = 0; i < SIZE * SIZE; ++i)
        for (uint32_t n = 0; n < ALL; ++n)
            assert_float_equal(pixels[n / 4][i][n % 4], n < count ? expected[n] : 0.0f, 1e-6f);
}

static void shaders_without_a_light(void **state)
{
    (void)state;
    gn_pipeline pipeline;

    reset();
    memset(&pipeline, 0, sizeof pipeline);
    assert_int_equal(gn_use_vertex_color(&pipeline, &color_uniforms), GN_OK);
    assert_varyings(&pipeline, 4, documented);
    assert_int_equal(gn_use_depth_only(&pipeline, &color_uniforms), GN_OK);
    assert_varyings(&pipeline, 0, documented);
    assert_int_equal(gn_use_depth_color(&pipeline, &depth_color_uniforms), GN_OK);
    assert_varyings(&pipeline, 0, documented);
    assert_int_equal(gn_use_unlit(&pipeline, &unlit_uniforms), GN_OK);
    assert_varyings(&pipeline, 4, documented);
    unlit_uniforms.map = &map;
    assert_int_equal(gn_use_unlit(&pipeline, &unlit_uniforms), GN_OK);
    assert_varyings(&pipeline, 6, documented);
}

static void gouraud_has_the_lit_colour_first(void **state)
{
    (void)state;
    gn_pipeline pipeline;
    float expected[ALL];

    reset();
    memcpy(expected, documented, sizeof expected);
    memcpy(expected, lit, sizeof lit);
    memset(&pipeline, 0, sizeof pipeline);
    lit_uniforms.material.normal_map = &map;
    lit_uniforms.material.normal_space = GN_NORMAL_OF_TANGENTS;
    assert_int_equal(gn_use_gouraud(&pipeline, &lit_uniforms), GN_OK);
    assert_varyings(&pipeline, 4, expected);
    lit_uniforms.material.diffuse_map = &map;
    assert_int_equal(gn_use_gouraud(&pipeline, &lit_uniforms), GN_OK);
    assert_varyings(&pipeline, 6, expected);
}

static void shaders_that_light_fragments(void **state)
{
    (void)state;
    static gn_status (*const use[])(gn_pipeline *, const gn_lit_uniforms *) = {
        gn_use_flat, gn_use_toon, gn_use_phong, gn_use_blinn_phong, gn_use_normal_color};
    gn_pipeline pipeline;

    for (size_t i = 0; i < sizeof use / sizeof *use; ++i) {
        reset();
        memset(&pipeline, 0, sizeof pipeline);
        assert_int_equal(use[i](&pipeline, &lit_uniforms), GN_OK);
        assert_varyings(&pipeline, 12, documented);
        lit_uniforms.material.diffuse_map = &map;
        lit_uniforms.material.specular_map = &map;
        lit_uniforms.material.glow_map = &map;
        lit_uniforms.material.normal_map = &map;
        assert_int_equal(use[i](&pipeline, &lit_uniforms), GN_OK);
        assert_varyings(&pipeline, 12, documented);
        lit_uniforms.material.normal_space = GN_NORMAL_OF_TANGENTS;
        assert_int_equal(use[i](&pipeline, &lit_uniforms), GN_OK);
        assert_varyings(&pipeline, 16, documented);
        mesh_has_attributes = false;
        assert_int_equal(use[i](&pipeline, &lit_uniforms), GN_OK);
        assert_varyings(&pipeline, 16, absent);
    }
}

static void the_material_of_gltf(void **state)
{
    (void)state;
    gn_pipeline pipeline;

    reset();
    memset(&pipeline, 0, sizeof pipeline);
    assert_int_equal(gn_use_metallic_roughness(&pipeline, &metallic_uniforms), GN_OK);
    assert_varyings(&pipeline, 12, documented);
    metallic_uniforms.material.base_color_map.texture = &map;
    metallic_uniforms.material.metallic_roughness_map.texture = &map;
    metallic_uniforms.material.occlusion_map.texture = &map;
    metallic_uniforms.material.emissive_map.texture = &map;
    assert_int_equal(gn_use_metallic_roughness(&pipeline, &metallic_uniforms), GN_OK);
    assert_varyings(&pipeline, 12, documented);
    metallic_uniforms.material.normal_map.texture = &map;
    assert_int_equal(gn_use_metallic_roughness(&pipeline, &metallic_uniforms), GN_OK);
    assert_varyings(&pipeline, 16, documented);
    mesh_has_attributes = false;
    assert_int_equal(gn_use_metallic_roughness(&pipeline, &metallic_uniforms), GN_OK);
    assert_varyings(&pipeline, 16, absent);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shaders_without_a_light),
        cmocka_unit_test(gouraud_has_the_lit_colour_first),
        cmocka_unit_test(shaders_that_light_fragments),
        cmocka_unit_test(the_material_of_gltf),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
