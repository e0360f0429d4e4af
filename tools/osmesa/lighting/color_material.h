/* The colours of materials that follow the current colour (OpenGL 2.1 section 2.14.3). */
#ifndef OSMESA_COLOR_MATERIAL_H
#define OSMESA_COLOR_MATERIAL_H

#include "../context/gl_context.h"

/* Returns the colours that a name of glMaterial stands for, as bits; 0 if none. */
unsigned material_colors(GLenum name);

/* Whether a face is this side, 0 for the front, or both. */
bool face_has_side(GLenum face, int side);

/* Whether glColorMaterial names a colour of a side, whether or not it is enabled. */
bool follows_color(const lighting_state *lighting, int side, enum material_color name);

/* Brings the colours that follow the current colour up to date. */
void follow_current_color(context *gl);

#endif
