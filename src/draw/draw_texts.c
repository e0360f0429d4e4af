/* The faults of pipelines and meshes in words. */
#define GN_FAULT_TEXTS
#include "draw_faults.h"

const char *gn_pipeline_fault(const gn_pipeline *pipeline, const gn_target *target)
{
    return fault_of_pipeline(pipeline, target);
}

const char *gn_mesh_fault(const gn_mesh *mesh)
{
    FAULT_FROM(fault_of_mesh(mesh));
    FAULT_IF(mesh->index_format != GN_INDEX_NONE && !gni_indices_are_within(mesh),
             GN_INDEX_OUT_OF_RANGE, "an index, with base_vertex, is not below vertex_count");
    return NO_FAULT;
}
