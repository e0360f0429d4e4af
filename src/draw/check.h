/* What gn_draw asks of a mesh before it reads the indices, which its stages do. */
#ifndef GN_DRAW_CHECK_H
#define GN_DRAW_CHECK_H

#include "gnomon/draw.h"

/* gn_mesh_check without a look at the indices. */
gn_status gn_check_mesh_but_indices(const gn_mesh *mesh);

#endif
