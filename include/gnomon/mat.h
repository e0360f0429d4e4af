/* Matrices of 3x3 and 4x4 floats, column-major: m[column][row], the bytes of a
 * GL uniform. Vectors are columns, so A*B applied to v applies B first.
 *
 * Pointers must be valid; a result may be the same object as an operand, since
 * it is written after everything was read. Results follow IEEE binary32 in the
 * order written, NaN and infinity included. A sum of n products has an error of
 * at most n * 2^-24 times the sum of their magnitudes, barring underflow. */
#ifndef GNOMON_MAT_H
#define GNOMON_MAT_H

#include "api.h"
#include "status.h"
#include "vec.h"

typedef struct gn_mat3 {
    float m[3][3];
} gn_mat3;

typedef struct gn_mat4 {
    float m[4][4];
} gn_mat4;

GN_BEGIN

/* The identity. */
GN_API void gn_mat3_identity(gn_mat3 *result);
GN_API void gn_mat4_identity(gn_mat4 *result);

/* The product a*b. Every column of it is a times that column of b, in the order
 * of gn_mat3_multiply_vec3 and gn_mat4_multiply_vec4. */
GN_API void gn_mat3_multiply(const gn_mat3 *a, const gn_mat3 *b, gn_mat3 *result);
GN_API void gn_mat4_multiply(const gn_mat4 *a, const gn_mat4 *b, gn_mat4 *result);

/* The product m*v: (c0*x + c1*y) + c2*z and ((c0*x + c1*y) + c2*z) + c3*w with
 * c0 to c3 the columns of m, in this order of operations (the GLSL compiler's
 * the pictures are compared with). */
GN_API gn_vec3 gn_mat3_multiply_vec3(const gn_mat3 *m, gn_vec3 v);
GN_API gn_vec4 gn_mat4_multiply_vec4(const gn_mat4 *m, gn_vec4 v);

/* The point m * (v, 1) without its w: right for affine matrices, whose last row
 * is (0, 0, 0, 1). Nothing is divided; for projections use
 * gn_mat4_multiply_vec4. */
GN_API gn_vec3 gn_mat4_transform_point(const gn_mat4 *m, gn_vec3 v);

/* The direction m * (v, 0) without its w: the translation does not act on it.
 * Normals need the normal matrix instead (transform.h). */
GN_API gn_vec3 gn_mat4_transform_direction(const gn_mat4 *m, gn_vec3 v);

/* The matrix whose rows are stored one after the other, as Direct3D and most text does, and the
 * rows of a matrix so stored. A row-vector convention's matrix is the transpose of the one for
 * columns, so its rows stored one after the other are m as it is: copy those bytes instead. */
GN_API void gn_mat3_from_rows(const float rows[9], gn_mat3 *result);
GN_API void gn_mat4_from_rows(const float rows[16], gn_mat4 *result);
GN_API void gn_mat3_to_rows(const gn_mat3 *m, float rows[9]);
GN_API void gn_mat4_to_rows(const gn_mat4 *m, float rows[16]);

/* The affine matrix that does to directions what `upper_left` does and leaves the origin. */
GN_API void gn_mat4_from_mat3(const gn_mat3 *upper_left, gn_mat4 *result);

/* Rows and columns exchanged. */
GN_API void gn_mat3_transpose(const gn_mat3 *m, gn_mat3 *result);
GN_API void gn_mat4_transpose(const gn_mat4 *m, gn_mat4 *result);

/* The sum of the diagonal: (m00 + m11) + m22 and (m00 + m11) + (m22 + m33). */
GN_API float gn_mat3_trace(const gn_mat3 *m);
GN_API float gn_mat4_trace(const gn_mat4 *m);

/* The determinant: by cofactors of the first column, and by Laplace expansion
 * over the 2x2 minors of the first and the last two columns. The error is at
 * most 6 (3x3) and 9 (4x4) times 2^-24 times the permanent of the magnitudes
 * (the determinant with every term taken positive), barring underflow. */
GN_API float gn_mat3_determinant(const gn_mat3 *m);
GN_API float gn_mat4_determinant(const gn_mat4 *m);

/* The inverse of any matrix that has one, as the adjugate over the determinant, computed in
 * double and rounded once. Scale does not matter: 1e-20 * m is as regular as m, and its
 * inverse 1e20 times as large. Relative to the exact inverse of the stored floats, the error is
 * at most 2^-23 + 2^-48 * k in the Frobenius norm, with k the ratio of m's largest and
 * smallest singular value, barring underflow: 1.2e-7 up to k = 1e6, 1e-6 up to 2e8. No entry
 * is a negative zero.
 *
 * `condition` may be null, and otherwise receives the condition number in the infinity
 * norm, |m| * |inverse| with |.| the largest sum of magnitudes in a row: at least 1, and k
 * within a factor of n (3 or 4) either way; infinity if it is beyond the largest float. What
 * is known of m to a relative error of e leaves the inverse an error of e times that.
 *
 * GN_NULL_POINTER, GN_NOT_FINITE; GN_SINGULAR where the determinant is zero, or below 2^-48
 * (3x3) or 2^-72 (4x4) of the magnitudes of the terms it is summed from: a product of
 * minors for 4x4; GN_OUT_OF_RANGE where an entry of the inverse overflows. These write
 * nothing. On a processor without doubles they call the compiler's routines for them. */
GN_API gn_status gn_mat3_invert(const gn_mat3 *m, gn_mat3 *result, float *condition);
GN_API gn_status gn_mat4_invert(const gn_mat4 *m, gn_mat4 *result, float *condition);

/* The inverse of a rotation R followed by a translation t: R^T and -R^T*t. Nothing checks
 * that m is such a matrix, and nothing is divided. The last row of m is not read; that of
 * the result is (0, 0, 0, 1) where t is finite. The translation is
 * 0 - ((c0*t.x + c1*t.y) + c2*t.z) with c0 to c2 the columns of R^T.
 * With u = 2^-24 and D = R*R^T - I, what the stored floats of R lack to be a rotation,
 * m * result - I is D, and at most |D||t| + 3 u |R||R^T||t| in the translation;
 * result * m - I is R^T*R - I, and at most 3 u |R^T||t|; both barring underflow. */
GN_API void gn_mat4_invert_rigid(const gn_mat4 *m, gn_mat4 *result);

/* The upper-left 3x3 part: what m does to directions. */
GN_API void gn_mat4_upper_left(const gn_mat4 *m, gn_mat3 *result);

GN_END

#endif
