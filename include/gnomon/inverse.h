/** @file
 * Inverses of bare matrices of known kinds, in terms of their entries. A gn_transform (transform.h)
 * already holds its inverse; these functions are for matrices that come from elsewhere.
 *
 *     rotation (mat3)      gn_mat3_transpose: the inverse is the transpose
 *     rotation, offset     gn_mat4_invert_rigid (mat.h): views, orthonormal frames
 *     T R S                gn_mat4_invert_trs
 *     affine               gn_mat4_invert_affine: any last row (0, 0, 0, 1)
 *     scale and offset     gn_mat4_invert_orthographic: orthographic projections,
 *                          viewports, translations, scalings
 *     perspective          gn_mat4_invert_perspective: frusta and perspectives of
 *                          every convention
 *
 * Nothing checks that a matrix is of the kind that the function's name says. Entries that are fixed
 * in that kind are not read, and in the result they are exact. The result may be the operand.
 *
 * Bounds are stated on E = m * result - identity, and on E with the factors exchanged. u = 2^-24
 * and |.| is taken entry by entry, as in transform.h; bounds hold barring underflow. M is m, M^-1
 * the result, L the upper-left 3x3 of m, t its translation, L^-1 the upper-left 3x3 of the result.
 *
 * All functions return GN_OK, or a fault and then write nothing: GN_NULL_POINTER for a null
 * pointer, GN_NOT_FINITE if an entry that is read is NaN or infinite, GN_OUT_OF_RANGE if a result
 * or a number on the way to it would overflow. Contracts name further faults. */
#ifndef GNOMON_INVERSE_H
#define GNOMON_INVERSE_H

#include "api.h"
#include "mat.h"
#include "status.h"

GN_BEGIN

/**
 * Writes the inverse of m = T R S with the rotation R and the scale S, which may reflect. The rows
 * of L^-1 are the columns of L divided by their squared lengths; the translation is -L^-1 t. Let G
 * be the exact inverse of the Gram diagonal, J = G L^T, D = L J - I and D' = J L - I. D and D'
 * measure what the stored floats of L lack to be a rotation times a scale:
 *
 *     m * result   |E| <= |D| + 4 u |L||L^-1|, and (|D| + 7 u |L||L^-1|) |t| in the
 *                  translation;
 *     result * m   |E| <= |D'| + 4 u |L^-1||L|, and 3 u |L^-1||t|.
 *
 * GN_SINGULAR if a column is zero. */
GN_API gn_status gn_mat4_invert_trs(const gn_mat4 *m, gn_mat4 *result);

/**
 * Writes the inverse of an affine matrix: gn_mat3_invert of L (adjugate over determinant, in
 * double), and -L^-1 t. Let k be the permanent of |L| over the magnitude of the determinant of L,
 * and v = u + 2^-50 k. Every entry of L^-1 has a relative error of at most v (2 u up to k = 2^26):
 *
 *     m * result   |E| <= v |L||L^-1|, and (v + 3 u) |L||L^-1||t| in the translation;
 *     result * m   |E| <= v |L^-1||L|, and 3 u |L^-1||t|.
 *
 * GN_SINGULAR if gn_mat3_invert returns it for L, which it never does while k is below 2^47. */
GN_API gn_status gn_mat4_invert_affine(const gn_mat4 *m, gn_mat4 *result);

/** Writes the inverse of a scale on the diagonal and an offset in the last column: 1 / scale and
 * -offset / scale. |E| <= u |M||M^-1|, and u |M^-1||M| with the factors exchanged. GN_SINGULAR if a
 * scale is zero, GN_OUT_OF_RANGE if its magnitude is not within 2^-126 .. 2^126. */
GN_API gn_status gn_mat4_invert_orthographic(const gn_mat4 *m, gn_mat4 *result);

/** Writes the inverse of a perspective projection: x and y are scaled and skewed by z, clip z = c
 * z + d, clip w = s z. If s is 1 or -1, |E| <= u |M||M^-1|, and u |M^-1||M| with the factors
 * exchanged; if s is another number, 3 u instead of u. GN_SINGULAR if a scale, d or s is zero,
 * GN_OUT_OF_RANGE if its magnitude is not within 2^-126 .. 2^126. */
GN_API gn_status gn_mat4_invert_perspective(const gn_mat4 *m, gn_mat4 *result);

/** Writes the matrix that takes the normals of a surface to the normals of the surface
 * transformed by the affine m: the transposed L^-1 of gn_mat4_invert_affine, with the same bound.
 * The last column and row are not read. Returns the statuses of gn_mat3_invert. */
GN_API gn_status gn_mat4_normal_matrix(const gn_mat4 *m, gn_mat3 *result);

GN_END

#endif
