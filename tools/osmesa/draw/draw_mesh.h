/* Draws vertices under the context's state. */
#ifndef OSMESA_DRAW_MESH_H
#define OSMESA_DRAW_MESH_H

#include "../context/gl_context.h"

/* Draws primitives of a mode, GL_POINTS to GL_POLYGON, for the function of OpenGL with this name.
 * The mesh has its vertices, elements from 0 on and `count`; its attributes are numbered by
 * attribute_name, and one without data has the current value. */
void draw_mesh(context *gl, GLenum mode, gn_mesh *mesh, const char *function);

#endif
