/* The order of checks that the headers state: faults are added from the last to the first, and each
 * one that is added is the one that is found, however many there are behind it. */
#include <math.h>
#include <string.h>

#include "unit.h"

static void no_vertices(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)uniforms;
    (void)in;
    (void)out;
}

static void expect_first(const char *text, const char *field)
{
    assert_non_null(text);
    if (strncmp(text, field, strlen(field)) != 0)
        fail_msg("'%s' is found before %s", text, field);
}

#define ADD(fault, field)                                                                          \
    do {                                                                                           \
        fault;                                                                                     \
        expect_first(gn_pipeline_fault(&p, NULL), field);                                          \
    } while (0)

/* In gnomon/pipeline.h, at gn_pipeline_check. */
static void pipelines(void **state)
{
    (void)state;
    gn_pipeline p = {0};

    p.program.vertex_shader = no_vertices;
    p.program.varying_count = 1;
    p.raster.viewport.set = p.depth.range.set = p.raster.polygon_offset.set = true;
    assert_null(gn_pipeline_fault(&p, NULL));
    ADD(p.raster.polygon_mode_back = (gn_polygon_mode)3, "raster.polygon_mode_back");
    ADD(p.raster.polygon_mode_front = (gn_polygon_mode)3, "raster.polygon_mode_front");
    ADD(p.raster.point_origin = (gn_point_origin)2, "raster.point_origin");
    ADD(p.raster.line_width = -1.0f, "raster.line_width");
    ADD(p.raster.point_size = NAN, "raster.point_size");
    p.samples.shading = true;
    ADD(p.samples.least_shading = NAN, "samples.least_shading");
    ADD(p.samples.write_disabled = 1u << GN_SAMPLES, "samples.write_disabled");
    ADD(p.color.logic_operation = (gn_logic_operation)16, "color.logic_operation");
    ADD(p.color.blend[7].source = (gn_blend_factor)99, "color.blend[7].source");
    ADD(p.color.write_disabled[7] = 16, "color.write_disabled[7]");
    ADD(p.color.blend[0].source = (gn_blend_factor)99, "color.blend[0].source");
    ADD(p.color.write_disabled[0] = 16, "color.write_disabled[0]");
    ADD(p.program.color_count = GN_MAX_COLORS + 1, "program.color_count");
    ADD(p.stencil.back.pass = (gn_stencil_operation)8, "stencil.back.pass");
    ADD(p.stencil.front.pass = (gn_stencil_operation)8, "stencil.front.pass");
    ADD(p.depth.function = (gn_compare)9, "depth.function");
    ADD(p.program.clip_distance_count = GN_MAX_CLIP_DISTANCES + 1, "program.clip_distance_count");
    ADD(p.depth.clip_depth = (gn_clip_depth)2, "depth.clip_depth");
    ADD(p.raster.polygon_offset.units = NAN, "raster.polygon_offset.units");
    ADD(p.depth.range.z_far = 2.0f, "depth.range.z_far");
    ADD(p.raster.viewport.width = -1.0f, "raster.viewport.width");
    ADD(p.raster.front_face = (gn_front_face)2, "raster.front_face");
    ADD(p.raster.cull = (gn_cull)4, "raster.cull");
    ADD(p.raster.provoking_vertex = (gn_provoking_vertex)2, "raster.provoking_vertex");
    ADD(p.raster.topology = (gn_topology)7, "raster.topology");
    ADD(p.program.location[0] = (gn_varying_location)3, "program.location");
    ADD(p.program.interpolation[0] = (gn_interpolation)3, "program.interpolation");
    ADD(p.program.varying_count = GN_MAX_VARYINGS + 1, "program.varying_count");
    ADD(p.program.fragment_discards = true, "program.fragment_discards");
    ADD(p.program.vertex_shader = NULL, "program.vertex_shader");
}

#undef ADD
#define ADD(fault, field)                                                                          \
    do {                                                                                           \
        fault;                                                                                     \
        expect_first(gn_target_fault(&t), field);                                                  \
    } while (0)

/* In gnomon/surface.h, at gn_target_check. */
static void targets(void **state)
{
    (void)state;
    static uint32_t pixels[2 * GN_SAMPLES * 4];
    gn_surface image = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, 2, 2);
    gn_target t = {0};

    t.color[0] = t.color[7] = gn_surface_multisampled(&image);
    image.format = GN_FORMAT_D24;
    t.depth = gn_surface_multisampled(&image);
    assert_null(gn_target_fault(&t));
    ADD(t.color[7].width = 1, "color[7].width is not that");
    ADD(t.depth.format = GN_FORMAT_R8, "depth.format");

    gn_surface *const s = &t.color[7];
    ADD(s->sample_stride = 0, "color[7].sample_stride is shorter");
    ADD(s->sample_stride = 2, "color[7].sample_stride is no multiple");
    ADD(s->samples = 3, "color[7].samples");
    ADD(s->row_stride = 0, "color[7].row_stride is shorter");
    ADD(s->row_stride = 2, "color[7].row_stride is no multiple");
    ADD(s->pixels = (unsigned char *)pixels + 1, "color[7].pixels is not aligned");
    ADD(s->pixels = NULL, "color[7].pixels is null");
    ADD(s->height = 0, "color[7].height");
    ADD(s->width = 0, "color[7].width");
    ADD(s->format = GN_FORMAT_D16, "color[7].format");
    ADD(t.color[0].format = GN_FORMAT_D16, "color[0].format");
    memset(&t, 0, sizeof t);
    ADD(t.depth.width = 0, "no color and no depth");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pipelines),
        cmocka_unit_test(targets),
    };

    return cmocka_run_group_tests_name("order of faults", tests, NULL, NULL);
}
