/* What gn_draw asks of a mesh before it reads the indices, which its stages do. */
#ifndef GN_DRAW_CHECK_H
#define GN_DRAW_CHECK_H

#include "gnomon/draw.h"

/* Index `at` of a mesh that has some. */
static inline uint32_t mesh_index(const gn_mesh *mesh, size_t at)
{
    return mesh->index_format == GN_INDEX_UINT8    ? ((const uint8_t *)mesh->indices)[at]
           : mesh->index_format == GN_INDEX_UINT16 ? ((const uint16_t *)mesh->indices)[at]
                                                   : ((const uint32_t *)mesh->indices)[at];
}

/* The index that restarts, where one does. */
static inline uint32_t restart_index_of(const gn_mesh *mesh)
{
    if (mesh->restart == GN_RESTART_INDEX)
        return mesh->restart_index;
    return mesh->index_format == GN_INDEX_UINT8    ? UINT8_MAX
           : mesh->index_format == GN_INDEX_UINT16 ? UINT16_MAX
                                                   : UINT32_MAX;
}

/* Whether an index is a restart and names no vertex. */
static inline bool is_restart(const gn_mesh *mesh, uint32_t index)
{
    return mesh->restart != GN_RESTART_NONE && index == restart_index_of(mesh);
}

/* Whether all indices that are drawn name vertices, or are restarts. */
bool gn_indices_are_within(const gn_mesh *mesh);

/* gn_mesh_check without a look at the indices. */
gn_status gn_check_mesh_but_indices(const gn_mesh *mesh);

#endif
