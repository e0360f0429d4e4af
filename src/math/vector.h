/* Predicates of vectors, matrices and numbers, and unit vectors, for the files of this folder. */
#ifndef GN_MATH_VECTOR_H
#define GN_MATH_VECTOR_H

#include <stdbool.h>

#include <gnomon/mat.h>

bool gni_vec3_is_finite(gn_vec3 v);
bool gni_mat4_is_finite(const gn_mat4 *m);

/* Returns whether the reciprocal of x rounds like any other number: 2^-126 <= |x| <= 2^126. */
bool gni_has_reciprocal(float x);

/* Writes v divided by its length, so that the squared length is within 7 * 2^-24 of 1.
 * Precondition: result is not null. Returns GN_NOT_FINITE or GN_DEGENERATE as gn_vec3_normalize
 * does, and then writes nothing. */
gn_status gni_vec3_unit(gn_vec3 v, gn_vec3 *result);

#endif
