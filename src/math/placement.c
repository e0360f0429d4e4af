/* Transforms that place things in a space: translations, scales and rotations. */
#include <gnomon/scalar.h>

#include "../scalars/bits.h"
#include "transform.h"
#include "vector.h"

gn_status gn_translate(gn_vec3 offset, gn_transform *result)
{
    gn_vec3 one = {1.0f, 1.0f, 1.0f};
    if (!result)
        return GN_NULL_POINTER;
    if (!gni_vec3_is_finite(offset))
        return GN_NOT_FINITE;
    return gni_transform_from_scale_offset(one, offset, result);
}

gn_status gn_scale(gn_vec3 factors, gn_transform *result)
{
    gn_vec3 zero = {0.0f, 0.0f, 0.0f};
    if (!result)
        return GN_NULL_POINTER;
    if (!gni_vec3_is_finite(factors))
        return GN_NOT_FINITE;
    if (factors.x == 0.0f || factors.y == 0.0f || factors.z == 0.0f)
        return GN_SINGULAR;
    return gni_transform_from_scale_offset(factors, zero, result);
}

/* Writes the rotation about axis 0, 1 or 2. Sine and cosine are within half a unit in the last
 * place, so s^2 + c^2 is within 2 u of 1. Off the diagonal c*s - s*c is exactly 0. */
static gn_status rotate_about(int axis, float radians, gn_transform *result)
{
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    float s, c;
    if (!result)
        return GN_NULL_POINTER;
    if (!is_finite(radians))
        return GN_NOT_FINITE;
    gn_sincos(radians, &s, &c);
    gni_transform_clear(result);
    result->matrix.m[next][next] = result->inverse.m[next][next] = c;
    result->matrix.m[last][last] = result->inverse.m[last][last] = c;
    result->matrix.m[next][last] = result->inverse.m[last][next] = s;
    result->matrix.m[last][next] = result->inverse.m[next][last] = -s;
    return GN_OK;
}

gn_status gn_rotate_x(float radians, gn_transform *result)
{
    return rotate_about(0, radians, result);
}

gn_status gn_rotate_y(float radians, gn_transform *result)
{
    return rotate_about(1, radians, result);
}

gn_status gn_rotate_z(float radians, gn_transform *result)
{
    return rotate_about(2, radians, result);
}

/* Rodrigues: R = c I + (1 - c) n n^T + s [n]x.
 *
 * Bound, with u = 2^-24; Gappa proves it from the lines of the kernel below (tests/proof). For the
 * stored n, s and c, rounding adds 4 u to an entry on the diagonal and 4.51 u to an entry off it.
 * The rows and columns of R have length 1, so rounding adds twice the root of 4^2 + 2 * 4.51^2,
 * 15.1 u, to R R^T and R^T R. Computed exactly, with |n|^2 = 1 + v, |v| <= 7 u (gni_vec3_unit), and
 * s^2 + c^2 = 1 + w, |w| <= 2 u, they differ from I by v (t^2 n_i^2 + s^2) + w (1 - n_i^2) on the
 * diagonal and by n_i n_j (t^2 v - w) off it: 30 u and 15 u. Lengths are off by half of a row's
 * sum, 46 + 2 * 31. */
gn_status gn_rotate_axis(gn_vec3 axis, float radians, gn_transform *result)
{
    gn_vec3 n;
    if (!result)
        return GN_NULL_POINTER;
    if (!is_finite(radians))
        return GN_NOT_FINITE;
    gn_status status = gni_vec3_unit(axis, &n);
    if (status != GN_OK)
        return status;
    float s, c;
    gn_sincos(radians, &s, &c);
    /* Kernel: rodrigues. */
    const float t = 1.0f - c;
    const float tx = t * n.x;
    const float ty = t * n.y;
    const float tz = t * n.z;
    const float sx = s * n.x;
    const float sy = s * n.y;
    const float sz = s * n.z;
    const float xx = tx * n.x + c;
    const float xy = tx * n.y + sz;
    const float xz = tx * n.z - sy;
    const float yx = ty * n.x - sz;
    const float yy = ty * n.y + c;
    const float yz = ty * n.z + sx;
    const float zx = tz * n.x + sy;
    const float zy = tz * n.y - sx;
    const float zz = tz * n.z + c;
    /* End of kernel. */
    const gn_vec3 x = {xx, xy, xz}, y = {yx, yy, yz}, z = {zx, zy, zz};
    gni_transform_from_rotation(x, y, z, result);
    return GN_OK;
}
