/* The ready-made shaders: what they set, what they refuse, and their formulas for a vertex and a
 * fragment. */
#include <math.h>
#include <string.h>

#include "unit.h"

static gn_lit_uniforms uniforms;
static gn_texture texture;
static const uint32_t texels[4] = {0xFF0000FFu, 0xFF00FF00u, 0xFFFF0000u, 0x80FFFFFFu};

static void reset(void)
{
    memset(&uniforms, 0, sizeof uniforms);
    memset(&texture, 0, sizeof texture);
    uniforms.material.diffuse_map = &texture;
    for (int i = 0; i < 4; ++i)
        uniforms.clip_from_model.m[i][i] = 2.0f;
    for (int i = 0; i < 3; ++i)
        uniforms.normal_matrix.m[i][i] = 1.0f;
    uniforms.light.direction.z = 1.0f;
    uniforms.light.ambient.x = uniforms.light.ambient.y = uniforms.light.ambient.z = 0.25f;
    uniforms.light.diffuse.x = uniforms.light.diffuse.y = uniforms.light.diffuse.z = 0.5f;
    texture.level[0].texels = texels;
    texture.level[0].row_stride = 8;
    texture.width = 2;
    texture.height = 2;
    texture.format = GN_FORMAT_RGBA8;
    uniforms.material.sampler.magnify = GN_MAGNIFY_NEAREST;
}

typedef gn_status use_function(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

static use_function *const lit_shaders[] = {gn_use_flat,  gn_use_gouraud,     gn_use_toon,
                                            gn_use_phong, gn_use_blinn_phong, gn_use_normal_color};

enum { LIT = sizeof lit_shaders / sizeof *lit_shaders };

static void null_pointers(void **state)
{
    (void)state;
    gn_color_uniforms color = {{{{0}}}};
    gn_unlit_uniforms unlit = {0};
    gn_depth_color_uniforms depth = {{{{0}}}, 0.0f, 0.0f};
    gn_pipeline p;

    reset();
    assert_int_equal(gn_use_vertex_color(NULL, &color), GN_NULL_POINTER);
    assert_int_equal(gn_use_vertex_color(&p, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_use_depth_only(NULL, &color), GN_NULL_POINTER);
    assert_int_equal(gn_use_depth_only(&p, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_use_unlit(NULL, &unlit), GN_NULL_POINTER);
    assert_int_equal(gn_use_unlit(&p, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_use_depth_color(NULL, &depth), GN_NULL_POINTER);
    assert_int_equal(gn_use_depth_color(&p, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_lit_uniforms_check(NULL), GN_NULL_POINTER);
    for (int i = 0; i < LIT; ++i) {
        assert_int_equal(lit_shaders[i](NULL, &uniforms), GN_NULL_POINTER);
        assert_int_equal(lit_shaders[i](&p, NULL), GN_NULL_POINTER);
    }
}

/* All shaders with light refuse it, and leave the pipeline unchanged. */
static void assert_refused(gn_status expected)
{
    gn_pipeline p, before;

    memset(&p, 0, sizeof p);
    before = p;
    assert_int_equal(gn_lit_uniforms_check(&uniforms), expected);
    for (int i = 0; i < LIT; ++i) {
        assert_int_equal(lit_shaders[i](&p, &uniforms), expected);
        assert_memory_equal(&p, &before, sizeof p);
    }
    reset();
}

static void bad_uniforms_leave_the_pipeline(void **state)
{
    (void)state;
    static const float depth = 0.5f;
    gn_light more_lights[GN_MAX_LIGHTS - 1] = {{GN_LIGHT_DIRECTIONAL}};
    gn_texture line, map;

    reset();
    texture.width = 0;
    assert_refused(GN_INVALID_SIZE);
    uniforms.material.alpha_cutoff = -0.5f;
    assert_refused(GN_OUT_OF_RANGE);
    uniforms.material.alpha_cutoff = NAN;
    assert_refused(GN_NOT_FINITE);
    uniforms.light.kind = (gn_light_kind)3;
    assert_refused(GN_INVALID_ENUM);
    uniforms.more_light_count = GN_MAX_LIGHTS;
    uniforms.more_lights = more_lights;
    assert_refused(GN_OUT_OF_RANGE);
    uniforms.more_light_count = 1;
    assert_refused(GN_NULL_POINTER);
    uniforms.more_light_count = GN_MAX_LIGHTS - 1;
    uniforms.more_lights = more_lights;
    more_lights[GN_MAX_LIGHTS - 2].kind = (gn_light_kind)-1;
    assert_refused(GN_INVALID_ENUM);
    uniforms.more_light_count = GN_MAX_LIGHTS - 2; /* the invalid one is not read */
    uniforms.more_lights = more_lights;
    assert_int_equal(gn_lit_uniforms_check(&uniforms), GN_OK);
    reset();
    uniforms.material.sampler.wrap_t = (gn_wrap)7;
    assert_refused(GN_INVALID_ENUM);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_RGBA8, 4, 1, 1, 1, texels, &line),
                     GN_OK);
    uniforms.material.glow_map = &line;
    assert_refused(GN_INVALID_ENUM);
    uniforms.material.normal_space = (gn_normal_space)2;
    assert_refused(GN_INVALID_ENUM);
    uniforms.material.bands = 1;
    assert_refused(GN_OUT_OF_RANGE);
    uniforms.material.bands = 257;
    assert_refused(GN_OUT_OF_RANGE);
    uniforms.shadow.map = &texture;
    uniforms.shadow.sampler.compare = GN_LESS;
    assert_refused(GN_INVALID_FORMAT);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, 1, 1, 1, 1, &depth, &map),
                     GN_OK);
    uniforms.shadow.map = &map;
    assert_refused(GN_INVALID_ENUM); /* nothing is compared */
    map.height = 0;
    uniforms.shadow.map = &map;
    uniforms.shadow.sampler.compare = GN_LESS;
    assert_refused(GN_INVALID_SIZE);
    map.height = 1;
    uniforms.shadow.map = &map;
    uniforms.shadow.sampler.compare = GN_LESS;
    uniforms.material.bands = 256;
    assert_int_equal(gn_lit_uniforms_check(&uniforms), GN_OK);
}

static void bad_maps_and_depths(void **state)
{
    (void)state;
    gn_unlit_uniforms unlit = {0};
    gn_depth_color_uniforms depth = {{{{0}}}, 0.5f, 0.5f};
    gn_pipeline p, before;

    reset();
    memset(&p, 0, sizeof p);
    before = p;
    texture.height = 0;
    unlit.map = &texture;
    assert_int_equal(gn_use_unlit(&p, &unlit), GN_INVALID_SIZE);
    reset();
    unlit.sampler.magnify = (gn_magnify)2;
    assert_int_equal(gn_use_unlit(&p, &unlit), GN_INVALID_ENUM);
    unlit.sampler.magnify = GN_MAGNIFY_LINEAR;
    unlit.alpha_cutoff = -1.0f;
    assert_int_equal(gn_use_unlit(&p, &unlit), GN_OUT_OF_RANGE);
    unlit.alpha_cutoff = INFINITY;
    assert_int_equal(gn_use_unlit(&p, &unlit), GN_NOT_FINITE);
    unlit.alpha_cutoff = 0.0f;
    assert_int_equal(gn_use_depth_color(&p, &depth), GN_OUT_OF_RANGE);
    depth.white = INFINITY;
    assert_int_equal(gn_use_depth_color(&p, &depth), GN_NOT_FINITE);
    assert_memory_equal(&p, &before, sizeof p);
    unlit.map = NULL;
    assert_int_equal(gn_use_unlit(&p, &unlit), GN_OK);
}

static void only_shader_fields_are_set(void **state)
{
    (void)state;
    gn_pipeline p;

    reset();
    memset(&p, 0, sizeof p);
    p.raster.topology = GN_TRIANGLE_FAN;
    p.raster.cull = GN_CULL_FRONT;
    p.depth.test = true;
    assert_int_equal(gn_use_gouraud(&p, &uniforms), GN_OK);
    assert_int_equal(p.program.varying_count, 6);
    for (uint32_t n = 0; n < p.program.varying_count; ++n)
        assert_int_equal(p.program.interpolation[n], GN_SMOOTH);
    assert_ptr_equal(p.program.uniforms, &uniforms);
    assert_int_equal(p.raster.topology, GN_TRIANGLE_FAN);
    assert_int_equal(p.raster.cull, GN_CULL_FRONT);
    assert_true(p.depth.test);
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
}

/* Every gn_use_ function sets fragment_discards: on for a cut-off of a shader that has one, and off
 * otherwise, also after a shader that discards. */
static void cutoffs_set_discarding(void **state)
{
    (void)state;
    gn_color_uniforms color = {{{{0}}}};
    gn_depth_color_uniforms depth = {{{{0}}}, 0.0f, 0.0f};
    gn_unlit_uniforms unlit = {0};
    gn_pipeline p;

    reset();
    memset(&p, 0, sizeof p);
    for (int i = 0; i < LIT; ++i) {
        uniforms.material.alpha_cutoff = 0.5f;
        assert_int_equal(lit_shaders[i](&p, &uniforms), GN_OK);
        assert_int_equal(p.program.fragment_discards, lit_shaders[i] != gn_use_normal_color);
        p.program.fragment_discards = true;
        uniforms.material.alpha_cutoff = 0.0f;
        assert_int_equal(lit_shaders[i](&p, &uniforms), GN_OK);
        assert_false(p.program.fragment_discards);
    }
    unlit.alpha_cutoff = 0.5f;
    assert_int_equal(gn_use_unlit(&p, &unlit), GN_OK);
    assert_true(p.program.fragment_discards);
    assert_int_equal(gn_use_depth_only(&p, &color), GN_OK);
    assert_false(p.program.fragment_discards);
    p.program.fragment_discards = true;
    assert_int_equal(gn_use_vertex_color(&p, &color), GN_OK);
    assert_false(p.program.fragment_discards);
    p.program.fragment_discards = true;
    assert_int_equal(gn_use_depth_color(&p, &depth), GN_OK);
    assert_false(p.program.fragment_discards);
}

/* The attributes that the mesh is said to have, as bits. */
static uint32_t present = 15;

static void shade_vertex(const gn_pipeline *p, const float normal[3], float position[4],
                         float varying[GN_SHADER_VARYINGS])
{
    static float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES];
    static float positions[4][GN_LANES], varyings[GN_MAX_VARYINGS][GN_LANES];
    uint32_t id[GN_LANES] = {0};
    gn_vertex_input in;
    gn_vertex_output out;

    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 4; ++c) {
            attribute[GN_ATTRIBUTE_POSITION][c][l] = (float)(c + 1);
            attribute[GN_ATTRIBUTE_COLOR][c][l] = 0.5f;
            attribute[GN_ATTRIBUTE_NORMAL][c][l] = c < 3 ? normal[c] : 1.0f;
            attribute[GN_ATTRIBUTE_TEXCOORD][c][l] = 0.125f * (float)c;
        }
    }
    in.attribute = (const float(*)[4][GN_LANES])attribute;
    in.vertex_id = id;
    in.count = GN_LANES;
    in.present = present;
    out.position = positions;
    out.varying = varyings;
    p->program.vertex_shader(p->program.uniforms, &in, &out);
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 4; ++c) {
            assert_true(positions[c][l] == positions[c][0]);
            position[c] = positions[c][l];
        }
        for (uint32_t n = 0; n < p->program.varying_count; ++n)
            varying[n] = varyings[n][l];
    }
}

static void light_follows_the_cosine(void **state)
{
    (void)state;
    /* N.L is 1, 0.6 (a normal of length 5), 0, and negative, which becomes 0. */
    static const float normals[4][3] = {{0, 0, 1}, {4, 0, 3}, {1, 0, 0}, {0, 0, -2}};
    static const float lit[4] = {0.75f, 0.55f, 0.25f, 0.25f};
    gn_pipeline p;
    float position[4], varying[GN_SHADER_VARYINGS];

    reset();
    memset(&p, 0, sizeof p);
    assert_int_equal(gn_use_gouraud(&p, &uniforms), GN_OK);
    for (int i = 0; i < 4; ++i) {
        shade_vertex(&p, normals[i], position, varying);
        for (int c = 0; c < 4; ++c)
            assert_true(position[c] == 2.0f * (float)(c + 1));
        for (int c = 0; c < 3; ++c)
            assert_true(fabsf(varying[c] - 0.5f * lit[i]) < 1e-6f);
        assert_true(varying[3] == 0.5f);
        assert_true(varying[4] == 0.0f && varying[5] == 0.125f);
    }
}

/* Lights after the first: N.L is 0.6 for a directional one. The position 1, 2, 3, which
 * world_from_model doubles, is at 2, 4, 6; the spot light 5 above it shines straight down through
 * half of its cone. */
static void vertices_receive_every_light(void **state)
{
    (void)state;
    static const float normal[3] = {0, 0, 1};
    gn_light more[2];
    gn_pipeline p;
    float position[4], varying[GN_SHADER_VARYINGS];

    reset();
    memset(&p, 0, sizeof p);
    memset(more, 0, sizeof more);
    for (int i = 0; i < 3; ++i)
        uniforms.world_from_model.m[i][i] = 2.0f;
    more[0].direction = (gn_vec3){0.8f, 0.0f, 0.6f};
    more[0].ambient = (gn_vec3){0.125f, 0.0f, 0.0f};
    more[0].diffuse = (gn_vec3){1.0f, 0.5f, 0.25f};
    more[1].kind = GN_LIGHT_SPOT;
    more[1].position = (gn_vec3){2.0f, 4.0f, 11.0f};
    more[1].direction = (gn_vec3){0.6f, 0.0f, 0.8f};
    more[1].inner_cosine = 0.9f;
    more[1].outer_cosine = 0.7f;
    more[1].diffuse = (gn_vec3){0.0f, 1.0f, 2.0f};
    uniforms.more_lights = more;
    uniforms.more_light_count = 2;
    assert_int_equal(gn_use_gouraud(&p, &uniforms), GN_OK);
    shade_vertex(&p, normal, position, varying);
    assert_true(fabsf(varying[0] - 0.5f * (0.75f + 0.125f + 0.6f)) < 1e-6f);
    assert_true(fabsf(varying[1] - 0.5f * (0.75f + 0.3f + 0.25f)) < 1e-6f);
    assert_true(fabsf(varying[2] - 0.5f * (0.75f + 0.15f + 0.5f)) < 1e-6f);
}

static void absent_colors_are_white(void **state)
{
    (void)state;
    static const float normal[3] = {0, 0, 1};
    gn_pipeline p;
    float position[4], varying[GN_SHADER_VARYINGS];

    reset();
    memset(&p, 0, sizeof p);
    present = 15 & ~(1u << GN_ATTRIBUTE_COLOR);
    for (int i = 0; i < LIT; ++i) {
        assert_int_equal(lit_shaders[i](&p, &uniforms), GN_OK);
        shade_vertex(&p, normal, position, varying);
        assert_true(varying[3] == 1.0f);
        assert_true(varying[0] == (lit_shaders[i] == gn_use_gouraud ? 0.75f : 1.0f));
    }
    present = 15;
}

static void texture_multiplies_every_channel(void **state)
{
    (void)state;
    static float varying[GN_SHADER_VARYINGS][GN_LANES], color[4][GN_LANES];
    gn_pipeline p;
    gn_fragment_input in = {0};
    gn_fragment_output out;

    reset();
    memset(&p, 0, sizeof p);
    assert_int_equal(gn_use_gouraud(&p, &uniforms), GN_OK);
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 4; ++c)
            varying[c][l] = 0.5f;
        varying[4][l] = varying[5][l] = 0.75f; /* the last texel: white, half transparent */
    }
    in.varying = (const float(*)[GN_LANES])varying;
    in.coverage = 0xFFFF;
    in.sampling = &(const gn_sampling){gn_sample_2d, NULL, NULL, NULL};
    out.color = color;
    p.program.fragment_shader(p.program.uniforms, &in, &out);
    for (int l = 0; l < GN_LANES; ++l) {
        assert_true(fabsf(color[0][l] - 0.5f) < 1e-6f && fabsf(color[2][l] - 0.5f) < 1e-6f);
        assert_true(fabsf(color[3][l] - 0.5f * 128.0f / 255.0f) < 1e-6f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(null_pointers),
        cmocka_unit_test(bad_uniforms_leave_the_pipeline),
        cmocka_unit_test(bad_maps_and_depths),
        cmocka_unit_test(only_shader_fields_are_set),
        cmocka_unit_test(cutoffs_set_discarding),
        cmocka_unit_test(light_follows_the_cosine),
        cmocka_unit_test(vertices_receive_every_light),
        cmocka_unit_test(absent_colors_are_white),
        cmocka_unit_test(texture_multiplies_every_channel),
    };
    return cmocka_run_group_tests_name("shaders", tests, NULL, NULL);
}
