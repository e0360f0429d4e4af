/* Inverses of bare matrices of known kinds, in terms of their entries. Whoever
 * builds matrices as transforms (transform.h) has the inverse already; these are
 * for matrices that come from elsewhere.
 *
 *   rotation (mat3)      gn_mat3_transpose: the inverse is the transpose
 *   rotation, offset     gn_mat4_invert_rigid (mat.h): views, orthonormal frames
 *   T R S                gn_mat4_invert_trs
 *   affine               gn_mat4_invert_affine: any last row (0, 0, 0, 1)
 *   scale and offset     gn_mat4_invert_orthographic: orthographic projections,
 *                        viewports, translations, scalings
 *   perspective          gn_mat4_invert_perspective: frusta and perspectives of
 *                        every convention
 *
 * Nothing checks that a matrix is of the kind the name says: entries that are
 * fixed in that kind are not read, and those of the result are exact. The result
 * may be the operand. E = m * result - identity, and the same with the factors
 * exchanged, u = 2^-24 and |.| entry by entry, as in transform.h; bounds hold
 * barring underflow. L is the upper-left 3x3 of m, t its translation, L^-1 the
 * upper-left 3x3 of the result.
 *
 * All functions return GN_OK or write nothing. GN_NULL_POINTER is returned for a
 * null pointer, GN_NOT_FINITE where an entry that is read is NaN or infinite,
 * GN_OUT_OF_RANGE where a result would overflow; contracts name what else. */
#ifndef GNOMON_INVERSE_H
#define GNOMON_INVERSE_H

#include "api.h"
#include "mat.h"
#include "status.h"

GN_BEGIN

/* Of T R S with the rotation R and the scale S, which may reflect: the rows of
 * L^-1 are the columns of L divided by their squared lengths, and the
 * translation is -L^-1 t. With G the exact inverse of the Gram diagonal, J =
 * G L^T and D = L J - I, D' = J L - I, what the stored floats of L lack to be a
 * rotation times a scale:
 *   m * result   |E| <= |D| + 4 u |L||L^-1|, and (|D| + 7 u |L||L^-1|) |t| in the
 *                translation;
 *   result * m   |E| <= |D'| + 4 u |L^-1||L|, and 3 u |L^-1||t|.
 * GN_SINGULAR where a column is zero. */
GN_API gn_status gn_mat4_invert_trs(const gn_mat4 *m, gn_mat4 *result);

/* Of an affine matrix: gn_mat3_invert of L (adjugate over determinant, in double),
 * and -L^-1 t. With k the permanent of |L| over the magnitude of its determinant
 * and v = u + 2^-50 k, every entry of L^-1 is within v of itself (2 u up to
 * k = 2^26):
 *   m * result   |E| <= v |L||L^-1|, and (v + 3 u) |L||L^-1||t| in the translation;
 *   result * m   |E| <= v |L^-1||L|, and 3 u |L^-1||t|.
 * GN_SINGULAR where k is above 2^48. */
GN_API gn_status gn_mat4_invert_affine(const gn_mat4 *m, gn_mat4 *result);

/* Of a scale on the diagonal and an offset in the last column: 1 / scale and
 * -offset / scale. |E| <= u |M||M^-1|, and u |M^-1||M| with the factors
 * exchanged. GN_SINGULAR where a scale is zero, GN_OUT_OF_RANGE where its
 * magnitude is not within 2^-126 .. 2^126. */
GN_API gn_status gn_mat4_invert_orthographic(const gn_mat4 *m, gn_mat4 *result);

/* Of a perspective projection: x and y scaled and skewed by z, clip z = c z + d,
 * clip w = s z. |E| <= u |M||M^-1|, and u |M^-1||M| with the factors exchanged,
 * where s is 1 or -1; 3 u where it is another number. GN_SINGULAR where a scale,
 * d or s is zero, GN_OUT_OF_RANGE where its magnitude is not within
 * 2^-126 .. 2^126. */
GN_API gn_status gn_mat4_invert_perspective(const gn_mat4 *m, gn_mat4 *result);

/* The matrix that takes normals where the affine m takes their surface: the
 * transposed L^-1 of gn_mat4_invert_affine, with its bound and its statuses. */
GN_API gn_status gn_mat4_normal_matrix(const gn_mat4 *m, gn_mat3 *result);

GN_END

#endif
