/* The framebuffers that are drawn to and read from: the window, or framebuffer objects, as surfaces
 * of Gnomon. */
#ifndef OSMESA_FRAMEBUFFER_VIEW_H
#define OSMESA_FRAMEBUFFER_VIEW_H

#include "../context/gl_context.h"

typedef struct framebuffer_view {
    gn_target target; /* to draw to: the colours that the draw buffers name */
    gn_surface read;  /* the colour that the read buffer names */
    GLint width, height;
    bool rows_go_down; /* row 0 is the top row, as in the window */
    bool has_floats;   /* in a colour */
    GLint bits[6];     /* red, green, blue, alpha, depth, stencil */
    GLint samples;     /* 0: one, not multisampled */
} framebuffer_view;

/* Describe the framebuffers. Return false if one is incomplete. */
bool view_draw_framebuffer(const context *gl, framebuffer_view *view);
bool view_read_framebuffer(const context *gl, framebuffer_view *view);

/* Describe one, with an error, GL_INVALID_FRAMEBUFFER_OPERATION, if it is incomplete. */
bool is_drawable_framebuffer(context *gl, framebuffer_view *view, const char *function);
bool is_readable_framebuffer(context *gl, framebuffer_view *view, const char *function);

/* Whether a colour that is drawn to has floats. */
bool draws_floats(const context *gl);

/* Returns a pixel of a surface of a view; y goes up. */
unsigned char *view_pixel(const framebuffer_view *view, const gn_surface *surface, GLint x,
                          GLint y);

#endif
