/* Lines and points in the window, smooth ones (GL_LINE_SMOOTH and GL_POINT_SMOOTH, OpenGL 2.1
 * sections 3.3 and 3.4) as the reference draws them: as two triangles, whose varyings tell how much
 * of a fragment is covered. */
#ifndef OSMESA_SMOOTH_PRIMITIVES_H
#define OSMESA_SMOOTH_PRIMITIVES_H

#include "window_primitives.h"

void add_window_point(window_primitives *p, const placement *place, const shaded_vertex *v);

/* The flat varyings are those of `b` in both vertices. */
void add_window_line(window_primitives *p, const placement *place, const shaded_vertex *a,
                     const shaded_vertex *b);

#endif
