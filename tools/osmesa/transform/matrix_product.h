/* Matrices of OpenGL's stacks, column-major. The order of operations is the reference's. */
#ifndef OSMESA_MATRIX_PRODUCT_H
#define OSMESA_MATRIX_PRODUCT_H

#include <stdbool.h>

#include "../context/gl_types.h"

/* result = a * b. The result may be a or b. */
void multiply_matrices(GLfloat result[16], const GLfloat a[16], const GLfloat b[16]);

/* Sets a matrix to the identity. */
void set_identity(GLfloat m[16]);

/* m = m * a rotation by degrees around an axis, a translation, or a scale. No rotation, and false,
 * if the axis is too short. */
bool rotate_matrix(GLfloat m[16], GLfloat degrees, GLfloat x, GLfloat y, GLfloat z);
void translate_matrix(GLfloat m[16], GLfloat x, GLfloat y, GLfloat z);
void scale_matrix(GLfloat m[16], GLfloat x, GLfloat y, GLfloat z);

/* m = m * the projection of glFrustum or glOrtho. */
void multiply_frustum(GLfloat m[16], GLfloat left, GLfloat right, GLfloat bottom, GLfloat top,
                      GLfloat z_near, GLfloat z_far);
void multiply_ortho(GLfloat m[16], GLfloat left, GLfloat right, GLfloat bottom, GLfloat top,
                    GLfloat z_near, GLfloat z_far);

#endif
