/* Checks pipelines, meshes and workspaces; returns the status of the first fault. */
#include "check.h"

#include "draw_faults.h"

gn_status gn_pipeline_check(const gn_pipeline *pipeline, const gn_target *target)
{
    return fault_of_pipeline(pipeline, target);
}

bool gni_indices_are_within(const gn_mesh *mesh)
{
    for (uint32_t i = 0; i < mesh->count; ++i) {
        const uint32_t index = mesh_index(mesh, (size_t)mesh->first + i);

        if (!is_restart(mesh, index) && index + (uint32_t)mesh->base_vertex >= mesh->vertex_count)
            return false;
    }
    return true;
}

gn_status gni_check_mesh_except_indices(const gn_mesh *mesh)
{
    return fault_of_mesh(mesh);
}

gn_status gn_mesh_check(const gn_mesh *mesh)
{
    const gn_status status = gni_check_mesh_except_indices(mesh);

    if (status)
        return status;
    if (mesh->index_format != GN_INDEX_NONE && !gni_indices_are_within(mesh))
        return GN_INDEX_OUT_OF_RANGE;
    return GN_OK;
}

gn_status gni_check_workspace(const gn_workspace *workspace, size_t least)
{
    return fault_of_workspace(workspace, least);
}
