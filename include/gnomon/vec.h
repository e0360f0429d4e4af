/* Vectors of two, three and four floats: plain structs passed by value, as
 * columns. Every operation is IEEE binary32, one rounding each, in the order
 * its contract writes, so results are the same on every target; NaN and
 * infinity pass through by IEEE rules except where a status is returned. */
#ifndef GNOMON_VEC_H
#define GNOMON_VEC_H

#include "api.h"
#include "status.h"

typedef struct gn_vec2 {
    float x, y;
} gn_vec2;

typedef struct gn_vec3 {
    float x, y, z;
} gn_vec3;

typedef struct gn_vec4 {
    float x, y, z, w;
} gn_vec4;

GN_BEGIN

/* a + b, component by component. */
GN_API gn_vec2 gn_vec2_add(gn_vec2 a, gn_vec2 b);
GN_API gn_vec3 gn_vec3_add(gn_vec3 a, gn_vec3 b);
GN_API gn_vec4 gn_vec4_add(gn_vec4 a, gn_vec4 b);

/* a - b, component by component. */
GN_API gn_vec2 gn_vec2_subtract(gn_vec2 a, gn_vec2 b);
GN_API gn_vec3 gn_vec3_subtract(gn_vec3 a, gn_vec3 b);
GN_API gn_vec4 gn_vec4_subtract(gn_vec4 a, gn_vec4 b);

/* v * factor, component by component. */
GN_API gn_vec2 gn_vec2_scale(gn_vec2 v, float factor);
GN_API gn_vec3 gn_vec3_scale(gn_vec3 v, float factor);
GN_API gn_vec4 gn_vec4_scale(gn_vec4 v, float factor);

/* The scalar product. The products are summed from the last component to the
 * first, y + x, (z + y) + x, ((w + z) + y) + x: the order of the GLSL compiler
 * the pictures are compared with. Error at most n * 2^-24 times the sum of the
 * products' magnitudes, for n components, barring underflow. */
GN_API float gn_vec2_dot(gn_vec2 a, gn_vec2 b);
GN_API float gn_vec3_dot(gn_vec3 a, gn_vec3 b);
GN_API float gn_vec4_dot(gn_vec4 a, gn_vec4 b);

/* The z component of the vector product of (a, 0) and (b, 0), which is
 * a.x*b.y - a.y*b.x: positive where b lies counterclockwise of a. */
GN_API float gn_vec2_cross(gn_vec2 a, gn_vec2 b);

/* The vector product a x b, right-handed: x cross y is z. Each component is the
 * difference of two rounded products. */
GN_API gn_vec3 gn_vec3_cross(gn_vec3 a, gn_vec3 b);

/* The Euclidean length, gn_sqrt(dot(v, v)). A vector whose square would
 * overflow or lose bits to underflow is scaled by a power of two first, so the
 * relative error is at most 3.5 * 2^-24 wherever the length is a normal float. An
 * infinite component, or a length beyond the largest float, gives infinity; a NaN
 * otherwise gives NaN. */
GN_API float gn_vec2_length(gn_vec2 v);
GN_API float gn_vec3_length(gn_vec3 v);
GN_API float gn_vec4_length(gn_vec4 v);

/* The vector of length one in the direction of v: v * (1 / length(v)), but with
 * four components v / length(v), one rounding less. Any finite vector but zero has one: the very
 * small and the very large are scaled by a power of two first. The length of the result is
 * within 5.5 * 2^-24 of 1. GN_NULL_POINTER, GN_NOT_FINITE (a component is NaN or infinite) and
 * GN_DEGENERATE (v is zero) leave the result untouched. */
GN_API gn_status gn_vec2_normalize(gn_vec2 v, gn_vec2 *result);
GN_API gn_status gn_vec3_normalize(gn_vec3 v, gn_vec3 *result);
GN_API gn_status gn_vec4_normalize(gn_vec4 v, gn_vec4 *result);

/* a + (b - a) * t, component by component: linear interpolation from a at t = 0
 * (exactly) to b at t = 1 (within a rounding of b - a). t is not clamped. */
GN_API gn_vec2 gn_vec2_lerp(gn_vec2 a, gn_vec2 b, float t);
GN_API gn_vec3 gn_vec3_lerp(gn_vec3 a, gn_vec3 b, float t);
GN_API gn_vec4 gn_vec4_lerp(gn_vec4 a, gn_vec4 b, float t);

GN_END

#endif
