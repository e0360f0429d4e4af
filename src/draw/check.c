/* Validation of what a draw is given: the first fault, named. */
#include "check.h"

#include "../math/bits.h"

static gn_status check_viewport(const gn_viewport *v)
{
    const float limit = (float)GN_MAX_SIZE;

    if (!v->set)
        return GN_OK;
    if (!gn_is_finite(v->x) || !gn_is_finite(v->y) || !gn_is_finite(v->width) ||
        !gn_is_finite(v->height))
        return GN_NOT_FINITE;
    if (v->width < 0.0f || v->height < 0.0f || v->width > limit || v->height > limit ||
        v->x < -limit || v->y < -limit || v->x > limit || v->y > limit)
        return GN_INVALID_VIEWPORT;
    return GN_OK;
}

static gn_status check_depth_range(const gn_depth_range *r)
{
    if (!r->set)
        return GN_OK;
    if (!gn_is_finite(r->z_near) || !gn_is_finite(r->z_far))
        return GN_NOT_FINITE;
    if (r->z_near < 0.0f || r->z_near > 1.0f || r->z_far < 0.0f || r->z_far > 1.0f)
        return GN_OUT_OF_RANGE;
    return GN_OK;
}

static gn_status check_polygon_offset(const gn_polygon_offset *o)
{
    if (o->set && (!gn_is_finite(o->factor) || !gn_is_finite(o->units) || !gn_is_finite(o->clamp)))
        return GN_NOT_FINITE;
    return GN_OK;
}

static gn_status check_blend(const gn_blend *b)
{
    if ((unsigned)b->equation > GN_EQUATION_MAX || (unsigned)b->alpha_equation > GN_EQUATION_MAX ||
        (unsigned)b->source > GN_FACTOR_SOURCE_ALPHA_SATURATE ||
        (unsigned)b->destination > GN_FACTOR_SOURCE_ALPHA_SATURATE ||
        (unsigned)b->alpha_source > GN_FACTOR_SOURCE_ALPHA_SATURATE ||
        (unsigned)b->alpha_destination > GN_FACTOR_SOURCE_ALPHA_SATURATE)
        return GN_INVALID_ENUM;
    for (int c = 0; b->enabled && c < 4; ++c) {
        if (!gn_is_finite(b->constant[c]))
            return GN_NOT_FINITE;
    }
    return GN_OK;
}

static bool is_stencil_face(const gn_stencil_face *f)
{
    return (unsigned)f->function <= GN_STENCIL_LESS &&
           (unsigned)f->fail <= GN_STENCIL_DECREMENT_WRAP &&
           (unsigned)f->depth_fail <= GN_STENCIL_DECREMENT_WRAP &&
           (unsigned)f->pass <= GN_STENCIL_DECREMENT_WRAP;
}

static gn_status check_size(float size)
{
    if (!gn_is_finite(size))
        return GN_NOT_FINITE;
    return size < 0.0f ? GN_OUT_OF_RANGE : GN_OK;
}

gn_status gn_pipeline_check(const gn_pipeline *pipeline)
{
    gn_status status;

    if (!pipeline)
        return GN_NULL_POINTER;
    if (!pipeline->vertex_shader)
        return GN_NO_SHADER;
    if (!pipeline->fragment_shader &&
        (pipeline->fragment_discards || pipeline->fragment_writes_depth))
        return GN_NO_SHADER;
    if (pipeline->varying_count > GN_MAX_VARYINGS)
        return GN_TOO_MANY_VARYINGS;
    for (uint32_t n = 0; n < pipeline->varying_count; ++n) {
        if ((unsigned)pipeline->interpolation[n] > GN_FLAT)
            return GN_INVALID_ENUM;
    }
    if ((unsigned)pipeline->topology > GN_LINE_LOOP ||
        (unsigned)pipeline->provoking_vertex > GN_PROVOKING_FIRST ||
        (unsigned)pipeline->cull > GN_CULL_FRONT_AND_BACK ||
        (unsigned)pipeline->front_face > GN_FRONT_CLOCKWISE)
        return GN_INVALID_ENUM;
    status = check_viewport(&pipeline->viewport);
    if (status)
        return status;
    status = check_depth_range(&pipeline->depth_range);
    if (status)
        return status;
    status = check_polygon_offset(&pipeline->polygon_offset);
    if (status)
        return status;
    if ((unsigned)pipeline->clip_depth > GN_ZERO_TO_ONE)
        return GN_INVALID_ENUM;
    if (pipeline->clip_distance_count > GN_MAX_CLIP_DISTANCES)
        return GN_OUT_OF_RANGE;
    if ((unsigned)pipeline->depth_function > GN_ALWAYS ||
        !is_stencil_face(&pipeline->stencil_front) || !is_stencil_face(&pipeline->stencil_back))
        return GN_INVALID_ENUM;
    if (pipeline->color_write_disabled > GN_CHANNEL_ALL)
        return GN_OUT_OF_RANGE;
    status = check_blend(&pipeline->blend);
    if (status)
        return status;
    if ((unsigned)pipeline->logic_operation > GN_LOGIC_SET)
        return GN_INVALID_ENUM;
    status = check_size(pipeline->point_size);
    if (status)
        return status;
    status = check_size(pipeline->line_width);
    if (status)
        return status;
    if ((unsigned)pipeline->polygon_mode_front > GN_POLYGON_POINT ||
        (unsigned)pipeline->polygon_mode_back > GN_POLYGON_POINT)
        return GN_INVALID_ENUM;
    return GN_OK;
}

bool gn_indices_are_within(const gn_mesh *mesh)
{
    for (uint32_t i = 0; i < mesh->count; ++i) {
        const uint32_t index = mesh_index(mesh, (size_t)mesh->first + i);

        if (!is_restart(mesh, index) && index + (uint32_t)mesh->base_vertex >= mesh->vertex_count)
            return false;
    }
    return true;
}

gn_status gn_check_mesh_but_indices(const gn_mesh *mesh)
{
    if (!mesh)
        return GN_NULL_POINTER;
    if ((unsigned)mesh->index_format > GN_INDEX_UINT32 ||
        (unsigned)mesh->restart > GN_RESTART_INDEX)
        return GN_INVALID_ENUM;

    const bool indexed = mesh->index_format != GN_INDEX_NONE;
    if (indexed && !mesh->indices && mesh->count > 0)
        return GN_NULL_POINTER;
    if ((mesh->index_format == GN_INDEX_UINT16 && (uintptr_t)mesh->indices % 2 != 0) ||
        (mesh->index_format == GN_INDEX_UINT32 && (uintptr_t)mesh->indices % 4 != 0))
        return GN_MISALIGNED;

    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        const gn_attribute *attribute = &mesh->attribute[a];

        if (!attribute->data)
            continue;
        if ((uintptr_t)attribute->data % 4 != 0)
            return GN_MISALIGNED;
        if (attribute->components < 1 || attribute->components > 4 || attribute->stride % 4 != 0)
            return GN_INVALID_ATTRIBUTE;
    }
    if (!indexed && mesh->count > 0 &&
        (mesh->count > mesh->vertex_count || mesh->first > mesh->vertex_count - mesh->count))
        return GN_INDEX_OUT_OF_RANGE;
    return GN_OK;
}

gn_status gn_mesh_check(const gn_mesh *mesh)
{
    const gn_status status = gn_check_mesh_but_indices(mesh);

    if (status)
        return status;
    if (mesh->index_format != GN_INDEX_NONE && !gn_indices_are_within(mesh))
        return GN_INDEX_OUT_OF_RANGE;
    return GN_OK;
}
