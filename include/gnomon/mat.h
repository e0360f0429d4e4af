/** @file
 * Matrices of 3x3 and 4x4 floats, column-major: m[column][row], the bytes of an OpenGL uniform.
 * Vectors are columns, so A*B applied to v applies B first.
 *
 * Pointers must be valid. A result may be the same object as an operand: it is written after
 * everything was read. Results follow IEEE binary32 in the order written, NaN and infinity
 * included. A sum of n products has an error of at most n * 2^-24 times the sum of their
 * magnitudes. Bounds hold barring underflow and overflow of a product or partial sum. */
#ifndef GNOMON_MAT_H
#define GNOMON_MAT_H

#include "api.h"
#include "status.h"
#include "vec.h"

/** A matrix of 3x3 floats, m[column][row]. */
typedef struct gn_mat3 {
    float m[3][3];
} gn_mat3;

/** A matrix of 4x4 floats, m[column][row]. */
typedef struct gn_mat4 {
    float m[4][4];
} gn_mat4;

GN_BEGIN

/** Writes the identity. @{ */
GN_API void gn_mat3_identity(gn_mat3 *result);
GN_API void gn_mat4_identity(gn_mat4 *result);
/** @} */

/** Writes the product a*b. Each column of it is a times that column of b, in the order of
 * operations of gn_mat3_multiply_vec3 and gn_mat4_multiply_vec4. @{ */
GN_API void gn_mat3_multiply(const gn_mat3 *a, const gn_mat3 *b, gn_mat3 *result);
GN_API void gn_mat4_multiply(const gn_mat4 *a, const gn_mat4 *b, gn_mat4 *result);
/** @} */

/** Returns the product m*v: (c0*x + c1*y) + c2*z and ((c0*x + c1*y) + c2*z) + c3*w with the columns
 * c0 to c3 of m, in this order of operations, which is that of the reference's GLSL compiler.
 * gn_multiply_mat3 and gn_multiply_mat4 (shader_vectors.h) are the same, inline. @{ */
GN_API gn_vec3 gn_mat3_multiply_vec3(const gn_mat3 *m, gn_vec3 v);
GN_API gn_vec4 gn_mat4_multiply_vec4(const gn_mat4 *m, gn_vec4 v);
/** @} */

/** Returns the point m * (v, 1) without its w. This is right for affine matrices, whose last row is
 * (0, 0, 0, 1). Nothing is divided; for projections use gn_mat4_multiply_vec4. */
GN_API gn_vec3 gn_mat4_transform_point(const gn_mat4 *m, gn_vec3 v);

/** Returns the direction m * (v, 0) without its w: the translation does not act on it. Normals need
 * the normal matrix instead (transform.h). */
GN_API gn_vec3 gn_mat4_transform_direction(const gn_mat4 *m, gn_vec3 v);

/** Converts between gn_mat3 or gn_mat4 and a matrix whose rows are stored one after the other, as
 * most texts print it. Do not convert the matrix of a row-vector convention, such as Direct3D's: it
 * is the transpose of the matrix for column vectors, so its rows stored one after the other are
 * already the bytes of m. Copy those bytes instead. Input and output must not overlap. @{ */
GN_API void gn_mat3_from_rows(const float rows[9], gn_mat3 *result);
GN_API void gn_mat4_from_rows(const float rows[16], gn_mat4 *result);
GN_API void gn_mat3_to_rows(const gn_mat3 *m, float rows[9]);
GN_API void gn_mat4_to_rows(const gn_mat4 *m, float rows[16]);
/** @} */

/** Writes the affine matrix that transforms directions as `upper_left` does and leaves the origin
 * in place. */
GN_API void gn_mat4_from_mat3(const gn_mat3 *upper_left, gn_mat4 *result);

/** Writes the transpose: rows and columns exchanged. @{ */
GN_API void gn_mat3_transpose(const gn_mat3 *m, gn_mat3 *result);
GN_API void gn_mat4_transpose(const gn_mat4 *m, gn_mat4 *result);
/** @} */

/** Returns the sum of the diagonal: (m00 + m11) + m22 and (m00 + m11) + (m22 + m33). @{ */
GN_API float gn_mat3_trace(const gn_mat3 *m);
GN_API float gn_mat4_trace(const gn_mat4 *m);
/** @} */

/** Returns the determinant: 3x3 by cofactors of the first column, 4x4 by Laplace expansion over the
 * 2x2 minors of the first and the last two columns. The error is at most 6 (3x3) and 9 (4x4) times
 * 2^-24 times the permanent of the magnitudes (the determinant with every term taken positive).
 * @{ */
GN_API float gn_mat3_determinant(const gn_mat3 *m);
GN_API float gn_mat4_determinant(const gn_mat4 *m);
/** @} */

/** Writes the inverse of any regular matrix: the adjugate over the determinant, computed in double
 * and rounded once. Scale does not matter: 1e-20 * m is as regular as m, and its inverse is 1e20
 * times as large. Relative to the exact inverse of the stored floats, the error is at most 2^-23 +
 * 2^-48 * k in the Frobenius norm, with k the ratio of m's largest to smallest singular value,
 * barring underflow: 1.2e-7 up to k = 1e6, 1e-6 up to 2e8. No entry is a negative zero.
 *
 * `condition` may be null. Otherwise it receives the condition number in the infinity norm, |m| *
 * |inverse|, with |.| the largest sum of magnitudes in a row. It is at least 1, within a factor of
 * n (3 or 4) of k either way, and infinity if it is beyond the largest float. If m is known to a
 * relative error of e, the inverse has an error of e times the condition number.
 *
 * GN_NULL_POINTER; GN_NOT_FINITE; GN_SINGULAR if the determinant is zero, or below 2^-48 (3x3) or
 * 2^-72 (4x4) of the sum of the magnitudes of its terms (for 3x3 each term is an entry of the first
 * column times a minor, for 4x4 a product of minors); GN_OUT_OF_RANGE if an entry of the inverse
 * overflows. On a fault nothing is written. On a processor without doubles these functions call the
 * compiler's double routines. @{ */
GN_API gn_status gn_mat3_invert(const gn_mat3 *m, gn_mat3 *result, float *condition);
GN_API gn_status gn_mat4_invert(const gn_mat4 *m, gn_mat4 *result, float *condition);
/** @} */

/** Writes the inverse of a rotation R followed by a translation t: R^T and -R^T*t. Nothing checks
 * that m is such a matrix, and nothing is divided. The last row of m is not read; the last row of
 * the result is (0, 0, 0, 1) if t is finite. The translation is 0 - ((c0*t.x + c1*t.y) + c2*t.z)
 * with the columns c0 to c2 of R^T. Let u = 2^-24 and D = R*R^T - I, which measures what the stored
 * floats of R lack to be a rotation. Then m * result - I is D, and at most |D||t| + 3 u |R||R^T||t|
 * in the translation; result * m - I is R^T*R - I, and at most 3 u |R^T||t| in the translation;
 * both barring underflow. */
GN_API void gn_mat4_invert_rigid(const gn_mat4 *m, gn_mat4 *result);

/** Writes the upper-left 3x3 part, which is what m does to directions. */
GN_API void gn_mat4_upper_left(const gn_mat4 *m, gn_mat3 *result);

GN_END

#endif
