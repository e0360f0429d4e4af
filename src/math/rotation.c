/* Rotations about coordinate axes and about any axis. */
#include <gnomon/scalar.h>

#include "bits.h"
#include "length.h"
#include "transform.h"

/* Sine and cosine are within half a last place, so s^2 + c^2 is within 2 u of 1;
 * off the diagonal c*s - s*c is exactly 0. */
gn_status gn_rotate_x(float radians, gn_transform *result)
{
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!gn_is_finite(radians)) {
        return GN_NOT_FINITE;
    }
    float s, c;
    gn_sincos(radians, &s, &c);
    gn_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, c, s}, z = {0.0f, -s, c};
    gn_transform_from_rotation(x, y, z, result);
    return GN_OK;
}

gn_status gn_rotate_y(float radians, gn_transform *result)
{
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!gn_is_finite(radians)) {
        return GN_NOT_FINITE;
    }
    float s, c;
    gn_sincos(radians, &s, &c);
    gn_vec3 x = {c, 0.0f, -s}, y = {0.0f, 1.0f, 0.0f}, z = {s, 0.0f, c};
    gn_transform_from_rotation(x, y, z, result);
    return GN_OK;
}

gn_status gn_rotate_z(float radians, gn_transform *result)
{
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!gn_is_finite(radians)) {
        return GN_NOT_FINITE;
    }
    float s, c;
    gn_sincos(radians, &s, &c);
    gn_vec3 x = {c, s, 0.0f}, y = {-s, c, 0.0f}, z = {0.0f, 0.0f, 1.0f};
    gn_transform_from_rotation(x, y, z, result);
    return GN_OK;
}

/* Rodrigues: R = c I + (1 - c) n n^T + s [n]x.
 *
 * Bound, with u = 2^-24. Rounding, for the stored n, to first order: s and c are
 * off by u/2, t = 1 - c by another u, each product by u of itself and the sum by
 * u, which adds up to 6 u on the diagonal (at n_i = 1, t = 2) and less than 4 u
 * off it. The rows r of a rotation have the length 1, so R R^T differs from I by
 * at most 6 u * (sum |r_ik| + sum |r_jk|) <= 12 sqrt(3) u < 21 u. Axis: let
 * |n|^2 = 1 + v, |v| <= 7 u. R takes n to (1 + t v) n and scales the plane across
 * it by 1 + s^2 v / 2, so R R^T differs from I by 2 t v n n^T + s^2 v (I - n n^T):
 * 28 u on the diagonal and 14 u off it. In all 49 u and 35 u. */
gn_status gn_rotate_axis(gn_vec3 axis, float radians, gn_transform *result)
{
    gn_vec3 n;
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!gn_is_finite(radians)) {
        return GN_NOT_FINITE;
    }
    gn_status status = gn_vec3_unit(axis, &n);
    if (status != GN_OK) {
        return status;
    }
    float s, c;
    gn_sincos(radians, &s, &c);
    float t = 1.0f - c;
    float tx = t * n.x, ty = t * n.y, tz = t * n.z;
    float sx = s * n.x, sy = s * n.y, sz = s * n.z;
    gn_vec3 x = {tx * n.x + c, tx * n.y + sz, tx * n.z - sy};
    gn_vec3 y = {ty * n.x - sz, ty * n.y + c, ty * n.z + sx};
    gn_vec3 z = {tz * n.x + sy, tz * n.y - sx, tz * n.z + c};
    gn_transform_from_rotation(x, y, z, result);
    return GN_OK;
}
