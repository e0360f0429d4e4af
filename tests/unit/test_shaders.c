/* The ready-made shaders: what they refuse, what they set, and the order of their varyings that
 * gnomon/shaders.h states: a user's fragment shader reads what each vertex shader writes. */
#include "canvas.h"
#include "ready_made.h"

static const uint32_t texels[4] = {0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu};
static gn_texture map;
static gn_material *const material = &uniforms.lit.material;

static int set_up(void **state)
{
    reset_uniforms();
    map = texture_of(GN_FORMAT_RGBA8, texels);
    return 0;
}

static void null_pointers(void **state)
{
    gn_pipeline p;

    for (int s = 0; s < SHADERS; ++s) {
        assert_int_equal(use_with(s, NULL, &uniforms), GN_NULL_POINTER);
        assert_int_equal(use_with(s, &p, NULL), GN_NULL_POINTER);
    }
    assert_int_equal(gn_lit_uniforms_check(NULL), GN_NULL_POINTER);
}

/* All shaders with light refuse it. */
static void assert_refused(gn_status expected)
{
    assert_int_equal(gn_lit_uniforms_check(&uniforms.lit), expected);
    for (int s = FIRST_LIT; s <= LAST_LIT; ++s)
        assert_shader_refuses(s, expected);
    set_up(NULL);
}

static void bad_lights_and_materials(void **state)
{
    static const struct {
        float cutoff;
        uint32_t bands;
        gn_status status;
    } numbers[] = {{-0.5f, 0, GN_OUT_OF_RANGE},
                   {NAN, 0, GN_NOT_FINITE},
                   {0, 1, GN_OUT_OF_RANGE},
                   {0, 257, GN_OUT_OF_RANGE},
                   {0, 256, GN_OK}};
    gn_light more_lights[GN_MAX_LIGHTS - 1];
    gn_texture line;

    memset(more_lights, 0, sizeof more_lights);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
        material->alpha_cutoff = numbers[i].cutoff;
        material->bands = numbers[i].bands;
        if (numbers[i].status == GN_OK)
            assert_int_equal(gn_lit_uniforms_check(&uniforms.lit), GN_OK);
        else
            assert_refused(numbers[i].status);
    }
    uniforms.lit.light.kind = (gn_light_kind)3;
    assert_refused(GN_INVALID_ENUM);
    uniforms.lit.more_light_count = GN_MAX_LIGHTS;
    uniforms.lit.more_lights = more_lights;
    assert_refused(GN_OUT_OF_RANGE);
    uniforms.lit.more_light_count = 1;
    assert_refused(GN_NULL_POINTER);
    uniforms.lit.more_light_count = GN_MAX_LIGHTS - 1;
    uniforms.lit.more_lights = more_lights;
    more_lights[GN_MAX_LIGHTS - 2].kind = (gn_light_kind)-1;
    assert_refused(GN_INVALID_ENUM);
    uniforms.lit.more_light_count = GN_MAX_LIGHTS - 2; /* the invalid one is not read */
    uniforms.lit.more_lights = more_lights;
    assert_int_equal(gn_lit_uniforms_check(&uniforms.lit), GN_OK);
    material->normal_space = (gn_normal_space)2;
    assert_refused(GN_INVALID_ENUM);
    material->diffuse_map = &map;
    material->sampler.wrap_t = (gn_wrap)7;
    assert_refused(GN_INVALID_ENUM);
    map.width = 0;
    material->diffuse_map = &map;
    assert_refused(GN_INVALID_SIZE);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_RGBA8, 4, 1, 1, 1, texels, &line),
                     GN_OK);
    material->glow_map = &line;
    assert_refused(GN_INVALID_ENUM);
}

static void bad_shadows(void **state)
{
    static const float depth = 0.5f;
    gn_texture shadow = texture_of(GN_FORMAT_D32F, &depth);

    uniforms.lit.shadow.map = &map;
    uniforms.lit.shadow.sampler.compare = GN_LESS;
    assert_refused(GN_INVALID_FORMAT);
    uniforms.lit.shadow.map = &shadow;
    assert_refused(GN_INVALID_ENUM); /* nothing is compared */
    uniforms.lit.shadow.map = &shadow;
    uniforms.lit.shadow.sampler.compare = GN_LESS;
    assert_int_equal(gn_lit_uniforms_check(&uniforms.lit), GN_OK);
    shadow.height = 0;
    assert_refused(GN_INVALID_SIZE);
}

static void bad_maps_and_depths(void **state)
{
    gn_unlit_uniforms *const unlit = &uniforms.unlit;
    gn_pipeline p;

    unlit->map = &map;
    map.height = 0;
    assert_shader_refuses(UNLIT, GN_INVALID_SIZE);
    map.height = 1;
    unlit->sampler.magnify = (gn_magnify)2;
    assert_shader_refuses(UNLIT, GN_INVALID_ENUM);
    unlit->sampler.magnify = GN_MAGNIFY_LINEAR;
    unlit->alpha_cutoff = -1.0f;
    assert_shader_refuses(UNLIT, GN_OUT_OF_RANGE);
    unlit->alpha_cutoff = INFINITY;
    assert_shader_refuses(UNLIT, GN_NOT_FINITE);
    unlit->alpha_cutoff = 0.0f;
    unlit->map = NULL;
    assert_int_equal(use_shader(UNLIT, &p), GN_OK);
    uniforms.depth.black = uniforms.depth.white = 0.5f;
    assert_shader_refuses(DEPTH_COLOR, GN_OUT_OF_RANGE);
    uniforms.depth.white = INFINITY;
    assert_shader_refuses(DEPTH_COLOR, GN_NOT_FINITE);
}

/* Every gn_use_ function sets fragment_discards: on for a cut-off of a shader that has one, and off
 * otherwise, also after a shader that discards. The rest of the pipeline stays. */
static void cutoffs_set_discarding(void **state)
{
    for (int s = 0; s < SHADERS; ++s) {
        gn_pipeline p;

        memset(&p, 0, sizeof p);
        p.raster.topology = GN_TRIANGLE_FAN;
        p.raster.cull = GN_CULL_FRONT;
        p.depth.test_enabled = true;
        for (int on = 1; on >= 0; --on) {
            material->alpha_cutoff = uniforms.unlit.alpha_cutoff =
                uniforms.metallic.material.alpha_cutoff = 0.5f * (float)on;
            p.program.fragment_discards = !on;
            assert_int_equal(use_shader(s, &p), GN_OK);
            assert_int_equal(p.program.fragment_discards,
                             on && s > DEPTH_COLOR && s != NORMAL_COLOR);
        }
        assert_int_equal(p.raster.topology, GN_TRIANGLE_FAN);
        assert_int_equal(p.raster.cull, GN_CULL_FRONT);
        assert_true(p.depth.test_enabled);
        assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    }
}

enum { ALL = GN_SHADER_VARYINGS };

static uint32_t varyings_read;

/* Varying n as channel n % 4 of attachment n / 4. */
static void show_varyings(const void *unused, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)unused;
    for (uint32_t n = 0; n < varyings_read; ++n)
        memcpy(out->color[n], in->varying[n], sizeof out->color[n]);
}

/* The ready-made shader, called by a user's. */
static gn_vertex_shader *ready_made;

static void call_ready_made(const void *lit, const gn_vertex_input *in, gn_vertex_output *out)
{
    ready_made(lit, in, out);
}

/* Draws one triangle over the whole target, flat, so that fragments have the values of the last
 * vertex, which is the provoking one. Compares every varying. */
static void assert_varyings(int shader, uint32_t count, bool has_attributes, const float *expected)
{
    static const float positions[12] = {-1, -1, 0, 1, 3, -1, 0, 1, -1, 3, 0.5f, 1};
    static const float vertex_colors[12] = {9, 8, 7, 6, 5, 4, 3, 2, 0.125f, 0.25f, 0.375f, 0.5f};
    static const float normals[9] = {1, 0, 0, 0, 1, 0, 4, -4, 2};
    static const float texcoords[6] = {9, 8, 7, 6, 0.625f, 0.75f};
    static const float tangents[12] = {0, 1, 0, 1, 0, 0, 1, 1, 4, -8, 8, -1};

    reset(positions, 3, GN_TRIANGLES);
    memset(&c.pipeline, 0, sizeof c.pipeline);
    assert_int_equal(use_shader(shader, &c.pipeline), GN_OK);
    assert_int_equal(c.pipeline.program.varying_count, count);
    assert_true(c.pipeline.program.uniforms != NULL);
    varyings_read = count;
    c.pipeline.program.fragment_shader = show_varyings;
    c.pipeline.program.color_count = ALL / 4;
    for (uint32_t n = 0; n < count; ++n) {
        assert_int_equal(c.pipeline.program.interpolation[n], GN_SMOOTH);
        c.pipeline.program.interpolation[n] = GN_FLAT;
    }
    set_float_colors(ALL / 4);
    if (has_attributes) {
        c.mesh.attribute[GN_ATTRIBUTE_COLOR] = floats(vertex_colors, 4);
        c.mesh.attribute[GN_ATTRIBUTE_NORMAL] = floats(normals, 3);
        c.mesh.attribute[GN_ATTRIBUTE_TEXCOORD] = floats(texcoords, 2);
        c.mesh.attribute[GN_ATTRIBUTE_TANGENT] = floats(tangents, 4);
    }
    ready_made = c.pipeline.program.vertex_shader;
    for (int called = 0; called < 2; ++called) {
        assert_int_equal(draw(), GN_OK);
        for (int i = 0; i < SIZE * SIZE; ++i)
            for (uint32_t n = 0; n < ALL; ++n)
                assert_float_equal(colors[n / 4][i][n % 4], n < count ? expected[n] : 0.0f, 1e-6f);
        set_float_colors(ALL / 4);
        c.pipeline.program.vertex_shader = call_ready_made;
    }
}

/* The matrix moves model x to y, y to z and z to x, doubles them and adds (10, 20, 30), so that the
 * place is (11, 18, 36). Three lights: from +x, with N.L = 1/3; from +y, with 2/3; and a spot light
 * along z, with 2/3. */
static void set_world_and_lights(void)
{
    static gn_light more[2];
    gn_mat4 *const world = &uniforms.lit.world_from_model;

    memset(&uniforms.lit.normal_matrix, 0, sizeof uniforms.lit.normal_matrix);
    memset(world, 0, sizeof *world);
    world->m[3][3] = 1.0f;
    for (int i = 0; i < 3; ++i) {
        world->m[i][(i + 1) % 3] = 2.0f;
        world->m[3][i] = 10.0f * (float)(i + 1);
        uniforms.lit.normal_matrix.m[i][(i + 1) % 3] = 0.5f;
    }
    uniforms.metallic.world_from_model = *world;
    uniforms.metallic.normal_matrix = uniforms.lit.normal_matrix;
    uniforms.lit.light.direction.x = 1.0f;
    uniforms.lit.light.ambient = (gn_vec3){0.5f, 0.25f, 0.125f};
    uniforms.lit.light.diffuse = (gn_vec3){0.75f, 1.5f, 3.0f};
    memset(more, 0, sizeof more);
    more[0].direction.y = 1.0f;
    more[0].diffuse.x = 0.75f;
    more[1].kind = GN_LIGHT_SPOT;
    more[1].position = (gn_vec3){11.0f, 18.0f, 31.0f};
    more[1].direction.z = -1.0f;
    more[1].diffuse.z = 0.75f;
    uniforms.lit.more_lights = more;
    uniforms.lit.more_light_count = 2;
}

static void set_maps(bool has_maps, bool has_tangents)
{
    gn_metallic_roughness *const metallic = &uniforms.metallic.material;
    const gn_texture *const maps = has_maps ? &map : NULL;

    uniforms.unlit.map = maps;
    material->diffuse_map = material->specular_map = maps;
    material->glow_map = material->normal_map = maps;
    material->normal_space = has_tangents ? GN_NORMAL_OF_TANGENTS : GN_NORMAL_OF_MODEL;
    metallic->base_color_map.texture = metallic->metallic_roughness_map.texture = maps;
    metallic->occlusion_map.texture = metallic->emissive_map.texture = maps;
    metallic->normal_map.texture = has_tangents ? &map : NULL;
}

static void varyings_are_in_the_documented_order(void **state)
{
    /* Colour; s, t; normal; position; tangent. */
    static const float documented[ALL] = {0.125f,      0.25f,       0.375f,       0.5f, /**/
                                          0.625f,      0.75f,                           /**/
                                          1.0f / 3.0f, 2.0f / 3.0f, -2.0f / 3.0f,       /**/
                                          11.0f,       18.0f,       36.0f,              /**/
                                          2.0f / 3.0f, 1.0f / 3.0f, -2.0f / 3.0f, -1.0f};
    /* Without attributes but the position: white, and a missing attribute's 0, 0, 0, 1. */
    static const float absent[ALL] = {1, 1, 1, 1, 0, 0, 0, 0, 0, 11, 18, 36, 0, 0, 0, 1};
    static const uint32_t counts[SHADERS][3] = {[VERTEX_COLOR] = {4, 4, 4},
                                                [UNLIT] = {4, 6, 6},
                                                [FLAT] = {12, 12, 16},
                                                [GOURAUD] = {4, 6, 6},
                                                [TOON] = {12, 12, 16},
                                                [PHONG] = {12, 12, 16},
                                                [BLINN_PHONG] = {12, 12, 16},
                                                [NORMAL_COLOR] = {12, 12, 16},
                                                [METALLIC_ROUGHNESS] = {12, 12, 16}};

    set_world_and_lights();
    for (int s = 0; s < SHADERS; ++s)
        for (int n = 0; n < 4; ++n) {
            const int maps = n < 3 ? n : 2;
            float expected[ALL];

            memcpy(expected, n < 3 ? documented : absent, sizeof expected);
            if (s == GOURAUD) { /* times the light; without a normal that is the ambient one */
                expected[0] *= n < 3 ? 1.25f : 0.5f;
                expected[1] *= n < 3 ? 0.75f : 0.25f;
                expected[2] *= n < 3 ? 1.625f : 0.125f;
            }
            set_maps(maps > 0, maps > 1);
            assert_varyings(s, counts[s][maps], n < 3, expected);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(null_pointers, set_up),
        cmocka_unit_test_setup(bad_lights_and_materials, set_up),
        cmocka_unit_test_setup(bad_shadows, set_up),
        cmocka_unit_test_setup(bad_maps_and_depths, set_up),
        cmocka_unit_test_setup(cutoffs_set_discarding, set_up),
        cmocka_unit_test_setup(varyings_are_in_the_documented_order, set_up),
    };
    return cmocka_run_group_tests_name("shaders", tests, NULL, NULL);
}
