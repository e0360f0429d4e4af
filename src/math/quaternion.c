/* The algebra of quaternions, and vectors rotated by them. */
#include "quaternion.h"

#include "bits.h"

gn_quat gn_quat_identity(void)
{
    const gn_quat q = {0.0f, 0.0f, 0.0f, 1.0f};
    return q;
}

gn_quat gn_quat_multiply(gn_quat a, gn_quat b)
{
    const gn_quat product = {(a.w * b.x + a.x * b.w) + (a.y * b.z - a.z * b.y),
                             (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z),
                             (a.w * b.z + a.z * b.w) + (a.x * b.y - a.y * b.x),
                             (a.w * b.w - a.x * b.x) - (a.y * b.y + a.z * b.z)};
    return product;
}

gn_quat gn_quat_conjugate(gn_quat q)
{
    const gn_quat back = {-q.x, -q.y, -q.z, q.w};
    return back;
}

/* The length is off by 3.5 u, twice, and each division by u. */
gn_status gn_quat_invert(gn_quat q, gn_quat *result)
{
    if (!result) {
        return GN_NULL_POINTER;
    }
    if (!gn_is_finite(q.x) || !gn_is_finite(q.y) || !gn_is_finite(q.z) || !gn_is_finite(q.w)) {
        return GN_NOT_FINITE;
    }
    float length = gn_vec4_length(gn_quat_components(q));
    if (length == 0.0f) {
        return GN_DEGENERATE;
    }
    const gn_quat back = {-q.x / length / length, -q.y / length / length, -q.z / length / length,
                          q.w / length / length};
    if (!gn_is_finite(length) || !gn_is_finite(back.x) || !gn_is_finite(back.y) ||
        !gn_is_finite(back.z) || !gn_is_finite(back.w)) {
        return GN_OUT_OF_RANGE;
    }
    *result = back;
    return GN_OK;
}

float gn_quat_dot(gn_quat a, gn_quat b)
{
    return gn_vec4_dot(gn_quat_components(a), gn_quat_components(b));
}

gn_status gn_quat_normalize(gn_quat q, gn_quat *result)
{
    gn_vec4 unit;
    if (!result) {
        return GN_NULL_POINTER;
    }
    gn_status status = gn_vec4_normalize(gn_quat_components(q), &unit);
    if (status == GN_OK) {
        *result = gn_quat_of(unit);
    }
    return status;
}

/* q v q* = v + 2 w (u x v) + 2 u x (u x v), for |q| = 1. */
gn_vec3 gn_quat_rotate(gn_quat q, gn_vec3 v)
{
    const gn_vec3 u = {q.x, q.y, q.z};
    gn_vec3 t = gn_vec3_scale(gn_vec3_cross(u, v), 2.0f);
    return gn_vec3_add(v, gn_vec3_add(gn_vec3_scale(t, q.w), gn_vec3_cross(u, t)));
}
