/* Checks of meshes and workspaces. gn_draw leaves index values to the stages, which check them when
 * they read them. */
#ifndef GN_DRAW_CHECK_H
#define GN_DRAW_CHECK_H

#include <gnomon/draw.h>

/* Returns index `at` of an indexed mesh. */
static inline uint32_t mesh_index(const gn_mesh *mesh, size_t at)
{
    return mesh->index_format == GN_INDEX_UINT8    ? ((const uint8_t *)mesh->indices)[at]
           : mesh->index_format == GN_INDEX_UINT16 ? ((const uint16_t *)mesh->indices)[at]
                                                   : ((const uint32_t *)mesh->indices)[at];
}

/* Returns the primitive-restart index. Precondition: the mesh is indexed and has a restart. */
static inline uint32_t restart_index_of(const gn_mesh *mesh)
{
    if (mesh->restart == GN_RESTART_INDEX)
        return mesh->restart_index;
    return mesh->index_format == GN_INDEX_UINT8    ? UINT8_MAX
           : mesh->index_format == GN_INDEX_UINT16 ? UINT16_MAX
                                                   : UINT32_MAX;
}

/* Returns whether an index is a restart; a restart names no vertex. */
static inline bool is_restart(const gn_mesh *mesh, uint32_t index)
{
    return mesh->restart != GN_RESTART_NONE && index == restart_index_of(mesh);
}

/* Returns whether every index that is drawn names a vertex or is a restart. */
bool gni_indices_are_within(const gn_mesh *mesh);

/* Returns the status of gn_mesh_check, but does not check index values. */
gn_status gni_check_mesh_except_indices(const gn_mesh *mesh);

/* Returns GN_NULL_POINTER (the workspace, its memory), GN_WORKSPACE_TOO_SMALL (below `least` bytes)
 * or GN_NOT_COMPILED (statistics in a GN_BASIC library). */
gn_status gni_check_workspace(const gn_workspace *workspace, size_t least);

#endif
