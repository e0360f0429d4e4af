/* Quads, strips of quads and polygons as triangles. */
#ifndef OSMESA_POLYGONS_H
#define OSMESA_POLYGONS_H

#include "../context/gl_context.h"

/* Returns element i of a mesh, without its base vertex. */
uint32_t mesh_element(const gn_mesh *mesh, uint32_t i);

/* Returns how many elements the whole polygons of a mode have, 0 if there is none. */
uint32_t elements_of_polygons(GLenum mode, uint32_t count);

/* Replaces a mesh's elements by indices of triangles, in the context's scratch.
 * How they are divided, and in which order triangles come, depends on whether a varying is flat and
 * whether the draw goes through the reference's stages of primitives, as where a vertex is clipped.
 * Precondition: elements_of_polygons is not 0. Returns false if memory is short. */
bool divide_polygons(context *gl, GLenum mode, bool is_flat, bool is_clipped, gn_mesh *mesh,
                     const char *function);

#endif
