/** @file
 * Vectors of two, three and four floats: plain structs passed by value, as columns. Every operation
 * is IEEE binary32, one rounding each, in the order its contract writes, so results are the same on
 * every target. NaN and infinity pass through by IEEE rules except where a contract says otherwise.
 * Bounds hold barring underflow and overflow of a product or partial sum.
 *
 *     add subtract multiply negate scale     arithmetic, component by component
 *     minimum maximum clamp                  selection, component by component
 *     dot cross                              products (cross: vec2, vec3)
 *     length distance normalize              lengths and directions
 *     angle                                  between directions (vec3)
 *     mix                                    between points
 *     reflect refract                        rays at a surface
 *
 * Each function exists as gn_vec2_, gn_vec3_ and gn_vec4_ unless the table names the types. */
#ifndef GNOMON_VEC_H
#define GNOMON_VEC_H

#include "api.h"
#include "status.h"

/** A vector of two floats: x and y. */
typedef struct gn_vec2 {
    float x, y;
} gn_vec2;

/** A vector of three floats: x, y and z. */
typedef struct gn_vec3 {
    float x, y, z;
} gn_vec3;

/** A vector of four floats: x, y, z and w. */
typedef struct gn_vec4 {
    float x, y, z, w;
} gn_vec4;

GN_BEGIN

/** Returns a + b, component by component. @{ */
GN_API gn_vec2 gn_vec2_add(gn_vec2 a, gn_vec2 b);
GN_API gn_vec3 gn_vec3_add(gn_vec3 a, gn_vec3 b);
GN_API gn_vec4 gn_vec4_add(gn_vec4 a, gn_vec4 b);
/** @} */

/** Returns a - b, component by component. @{ */
GN_API gn_vec2 gn_vec2_subtract(gn_vec2 a, gn_vec2 b);
GN_API gn_vec3 gn_vec3_subtract(gn_vec3 a, gn_vec3 b);
GN_API gn_vec4 gn_vec4_subtract(gn_vec4 a, gn_vec4 b);
/** @} */

/** Returns a * b, component by component. @{ */
GN_API gn_vec2 gn_vec2_multiply(gn_vec2 a, gn_vec2 b);
GN_API gn_vec3 gn_vec3_multiply(gn_vec3 a, gn_vec3 b);
GN_API gn_vec4 gn_vec4_multiply(gn_vec4 a, gn_vec4 b);
/** @} */

/** Returns -v: the sign of every component changes, also of zeros and NaN. @{ */
GN_API gn_vec2 gn_vec2_negate(gn_vec2 v);
GN_API gn_vec3 gn_vec3_negate(gn_vec3 v);
GN_API gn_vec4 gn_vec4_negate(gn_vec4 v);
/** @} */

/** Returns v * factor, component by component. @{ */
GN_API gn_vec2 gn_vec2_scale(gn_vec2 v, float factor);
GN_API gn_vec3 gn_vec3_scale(gn_vec3 v, float factor);
GN_API gn_vec4 gn_vec4_scale(gn_vec4 v, float factor);
/** @} */

/** Return the lesser or the greater component of a and b. If one is NaN, the result is the other,
 * as in the reference's GLSL. Otherwise it is a < b ? a : b or a > b ? a : b, so that of two zeros
 * the result is b's. @{ */
GN_API gn_vec2 gn_vec2_minimum(gn_vec2 a, gn_vec2 b);
GN_API gn_vec3 gn_vec3_minimum(gn_vec3 a, gn_vec3 b);
GN_API gn_vec4 gn_vec4_minimum(gn_vec4 a, gn_vec4 b);
GN_API gn_vec2 gn_vec2_maximum(gn_vec2 a, gn_vec2 b);
GN_API gn_vec3 gn_vec3_maximum(gn_vec3 a, gn_vec3 b);
GN_API gn_vec4 gn_vec4_maximum(gn_vec4 a, gn_vec4 b);
/** @} */

/** Returns every component clamped to low and high: the lesser of high and the greater of v and
 * low. For NaN returns low; if low > high returns high. @{ */
GN_API gn_vec2 gn_vec2_clamp(gn_vec2 v, float low, float high);
GN_API gn_vec3 gn_vec3_clamp(gn_vec3 v, float low, float high);
GN_API gn_vec4 gn_vec4_clamp(gn_vec4 v, float low, float high);
/** @} */

/** Returns the scalar product. The products are summed from the last component to the first, y + x,
 * (z + y) + x, ((w + z) + y) + x: the order of the reference's GLSL compiler. For n components, the
 * error is at most n * 2^-24 times the sum of the products' magnitudes, barring underflow. @{ */
GN_API float gn_vec2_dot(gn_vec2 a, gn_vec2 b);
GN_API float gn_vec3_dot(gn_vec3 a, gn_vec3 b);
GN_API float gn_vec4_dot(gn_vec4 a, gn_vec4 b);
/** @} */

/** Returns the z component of the vector product of (a, 0) and (b, 0): a.x*b.y - a.y*b.x. It is
 * positive if b lies counterclockwise of a. */
GN_API float gn_vec2_cross(gn_vec2 a, gn_vec2 b);

/** Returns the vector product a x b, right-handed: x cross y is z. Each component is the difference
 * of two rounded products. */
GN_API gn_vec3 gn_vec3_cross(gn_vec3 a, gn_vec3 b);

/** Returns the Euclidean length, gn_sqrt(dot(v, v)). A vector whose square would overflow, or would
 * lose bits to underflow, is first scaled by a power of two. So the relative error is at most 3.5 *
 * 2^-24 whenever the length is a normal float. If a component is infinite or the length is beyond
 * the largest float, returns infinity; otherwise, if a component is NaN, returns NaN. @{ */
GN_API float gn_vec2_length(gn_vec2 v);
GN_API float gn_vec3_length(gn_vec3 v);
GN_API float gn_vec4_length(gn_vec4 v);
/** @} */

/** Returns length(b - a). If the difference does not overflow and the result is a normal float, its
 * relative error is at most 4.5 * 2^-24 of the exact distance. @{ */
GN_API float gn_vec2_distance(gn_vec2 a, gn_vec2 b);
GN_API float gn_vec3_distance(gn_vec3 a, gn_vec3 b);
GN_API float gn_vec4_distance(gn_vec4 a, gn_vec4 b);
/** @} */

/** Writes the vector of length one in the direction of v: v / length(v), one division per
 * component. With n components, every component has a relative error of at most (n / 2 + 2) *
 * 2^-24, or an error of at most 2^-148 if it is no normal float; the length of the result is within
 * (n / 2 + 2) * 2^-24 of 1. Every finite vector but zero has a result: very short and very long
 * vectors are first scaled by a power of two. GN_NULL_POINTER, GN_NOT_FINITE (a component is NaN or
 * infinite) and GN_DEGENERATE (v is zero) leave the result untouched. @{ */
GN_API gn_status gn_vec2_normalize(gn_vec2 v, gn_vec2 *result);
GN_API gn_status gn_vec3_normalize(gn_vec3 v, gn_vec3 *result);
GN_API gn_status gn_vec4_normalize(gn_vec4 v, gn_vec4 *result);
/** @} */

/** Writes the angle between two directions, 0 to pi, within 10 * 2^-24 radians at every angle: W.
 * Kahan's 2 atan2(|a - b|, |a + b|) of the unit vectors. GN_NULL_POINTER, GN_NOT_FINITE and
 * GN_DEGENERATE (a or b is zero) leave the result untouched. */
GN_API gn_status gn_vec3_angle(gn_vec3 a, gn_vec3 b, float *radians);

/** Returns a * (1 - t) + b * t, component by component: linear interpolation in gn_mix's
 * operations. For finite a and b, the result is exactly a at t = 0 and exactly b at t = 1, except
 * that -0 may become +0. t is not clamped. The error is at most 3 * 2^-24 times the sum of the
 * magnitudes of both products. @{ */
GN_API gn_vec2 gn_vec2_mix(gn_vec2 a, gn_vec2 b, float t);
GN_API gn_vec3 gn_vec3_mix(gn_vec3 a, gn_vec3 b, float t);
GN_API gn_vec4 gn_vec4_mix(gn_vec4 a, gn_vec4 b, float t);
/** @} */

/** Returns the direction v reflected at a surface of unit normal: v - (2 * dot(normal, v)) *
 * normal. This is GLSL's reflect in the operations of the reference's compiler. A normal of
 * another length reflects wrongly. With n components, the error is at most (2 n + 4) * 2^-24 *
 * |v|. @{ */
GN_API gn_vec2 gn_vec2_reflect(gn_vec2 v, gn_vec2 normal);
GN_API gn_vec3 gn_vec3_reflect(gn_vec3 v, gn_vec3 normal);
GN_API gn_vec4 gn_vec4_reflect(gn_vec4 v, gn_vec4 normal);
/** @} */

/** Returns the unit direction v refracted at a surface of unit normal. v must come from the side of
 * the normal (dot(normal, v) < 0); eta is the refractive index of the side v comes from over that
 * of the other side. This is GLSL's refract in its specification's operations: with d = dot(normal,
 * v) and k = 1 - eta * (eta * (1 - d * d)), the result is eta * v - (eta * d + sqrt(k)) * normal,
 * or zero if k < 0 (total internal reflection). With u = 2^-24, k is off by at most (10 eta^2 + 1)
 * u. If k is more than twice that, the result is off by at most (8 eta + 4) u + (6 eta^2 + 1)
 * u / sqrt(k), barring underflow. @{ */
GN_API gn_vec2 gn_vec2_refract(gn_vec2 v, gn_vec2 normal, float eta);
GN_API gn_vec3 gn_vec3_refract(gn_vec3 v, gn_vec3 normal, float eta);
GN_API gn_vec4 gn_vec4_refract(gn_vec4 v, gn_vec4 normal, float eta);
/** @} */

GN_END

#endif
