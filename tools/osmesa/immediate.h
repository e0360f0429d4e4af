/* Vertices one by one: current attributes, and what glVertex does between glBegin and glEnd. */
#ifndef OSMESA_IMMEDIATE_H
#define OSMESA_IMMEDIATE_H

#include "gl_context.h"

/* Sets components `first` to `first + count - 1` of a current attribute. */
static inline void set_attribute(enum attribute_name name, int first, int count,
                                 const GLfloat *value)
{
    context *const gl = current_context();

    if (!gl)
        return;
    for (int i = 0; i < count; ++i)
        gl->current.attribute[name][first + i] = value[i];
    gl->immediate.touched |= 1u << name;
}

/* Adds a vertex with the current attributes; nothing outside glBegin and glEnd. */
void add_vertex(GLfloat x, GLfloat y, GLfloat z, GLfloat w);

#endif
