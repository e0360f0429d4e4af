/** @file
 * Many vectors times one matrix, and many matrices times many, over SIMD registers. Without _packed
 * or _arrays, the name of each function is that of a function of mat.h. For each vector or matrix
 * these two write the same bits; only the bits of a NaN may differ. Two layouts:
 *
 *     _packed   gn_vec3, gn_vec4 or gn_mat4, one after the other
 *     _arrays   structure of arrays, the fastest: one array of floats for each component,
 *               given as pointers in the order x, y, z, w
 *
 * All functions return GN_OK, or a fault and then write nothing: GN_NULL_POINTER if a pointer is
 * null (arrays of no vectors may be null), GN_BACKEND_UNAVAILABLE if the library does not contain
 * the back end.
 *
 * A result may replace an operand: a result array may be exactly an operand's array, of any
 * component. Otherwise results and operands must not overlap. The matrix that many vectors are
 * multiplied by is read first and may lie anywhere.
 *
 * The caller names the back end, because asking the processor can take longer than tens of
 * thousands of vectors on a virtual machine. A named back end must be available
 * (gn_backend_available); this is not checked. gn_backend_best, asked once, returns the fastest.
 * GN_BACKEND_AUTO asks the processor for GN_BULK_ASK vectors or more (a matrix counts as four); for
 * fewer vectors it takes the best back end that every processor of the target has. */
#ifndef GNOMON_BULK_H
#define GNOMON_BULK_H

#include <stddef.h>

#include "api.h"
#include "backend.h"
#include "mat.h"
#include "status.h"
#include "vec.h"

/** The number of vectors from which on GN_BACKEND_AUTO asks the processor. */
#define GN_BULK_ASK 65536

GN_BEGIN

/** result[i] = m * v[i] for i below count. @{ */
GN_API gn_status gn_mat4_multiply_vec4_packed(const gn_mat4 *m, const gn_vec4 *v, gn_vec4 *result,
                                              size_t count, gn_backend backend);
GN_API gn_status gn_mat4_multiply_vec4_arrays(const gn_mat4 *m, const float *const v[4],
                                              float *const result[4], size_t count,
                                              gn_backend backend);
/** @} */

/** result[i] = a[i] * b[i] for i below count. To multiply one matrix by many, use
 * gn_mat4_multiply_vec4_packed over the columns of the many. */
GN_API gn_status gn_mat4_multiply_packed(const gn_mat4 *a, const gn_mat4 *b, gn_mat4 *result,
                                         size_t count, gn_backend backend);

/** result[i] = m * (v[i], 1) without its w, for i below count: points. @{ */
GN_API gn_status gn_mat4_transform_point_packed(const gn_mat4 *m, const gn_vec3 *v, gn_vec3 *result,
                                                size_t count, gn_backend backend);
GN_API gn_status gn_mat4_transform_point_arrays(const gn_mat4 *m, const float *const v[3],
                                                float *const result[3], size_t count,
                                                gn_backend backend);
/** @} */

/** result[i] = m * (v[i], 0) without its w, for i below count: directions. @{ */
GN_API gn_status gn_mat4_transform_direction_packed(const gn_mat4 *m, const gn_vec3 *v,
                                                    gn_vec3 *result, size_t count,
                                                    gn_backend backend);
GN_API gn_status gn_mat4_transform_direction_arrays(const gn_mat4 *m, const float *const v[3],
                                                    float *const result[3], size_t count,
                                                    gn_backend backend);
/** @} */

/** result[i] = m * v[i] for i below count. With the normal matrix (transform.h) as m, v holds
 * normals. @{ */
GN_API gn_status gn_mat3_multiply_vec3_packed(const gn_mat3 *m, const gn_vec3 *v, gn_vec3 *result,
                                              size_t count, gn_backend backend);
GN_API gn_status gn_mat3_multiply_vec3_arrays(const gn_mat3 *m, const float *const v[3],
                                              float *const result[3], size_t count,
                                              gn_backend backend);
/** @} */

GN_END

#endif
