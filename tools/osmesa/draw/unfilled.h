/* Polygons that are drawn as lines or points (glPolygonMode), and their edge flags (OpenGL 2.1
 * sections 2.6.2 and 3.5.4). */
#ifndef OSMESA_UNFILLED_H
#define OSMESA_UNFILLED_H

#include "../context/gl_context.h"

/* Whether polygons of a mode may be drawn as lines or points. */
bool draws_unfilled(const context *gl, GLenum mode);

/* Whether a vertex has an edge flag that is false, and a mode that would show it, be it that of
 * faces that are culled. */
bool hides_edges(const context *gl, const gn_mesh *mesh);

/* Returns how many triangles the primitives of a mode make, GL_TRIANGLES to GL_POLYGON. */
size_t triangles_of(GLenum mode, uint32_t count);

/* Lists these triangles: three corners each, as elements of the mesh, and which edges are drawn, as
 * bits. An edge belongs to its first corner. */
void list_triangles(const context *gl, GLenum mode, const gn_mesh *mesh, uint32_t *corner,
                    unsigned char *mask);

#endif
