/* Every fault of a pipeline and of a mesh, and workspace sizes. */
#include <math.h>
#include <string.h>

#include "unit.h"

static void no_vertices(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)uniforms;
    (void)in;
    (void)out;
}

static gn_pipeline good_pipeline(void)
{
    gn_pipeline p;

    memset(&p, 0, sizeof p);
    p.program.vertex_shader = no_vertices;
    return p;
}

static void zero_state_is_valid(void **state)
{
    (void)state;
    const gn_pipeline p = good_pipeline();

    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    assert_int_equal(gn_pipeline_check(NULL, NULL), GN_NULL_POINTER);
}

static void pipeline_faults(void **state)
{
    (void)state;
    gn_pipeline p = good_pipeline();

    p.program.vertex_shader = NULL;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NO_SHADER);
    p = good_pipeline();
    p.program.varying_count = GN_MAX_VARYINGS + 1;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_TOO_MANY_VARYINGS);
    p = good_pipeline();
    p.program.varying_count = 3;
    p.program.interpolation[2] = (gn_interpolation)3;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    p.program.varying_count = 2;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);

    p = good_pipeline();
    p.raster.topology = (gn_topology)(GN_LINE_LOOP + 1);
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    p = good_pipeline();
    p.raster.provoking_vertex = (gn_provoking_vertex)2;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    p = good_pipeline();
    p.raster.cull = (gn_cull)4;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    p = good_pipeline();
    p.raster.front_face = (gn_front_face)2;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    p = good_pipeline();
    p.program.clip_distance_count = GN_MAX_CLIP_DISTANCES + 1;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OUT_OF_RANGE);
    p.program.clip_distance_count = GN_MAX_CLIP_DISTANCES;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.depth.clip_depth = (gn_clip_depth)2;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    p = good_pipeline();
    p.depth.function = (gn_compare)(GN_ALWAYS + 1);
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    for (int member = 0; member < 8; ++member) {
        p = good_pipeline();
        gn_stencil_face *f = member < 4 ? &p.stencil.front : &p.stencil.back;
        if (member % 4 == 0)
            f->function = (gn_compare)(GN_ALWAYS + 1);
        else if (member % 4 == 1)
            f->fail = (gn_stencil_operation)8;
        else if (member % 4 == 2)
            f->depth_fail = (gn_stencil_operation)8;
        else
            f->pass = (gn_stencil_operation)8;
        assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    }
    p = good_pipeline();
    p.program.fragment_discards = true;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NO_SHADER);
    p = good_pipeline();
    p.program.fragment_writes_depth = true;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NO_SHADER);
    p = good_pipeline();
    p.program.fragment_writes_sample_mask = true;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NO_SHADER);
}

static void color_state_faults(void **state)
{
    (void)state;
    gn_pipeline p = good_pipeline();

    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        p = good_pipeline();
        p.color.write_disabled[i] = GN_CHANNEL_ALL;
        assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
        p.color.write_disabled[i] = GN_CHANNEL_ALL + 1;
        assert_int_equal(gn_pipeline_check(&p, NULL), GN_OUT_OF_RANGE);
    }
    p = good_pipeline();
    p.program.color_count = GN_MAX_COLORS;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.program.color_count = GN_MAX_COLORS + 1;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OUT_OF_RANGE);

    for (int member = 0; member < 6; ++member) {
        p = good_pipeline();
        gn_blend *b = &p.color.blend[member];
        const int last = member < 2 ? GN_EQUATION_MAX : GN_FACTOR_SOURCE_ALPHA_SATURATE;
        for (int value = last; value <= last + 1; ++value) {
            switch (member) {
            case 0:
                b->equation = (gn_blend_equation)value;
                break;
            case 1:
                b->alpha_equation = (gn_blend_equation)value;
                break;
            case 2:
                b->source = (gn_blend_factor)value;
                break;
            case 3:
                b->destination = (gn_blend_factor)value;
                break;
            case 4:
                b->alpha_source = (gn_blend_factor)value;
                break;
            default:
                b->alpha_destination = (gn_blend_factor)value;
                break;
            }
            assert_int_equal(gn_pipeline_check(&p, NULL), value == last ? GN_OK : GN_INVALID_ENUM);
        }
    }
    p = good_pipeline();
    p.color.blend_constant[3] = INFINITY;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK); /* not enabled, so not checked */
    p.color.blend[GN_MAX_COLORS - 1].enabled = true;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);

    p = good_pipeline();
    p.color.logic_operation = GN_LOGIC_SET;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.color.logic_operation = (gn_logic_operation)16;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
}

static void size_faults(void **state)
{
    (void)state;
    gn_pipeline p = good_pipeline();

    p.raster.point_size = 1e30f;
    p.raster.line_width = 1e30f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.raster.point_size = -1.0f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OUT_OF_RANGE);
    p.raster.point_size = NAN;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
    p = good_pipeline();
    p.samples.write_disabled = 16;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OUT_OF_RANGE);
    p.samples.write_disabled = 15;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.raster.line_width = -0.5f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OUT_OF_RANGE);
    p.raster.line_width = INFINITY;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
    p = good_pipeline();
    p.raster.polygon_mode_front = (gn_polygon_mode)3;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
    p.raster.polygon_mode_front = GN_POLYGON_POINT;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.raster.polygon_mode_back = (gn_polygon_mode)3;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_ENUM);
}

static void viewport_faults(void **state)
{
    (void)state;
    gn_pipeline p = good_pipeline();

    p.raster.viewport.width = NAN;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK); /* not set, so not checked */
    p.raster.viewport.set = true;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
    p.raster.viewport.width = -1.0f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_VIEWPORT);
    p.raster.viewport.width = (float)GN_MAX_SIZE;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.raster.viewport.height = (float)GN_MAX_SIZE + 1.0f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_VIEWPORT);
    p.raster.viewport.height = 1.0f;
    p.raster.viewport.x = -(float)GN_MAX_SIZE - 1.0f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_INVALID_VIEWPORT);
    p.raster.viewport.x = 0.0f;
    p.raster.viewport.y = INFINITY;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
}

static void depth_range_faults(void **state)
{
    (void)state;
    gn_pipeline p = good_pipeline();

    p.depth.range.z_near = NAN;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.depth.range.set = true;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
    p.depth.range.z_near = 1.0f;
    p.depth.range.z_far = 0.25f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.depth.range.z_far = 1.5f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OUT_OF_RANGE);
    p.depth.range.z_far = -0.5f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OUT_OF_RANGE);
}

static void any_scissor_is_valid(void **state)
{
    (void)state;
    gn_pipeline p = good_pipeline();

    p.raster.scissor = (gn_scissor){true, INT32_MIN, INT32_MAX, UINT32_MAX, 0};
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
}

static void polygon_offset_faults(void **state)
{
    (void)state;
    gn_pipeline p = good_pipeline();

    p.raster.polygon_offset.factor = NAN;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
    p.raster.polygon_offset.set = true;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
    p.raster.polygon_offset = (gn_polygon_offset){true, 1.0f, INFINITY, 0.0f};
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
    p.raster.polygon_offset = (gn_polygon_offset){true, 1.0f, 1.0f, NAN};
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_NOT_FINITE);
    p.raster.polygon_offset.clamp = -0.5f;
    assert_int_equal(gn_pipeline_check(&p, NULL), GN_OK);
}

static const float positions[8] = {0};

static gn_mesh good_mesh(void)
{
    gn_mesh m;

    memset(&m, 0, sizeof m);
    m.attribute[0].data = positions;
    m.attribute[0].components = 2;
    m.vertex_count = 4;
    m.count = 4;
    return m;
}

static void mesh_faults(void **state)
{
    (void)state;
    static const uint32_t indices[4] = {0, 1, 2, 3};
    gn_mesh m = good_mesh();

    assert_int_equal(gn_mesh_check(&m), GN_OK);
    assert_int_equal(gn_mesh_check(NULL), GN_NULL_POINTER);
    m.index_format = (gn_index_format)4;
    assert_int_equal(gn_mesh_check(&m), GN_INVALID_ENUM);
    m.index_format = GN_INDEX_UINT16;
    assert_int_equal(gn_mesh_check(&m), GN_NULL_POINTER);
    m.indices = (const char *)indices + 1;
    assert_int_equal(gn_mesh_check(&m), GN_MISALIGNED);
    m.index_format = GN_INDEX_UINT32;
    m.indices = (const char *)indices + 2;
    assert_int_equal(gn_mesh_check(&m), GN_MISALIGNED);

    m = good_mesh();
    m.attribute[3].data = (const float *)(const void *)((const char *)positions + 1);
    m.attribute[3].components = 1;
    assert_int_equal(gn_mesh_check(&m), GN_MISALIGNED);
    m.attribute[3].data = positions;
    m.attribute[3].components = 0;
    assert_int_equal(gn_mesh_check(&m), GN_INVALID_ATTRIBUTE);
    m.attribute[3].components = 5;
    assert_int_equal(gn_mesh_check(&m), GN_INVALID_ATTRIBUTE);
    m.attribute[3].components = 4;
    m.attribute[3].stride = 6;
    assert_int_equal(gn_mesh_check(&m), GN_INVALID_ATTRIBUTE);
}

static void ranges_and_indices(void **state)
{
    (void)state;
    static const uint8_t bytes[6] = {0, 1, 2, 3, 4, 200};
    static const uint16_t shorts[6] = {0, 1, 2, 3, 4, 60000};
    static const uint32_t words[6] = {0, 1, 2, 3, 4, UINT32_MAX};
    const void *indices[3] = {bytes, shorts, words};
    gn_mesh m = good_mesh();

    m.count = 5;
    assert_int_equal(gn_mesh_check(&m), GN_INDEX_OUT_OF_RANGE);
    m.first = 4;
    m.count = 0;
    assert_int_equal(gn_mesh_check(&m), GN_OK);
    m.first = 1;
    m.count = 4;
    assert_int_equal(gn_mesh_check(&m), GN_INDEX_OUT_OF_RANGE);
    m.first = UINT32_MAX;
    m.count = 2;
    assert_int_equal(gn_mesh_check(&m), GN_INDEX_OUT_OF_RANGE);

    for (int i = 0; i < 3; ++i) {
        m = good_mesh();
        m.index_format = (gn_index_format)(GN_INDEX_UINT8 + i);
        m.indices = indices[i];
        m.count = 4;
        assert_int_equal(gn_mesh_check(&m), GN_OK);
        m.count = 5;
        assert_int_equal(gn_mesh_check(&m), GN_INDEX_OUT_OF_RANGE);
        m.vertex_count = 5;
        assert_int_equal(gn_mesh_check(&m), GN_OK);
        m.first = 1;
        assert_int_equal(gn_mesh_check(&m), GN_INDEX_OUT_OF_RANGE);
    }
}

static void workspace_sizes(void **state)
{
    (void)state;
    const uint32_t counts[] = {0, 1, 15, 16, 17, 1000, 100000};

    for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i) {
        for (uint32_t v = 0; v <= GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES; v += 8) {
            assert_int_equal(gn_workspace_size(counts[i], v), GN_WORKSPACE_SIZE(counts[i], v));
            assert_true(gn_workspace_size(counts[i], v) >= gn_workspace_size(0, v));
        }
    }
    assert_int_equal(gn_workspace_size(1, GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES + 1), SIZE_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zero_state_is_valid),   cmocka_unit_test(pipeline_faults),
        cmocka_unit_test(viewport_faults),       cmocka_unit_test(depth_range_faults),
        cmocka_unit_test(mesh_faults),           cmocka_unit_test(ranges_and_indices),
        cmocka_unit_test(workspace_sizes),       cmocka_unit_test(any_scissor_is_valid),
        cmocka_unit_test(polygon_offset_faults), cmocka_unit_test(color_state_faults),
        cmocka_unit_test(size_faults),
    };
    return cmocka_run_group_tests_name("pipeline", tests, NULL, NULL);
}
