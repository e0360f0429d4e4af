/* Vertices one by one: current attributes, and what glVertex does between glBegin and glEnd. */
#ifndef OSMESA_IMMEDIATE_H
#define OSMESA_IMMEDIATE_H

#include "../context/gl_context.h"

/* Draws the vertices that wait, before an attribute gets more components than they have. */
void grow_layout(context *gl, int attribute, int size);

/* Draws the vertices that wait, inside glBegin and glEnd too, where those that the primitive needs
 * again stay. */
void draw_vertices_so_far(context *gl);

enum { FOG_COORDINATE_ATTRIBUTE = ATTRIBUTES };

/* Sets components of the vertices that an unfinished primitive goes on with. */
void complete_vertices(context *gl, enum attribute_name name, int first, int count);

/* Sets components `first` to `first + count - 1` of a current attribute. `size` is the number that
 * the program named. */
static inline void set_attribute(enum attribute_name name, int first, int count, int size,
                                 const GLfloat *value)
{
    context *const gl = current_context();
    const int attribute = first == 3 ? FOG_COORDINATE_ATTRIBUTE : (int)name;

    if (!gl)
        return;
    const bool grows = size > gl->immediate.size[attribute];

    if (grows)
        grow_layout(gl, attribute, size);
    for (int i = 0; i < count; ++i)
        gl->current.attribute[name][first + i] = value[i];
    if (grows && (gl->immediate.unknown >> attribute & 1u))
        complete_vertices(gl, name, first, count);
}

/* Adds a vertex with the current attributes; nothing outside glBegin and glEnd. */
void add_vertex(int size, GLfloat x, GLfloat y, GLfloat z, GLfloat w);

#endif
