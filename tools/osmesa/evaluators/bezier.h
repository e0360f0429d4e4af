/* Bezier curves and surfaces, in the order of operations of the reference. */
#ifndef OSMESA_BEZIER_H
#define OSMESA_BEZIER_H

#include <stdbool.h>

#include "../context/gl_types.h"

enum { MOST_ORDER = 30, MOST_COMPONENTS = 4 };

/* The control points of a surface: `order[0]` rows, along u, of `order[1]` points, along v. */
typedef struct bezier_surface {
    const GLfloat *points;
    int components, order[2];
} bezier_surface;

/* Writes the point at t of a curve whose control points are `step` floats apart. */
void bezier_curve(const GLfloat *points, int step, int components, int order, GLfloat t,
                  GLfloat *out);

/* Writes the point of a surface at u, v. */
void bezier_point(const bezier_surface *surface, GLfloat u, GLfloat v, GLfloat *out);

/* The same point by another method, whose last bits differ, with the directions of its derivatives.
 * Along a direction in which there is but one control point, the derivative is 0. */
void bezier_tangents(const bezier_surface *surface, GLfloat u, GLfloat v, GLfloat *out, GLfloat *du,
                     GLfloat *dv);

#endif
