/* Every fault of a pipeline, a mesh, a target and a workspace: its status, and its words, which are
 * its own and begin with the field. Faults are added from the last that the headers name to the
 * first, and each one that is added is the one that is found, however many there are behind it. And
 * what is valid at the ends of the ranges. */
#include <math.h>
#include <stdio.h>

#include "drawing.h"

#define MAX_TEXTS 256

/* The texts seen so far. */
static const char *met[MAX_TEXTS];
static int met_count;

/* Checks the text of a fault: it is new and begins with these words. `among_others` is the text for
 * the same fault with all that were tested before. */
static void expect(gn_status status, gn_status expected, const char *text, const char *among_others,
                   const char *words)
{
    assert_int_equal(status, expected);
    assert_non_null(text);
    assert_non_null(among_others);
    assert_true(strlen(text) > strlen(words) + 2);
    if (strncmp(text, words, strlen(words)) != 0)
        fail_msg("'%s' does not begin with '%s'", text, words);
    if (strcmp(text, among_others) != 0)
        fail_msg("'%s' is found before '%s'", among_others, text);
    for (int i = 0; i < met_count; ++i)
        assert_string_not_equal(text, met[i]);
    assert_true(met_count < MAX_TEXTS);
    met[met_count++] = text;
}

static uint32_t words[64];

static gn_target good_target(void)
{
    gn_target t = {0};

    t.color[0] = t.color[5] = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, 4, 4);
    t.depth = gn_surface_bottom_up(words, GN_FORMAT_D24, 4, 4);
    make_multisampled(&t);
    return t;
}

static gn_mesh good_mesh(void)
{
    gn_mesh m;

    memset(&m, 0, sizeof m);
    for (int i = 0; i < GN_MAX_ATTRIBUTES; ++i)
        m.attribute[i] = floats((const float *)words, 1 + (uint32_t)i % 4);
    m.vertex_count = m.count = 4;
    return m;
}

static gn_workspace good_workspace(void)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(4, GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES)];

    return (gn_workspace){.memory = memory, .size = sizeof memory};
}

/* Everything that can be on is on, so that all is checked. */
static gn_pipeline good_pipeline(void)
{
    gn_pipeline p;

    memset(&p, 0, sizeof p);
    p.program.vertex_shader = pass_positions;
    p.program.varying_count = 3;
    p.raster.viewport.enabled = p.depth.range.enabled = p.raster.polygon_offset.enabled = true;
    p.samples.shading_enabled = true;
    p.color.blend[3].enabled = true;
    return p;
}

/* Draws without colour, which needs no fragment shader, and with a faultless mesh. */
static const char *fault_of_pipeline(const gn_pipeline *pipeline)
{
    const gn_target target = {.depth = good_target().depth};
    const gn_mesh mesh = good_mesh();
    const gn_workspace workspace = good_workspace();

    return gn_draw_fault(&target, pipeline, &mesh, &workspace);
}

static const char *fault_of_target(const gn_target *target)
{
    gn_pipeline pipeline = good_pipeline();
    const gn_mesh mesh = good_mesh();
    const gn_workspace workspace = good_workspace();

    pipeline.program.fragment_shader = shade_white;
    return gn_draw_fault(target, &pipeline, &mesh, &workspace);
}

static const char *fault_of_mesh(const gn_mesh *mesh)
{
    const gn_target target = {.depth = good_target().depth};
    const gn_pipeline pipeline = good_pipeline();
    const gn_workspace workspace = good_workspace();

    return gn_draw_fault(&target, &pipeline, mesh, &workspace);
}

#define FAULT_IN_WORDS(member, value, status, words)                                               \
    do {                                                                                           \
        gn_pipeline one = good_pipeline();                                                         \
        one.member = all.member = (value);                                                         \
        expect(gn_pipeline_check(&one, NULL), status, fault_of_pipeline(&one),                     \
               fault_of_pipeline(&all), words);                                                    \
    } while (0)

#define FAULT(member, value, status) FAULT_IN_WORDS(member, value, status, #member " ")

#define VALID(member, value)                                                                       \
    do {                                                                                           \
        gn_pipeline one = good_pipeline();                                                         \
        one.member = (value);                                                                      \
        assert_int_equal(gn_pipeline_check(&one, NULL), GN_OK);                                    \
        assert_null(fault_of_pipeline(&one));                                                      \
    } while (0)

/* A number, or an enumeration, above its largest value. */
#define ABOVE(member, largest, status)                                                             \
    do {                                                                                           \
        VALID(member, largest);                                                                    \
        FAULT(member, (largest) + 1, status);                                                      \
    } while (0)

#define NO_ENUM(member, largest) ABOVE(member, largest, GN_INVALID_ENUM)

#define NO_STENCIL_FACE(face)                                                                      \
    do {                                                                                           \
        NO_ENUM(face.pass, GN_STENCIL_DECREMENT_WRAP);                                             \
        NO_ENUM(face.depth_fail, GN_STENCIL_DECREMENT_WRAP);                                       \
        NO_ENUM(face.fail, GN_STENCIL_DECREMENT_WRAP);                                             \
        NO_ENUM(face.function, GN_ALWAYS);                                                         \
    } while (0)

#define NO_BLEND(i)                                                                                \
    do {                                                                                           \
        NO_ENUM(color.blend[i].alpha_destination, GN_FACTOR_SOURCE_ALPHA_SATURATE);                \
        NO_ENUM(color.blend[i].alpha_source, GN_FACTOR_SOURCE_ALPHA_SATURATE);                     \
        NO_ENUM(color.blend[i].alpha_equation, GN_EQUATION_MAX);                                   \
        NO_ENUM(color.blend[i].destination, GN_FACTOR_SOURCE_ALPHA_SATURATE);                      \
        NO_ENUM(color.blend[i].source, GN_FACTOR_SOURCE_ALPHA_SATURATE);                           \
        NO_ENUM(color.blend[i].equation, GN_EQUATION_MAX);                                         \
        ABOVE(color.write_disabled[i], GN_CHANNEL_ALL, GN_OUT_OF_RANGE);                           \
    } while (0)

/* In gnomon/pipeline.h, at gn_pipeline_check. */
static void pipelines(void **state)
{
    gn_pipeline all = good_pipeline();

    met_count = 0;
    NO_ENUM(raster.polygon_mode_back, GN_POLYGON_POINT);
    NO_ENUM(raster.polygon_mode_front, GN_POLYGON_POINT);
    NO_ENUM(raster.point_origin, GN_POINT_LOWER_LEFT);
    FAULT(raster.line_width, -1.0f, GN_OUT_OF_RANGE);
    FAULT(raster.line_width, INFINITY, GN_NOT_FINITE);
    FAULT(raster.point_size, -1.0f, GN_OUT_OF_RANGE);
    FAULT(raster.point_size, NAN, GN_NOT_FINITE);
    FAULT(samples.least_shading, 1.25f, GN_OUT_OF_RANGE);
    FAULT(samples.least_shading, NAN, GN_NOT_FINITE);
    ABOVE(samples.write_disabled, (1u << GN_SAMPLES) - 1, GN_OUT_OF_RANGE);
    NO_ENUM(color.logic_operation, GN_LOGIC_SET);
    NO_BLEND(7);
    FAULT_IN_WORDS(color.blend_constant[3], NAN, GN_NOT_FINITE, "a number of color.blend_constant");
    NO_BLEND(3);
    NO_BLEND(0);
    ABOVE(program.color_count, GN_MAX_COLORS, GN_OUT_OF_RANGE);
    NO_STENCIL_FACE(stencil.back);
    NO_STENCIL_FACE(stencil.front);
    NO_ENUM(depth.function, GN_ALWAYS);
    ABOVE(program.clip_distance_count, GN_MAX_CLIP_DISTANCES, GN_OUT_OF_RANGE);
    NO_ENUM(depth.clip_depth, GN_ZERO_TO_ONE);
    FAULT(raster.polygon_offset.clamp, NAN, GN_NOT_FINITE);
    FAULT(raster.polygon_offset.units, INFINITY, GN_NOT_FINITE);
    FAULT(raster.polygon_offset.factor, NAN, GN_NOT_FINITE);
    FAULT(depth.range.z_far, 1.5f, GN_OUT_OF_RANGE);
    FAULT(depth.range.z_near, -0.5f, GN_OUT_OF_RANGE);
    FAULT(depth.range.z_far, INFINITY, GN_NOT_FINITE);
    FAULT(depth.range.z_near, NAN, GN_NOT_FINITE);
    FAULT(raster.viewport.y, (float)GN_MAX_SIZE + 1.0f, GN_INVALID_VIEWPORT);
    FAULT(raster.viewport.x, -(float)GN_MAX_SIZE - 1.0f, GN_INVALID_VIEWPORT);
    FAULT(raster.viewport.height, -(float)GN_MAX_SIZE - 1.0f, GN_INVALID_VIEWPORT);
    FAULT(raster.viewport.width, -1.0f, GN_INVALID_VIEWPORT);
    FAULT(raster.viewport.height, -INFINITY, GN_NOT_FINITE);
    FAULT(raster.viewport.width, NAN, GN_NOT_FINITE);
    FAULT(raster.viewport.y, INFINITY, GN_NOT_FINITE);
    FAULT(raster.viewport.x, NAN, GN_NOT_FINITE);
    NO_ENUM(raster.front_face, GN_FRONT_CLOCKWISE);
    NO_ENUM(raster.cull, GN_CULL_FRONT_AND_BACK);
    NO_ENUM(raster.provoking_vertex, GN_PROVOKING_FIRST);
    NO_ENUM(raster.topology, GN_LINE_LOOP);
    FAULT_IN_WORDS(program.interpolated_at[2], (gn_interpolation_point)3, GN_INVALID_ENUM,
                   "program.interpolated_at");
    FAULT_IN_WORDS(program.interpolation[2], (gn_interpolation)3, GN_INVALID_ENUM,
                   "program.interpolation");
    ABOVE(program.varying_count, GN_MAX_VARYINGS, GN_TOO_MANY_VARYINGS);
    FAULT_IN_WORDS(program.fragment_writes_sample_mask, true, GN_NO_SHADER,
                   "program.fragment_writes_sample_mask,");
    FAULT_IN_WORDS(program.fragment_writes_depth, true, GN_NO_SHADER,
                   "program.fragment_writes_depth,");
    FAULT_IN_WORDS(program.fragment_discards, true, GN_NO_SHADER, "program.fragment_discards,");
    FAULT(program.vertex_shader, NULL, GN_NO_SHADER);
    assert_int_equal(gn_pipeline_check(NULL, NULL), GN_NULL_POINTER);
    assert_string_equal(fault_of_pipeline(NULL), "the pipeline is null");
}

/* What is not on is not looked at. */
static void valid_pipelines(void **state)
{
    gn_pipeline p;

    VALID(raster.point_size, 1e30f);
    VALID(raster.line_width, 1e30f);
    VALID(raster.viewport.width, (float)GN_MAX_SIZE);
    VALID(raster.viewport.height, -(float)GN_MAX_SIZE);
    VALID(raster.viewport.x, -(float)GN_MAX_SIZE);
    VALID(raster.polygon_offset.clamp, -0.5f);
    VALID(raster.scissor, ((gn_scissor){true, INT32_MIN, INT32_MAX, UINT32_MAX, 0}));
    VALID(depth.range, ((gn_depth_range){true, 1.0f, 0.0f})); /* reversed */
    VALID(program.interpolation[3], (gn_interpolation)3);

    memset(&p, 0, sizeof p);
    p.program.vertex_shader = pass_positions;
    p.raster.viewport.width = p.raster.polygon_offset.factor = NAN;
    p.depth.range.z_near = p.samples.least_shading = NAN;
    p.color.blend_constant[3] = INFINITY;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.color.blend[GN_MAX_COLORS - 1].enabled = true;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
}

/* A target with colour needs a fragment shader; a target without colour does not. gn_draw
 * agrees. */
static void pipelines_and_targets(void **state)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 3)];
    const gn_surface color = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, 2, 2);
    const gn_surface depth = gn_surface_bottom_up(words, GN_FORMAT_D24, 2, 2);
    const gn_target targets[] = {{{color}, {0}}, {{[3] = color}, {0}}, {.depth = depth}};
    const gn_pipeline p = good_pipeline();
    const gn_mesh none = {0};

    for (int i = 0; i < 3; ++i) {
        gn_workspace workspace = {.memory = memory, .size = sizeof memory};
        const gn_status expected = i < 2 ? GN_NO_SHADER : GN_OK;
        const char *const fault = gn_draw_fault(&targets[i], &p, &none, &workspace);

        assert_null(fault_of_target(&targets[i]));
        assert_int_equal(gn_pipeline_check(&p, &targets[i]), expected);
        assert_int_equal(gn_draw(&targets[i], &p, &none, &workspace), expected);
        if (i < 2)
            assert_string_equal(fault,
                                "program.fragment_shader is null, but the target has colour");
        else
            assert_null(fault);
    }
}

#define MESH_FAULT(member, value, status, words)                                                   \
    do {                                                                                           \
        gn_mesh one = good_mesh();                                                                 \
        one.member = all.member = (value);                                                         \
        expect(gn_mesh_check(&one), status, fault_of_mesh(&one), fault_of_mesh(&all), words);      \
    } while (0)

/* In gnomon/draw.h, at gn_mesh_check. */
static void meshes(void **state)
{
    gn_mesh all = good_mesh(), m;

    met_count = 0;
    MESH_FAULT(first, 1, GN_INDEX_OUT_OF_RANGE, "first + count ");
    MESH_FAULT(count, 5, GN_INDEX_OUT_OF_RANGE, "count ");
    for (int a = GN_MAX_ATTRIBUTES; a-- > 0;) {
        char name[32];

        snprintf(name, sizeof name, "attribute[%d].", a);
        MESH_FAULT(attribute[a].stride, 7, GN_INVALID_ATTRIBUTE, name);
        MESH_FAULT(attribute[a].components, a % 2 ? 0 : 5, GN_INVALID_ATTRIBUTE, name);
        MESH_FAULT(attribute[a].data, (const float *)(const void *)((const char *)words + 1),
                   GN_MISALIGNED, name);
    }
    for (int format = GN_INDEX_UINT16; format <= GN_INDEX_UINT32; ++format) {
        m = good_mesh();
        m.index_format = (gn_index_format)format;
        m.indices = (const char *)words + format - 1;
        assert_int_equal(gn_mesh_check(&m), GN_MISALIGNED);
        assert_string_equal(fault_of_mesh(&m), "indices is not aligned to an index");
    }
    MESH_FAULT(index_format, GN_INDEX_UINT16, GN_NULL_POINTER, "indices is null");
    MESH_FAULT(restart, (gn_restart)(GN_RESTART_INDEX + 1), GN_INVALID_ENUM, "restart ");
    MESH_FAULT(index_format, (gn_index_format)4, GN_INVALID_ENUM, "index_format ");
    assert_int_equal(gn_mesh_check(NULL), GN_NULL_POINTER);
    assert_string_equal(fault_of_mesh(NULL), "the mesh is null");
}

static void ranges_and_indices(void **state)
{
    static const uint8_t bytes[6] = {0, 1, 2, 3, 4, 200};
    static const uint16_t shorts[6] = {0, 1, 2, 3, 4, 60000};
    static const uint32_t longs[6] = {0, 1, 2, 3, 4, UINT32_MAX};
    const void *const indices[] = {NULL, bytes, shorts, longs};
    static const struct {
        int indexed;
        uint32_t first, count, vertices;
        gn_status status;
    } cases[] = {{0, 0, 4, 4, GN_OK},
                 {0, 4, 0, 4, GN_OK},
                 {0, 1, 4, 4, GN_INDEX_OUT_OF_RANGE},
                 {0, UINT32_MAX, 2, 4, GN_INDEX_OUT_OF_RANGE},
                 {1, 0, 4, 4, GN_OK},
                 {1, 0, 5, 4, GN_INDEX_OUT_OF_RANGE},
                 {1, 0, 5, 5, GN_OK},
                 {1, 1, 5, 5, GN_INDEX_OUT_OF_RANGE}};

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
        for (int format = cases[i].indexed; format <= 3 * cases[i].indexed; ++format) {
            gn_mesh m = good_mesh();

            m.index_format = (gn_index_format)format;
            m.indices = indices[format];
            m.first = cases[i].first;
            m.count = cases[i].count;
            m.vertex_count = cases[i].vertices;
            assert_int_equal(gn_mesh_check(&m), cases[i].status);
            if (cases[i].indexed && cases[i].status != GN_OK)
                assert_string_equal(fault_of_mesh(&m),
                                    "an index, with base_vertex, is not below vertex_count");
        }
}

static gn_surface *surface_of(gn_target *t, int i)
{
    return i == 0 ? &t->depth : i == 1 ? &t->color[5] : &t->color[0];
}

#define SURFACE_FAULT(member, value, status)                                                       \
    do {                                                                                           \
        static const char *const names[] = {"depth." #member " ", "color[5]." #member " ",         \
                                            "color[0]." #member " "};                              \
        gn_target one = good_target();                                                             \
        surface_of(&one, i)->member = surface_of(&all, i)->member = (value);                       \
        expect(gn_target_check(&one), status, fault_of_target(&one), fault_of_target(&all),        \
               names[i]);                                                                          \
    } while (0)

/* In gnomon/surface.h, at gn_target_check. */
static void targets(void **state)
{
    static const gn_format wrong[] = {GN_FORMAT_R8, GN_FORMAT_D24, GN_FORMAT_D16};
    gn_target all = good_target(), none = {0};

    met_count = 0;
    assert_null(fault_of_target(&all));
    none.depth.samples = 3;
    for (int i = 0; i < 2; ++i) {
        SURFACE_FAULT(samples, 0, GN_SIZE_MISMATCH);
        SURFACE_FAULT(height, 3, GN_SIZE_MISMATCH);
        SURFACE_FAULT(width, 3, GN_SIZE_MISMATCH);
    }
    all = good_target();
    for (int i = 0; i < 3; ++i) {
        SURFACE_FAULT(sample_stride, PTRDIFF_MAX / 4 * 4, GN_INVALID_STRIDE);
        SURFACE_FAULT(sample_stride, 12, GN_INVALID_STRIDE);
        SURFACE_FAULT(sample_stride, 66, GN_MISALIGNED);
        SURFACE_FAULT(samples, 3, GN_INVALID_SAMPLES);
        SURFACE_FAULT(row_stride, PTRDIFF_MAX / 4 * 4, GN_INVALID_STRIDE);
        SURFACE_FAULT(row_stride, 12, GN_INVALID_STRIDE);
        SURFACE_FAULT(row_stride, 18, GN_MISALIGNED);
        SURFACE_FAULT(pixels, (char *)words + 2, GN_MISALIGNED);
        SURFACE_FAULT(pixels, NULL, GN_NULL_POINTER);
        SURFACE_FAULT(height, GN_MAX_SIZE + 1, GN_INVALID_SIZE);
        SURFACE_FAULT(width, 0, GN_INVALID_SIZE);
        SURFACE_FAULT(format, wrong[i], GN_INVALID_FORMAT);
    }
    all.color[0].format = (gn_format)200;
    assert_string_equal(fault_of_target(&all), "color[0].format does not belong there");
    assert_int_equal(gn_target_check(&none), GN_NO_SURFACE);
    assert_string_equal(fault_of_target(&none), "no color and no depth has a format");
    assert_int_equal(gn_target_check(NULL), GN_NULL_POINTER);
    assert_string_equal(fault_of_target(NULL), "the target is null");
}

/* In gnomon/draw.h, at gn_draw: what remains after target, pipeline and mesh. The back end that no
 * library has is last before the indices. */
static void workspaces(void **state)
{
    static const uint8_t beyond = 4;
    const gn_target target = {.depth = good_target().depth};
    gn_pipeline pipeline = good_pipeline();
    gn_mesh mesh = good_mesh();
    gn_workspace good = good_workspace(), all = good;

    pipeline.program.clip_distance_count = 2;
    assert_null(gn_draw_fault(&target, &pipeline, &mesh, &good));
    mesh.index_format = GN_INDEX_UINT8;
    mesh.indices = &beyond;
    mesh.count = 1;
    met_count = 0;
#define WORKSPACE_FAULT(member, value, status, words)                                              \
    do {                                                                                           \
        gn_workspace one = good;                                                                   \
        one.member = all.member = (value);                                                         \
        expect(gn_draw(&target, &pipeline, &mesh, &one), status,                                   \
               gn_draw_fault(&target, &pipeline, &mesh, &one),                                     \
               gn_draw_fault(&target, &pipeline, &mesh, &all), words);                             \
    } while (0)
    WORKSPACE_FAULT(size, good.size, GN_INDEX_OUT_OF_RANGE, "an index, with base_vertex,");
    WORKSPACE_FAULT(backend, GN_BACKEND_COUNT, GN_BACKEND_UNAVAILABLE, "workspace.backend ");
    WORKSPACE_FAULT(size, gn_workspace_size(0, 5) - 1, GN_WORKSPACE_TOO_SMALL, "workspace.size ");
    WORKSPACE_FAULT(memory, NULL, GN_NULL_POINTER, "workspace.memory ");
    assert_string_equal(gn_draw_fault(&target, &pipeline, &mesh, NULL), "the workspace is null");
    mesh.restart = (gn_restart)(GN_RESTART_INDEX + 1);
    assert_string_equal(gn_draw_fault(&target, &pipeline, &mesh, NULL), "restart is no gn_restart");
    assert_string_equal(gn_draw_fault(&target, NULL, &mesh, NULL), "the pipeline is null");
    assert_string_equal(gn_draw_fault(NULL, NULL, NULL, NULL), "the target is null");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pipelines),
        cmocka_unit_test(valid_pipelines),
        cmocka_unit_test(pipelines_and_targets),
        cmocka_unit_test(meshes),
        cmocka_unit_test(ranges_and_indices),
        cmocka_unit_test(targets),
        cmocka_unit_test(workspaces),
    };
    return cmocka_run_group_tests_name("pipeline", tests, NULL, NULL);
}
