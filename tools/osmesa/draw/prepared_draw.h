/* The end of a draw: a mesh that Gnomon can draw, under a pipeline. */
#ifndef OSMESA_PREPARED_DRAW_H
#define OSMESA_PREPARED_DRAW_H

#include "../context/gl_context.h"

/* Draws a mesh under a pipeline, for the function of OpenGL with this name, which has the errors.
 */
void draw_prepared(context *gl, const gn_target *target, const gn_pipeline *pipeline,
                   const gn_mesh *mesh, const char *function);

#endif
