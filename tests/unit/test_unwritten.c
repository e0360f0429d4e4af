/* Outputs that a shader leaves unwritten have the values that gnomon/pipeline.h states, on every
 * back end and whatever the workspace held before. */
#include "canvas.h"

/* Bytes that a workspace is filled with; as floats they are 0, 8.1 and -24.2. */
static const unsigned char fills[] = {0x00, 0x41, 0xC1};

static float colors[GN_MAX_COLORS][SIZE * SIZE][4];

typedef struct lit_scene {
    gn_color_uniforms color;
    gn_unlit_uniforms unlit;
    gn_lit_uniforms lit;
    gn_metallic_roughness_uniforms metallic;
    gn_depth_color_uniforms depth;
} lit_scene;

static lit_scene uniforms;

static gn_status use_shader(int shader, gn_pipeline *pipeline)
{
    switch (shader) {
    case 0:
        return gn_use_vertex_color(pipeline, &uniforms.color);
    case 1:
        return gn_use_unlit(pipeline, &uniforms.unlit);
    case 2:
        return gn_use_flat(pipeline, &uniforms.lit);
    case 3:
        return gn_use_gouraud(pipeline, &uniforms.lit);
    case 4:
        return gn_use_toon(pipeline, &uniforms.lit);
    case 5:
        return gn_use_phong(pipeline, &uniforms.lit);
    case 6:
        return gn_use_blinn_phong(pipeline, &uniforms.lit);
    case 7:
        return gn_use_normal_color(pipeline, &uniforms.lit);
    case 8:
        return gn_use_metallic_roughness(pipeline, &uniforms.metallic);
    default:
        return gn_use_depth_color(pipeline, &uniforms.depth);
    }
}

enum { SHADERS = 10 };

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

/* Calls `check` for every back end and every content of the workspace. */
static void everywhere(void (*check)(void))
{
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        if (!gn_backend_available((gn_backend)b))
            continue;
        for (size_t f = 0; f < sizeof fills; ++f) {
            reset(square, 4, GN_TRIANGLE_STRIP);
            memset(c.memory, fills[f], sizeof c.memory);
            c.workspace.backend = (gn_backend)b;
            set_uniforms();
            check();
        }
    }
}

/* A target with this many attachments of floats, all of whose channels are 7. */
static void set_float_colors(int count)
{
    for (int a = 0; a < count; ++a) {
        for (int i = 0; i < SIZE * SIZE * 4; ++i)
            colors[a][i / 4][i % 4] = 7.0f;
        c.target.color[a] = gn_surface_bottom_up(colors[a], GN_FORMAT_RGBA32F, SIZE, SIZE);
    }
}

static void assert_attachment_is(int attachment, float value)
{
    for (int i = 0; i < SIZE * SIZE * 4; ++i)
        assert_float_equal(colors[attachment][i / 4][i % 4], value, 0.0f);
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
    for (int i = 0; i < 2 * SHADERS; ++i) {
        const int shader = i / 2;

        memset(&c.pipeline, 0, sizeof c.pipeline);
        c.pipeline.raster.topology = GN_TRIANGLE_STRIP;
        c.pipeline.program.color_count = 3;
        c.pipeline.program.fragment_writes_all_colors = i % 2; /* no effect */
        set_float_colors(4);
        assert_int_equal(use_shader(shader, &c.pipeline), GN_OK);
        fill_stack();
        assert_int_equal(draw(), GN_OK);
        assert_attachment_is(1, 0.0f);
        assert_attachment_is(2, 0.0f);
        assert_attachment_is(3, 7.0f);
        assert_true(colors[0][9][3] != 7.0f);
    }
}

static void ready_made_shaders_leave_more_colors_zero(void **state)
{
    (void)state;
    everywhere(more_colors_of_ready_made_shaders);
}

static const float middle[4] = {0, 0, 0, 1};

static void sizes_of_ready_made_shaders(void)
{
    static const struct {
        float size;
        int covered;
    } sizes[] = {{0, 1}, {1, 1}, {2, 4}, {4, 16}};

    for (int shader = 0; shader < SHADERS; ++shader) {
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
            uint64_t passed = 0;

            memset(&c.pipeline, 0, sizeof c.pipeline);
            c.mesh.attribute[GN_ATTRIBUTE_POSITION].data = middle;
            c.mesh.vertex_count = c.mesh.count = 1;
            c.pipeline.raster.topology = GN_POINTS;
            c.pipeline.program.vertex_writes_point_size = true;
            c.pipeline.raster.point_size = sizes[i].size;
            c.workspace.samples_passed = &passed;
            assert_int_equal(use_shader(shader, &c.pipeline), GN_OK);
            assert_int_equal(draw(), GN_OK);
            assert_int_equal(passed, sizes[i].covered);
        }
    }
}

static void ready_made_shaders_leave_the_size_of_the_state(void **state)
{
    (void)state;
    everywhere(sizes_of_ready_made_shaders);
}

static void distances_of_ready_made_shaders(void)
{
    for (int shader = 0; shader < SHADERS; ++shader) {
        for (uint32_t count = 1; count <= GN_MAX_CLIP_DISTANCES; ++count) {
            unsigned char memory[GN_WORKSPACE_SIZE(16, GN_SHADER_VARYINGS + GN_MAX_CLIP_DISTANCES)];
            uint64_t passed = 0;

            memset(memory, c.memory[0], sizeof memory);
            memset(&c.pipeline, 0, sizeof c.pipeline);
            c.pipeline.raster.topology = GN_TRIANGLE_STRIP;
            c.pipeline.program.clip_distance_count = count;
            c.workspace.memory = memory;
            c.workspace.size = sizeof memory;
            c.workspace.samples_passed = &passed;
            assert_int_equal(use_shader(shader, &c.pipeline), GN_OK);
            assert_int_equal(draw(), GN_OK);
            assert_int_equal(passed, SIZE * SIZE);
        }
    }
}

static void ready_made_shaders_clip_nothing(void **state)
{
    (void)state;
    everywhere(distances_of_ready_made_shaders);
}

static void write_no_vertex(const void *unused, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)unused;
    (void)in;
    (void)out;
}

static void write_no_fragment(const void *unused, const gn_fragment_input *in,
                              gn_fragment_output *out)
{
    (void)unused;
    (void)in;
    (void)out;
}

/* Writes positions and varying 1 only for the vertices with an odd number. */
static void write_odd_vertices(const void *unused, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)unused;
    for (int l = 0; l < GN_LANES; ++l) {
        if (in->vertex_id[l] % 2 == 0)
            continue;
        out->position[0][l] = 0.9f;
        out->varying[1][l] = 3.0f;
    }
}

static void show_varyings(const void *unused, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)unused;
    for (int n = 0; n < 4; ++n)
        for (int l = 0; l < GN_LANES; ++l)
            out->color[n][l] = in->varying[n][l];
}

static void points_of_nothing(void)
{
    float positions[40][4] = {{0}};

    /* Vertices are at the middle of clip space, which is a corner of the pixel (3, 3): the point is
     * that pixel. Vertices with an odd number are at x = 0.9, and their point is the pixel (7,
     * 3). */
    set_float_colors(1);
    memset(&c.pipeline, 0, sizeof c.pipeline);
    c.pipeline.raster.topology = GN_POINTS;
    c.pipeline.program.vertex_shader = write_odd_vertices;
    c.pipeline.program.fragment_shader = show_varyings;
    c.pipeline.program.varying_count = 4;
    c.mesh.attribute[GN_ATTRIBUTE_POSITION].data = positions[0];
    c.mesh.attribute[GN_ATTRIBUTE_COLOR].data = NULL;
    c.mesh.vertex_count = 40;
    for (uint32_t count = 1; count <= 40; ++count) {
        set_float_colors(1);
        c.mesh.count = count;
        assert_int_equal(draw(), GN_OK);
        for (int i = 0; i < SIZE * SIZE; ++i) {
            const bool even = i == 3 * SIZE + 3;
            const bool odd = i == 3 * SIZE + 7 && count > 1;

            assert_float_equal(colors[0][i][0], even || odd ? 0.0f : 7.0f, 0.0f);
            assert_float_equal(colors[0][i][1], even ? 0.0f : odd ? 3.0f : 7.0f, 0.0f);
        }
    }
    c.pipeline.program.vertex_shader = write_no_vertex;
    c.mesh.count = 1;
    set_float_colors(1);
    assert_int_equal(draw(), GN_OK);
    for (int n = 0; n < 4; ++n)
        assert_float_equal(colors[0][3 * SIZE + 3][n], 0.0f, 0.0f);
}

static void vertices_that_a_shader_does_not_write_are_in_the_middle(void **state)
{
    (void)state;
    everywhere(points_of_nothing);
}

static void colors_of_nothing(void)
{
    for (uint32_t count = 0; count <= GN_MAX_COLORS; ++count) {
        for (int late = 0; late < 2; ++late) {
            reset(square, 4, GN_TRIANGLE_STRIP);
            set_float_colors(GN_MAX_COLORS);
            c.pipeline.program.fragment_shader = write_no_fragment;
            c.pipeline.program.fragment_discards = late;
            c.pipeline.program.fragment_writes_depth = late;
            c.pipeline.depth.test = true;
            c.pipeline.program.color_count = count;
            assert_int_equal(draw(), GN_OK);
            for (int a = 0; a < GN_MAX_COLORS; ++a)
                assert_attachment_is(a, a < (int)count || a == 0 ? 0.0f : 7.0f);
            /* Half of 2^24 - 1, rounded to even. */
            assert_int_equal(c.depth[9], 0x800000);
        }
    }
}

static void colors_that_a_shader_does_not_write_are_zero(void **state)
{
    (void)state;
    everywhere(colors_of_nothing);
}

static uint32_t written_colors;

static void write_all_colors(const void *unused, const gn_fragment_input *in,
                             gn_fragment_output *out)
{
    (void)unused;
    (void)in;
    for (uint32_t n = 0; n < 4 * written_colors; ++n)
        for (int l = 0; l < GN_LANES; ++l)
            out->color[n][l] = (float)(n / 4);
}

static void colors_of_a_shader_that_writes_all(void)
{
    for (uint32_t count = 1; count <= GN_MAX_COLORS; ++count) {
        reset(square, 4, GN_TRIANGLE_STRIP);
        set_float_colors(GN_MAX_COLORS);
        c.pipeline.program.fragment_shader = write_all_colors;
        c.pipeline.program.fragment_writes_all_colors = true;
        c.pipeline.program.color_count = written_colors = count;
        assert_int_equal(draw(), GN_OK);
        for (int a = 0; a < GN_MAX_COLORS; ++a)
            assert_attachment_is(a, a < (int)count ? (float)a : 7.0f);
    }
}

static void all_colors_of_a_shader_that_writes_all(void **state)
{
    (void)state;
    everywhere(colors_of_a_shader_that_writes_all);
}

static gn_texture white_texture(void)
{
    static const uint32_t texel = 0xFFFFFFFF;
    gn_texture t = {.format = GN_FORMAT_RGBA8, .width = 1, .height = 1, .level_count = 1};

    t.level[0].texels = &texel;
    t.level[0].row_stride = 4;
    return t;
}

/* Ready-made shaders read and write varyings that varying_count must count. */
static void too_few_varyings_are_refused(void **state)
{
    (void)state;
    const gn_texture map = white_texture();

    reset(square, 4, GN_TRIANGLE_STRIP);
    set_uniforms();
    for (int shader = 0; shader < SHADERS; ++shader) {
        assert_int_equal(use_shader(shader, &c.pipeline), GN_OK);
        assert_int_equal(gn_pipeline_check(&c.pipeline, NULL), GN_OK);
        if (c.pipeline.program.varying_count == 0)
            continue;
        --c.pipeline.program.varying_count;
        assert_int_equal(gn_pipeline_check(&c.pipeline, NULL), GN_OUT_OF_RANGE);
        assert_string_equal(
            gn_pipeline_fault(&c.pipeline, NULL),
            "program.varying_count is below what the ready-made shaders and their maps "
            "use: call the gn_use_ function again");
        assert_int_equal(draw(), GN_OUT_OF_RANGE);
        assert_int_equal(covered(), 0);
    }
    /* A map that is added after gn_use_unlit needs texture coordinates. */
    assert_int_equal(gn_use_unlit(&c.pipeline, &uniforms.unlit), GN_OK);
    uniforms.unlit.map = &map;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    assert_int_equal(gn_use_unlit(&c.pipeline, &uniforms.unlit), GN_OK);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(gn_use_gouraud(&c.pipeline, &uniforms.lit), GN_OK);
    uniforms.lit.material.diffuse_map = &map;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    uniforms.lit.material.diffuse_map = NULL;
    assert_int_equal(gn_use_phong(&c.pipeline, &uniforms.lit), GN_OK);
    uniforms.lit.material.normal_map = &map;
    uniforms.lit.material.normal_space = GN_NORMAL_OF_TANGENTS;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    assert_int_equal(gn_use_metallic_roughness(&c.pipeline, &uniforms.metallic), GN_OK);
    uniforms.metallic.material.normal_map.texture = &map;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    assert_int_equal(gn_use_metallic_roughness(&c.pipeline, &uniforms.metallic), GN_OK);
    assert_int_equal(draw(), GN_OK);
}

static void what_ready_made_shaders_read_must_be_there(void **state)
{
    (void)state;
    reset(square, 4, GN_TRIANGLE_STRIP);
    set_uniforms();
    assert_int_equal(gn_use_depth_color(&c.pipeline, &uniforms.depth), GN_OK);
    c.pipeline.program.fragment_reads_position = false;
    assert_int_equal(draw(), GN_OUT_OF_RANGE);
    assert_string_equal(
        gn_pipeline_fault(&c.pipeline, NULL),
        "program.fragment_reads_position is off, but gn_use_depth_color's shader reads it");
    assert_int_equal(gn_use_vertex_color(&c.pipeline, &uniforms.color), GN_OK);
    c.pipeline.program.uniforms = NULL;
    assert_int_equal(draw(), GN_NULL_POINTER);
    assert_string_equal(gn_pipeline_fault(&c.pipeline, NULL),
                        "program.uniforms is null, but a shader is a ready-made one");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ready_made_shaders_leave_more_colors_zero),
        cmocka_unit_test(ready_made_shaders_leave_the_size_of_the_state),
        cmocka_unit_test(ready_made_shaders_clip_nothing),
        cmocka_unit_test(vertices_that_a_shader_does_not_write_are_in_the_middle),
        cmocka_unit_test(colors_that_a_shader_does_not_write_are_zero),
        cmocka_unit_test(all_colors_of_a_shader_that_writes_all),
        cmocka_unit_test(too_few_varyings_are_refused),
        cmocka_unit_test(what_ready_made_shaders_read_must_be_there),
    };
    return cmocka_run_group_tests_name("unwritten outputs", tests, NULL, NULL);
}
