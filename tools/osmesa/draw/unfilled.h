/* Polygons that are drawn as lines or points (glPolygonMode), and their edge flags (OpenGL 2.1
 * sections 2.6.2 and 3.5.4). */
#ifndef OSMESA_UNFILLED_H
#define OSMESA_UNFILLED_H

#include "fixed_function.h"

/* Whether polygons of a mode may be drawn as lines or points. */
bool draws_unfilled(const context *gl, GLenum mode);

/* Whether all faces that are not culled are drawn as points. */
bool draws_polygon_points(const context *gl);

/* Returns how many triangles the primitives of a mode make, GL_TRIANGLES to GL_POLYGON. */
size_t triangles_of(GLenum mode, uint32_t count);

/* Lists these triangles: three corners each, as elements of the mesh, and which edges are drawn, as
 * bits. An edge belongs to its first corner. */
void list_triangles(const context *gl, GLenum mode, const gn_mesh *mesh, uint32_t *corner,
                    unsigned char *mask);

/* Replaces a mesh by triangles with corners of their own, in the context's scratch, and sets which
 * edges are drawn: a point belongs to its corner.
 * Returns false if there is nothing to draw, or memory is short. */
bool separate_triangles(context *gl, GLenum mode, gn_mesh *mesh, fixed_function *fixed,
                        gn_program *program, const char *function);

#endif
