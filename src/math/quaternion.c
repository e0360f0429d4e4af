/* The algebra of quaternions, and vectors rotated by them. */
#include "quaternion.h"

#include "../scalars/bits.h"

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

/* The length is off by 3.5 u, and enters twice; each division adds u. If the length is less than 1,
 * the first of the two quotients is smaller than the result, so it may be below the normal floats
 * although the result is not. So dividend and divisors are multiplied by 2^96 = 2^64 * 2^32: a
 * quotient is then below the normal floats only if the length is above 1 and the result is below
 * them too. Lengths near 1 all take this path, because a branch between lengths near 1 would be
 * mispredicted. */
gn_status gn_quat_invert(gn_quat q, gn_quat *result)
{
    if (!result)
        return GN_NULL_POINTER;
    if (!gn_is_finite(q.x) || !gn_is_finite(q.y) || !gn_is_finite(q.z) || !gn_is_finite(q.w))
        return GN_NOT_FINITE;
    float length = gn_vec4_length(gn_quat_components(q));
    if (length == 0.0f)
        return GN_DEGENERATE;
    const bool is_long = length >= 0x1p31f;
    const float lift = is_long ? 1.0f : 0x1p96f;
    const float first = is_long ? length : length * 0x1p64f;
    const float second = is_long ? length : length * 0x1p32f;
    const gn_quat back = {-q.x * lift / first / second, -q.y * lift / first / second,
                          -q.z * lift / first / second, q.w * lift / first / second};
    if (!gn_is_finite(length) || !gn_is_finite(back.x) || !gn_is_finite(back.y) ||
        !gn_is_finite(back.z) || !gn_is_finite(back.w))
        return GN_OUT_OF_RANGE;
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
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = gn_vec4_normalize(gn_quat_components(q), &unit);
    if (status == GN_OK)
        *result = gn_quat_of(unit);
    return status;
}

/* q v q^-1 = v + 2 (w (u x v) + u x (u x v)) / |q|^2. Dividing by |q|^2 ensures that a unit
 * quaternion whose length is off by rounding does not stretch the vector. */
gn_vec3 gn_quat_rotate(gn_quat q, gn_vec3 v)
{
    const gn_vec3 u = {q.x, q.y, q.z};
    const float square = gn_quat_dot(q, q);
    const gn_vec3 t = gn_vec3_scale(gn_vec3_cross(u, v), square > 0.0f ? 2.0f / square : 2.0f);
    return gn_vec3_add(v, gn_vec3_add(gn_vec3_scale(t, q.w), gn_vec3_cross(u, t)));
}
