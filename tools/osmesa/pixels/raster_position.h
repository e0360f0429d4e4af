/* The raster position: where bitmaps and rectangles of pixels are drawn (OpenGL 2.1 section 2.13).
 * As in the reference, it is no vertex: each operation is one of C, in the order written. */
#ifndef OSMESA_RASTER_POSITION_H
#define OSMESA_RASTER_POSITION_H

#include "../draw/fixed_lighting.h"

/* Sets the position from a vertex in object space; it becomes invalid if the vertex is clipped. */
void set_raster_position(context *gl, const GLfloat vertex[4]);

/* Sets the position in the window. */
void set_window_position(context *gl, GLfloat x, GLfloat y, GLfloat z);

/* Lights a vertex (raster_position_lighting.c). Its place and its normal are in the space that is
 * used; colours are clamped. */
void light_raster_position(const context *gl, const eye_derived *eye, const GLfloat vertex[4],
                           const GLfloat normal[3], GLfloat color[4], GLfloat secondary[4]);

/* Sum of products, from the first component on. */
static inline GLfloat forward_dot_3(const GLfloat *a, const GLfloat *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Makes a vector's length 1; a vector of length 0 stays. */
void make_unit_length(GLfloat v[3]);

#endif
