/* The window of a context: the program's memory as a surface, and depth and stencil beside it. */
#ifndef OSMESA_WINDOW_H
#define OSMESA_WINDOW_H

#include "../context/gl_context.h"

/* Binds a window to the program's memory. Returns false, and leaves it as it was, if the format is
 * not supported, the size is not 1 to GN_MAX_SIZE, or memory is short. */
bool bind_window(window_state *window, void *memory, GLenum type, GLint width, GLint height);

/* Follows a change of row_length or y_up. */
void lay_out_window(window_state *window);

/* Brings what was drawn into the program's memory, if it was drawn elsewhere. */
void finish_window(window_state *window);

void release_window(window_state *window);

#endif
