/* Outputs that a shader leaves unwritten have the values that gnomon/program.h states, on every
 * back end and whatever the workspace held before; alpha cut-offs of ready-made shaders; and what
 * ready-made shaders need. */
#include <math.h>

#include "canvas.h"

/* Bytes that a workspace is filled with; as floats they are 0, 8.1 and -24.2. */
static const unsigned char fills[] = {0x00, 0x41, 0xC1};

static struct {
    gn_color_uniforms color;
    gn_unlit_uniforms unlit;
    gn_lit_uniforms lit;
    gn_metallic_roughness_uniforms metallic;
    gn_depth_color_uniforms depth;
} uniforms;

#define USE(name, member)                                                                          \
    static gn_status use_##name(gn_pipeline *p)                                                    \
    {                                                                                              \
        return gn_use_##name(p, &uniforms.member);                                                 \
    }

USE(vertex_color, color)
USE(unlit, unlit)
USE(flat, lit)
USE(gouraud, lit)
USE(toon, lit)
USE(phong, lit)
USE(blinn_phong, lit)
USE(normal_color, lit)
USE(metallic_roughness, metallic)
USE(depth_color, depth)

static const struct shader {
    gn_status (*use)(gn_pipeline *);
    bool has_cutoff;
} shaders[] = {{use_vertex_color, false}, {use_unlit, true},         {use_flat, true},
               {use_gouraud, true},       {use_toon, true},          {use_phong, true},
               {use_blinn_phong, true},   {use_normal_color, false}, {use_metallic_roughness, true},
               {use_depth_color, false}};

static void set_uniforms(void)
{
    memset(&uniforms, 0, sizeof uniforms);
    gn_mat4_identity(&uniforms.color.clip_from_model);
    gn_mat4_identity(&uniforms.unlit.clip_from_model);
    gn_mat4_identity(&uniforms.lit.clip_from_model);
    gn_mat4_identity(&uniforms.lit.world_from_model);
    gn_mat3_identity(&uniforms.lit.normal_matrix);
    gn_mat4_identity(&uniforms.metallic.clip_from_model);
    gn_mat4_identity(&uniforms.metallic.world_from_model);
    gn_mat3_identity(&uniforms.metallic.normal_matrix);
    gn_mat4_identity(&uniforms.depth.clip_from_model);
}

static gn_backend backend;
static unsigned char fill;

/* A canvas for the back end, in a workspace that holds the fill. */
static void start(void)
{
    reset(square, 4, GN_TRIANGLE_STRIP);
    memset(c.memory, fill, sizeof c.memory);
    c.workspace.backend = backend;
}

/* Calls `check` for every back end and every content of the workspace. */
static void everywhere(void (*check)(void))
{
    for (backend = GN_BACKEND_PORTABLE; backend < GN_BACKEND_COUNT;
         backend = next_backend(backend)) {
        for (size_t f = 0; f < sizeof fills; ++f) {
            fill = fills[f];
            start();
            set_uniforms();
            check();
        }
    }
    backend = GN_BACKEND_AUTO;
}

/* A pipeline with a ready-made shader alone. */
static void use(const struct shader *shader, gn_topology topology)
{
    memset(&c.pipeline, 0, sizeof c.pipeline);
    c.pipeline.raster.topology = topology;
    assert_int_equal(shader->use(&c.pipeline), GN_OK);
}

static void assert_attachment_is(int attachment, float value)
{
    for (int i = 0; i < SIZE * SIZE * 4; ++i)
        assert_true(colors[attachment][i / 4][i % 4] == value);
}

/* Draws, and returns how many samples passed. */
static uint64_t count_passed(void)
{
    uint64_t passed = 0;

    c.workspace.samples_passed = &passed;
    assert_int_equal(draw(), GN_OK);
    c.workspace.samples_passed = NULL;
    return passed;
}

/* Leaves bytes on the stack that a draw could mistake for its own. */
static void fill_stack(void)
{
    volatile unsigned char bytes[49152];

    for (size_t i = 0; i < sizeof bytes; ++i)
        bytes[i] = fills[1];
}

static void more_colors_of_ready_made_shaders(void)
{
    for (size_t i = 0; i < 2 * COUNT(shaders); ++i) {
        use(&shaders[i / 2], GN_TRIANGLE_STRIP);
        c.pipeline.program.color_count = 3;
        c.pipeline.program.fragment_writes_all_colors = i % 2; /* no effect */
        assert_int_equal(shaders[i / 2].use(&c.pipeline), GN_OK);
        set_float_colors(4);
        fill_stack();
        assert_int_equal(draw(), GN_OK);
        assert_attachment_is(1, 0);
        assert_attachment_is(2, 0);
        assert_attachment_is(3, 7);
        assert_true(colors[0][9][3] != 7);
    }
}

/* More colours are zero. */
static void colors_of_ready_made_shaders(void **state)
{
    everywhere(more_colors_of_ready_made_shaders);
}

static void sizes_and_distances_of_ready_made_shaders(void)
{
    static const float middle[4] = {0, 0, 0, 1};
    static const struct {
        float size;
        uint64_t covered;
    } sizes[] = {{0, 1}, {1, 1}, {2, 4}, {4, 16}};
    unsigned char memory[GN_WORKSPACE_SIZE(16, GN_SHADER_VARYINGS + GN_MAX_CLIP_DISTANCES)];

    memset(memory, fill, sizeof memory);
    c.workspace.memory = memory;
    c.workspace.size = sizeof memory;
    for (size_t shader = 0; shader < COUNT(shaders); ++shader) {
        c.mesh.attribute[GN_ATTRIBUTE_POSITION].data = middle;
        c.mesh.vertex_count = c.mesh.count = 1;
        for (size_t i = 0; i < COUNT(sizes); ++i) {
            use(&shaders[shader], GN_POINTS);
            c.pipeline.program.vertex_writes_point_size = true;
            c.pipeline.raster.point_size = sizes[i].size;
            assert_int_equal(count_passed(), sizes[i].covered);
        }
        c.mesh.attribute[GN_ATTRIBUTE_POSITION].data = square;
        c.mesh.vertex_count = c.mesh.count = 4;
        for (uint32_t count = 1; count <= GN_MAX_CLIP_DISTANCES; ++count) {
            use(&shaders[shader], GN_TRIANGLE_STRIP);
            c.pipeline.program.clip_distance_count = count;
            assert_int_equal(count_passed(), SIZE * SIZE);
        }
    }
}

/* Points have the size of the state, and nothing is clipped. */
static void points_and_clipping_of_ready_made_shaders(void **state)
{
    everywhere(sizes_and_distances_of_ready_made_shaders);
}

static void write_no_vertex(const void *unused, const gn_vertex_input *in, gn_vertex_output *out)
{
}

static void write_no_fragment(const void *unused, const gn_fragment_input *in,
                              gn_fragment_output *out)
{
}

/* Writes positions and varying 1 only for the vertices with an odd number. */
static void write_odd_vertices(const void *unused, const gn_vertex_input *in, gn_vertex_output *out)
{
    for (int l = 0; l < GN_LANES; ++l) {
        if (in->vertex_id[l] % 2 == 0)
            continue;
        out->position[0][l] = 0.9f;
        out->varying[1][l] = 3.0f;
    }
}

static void show_varyings(const void *unused, const gn_fragment_input *in, gn_fragment_output *out)
{
    for (int n = 0; n < 4; ++n)
        for (int l = 0; l < GN_LANES; ++l)
            out->color[n][l] = in->varying[n][l];
}

/* Vertices are at the middle of clip space, which is a corner of the pixel (3, 3): the point is
 * that pixel. Vertices with an odd number are at x = 0.9, and their point is the pixel (7, 3). */
static void points_of_nothing(void)
{
    float positions[40][4] = {{0}};

    memset(&c.pipeline, 0, sizeof c.pipeline);
    c.pipeline.raster.topology = GN_POINTS;
    c.pipeline.program.vertex_shader = write_odd_vertices;
    c.pipeline.program.fragment_shader = show_varyings;
    c.pipeline.program.varying_count = 4;
    c.mesh.attribute[GN_ATTRIBUTE_POSITION].data = positions[0];
    c.mesh.attribute[GN_ATTRIBUTE_COLOR].data = NULL;
    c.mesh.vertex_count = 40;
    for (uint32_t count = 1; count <= 41; ++count) {
        if (count == 41)
            c.pipeline.program.vertex_shader = write_no_vertex;
        set_float_colors(1);
        c.mesh.count = count % 40 + 1;
        assert_int_equal(draw(), GN_OK);
        for (int i = 0; i < SIZE * SIZE; ++i) {
            const bool even = i == 3 * SIZE + 3;
            const bool odd = i == 3 * SIZE + 7 && c.mesh.count > 1 && count < 41;

            assert_true(colors[0][i][0] == (even || odd ? 0 : 7));
            assert_true(colors[0][i][1] == (even ? 0 : odd ? 3 : 7));
        }
    }
}

static void vertices_that_a_shader_does_not_write_are_in_the_middle(void **state)
{
    everywhere(points_of_nothing);
}

static uint32_t written_colors;

static void write_all_colors(const void *unused, const gn_fragment_input *in,
                             gn_fragment_output *out)
{
    for (uint32_t n = 0; n < 4 * written_colors; ++n)
        for (int l = 0; l < GN_LANES; ++l)
            out->color[n][l] = (float)(n / 4);
}

/* Way 0: a shader that writes no colour; 1: and the depth test is late; 2: one that writes all. */
static void colors_of_nothing_and_all(void)
{
    for (uint32_t i = 0; i < 3 * (GN_MAX_COLORS + 1); ++i) {
        const uint32_t count = i / 3, way = i % 3;

        if (way == 2 && count == 0)
            continue;
        start();
        set_float_colors(GN_MAX_COLORS);
        c.pipeline.program.fragment_shader = way == 2 ? write_all_colors : write_no_fragment;
        c.pipeline.program.fragment_writes_all_colors = way == 2;
        c.pipeline.program.fragment_discards = way == 1;
        c.pipeline.program.fragment_writes_depth = way == 1;
        c.pipeline.depth.test_enabled = true;
        c.pipeline.program.color_count = written_colors = count;
        assert_int_equal(draw(), GN_OK);
        for (uint32_t a = 0; a < GN_MAX_COLORS; ++a)
            assert_attachment_is((int)a, a >= count && a > 0 ? 7 : way == 2 ? (float)a : 0);
        /* Half of 2^24 - 1, rounded to even. */
        assert_int_equal(c.depth[9], 0x800000);
    }
}

static void colors_that_a_shader_does_not_write_are_zero(void **state)
{
    everywhere(colors_of_nothing_and_all);
}

/* Alpha rises along x from 0 to 1, so at the centres of columns 3 and 4 it is 3.5 / 8 and 4.5 / 8.
 * Fragments below the cut-off leave neither colour nor depth and are not counted. */
static void cutoffs(void)
{
    static const float fading[16] = {1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1};
    static const struct {
        float cutoff;
        int first; /* of the columns that are drawn */
    } cases[] = {{0, 0}, {0.5f, 4}, {2, SIZE}};

    for (size_t i = 0; i < COUNT(shaders) * 2 * COUNT(cases); ++i) {
        const struct shader *const shader = &shaders[i / 2 / COUNT(cases)];
        const float cutoff = cases[i / 2 % COUNT(cases)].cutoff;
        const int first = cases[i / 2 % COUNT(cases)].first;
        const bool has_color = i % 2;

        if (!shader->has_cutoff)
            continue;
        start();
        use(shader, GN_TRIANGLE_STRIP);
        uniforms.metallic.light.ambient = uniforms.lit.light.ambient = (gn_vec3){1, 1, 1};
        uniforms.unlit.alpha_cutoff = uniforms.lit.material.alpha_cutoff =
            uniforms.metallic.material.alpha_cutoff = cutoff;
        c.mesh.attribute[GN_ATTRIBUTE_COLOR] = floats(fading, 4);
        c.pipeline.depth.test_enabled = true;
        if (!has_color)
            memset(&c.target.color[0], 0, sizeof c.target.color[0]);
        assert_int_equal(shader->use(&c.pipeline), GN_OK);
        assert_int_equal(count_passed(), SIZE * (SIZE - first));
        for (int k = 0; k < SIZE * SIZE; ++k) {
            const bool drawn = k % SIZE >= first;

            assert_int_equal(c.depth[k], drawn ? 0x800000 : 0xFFFFFF);
            assert_int_equal(c.color[k] != 0, drawn && has_color);
        }
    }
}

static void transparent_columns_are_discarded(void **state)
{
    everywhere(cutoffs);
}

/* Depth 0.5 as grey: between black and white; both 0 mean 0 to 1. */
static void depths_between_black_and_white(void **state)
{
    static const struct {
        float black, white;
        uint32_t grey;
    } cases[] = {{0, 0, 128}, {0, 0.5f, 255}, {0.5f, 0, 0}, {1, 0, 128}, {0, 1, 128}};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        start();
        set_uniforms();
        uniforms.depth.black = cases[i].black;
        uniforms.depth.white = cases[i].white;
        assert_int_equal(use_depth_color(&c.pipeline), GN_OK);
        assert_int_equal(draw(), GN_OK);
        assert_int_equal(c.color[9] & 255, cases[i].grey);
    }
    uniforms.depth.black = NAN;
    assert_int_equal(use_depth_color(&c.pipeline), GN_NOT_FINITE);
    uniforms.depth.black = 0;
    uniforms.depth.white = NAN;
    assert_int_equal(use_depth_color(&c.pipeline), GN_NOT_FINITE);
}

static const char few_varyings[] = "program.varying_count is below what the ready-made shaders and "
                                   "their maps use: call the gn_use_ function again";

/* Ready-made shaders read and write varyings that varying_count must count. A map that is added
 * afterwards needs texture coordinates. */
static void too_few_varyings_are_refused(void **state)
{
    static const uint32_t texel = 0xFFFFFFFF;
    gn_texture map;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 1, 1, 1, 1, &texel, &map),
                     GN_OK);
    start();
    set_uniforms();
    for (size_t shader = 0; shader < COUNT(shaders); ++shader) {
        assert_int_equal(shaders[shader].use(&c.pipeline), GN_OK);
        assert_int_equal(gn_pipeline_check(&c.pipeline, NULL), GN_OK);
        if (c.pipeline.program.varying_count == 0)
            continue;
        --c.pipeline.program.varying_count;
        assert_int_equal(gn_pipeline_check(&c.pipeline, NULL), GN_OUT_OF_RANGE);
        assert_string_equal(gn_draw_fault(&c.target, &c.pipeline, &c.mesh, &c.workspace),
                            few_varyings);
        assert_int_equal(draw(), GN_OUT_OF_RANGE);
        assert_int_equal(covered(), 0);
    }
    assert_int_equal(use_unlit(&c.pipeline), GN_OK);
    uniforms.unlit.map = &map;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    assert_int_equal(use_unlit(&c.pipeline), GN_OK);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(use_gouraud(&c.pipeline), GN_OK);
    uniforms.lit.material.diffuse_map = &map;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    uniforms.lit.material.diffuse_map = NULL;
    assert_int_equal(use_phong(&c.pipeline), GN_OK);
    uniforms.lit.material.normal_map = &map;
    uniforms.lit.material.normal_space = GN_NORMAL_OF_TANGENTS;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    assert_int_equal(use_metallic_roughness(&c.pipeline), GN_OK);
    uniforms.metallic.material.normal_map.texture = &map;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    assert_int_equal(use_metallic_roughness(&c.pipeline), GN_OK);
    assert_int_equal(draw(), GN_OK);
}

/* Uniforms may be null only if neither shader is a ready-made one that reads them. */
static void what_ready_made_shaders_read_must_be_there(void **state)
{
    gn_pipeline plain;

    start();
    set_uniforms();
    plain = c.pipeline;
    for (size_t shader = 0; shader < COUNT(shaders); ++shader) {
        const bool reads_in_fragments = shaders[shader].use != use_vertex_color;

        use(&shaders[shader], GN_TRIANGLE_STRIP);
        c.pipeline.program.uniforms = NULL;
        assert_int_equal(draw(), GN_NULL_POINTER);
        assert_string_equal(gn_draw_fault(&c.target, &c.pipeline, &c.mesh, &c.workspace),
                            "program.uniforms is null, but a shader is a ready-made one");
        c.pipeline.program.vertex_shader = write_no_vertex;
        assert_int_equal(gn_pipeline_check(&c.pipeline, &c.target),
                         reads_in_fragments ? GN_NULL_POINTER : GN_OK);
        use(&shaders[shader], GN_TRIANGLE_STRIP);
        c.pipeline.program.uniforms = NULL;
        c.pipeline.program.fragment_shader = plain.program.fragment_shader;
        assert_int_equal(gn_pipeline_check(&c.pipeline, &c.target), GN_NULL_POINTER);
    }
    assert_int_equal(use_depth_color(&c.pipeline), GN_OK);
    c.pipeline.program.fragment_reads_position = false;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    assert_string_equal(
        gn_draw_fault(&c.target, &c.pipeline, &c.mesh, &c.workspace),
        "program.fragment_reads_position is off, but gn_use_depth_color's shader reads it");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colors_of_ready_made_shaders),
        cmocka_unit_test(points_and_clipping_of_ready_made_shaders),
        cmocka_unit_test(vertices_that_a_shader_does_not_write_are_in_the_middle),
        cmocka_unit_test(colors_that_a_shader_does_not_write_are_zero),
        cmocka_unit_test(transparent_columns_are_discarded),
        cmocka_unit_test(depths_between_black_and_white),
        cmocka_unit_test(too_few_varyings_are_refused),
        cmocka_unit_test(what_ready_made_shaders_read_must_be_there),
    };
    return cmocka_run_group_tests_name("contracts of shaders", tests, NULL, NULL);
}
