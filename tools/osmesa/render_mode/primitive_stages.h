/* The stages of primitives from the vertex shader to the window, for selection, feedback, polygons
 * as lines or points, and lines with a pattern: clipping, culling, colours of the side that is
 * seen, polygon offset, polygon modes (OpenGL 2.1 sections 2.12, 2.14.1, 3.5). As in the
 * reference's stages, polygons are given as triangles, and the order of operations is theirs. */
#ifndef OSMESA_PRIMITIVE_STAGES_H
#define OSMESA_PRIMITIVE_STAGES_H

#include "shaded_vertices.h"

/* What takes the primitives. `begin_pattern` is called before the lines of a polygon; a line that
 * is no polygon's may begin the pattern itself. `finish` is called after the last primitive. Units
 * of glPolygonOffset are steps of the depth format; without one, as in the reference, they do not
 * count. */
typedef struct primitive_sink {
    void *user; /* passed to the functions */
    void (*point)(void *user, const placement *place, const shaded_vertex *v);
    void (*line)(void *user, const placement *place, const shaded_vertex *a, const shaded_vertex *b,
                 bool begins_pattern);
    void (*triangle)(void *user, const placement *place, const shaded_vertex *const v[3]);
    void (*begin_pattern)(void *user);
    void (*finish)(void *user, const placement *place);
    gn_format depth_format;
} primitive_sink;

/* Takes the primitives of a mode, GL_POINTS to GL_POLYGON, through all stages, with a mesh as
 * draw_mesh takes it. */
void pass_primitives(context *gl, GLenum mode, const gn_mesh *mesh, const primitive_sink *sink,
                     const char *function);

#endif
