/* Many vectors by one matrix, and many matrices, over SIMD registers. Every result has the
 * bits of the function for one that the name begins with (mat.h); only which NaN a NaN is may
 * differ. Two layouts:
 *
 *   _packed   gn_vec3, gn_vec4 or gn_mat4, one after the other
 *   _arrays   structure of arrays, the fastest: an array of floats for each component,
 *             given by pointers in the order x, y, z, w
 *
 * All functions return GN_OK or write nothing: GN_NULL_POINTER where a pointer is null
 * (arrays of no vectors may be) and GN_BACKEND_UNAVAILABLE for a back end that the library
 * does not hold. A result may be in place of an operand: the result array the very array
 * of the operand, of any component. Otherwise they must not overlap. The matrix that many
 * vectors are multiplied by is read first and may lie anywhere.
 *
 * The back end is the caller's to name, since asking the processor can take longer than
 * tens of thousands of vectors on a virtual machine. One that is named must be available
 * (gn_backend_available), and is not asked about again; gn_backend_best, asked once, gives
 * the fastest. GN_BACKEND_AUTO asks for GN_BULK_ASK vectors and more (a matrix is four), and
 * takes the best that every processor of the target has for fewer. */
#ifndef GNOMON_BULK_H
#define GNOMON_BULK_H

#include <stddef.h>

#include "api.h"
#include "backend.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

#define GN_BULK_ASK 65536

GN_BEGIN

/* result[i] = m * v[i] for i below count. */
GN_API gn_status gn_mat4_multiply_vec4_packed(const gn_mat4 *m, const gn_vec4 *v, gn_vec4 *result,
                                              size_t count, gn_backend backend);
GN_API gn_status gn_mat4_multiply_vec4_arrays(const gn_mat4 *m, const float *const v[4],
                                              float *const result[4], size_t count,
                                              gn_backend backend);

/* result[i] = a[i] * b[i]. One matrix times many is gn_mat4_multiply_vec4_packed over their
 * columns. */
GN_API gn_status gn_mat4_multiply_packed(const gn_mat4 *a, const gn_mat4 *b, gn_mat4 *result,
                                         size_t count, gn_backend backend);

/* The points m * (v[i], 1) without their w. */
GN_API gn_status gn_mat4_transform_point_packed(const gn_mat4 *m, const gn_vec3 *v, gn_vec3 *result,
                                                size_t count, gn_backend backend);
GN_API gn_status gn_mat4_transform_point_arrays(const gn_mat4 *m, const float *const v[3],
                                                float *const result[3], size_t count,
                                                gn_backend backend);

/* The directions m * (v[i], 0) without their w. */
GN_API gn_status gn_mat4_transform_direction_packed(const gn_mat4 *m, const gn_vec3 *v,
                                                    gn_vec3 *result, size_t count,
                                                    gn_backend backend);
GN_API gn_status gn_mat4_transform_direction_arrays(const gn_mat4 *m, const float *const v[3],
                                                    float *const result[3], size_t count,
                                                    gn_backend backend);

/* result[i] = m * v[i]: with the normal matrix (transform.h), normals. */
GN_API gn_status gn_mat3_multiply_vec3_packed(const gn_mat3 *m, const gn_vec3 *v, gn_vec3 *result,
                                              size_t count, gn_backend backend);
GN_API gn_status gn_mat3_multiply_vec3_arrays(const gn_mat3 *m, const float *const v[3],
                                              float *const result[3], size_t count,
                                              gn_backend backend);

GN_END

#endif
