/* The faults of draws in words. */
#define GN_FAULT_TEXTS
#include "draw_faults.h"

#include "../formats/surface_faults.h"
#include "../kernel/geometry/vertex_store.h"

const char *gn_draw_fault(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                          const gn_workspace *workspace)
{
    FAULT_FROM(fault_of_target(target));
    FAULT_FROM(fault_of_pipeline(pipeline, target));
    FAULT_FROM(fault_of_mesh(mesh));
    FAULT_FROM(fault_of_workspace(workspace, gn_workspace_size(0, stored_values(pipeline))));
    FAULT_IF(!gn_backend_available(workspace->backend), GN_BACKEND_UNAVAILABLE,
             "workspace.backend is not in the library, or the processor does not have it");
    FAULT_IF(mesh->index_format != GN_INDEX_NONE && !gni_indices_are_within(mesh),
             GN_INDEX_OUT_OF_RANGE, "an index, with base_vertex, is not below vertex_count");
    return NO_FAULT;
}
