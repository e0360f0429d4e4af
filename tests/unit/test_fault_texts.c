/* The texts of faults: every fault has its own, which names the field, and it agrees with the
 * status. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "unit.h"

#define MAX_TEXTS 256

/* The texts seen so far. */
static const char *met[MAX_TEXTS];
static int met_count;

/* Checks the text of a fault: it begins with the field's name and is new. */
static void expect(gn_status status, gn_status expected, const char *text, const char *field)
{
    assert_int_equal(status, expected);
    assert_non_null(text);
    assert_true(strlen(text) > strlen(field) + 2);
    if (strncmp(text, field, strlen(field)) != 0)
        fail_msg("'%s' does not begin with '%s'", text, field);
    for (int i = 0; i < met_count; ++i)
        assert_string_not_equal(text, met[i]);
    assert_true(met_count < MAX_TEXTS);
    met[met_count++] = text;
}

static void no_vertices(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)uniforms;
    (void)in;
    (void)out;
}

static gn_pipeline p;

/* Tests the pipeline with one fault and then without it. */
static void expect_pipeline(gn_status expected, const char *field)
{
    expect(gn_pipeline_check(&p, NULL), expected, gn_pipeline_fault(&p, NULL), field);
    memset(&p, 0, sizeof p);
    p.program.vertex_shader = no_vertices;
    assert_null(gn_pipeline_fault(&p, NULL));
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
}

/* Sets a member above its largest value. */
#define ABOVE(member, largest)                                                                     \
    do {                                                                                           \
        p.member = (largest);                                                                      \
        assert_null(gn_pipeline_fault(&p, NULL));                                                  \
        ++p.member;                                                                                \
        expect_pipeline(GN_INVALID_ENUM, #member " is no gn_");                                    \
    } while (0)

#define NUMBER(group, member, value, status)                                                       \
    do {                                                                                           \
        p.group.set = true;                                                                        \
        p.group.member = (value);                                                                  \
        expect_pipeline(status, #group "." #member " ");                                           \
    } while (0)

#define SHADING(value, status)                                                                     \
    do {                                                                                           \
        p.samples.least_shading = (value);                                                         \
        assert_null(gn_pipeline_fault(&p, NULL));                                                  \
        p.samples.shading = true;                                                                  \
        expect_pipeline(status, "samples.least_shading ");                                         \
    } while (0)

static void pipelines(void **state)
{
    (void)state;
    met_count = 0;
    expect(gn_pipeline_check(NULL, NULL), GN_NULL_POINTER, gn_pipeline_fault(NULL, NULL),
           "the pipeline");
    memset(&p, 0, sizeof p);
    expect_pipeline(GN_NO_SHADER, "program.vertex_shader");
    p.program.fragment_discards = true;
    expect_pipeline(GN_NO_SHADER, "program.fragment_discards");
    p.program.fragment_writes_sample_mask = true;
    expect_pipeline(GN_NO_SHADER, "program.fragment_writes_sample_mask");
    p.program.fragment_writes_depth = true;
    expect_pipeline(GN_NO_SHADER, "program.fragment_writes_depth");
    p.program.varying_count = GN_MAX_VARYINGS + 1;
    expect_pipeline(GN_TOO_MANY_VARYINGS, "program.varying_count");
    p.program.varying_count = 3;
    p.program.interpolation[2] = (gn_interpolation)3;
    expect_pipeline(GN_INVALID_ENUM, "program.interpolation");
    p.program.varying_count = 3;
    p.program.location[2] = (gn_varying_location)3;
    expect_pipeline(GN_INVALID_ENUM, "program.location");
    ABOVE(raster.topology, GN_LINE_LOOP);
    ABOVE(raster.provoking_vertex, GN_PROVOKING_FIRST);
    ABOVE(raster.cull, GN_CULL_FRONT_AND_BACK);
    ABOVE(raster.front_face, GN_FRONT_CLOCKWISE);
    ABOVE(depth.clip_depth, GN_ZERO_TO_ONE);
    ABOVE(depth.function, GN_ALWAYS);
    ABOVE(stencil.front.function, GN_ALWAYS);
    ABOVE(stencil.front.fail, GN_STENCIL_DECREMENT_WRAP);
    ABOVE(stencil.front.depth_fail, GN_STENCIL_DECREMENT_WRAP);
    ABOVE(stencil.front.pass, GN_STENCIL_DECREMENT_WRAP);
    ABOVE(stencil.back.function, GN_ALWAYS);
    ABOVE(stencil.back.fail, GN_STENCIL_DECREMENT_WRAP);
    ABOVE(stencil.back.depth_fail, GN_STENCIL_DECREMENT_WRAP);
    ABOVE(stencil.back.pass, GN_STENCIL_DECREMENT_WRAP);
    ABOVE(color.blend[3].equation, GN_EQUATION_MAX);
    ABOVE(color.blend[3].source, GN_FACTOR_SOURCE_ALPHA_SATURATE);
    ABOVE(color.blend[3].destination, GN_FACTOR_SOURCE_ALPHA_SATURATE);
    ABOVE(color.blend[3].alpha_equation, GN_EQUATION_MAX);
    ABOVE(color.blend[3].alpha_source, GN_FACTOR_SOURCE_ALPHA_SATURATE);
    ABOVE(color.blend[3].alpha_destination, GN_FACTOR_SOURCE_ALPHA_SATURATE);
    ABOVE(color.logic_operation, GN_LOGIC_SET);
    ABOVE(raster.point_origin, GN_POINT_LOWER_LEFT);
    ABOVE(raster.polygon_mode_front, GN_POLYGON_POINT);
    ABOVE(raster.polygon_mode_back, GN_POLYGON_POINT);
    NUMBER(raster.viewport, x, NAN, GN_NOT_FINITE);
    NUMBER(raster.viewport, y, INFINITY, GN_NOT_FINITE);
    NUMBER(raster.viewport, width, NAN, GN_NOT_FINITE);
    NUMBER(raster.viewport, height, -INFINITY, GN_NOT_FINITE);
    NUMBER(raster.viewport, x, -1e5f, GN_INVALID_VIEWPORT);
    NUMBER(raster.viewport, y, 1e5f, GN_INVALID_VIEWPORT);
    NUMBER(raster.viewport, width, -1.0f, GN_INVALID_VIEWPORT);
    NUMBER(raster.viewport, height, 1e5f, GN_INVALID_VIEWPORT);
    SHADING(NAN, GN_NOT_FINITE);
    SHADING(1.25f, GN_OUT_OF_RANGE);
    NUMBER(depth.range, z_near, NAN, GN_NOT_FINITE);
    NUMBER(depth.range, z_far, INFINITY, GN_NOT_FINITE);
    NUMBER(depth.range, z_near, -0.5f, GN_OUT_OF_RANGE);
    NUMBER(depth.range, z_far, 1.5f, GN_OUT_OF_RANGE);
    NUMBER(raster.polygon_offset, factor, NAN, GN_NOT_FINITE);
    NUMBER(raster.polygon_offset, units, INFINITY, GN_NOT_FINITE);
    NUMBER(raster.polygon_offset, clamp, NAN, GN_NOT_FINITE);
    p.program.clip_distance_count = GN_MAX_CLIP_DISTANCES + 1;
    expect_pipeline(GN_OUT_OF_RANGE, "program.clip_distance_count");
    p.program.color_count = GN_MAX_COLORS + 1;
    expect_pipeline(GN_OUT_OF_RANGE, "program.color_count");
    p.color.write_disabled[7] = 16;
    expect_pipeline(GN_OUT_OF_RANGE, "color.write_disabled[7]");
    p.color.blend[1].enabled = true;
    p.color.blend_constant[3] = NAN;
    expect_pipeline(GN_NOT_FINITE, "a number of color.blend_constant");
    p.samples.write_disabled = 1u << GN_SAMPLES;
    expect_pipeline(GN_OUT_OF_RANGE, "samples.write_disabled");
    p.raster.point_size = NAN;
    expect_pipeline(GN_NOT_FINITE, "raster.point_size");
    p.raster.point_size = -1.0f;
    expect_pipeline(GN_OUT_OF_RANGE, "raster.point_size");
    p.raster.line_width = INFINITY;
    expect_pipeline(GN_NOT_FINITE, "raster.line_width");
    p.raster.line_width = -1.0f;
    expect_pipeline(GN_OUT_OF_RANGE, "raster.line_width");
}

/* A target with colour needs a fragment shader; a target without colour does not. gn_draw
 * agrees. */
static void pipelines_and_targets(void **state)
{
    (void)state;
    static uint32_t pixels[4];
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 0)];
    gn_target colored = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, 2, 2)}, {0}};
    gn_target second = {0};
    gn_target depth = {.depth = gn_surface_bottom_up(pixels, GN_FORMAT_D24, 2, 2)};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh none = {0};

    second.color[3] = colored.color[0];
    memset(&p, 0, sizeof p);
    p.program.vertex_shader = no_vertices;
    const gn_target *const targets[] = {&colored, &second};
    for (int i = 0; i < 2; ++i) {
        assert_int_equal(gn_pipeline_check(&p, targets[i]), GN_NO_SHADER);
        assert_string_equal(gn_pipeline_fault(&p, targets[i]),
                            "program.fragment_shader is null, but the target has colour");
        assert_int_equal(gn_draw(targets[i], &p, &none, &workspace), GN_NO_SHADER);
    }
    assert_int_equal(gn_pipeline_check(&p, &depth), GN_OK);
    assert_null(gn_pipeline_fault(&p, &depth));
    assert_int_equal(gn_draw(&depth, &p, &none, &workspace), GN_OK);
}

static gn_mesh mesh;
static uint32_t words[64];

static void expect_mesh(gn_status expected, const char *field)
{
    expect(gn_mesh_check(&mesh), expected, gn_mesh_fault(&mesh), field);
    memset(&mesh, 0, sizeof mesh);
    assert_null(gn_mesh_fault(&mesh));
}

static void meshes(void **state)
{
    (void)state;
    char name[32];

    met_count = 0;
    memset(&mesh, 0, sizeof mesh);
    expect(gn_mesh_check(NULL), GN_NULL_POINTER, gn_mesh_fault(NULL), "the mesh");
    mesh.index_format = (gn_index_format)(GN_INDEX_UINT32 + 1);
    expect_mesh(GN_INVALID_ENUM, "index_format");
    mesh.restart = (gn_restart)(GN_RESTART_INDEX + 1);
    expect_mesh(GN_INVALID_ENUM, "restart");
    mesh.index_format = GN_INDEX_UINT8;
    mesh.count = 1;
    expect_mesh(GN_NULL_POINTER, "indices");
    mesh.index_format = GN_INDEX_UINT32;
    mesh.indices = (const char *)words + 2;
    expect_mesh(GN_MISALIGNED, "indices");
    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        snprintf(name, sizeof name, "attribute[%d].", a);
        mesh.attribute[a].data = (const float *)(const void *)((const char *)words + 1);
        expect_mesh(GN_MISALIGNED, name);
        mesh.attribute[a].data = (const float *)words;
        expect_mesh(GN_INVALID_ATTRIBUTE, name);
        mesh.attribute[a].data = (const float *)words;
        mesh.attribute[a].components = 4;
        mesh.attribute[a].stride = 7;
        expect_mesh(GN_INVALID_ATTRIBUTE, name);
    }
    mesh.vertex_count = 3;
    mesh.count = 4;
    expect_mesh(GN_INDEX_OUT_OF_RANGE, "count");
    mesh.vertex_count = 3;
    mesh.count = 3;
    mesh.first = 1;
    expect_mesh(GN_INDEX_OUT_OF_RANGE, "first + count");
    words[0] = 5;
    mesh.index_format = GN_INDEX_UINT32;
    mesh.indices = words;
    mesh.count = 1;
    mesh.vertex_count = 5;
    expect_mesh(GN_INDEX_OUT_OF_RANGE, "an index");
}

static gn_target target;

static void reset_target(void)
{
    memset(&target, 0, sizeof target);
    target.color[0] = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, 4, 4);
    target.color[5] = target.color[0];
    target.depth = gn_surface_bottom_up(words, GN_FORMAT_D24, 4, 4);
}

static void expect_target(gn_status expected, const char *field)
{
    expect(gn_target_check(&target), expected, gn_target_fault(&target), field);
    reset_target();
    assert_null(gn_target_fault(&target));
}

static void targets(void **state)
{
    (void)state;
    met_count = 0;
    expect(gn_target_check(NULL), GN_NULL_POINTER, gn_target_fault(NULL), "the target");
    memset(&target, 0, sizeof target);
    expect_target(GN_NO_SURFACE, "no color and no depth");
    for (int i = 0; i < 3; ++i) {
        gn_surface *const s = i == 2 ? &target.depth : &target.color[5 * i];
        const char *const name = i == 0 ? "color[0]." : i == 1 ? "color[5]." : "depth.";

        s->format = i < 2 ? GN_FORMAT_D24 : GN_FORMAT_RGBA8;
        expect_target(GN_INVALID_FORMAT, name);
        s->width = 0;
        expect_target(GN_INVALID_SIZE, name);
        s->height = GN_MAX_SIZE + 1;
        expect_target(GN_INVALID_SIZE, name);
        s->pixels = NULL;
        expect_target(GN_NULL_POINTER, name);
        s->pixels = (char *)words + 2;
        expect_target(GN_MISALIGNED, name);
        s->row_stride = 18;
        expect_target(GN_MISALIGNED, name);
        s->row_stride = 12;
        expect_target(GN_INVALID_STRIDE, name);
        s->row_stride = PTRDIFF_MAX / 4 * 4;
        expect_target(GN_INVALID_STRIDE, name);
        s->samples = 3;
        expect_target(GN_INVALID_SAMPLES, name);
        *s = gn_surface_multisampled(s);
        s->sample_stride = 66;
        expect_target(GN_MISALIGNED, name);
        *s = gn_surface_multisampled(s);
        s->sample_stride = 12;
        expect_target(GN_INVALID_STRIDE, name);
        *s = gn_surface_multisampled(s);
        s->sample_stride = PTRDIFF_MAX / 4 * 4;
        expect_target(GN_INVALID_STRIDE, name);
    }
    for (int i = 0; i < 2; ++i) {
        gn_surface *const s = i == 0 ? &target.color[5] : &target.depth;
        const char *const name = i == 0 ? "color[5]." : "depth.";

        s->width = 3;
        expect_target(GN_SIZE_MISMATCH, name);
        s->height = 3;
        expect_target(GN_SIZE_MISMATCH, name);
        *s = gn_surface_multisampled(s);
        expect_target(GN_SIZE_MISMATCH, name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pipelines),
        cmocka_unit_test(pipelines_and_targets),
        cmocka_unit_test(meshes),
        cmocka_unit_test(targets),
    };
    return cmocka_run_group_tests_name("faults", tests, NULL, NULL);
}
