/* Lines with a pattern (glLineStipple, OpenGL 2.1 section 3.4.2), as the reference draws them: each
 * line is cut, in the window, into the pieces where the pattern has bits. */
#ifndef OSMESA_STIPPLED_LINES_H
#define OSMESA_STIPPLED_LINES_H

#include "window_primitives.h"

/* Adds the pieces of a line to the primitives that wait. */
void stipple_line(window_primitives *p, const placement *place, const shaded_vertex *a,
                  const shaded_vertex *b, bool begins_pattern);

#endif
