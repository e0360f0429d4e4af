/* Rectangles of pixels that are drawn as fragments: bitmaps and what glDrawPixels and glCopyPixels
 * draw (OpenGL 2.1 sections 3.6.4 and 3.7). */
#ifndef OSMESA_PIXEL_RECTANGLE_H
#define OSMESA_PIXEL_RECTANGLE_H

#include "../context/gl_context.h"

/* What the pixels of the source are. */
typedef enum rectangle_kind {
    RECTANGLE_BITS,   /* GN_FORMAT_R8: a fragment where a pixel is not 0 */
    RECTANGLE_COLORS, /* colours of the fragments */
    RECTANGLE_DEPTHS, /* depths of the fragments, whose colour is not clamped */
    RECTANGLE_STENCIL /* GN_FORMAT_RGBA32F: a stencil index, a depth, 0 and 1 */
} rectangle_kind;

typedef struct pixel_rectangle {
    rectangle_kind kind;
    GLfloat x, y; /* of the lower left corner of the first pixel, in the window */
    GLfloat zoom_x, zoom_y;
    GLfloat z;             /* in the window; depths of their own do not use it */
    GLfloat color[4];      /* of bits and depths */
    GLsizei width, height; /* of the source */
    gn_format format;
    const void *pixels; /* rows without gaps, the lowest first */
    bool skips_tests;   /* neither depth nor stencil is tested */
    bool sets_depth;    /* of stencil: each depth is set, too, without a test */
} pixel_rectangle;

/* Returns a rectangle without pixels at the raster position, which is rounded to a whole pixel,
 * under the zoom. */
pixel_rectangle rectangle_at_raster_position(const context *gl, rectangle_kind kind, GLsizei width,
                                             GLsizei height);

/* Draws one fragment for each pixel of the window that a rectangle covers. */
void draw_pixel_rectangle(context *gl, const pixel_rectangle *rectangle, const char *function);

#endif
