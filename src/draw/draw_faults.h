/* The first fault of a pipeline, a mesh and a workspace, in the order of their fields. */
#ifndef GN_DRAW_DRAW_FAULTS_H
#define GN_DRAW_DRAW_FAULTS_H

#include "../config/faults.h"
#include "../config/features.h"
#include "../scalars/bits.h"
#include "../kernel/shaders/ready_made.h"
#include "../formats/surface_memory.h"
#include "check.h"

static inline fault fault_of_viewport(const gn_viewport *v)
{
    const float limit = (float)GN_MAX_SIZE;

    if (!v->enabled)
        return NO_FAULT;
    FAULT_IF(!is_finite(v->x), GN_NOT_FINITE, "raster.viewport.x is not finite");
    FAULT_IF(!is_finite(v->y), GN_NOT_FINITE, "raster.viewport.y is not finite");
    FAULT_IF(!is_finite(v->width), GN_NOT_FINITE, "raster.viewport.width is not finite");
    FAULT_IF(!is_finite(v->height), GN_NOT_FINITE, "raster.viewport.height is not finite");
    FAULT_IF(v->width < 0.0f || v->width > limit, GN_INVALID_VIEWPORT,
             "raster.viewport.width is not in 0 to GN_MAX_SIZE");
    FAULT_IF(v->height < -limit || v->height > limit, GN_INVALID_VIEWPORT,
             "raster.viewport.height is not in -GN_MAX_SIZE to GN_MAX_SIZE");
    FAULT_IF(v->x < -limit || v->x > limit, GN_INVALID_VIEWPORT,
             "raster.viewport.x is not in -GN_MAX_SIZE to GN_MAX_SIZE");
    FAULT_IF(v->y < -limit || v->y > limit, GN_INVALID_VIEWPORT,
             "raster.viewport.y is not in -GN_MAX_SIZE to GN_MAX_SIZE");
    return NO_FAULT;
}

static inline fault fault_of_depth_range(const gn_depth_range *r)
{
    if (!r->enabled)
        return NO_FAULT;
    FAULT_IF(!is_finite(r->z_near), GN_NOT_FINITE, "depth.range.z_near is not finite");
    FAULT_IF(!is_finite(r->z_far), GN_NOT_FINITE, "depth.range.z_far is not finite");
    FAULT_IF(r->z_near < 0.0f || r->z_near > 1.0f, GN_OUT_OF_RANGE,
             "depth.range.z_near is not in 0 to 1");
    FAULT_IF(r->z_far < 0.0f || r->z_far > 1.0f, GN_OUT_OF_RANGE,
             "depth.range.z_far is not in 0 to 1");
    return NO_FAULT;
}

static inline fault fault_of_polygon_offset(const gn_polygon_offset *o)
{
    if (!o->enabled)
        return NO_FAULT;
    FAULT_IF(!is_finite(o->factor), GN_NOT_FINITE, "raster.polygon_offset.factor is not finite");
    FAULT_IF(!is_finite(o->units), GN_NOT_FINITE, "raster.polygon_offset.units is not finite");
    FAULT_IF(!is_finite(o->clamp), GN_NOT_FINITE, "raster.polygon_offset.clamp is not finite");
    return NO_FAULT;
}

#define NO_OPERATION " is no gn_stencil_operation"
#define OF_FACE(text) (is_back ? "stencil.back." text : "stencil.front." text)

static inline fault fault_of_stencil_face(const gn_stencil_face *f, bool is_back)
{
    const unsigned last = GN_STENCIL_DECREMENT_WRAP;

    (void)is_back;
    FAULT_IF((unsigned)f->function > GN_ALWAYS, GN_INVALID_ENUM,
             OF_FACE("function is no gn_compare"));
    FAULT_IF((unsigned)f->fail > last, GN_INVALID_ENUM, OF_FACE("fail" NO_OPERATION));
    FAULT_IF((unsigned)f->depth_fail > last, GN_INVALID_ENUM, OF_FACE("depth_fail" NO_OPERATION));
    FAULT_IF((unsigned)f->pass > last, GN_INVALID_ENUM, OF_FACE("pass" NO_OPERATION));
    return NO_FAULT;
}

#define NO_EQUATION " is no gn_blend_equation"
#define NO_FACTOR " is no gn_blend_factor"

/* Checks the blending of attachment i. */
static inline fault fault_of_blend(const gn_blend *b, int i, const float constant[4])
{
    const unsigned equation = GN_EQUATION_MAX, factor = GN_FACTOR_SOURCE_ALPHA_SATURATE;

    (void)i;
    FAULT_IF_EIGHTH((unsigned)b->equation > equation, i, GN_INVALID_ENUM, "color.blend",
                    ".equation" NO_EQUATION);
    FAULT_IF_EIGHTH((unsigned)b->source > factor, i, GN_INVALID_ENUM, "color.blend",
                    ".source" NO_FACTOR);
    FAULT_IF_EIGHTH((unsigned)b->destination > factor, i, GN_INVALID_ENUM, "color.blend",
                    ".destination" NO_FACTOR);
    FAULT_IF_EIGHTH((unsigned)b->alpha_equation > equation, i, GN_INVALID_ENUM, "color.blend",
                    ".alpha_equation" NO_EQUATION);
    FAULT_IF_EIGHTH((unsigned)b->alpha_source > factor, i, GN_INVALID_ENUM, "color.blend",
                    ".alpha_source" NO_FACTOR);
    FAULT_IF_EIGHTH((unsigned)b->alpha_destination > factor, i, GN_INVALID_ENUM, "color.blend",
                    ".alpha_destination" NO_FACTOR);
    for (int c = 0; b->enabled && c < 4; ++c)
        FAULT_IF(!is_finite(constant[c]), GN_NOT_FINITE,
                 "a number of color.blend_constant is not finite");
    return NO_FAULT;
}

static inline fault fault_of_points_and_lines(const gn_pipeline *p)
{
    FAULT_IF(!is_finite(p->raster.point_size), GN_NOT_FINITE, "raster.point_size is not finite");
    FAULT_IF(p->raster.point_size < 0.0f, GN_OUT_OF_RANGE, "raster.point_size is below 0");
    FAULT_IF(!is_finite(p->raster.line_width), GN_NOT_FINITE, "raster.line_width is not finite");
    FAULT_IF(p->raster.line_width < 0.0f, GN_OUT_OF_RANGE, "raster.line_width is below 0");
    FAULT_IF((unsigned)p->raster.point_origin > GN_POINT_LOWER_LEFT, GN_INVALID_ENUM,
             "raster.point_origin is no gn_point_origin");
    FAULT_IF((unsigned)p->raster.polygon_mode_front > GN_POLYGON_POINT, GN_INVALID_ENUM,
             "raster.polygon_mode_front is no gn_polygon_mode");
    FAULT_IF((unsigned)p->raster.polygon_mode_back > GN_POLYGON_POINT, GN_INVALID_ENUM,
             "raster.polygon_mode_back is no gn_polygon_mode");
    return NO_FAULT;
}

static inline fault fault_of_sample_shading(const gn_samples *s)
{
    if (!s->shading_enabled)
        return NO_FAULT;
    FAULT_IF(!is_finite(s->least_shading), GN_NOT_FINITE, "samples.least_shading is not finite");
    FAULT_IF(s->least_shading < 0.0f || s->least_shading > 1.0f, GN_OUT_OF_RANGE,
             "samples.least_shading is not in 0 to 1");
    return NO_FAULT;
}

/* Small libraries do not check this: they have the code of ready-made shaders in use alone. */
static inline fault fault_of_ready_made(const gn_pipeline *p)
{
#if GN_SPECIALISED
    const ready_made_fault found = gni_find_ready_made_fault(p);

    FAULT_IF(found == GN_READY_MADE_NO_UNIFORMS, GN_NULL_POINTER,
             "program.uniforms is null, but a shader is a ready-made one");
    FAULT_IF(found == GN_READY_MADE_NO_POSITION, GN_OUT_OF_RANGE,
             "program.fragment_reads_position is off, but gn_use_depth_color's shader reads it");
    FAULT_IF(
        found == GN_READY_MADE_FEW_VARYINGS, GN_OUT_OF_RANGE,
        "program.varying_count is below what the ready-made shaders and their maps use: call the "
        "gn_use_ function again");
#else
    (void)p;
#endif
    return NO_FAULT;
}

/* Returns the first feature that the pipeline asks for and this library lacks (config/features.h).
 * Only the first colour matters, since a library without combining has no others. */
static inline fault fault_of_uncompiled_pipeline(const gn_pipeline *p)
{
    FAULT_IF(!GN_HAVE_LINES && p->raster.topology > GN_TRIANGLE_FAN, GN_NOT_COMPILED,
             "raster.topology makes lines or points in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_LINES && p->program.fragment_reads_point_coordinate, GN_NOT_COMPILED,
             "program.fragment_reads_point_coordinate is on in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_LINES && p->raster.polygon_mode_front != GN_POLYGON_FILL, GN_NOT_COMPILED,
             "raster.polygon_mode_front is not GN_POLYGON_FILL in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_LINES && p->raster.polygon_mode_back != GN_POLYGON_FILL, GN_NOT_COMPILED,
             "raster.polygon_mode_back is not GN_POLYGON_FILL in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_COMBINING && p->color.write_disabled[0] != 0, GN_NOT_COMPILED,
             "color.write_disabled[0] is not 0 in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_COMBINING && p->color.blend[0].enabled, GN_NOT_COMPILED,
             "color.blend[0].enabled is on in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_COMBINING && p->color.logic_enabled, GN_NOT_COMPILED,
             "color.logic_enabled is on in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_ATTACHMENTS && p->program.color_count > 1, GN_NOT_COMPILED,
             "program.color_count is above 1 in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_DISTANCES && p->program.clip_distance_count > 0, GN_NOT_COMPILED,
             "program.clip_distance_count is not 0 in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_SAMPLES && p->program.fragment_reads_sample_mask, GN_NOT_COMPILED,
             "program.fragment_reads_sample_mask is on in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_SAMPLES && p->program.fragment_writes_sample_mask, GN_NOT_COMPILED,
             "program.fragment_writes_sample_mask is on in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_OFFSET && p->raster.polygon_offset.enabled, GN_NOT_COMPILED,
             "raster.polygon_offset.enabled is on in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_OFFSET && p->depth.clamp_enabled, GN_NOT_COMPILED,
             "depth.clamp_enabled is on in a GN_BASIC library");
    return NO_FAULT;
}

/* `target` may be null: then it is not known whether a fragment shader is needed. */
static inline fault fault_of_pipeline(const gn_pipeline *p, const gn_target *target)
{
    FAULT_IF(!p, GN_NULL_POINTER, "the pipeline is null");
    FAULT_IF(!p->program.vertex_shader, GN_NO_SHADER, "program.vertex_shader is null");
    FAULT_IF(!p->program.fragment_shader && target && first_surface(target) != &target->depth,
             GN_NO_SHADER, "program.fragment_shader is null, but the target has colour");
    FAULT_IF(!p->program.fragment_shader && p->program.fragment_discards, GN_NO_SHADER,
             "program.fragment_discards, but program.fragment_shader is null");
    FAULT_IF(!p->program.fragment_shader && p->program.fragment_writes_depth, GN_NO_SHADER,
             "program.fragment_writes_depth, but program.fragment_shader is null");
    if (GN_HAVE_SAMPLES)
        FAULT_IF(!p->program.fragment_shader && p->program.fragment_writes_sample_mask,
                 GN_NO_SHADER,
                 "program.fragment_writes_sample_mask, but program.fragment_shader is null");
    FAULT_IF(p->program.varying_count > GN_MAX_VARYINGS, GN_TOO_MANY_VARYINGS,
             "program.varying_count is above GN_MAX_VARYINGS");
    for (uint32_t n = 0; n < p->program.varying_count; ++n) {
        FAULT_IF((unsigned)p->program.interpolation[n] > GN_FLAT, GN_INVALID_ENUM,
                 "program.interpolation of a varying is no gn_interpolation");
        if (GN_HAVE_SAMPLES)
            FAULT_IF((unsigned)p->program.interpolated_at[n] > GN_AT_SAMPLE, GN_INVALID_ENUM,
                     "program.interpolated_at of a varying is no gn_interpolation_point");
    }
    FAULT_IF((unsigned)p->raster.topology > GN_LINE_LOOP, GN_INVALID_ENUM,
             "raster.topology is no gn_topology");
    FAULT_IF((unsigned)p->raster.provoking_vertex > GN_PROVOKING_FIRST, GN_INVALID_ENUM,
             "raster.provoking_vertex is no gn_provoking_vertex");
    FAULT_IF((unsigned)p->raster.cull > GN_CULL_FRONT_AND_BACK, GN_INVALID_ENUM,
             "raster.cull is no gn_cull");
    FAULT_IF((unsigned)p->raster.front_face > GN_FRONT_CLOCKWISE, GN_INVALID_ENUM,
             "raster.front_face is no gn_front_face");
    FAULT_FROM(fault_of_viewport(&p->raster.viewport));
    FAULT_FROM(fault_of_depth_range(&p->depth.range));
    if (GN_HAVE_OFFSET)
        FAULT_FROM(fault_of_polygon_offset(&p->raster.polygon_offset));
    FAULT_IF((unsigned)p->depth.clip_depth > GN_ZERO_TO_ONE, GN_INVALID_ENUM,
             "depth.clip_depth is no gn_clip_depth");
    if (GN_HAVE_DISTANCES)
        FAULT_IF(p->program.clip_distance_count > GN_MAX_CLIP_DISTANCES, GN_OUT_OF_RANGE,
                 "program.clip_distance_count is above GN_MAX_CLIP_DISTANCES");
    FAULT_IF((unsigned)p->depth.function > GN_ALWAYS, GN_INVALID_ENUM,
             "depth.function is no gn_compare");
    if (GN_HAVE_STENCIL) {
        FAULT_FROM(fault_of_stencil_face(&p->stencil.front, false));
        FAULT_FROM(fault_of_stencil_face(&p->stencil.back, true));
    }
    if (GN_HAVE_ATTACHMENTS)
        FAULT_IF(p->program.color_count > GN_MAX_COLORS, GN_OUT_OF_RANGE,
                 "program.color_count is above GN_MAX_COLORS");
    for (int i = 0; GN_HAVE_COMBINING && i < GN_MAX_COLORS; ++i) {
        FAULT_IF_EIGHTH(p->color.write_disabled[i] > GN_CHANNEL_ALL, i, GN_OUT_OF_RANGE,
                        "color.write_disabled", " has bits beyond GN_CHANNEL_ALL");
        FAULT_FROM(fault_of_blend(&p->color.blend[i], i, p->color.blend_constant));
    }
    if (GN_HAVE_COMBINING)
        FAULT_IF((unsigned)p->color.logic_operation > GN_LOGIC_SET, GN_INVALID_ENUM,
                 "color.logic_operation is no gn_logic_operation");
    if (GN_HAVE_SAMPLES) {
        FAULT_IF(p->samples.write_disabled >= 1u << GN_SAMPLES, GN_OUT_OF_RANGE,
                 "samples.write_disabled has bits beyond GN_SAMPLES");
        FAULT_FROM(fault_of_sample_shading(&p->samples));
    }
    if (GN_HAVE_LINES)
        FAULT_FROM(fault_of_points_and_lines(p));
    FAULT_FROM(fault_of_ready_made(p));
    FAULT_FROM(fault_of_uncompiled_pipeline(p));
    return NO_FAULT;
}

/* Does not check index values. */
static inline fault fault_of_mesh(const gn_mesh *mesh)
{
    FAULT_IF(!mesh, GN_NULL_POINTER, "the mesh is null");
    FAULT_IF((unsigned)mesh->index_format > GN_INDEX_UINT32, GN_INVALID_ENUM,
             "index_format is no gn_index_format");
    FAULT_IF((unsigned)mesh->restart > GN_RESTART_INDEX, GN_INVALID_ENUM,
             "restart is no gn_restart");
    FAULT_IF(!GN_HAVE_INSTANCES && mesh->restart != GN_RESTART_NONE, GN_NOT_COMPILED,
             "restart is not GN_RESTART_NONE in a GN_BASIC library");
    FAULT_IF(!GN_HAVE_INSTANCES && mesh->instance_count > 1, GN_NOT_COMPILED,
             "instance_count is above 1 in a GN_BASIC library");

    const bool indexed = mesh->index_format != GN_INDEX_NONE;
    FAULT_IF(indexed && !mesh->indices && mesh->count > 0, GN_NULL_POINTER,
             "indices is null, but index_format is not GN_INDEX_NONE");
    FAULT_IF((mesh->index_format == GN_INDEX_UINT16 && (uintptr_t)mesh->indices % 2 != 0) ||
                 (mesh->index_format == GN_INDEX_UINT32 && (uintptr_t)mesh->indices % 4 != 0),
             GN_MISALIGNED, "indices is not aligned to an index");

    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        const gn_attribute *attribute = &mesh->attribute[a];

        if (!attribute->data)
            continue;
        FAULT_IF_EIGHTH((uintptr_t)attribute->data % 4 != 0, a, GN_MISALIGNED, "attribute",
                        ".data is not aligned to a float");
        FAULT_IF_EIGHTH(attribute->components < 1 || attribute->components > 4, a,
                        GN_INVALID_ATTRIBUTE, "attribute", ".components is not in 1 to 4");
        FAULT_IF_EIGHTH(attribute->stride % 4 != 0, a, GN_INVALID_ATTRIBUTE, "attribute",
                        ".stride is no multiple of 4");
    }
    FAULT_IF(!indexed && mesh->count > 0 && mesh->count > mesh->vertex_count, GN_INDEX_OUT_OF_RANGE,
             "count is above vertex_count");
    FAULT_IF(!indexed && mesh->count > 0 && mesh->first > mesh->vertex_count - mesh->count,
             GN_INDEX_OUT_OF_RANGE, "first + count is above vertex_count");
    return NO_FAULT;
}

/* `least` is the number of bytes without which the draw's pipeline cannot run. Does not check the
 * back end, since to ask the processor takes longer than a small draw. */
static inline fault fault_of_workspace(const gn_workspace *w, size_t least)
{
    FAULT_IF(!w, GN_NULL_POINTER, "the workspace is null");
    FAULT_IF(!w->memory, GN_NULL_POINTER, "workspace.memory is null");
    FAULT_IF(w->size < least, GN_WORKSPACE_TOO_SMALL,
             "workspace.size is below gn_workspace_size(0, varying_count + clip_distance_count)");
    FAULT_IF(!GN_HAVE_STATISTICS && w->statistics, GN_NOT_COMPILED,
             "workspace.statistics is not null in a GN_BASIC library");
    return NO_FAULT;
}

#endif
