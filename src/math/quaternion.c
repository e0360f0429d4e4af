/* Quaternions: their algebra, vectors rotated by them, their matrices, and interpolation between
 * two rotations. */
#include <gnomon/quat.h>
#include <gnomon/scalar.h>

#include "../scalars/bits.h"

static gn_vec4 components_of(gn_quat q)
{
    const gn_vec4 v = {q.x, q.y, q.z, q.w};
    return v;
}

static gn_quat quat_of(gn_vec4 v)
{
    const gn_quat q = {v.x, v.y, v.z, v.w};
    return q;
}

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
    if (!is_finite(q.x) || !is_finite(q.y) || !is_finite(q.z) || !is_finite(q.w))
        return GN_NOT_FINITE;
    float length = gn_vec4_length(components_of(q));
    if (length == 0.0f)
        return GN_DEGENERATE;
    const bool is_long = length >= 0x1p31f;
    const float lift = is_long ? 1.0f : 0x1p96f;
    const float first = is_long ? length : length * 0x1p64f;
    const float second = is_long ? length : length * 0x1p32f;
    const gn_quat back = {-q.x * lift / first / second, -q.y * lift / first / second,
                          -q.z * lift / first / second, q.w * lift / first / second};
    if (!is_finite(length) || !is_finite(back.x) || !is_finite(back.y) || !is_finite(back.z) ||
        !is_finite(back.w))
        return GN_OUT_OF_RANGE;
    *result = back;
    return GN_OK;
}

float gn_quat_dot(gn_quat a, gn_quat b)
{
    return gn_vec4_dot(components_of(a), components_of(b));
}

gn_status gn_quat_normalize(gn_quat q, gn_quat *result)
{
    gn_vec4 unit;
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = gn_vec4_normalize(components_of(q), &unit);
    if (status == GN_OK)
        *result = quat_of(unit);
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

/* s = 2 / |q|^2 is off by 5 u of itself, four of them for the sum of squares; the products,
 * their sum and the product with s add 3 u. On the diagonal s (y^2 + z^2) is at most 2, so the
 * error is 16 u and the last rounding. Off the diagonal s (|x y| + |z w|) is at most 1, so the
 * error is 8 u. */
gn_status gn_quat_to_mat3(gn_quat q, gn_mat3 *result)
{
    if (!result)
        return GN_NULL_POINTER;
    float square = gn_quat_dot(q, q);
    /* Between these two, products with components neither overflow nor lose bits. */
    if (!(square >= 0x1p-60f && square <= 0x1p60f)) {
        gn_status status = gn_quat_normalize(q, &q);
        if (status != GN_OK)
            return status;
        square = gn_quat_dot(q, q);
    }
    float s = 2.0f / square;
    float xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
    float xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    float xw = q.x * q.w, yw = q.y * q.w, zw = q.z * q.w;
    result->m[0][0] = 1.0f - s * (yy + zz);
    result->m[0][1] = s * (xy + zw);
    result->m[0][2] = s * (xz - yw);
    result->m[1][0] = s * (xy - zw);
    result->m[1][1] = 1.0f - s * (xx + zz);
    result->m[1][2] = s * (yz + xw);
    result->m[2][0] = s * (xz + yw);
    result->m[2][1] = s * (yz - xw);
    result->m[2][2] = 1.0f - s * (xx + yy);
    return GN_OK;
}

gn_status gn_quat_to_mat4(gn_quat q, gn_mat4 *result)
{
    gn_mat3 rotation;
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = gn_quat_to_mat3(q, &rotation);
    if (status == GN_OK)
        gn_mat4_from_mat3(&rotation, result);
    return status;
}

/* Writes both quaternions normalised, with the second in the half space of the first. */
static gn_status normalize_both(gn_quat from, gn_quat to, float t, gn_vec4 *a, gn_vec4 *b)
{
    gn_status status = gn_vec4_normalize(components_of(from), a);
    gn_status other = gn_vec4_normalize(components_of(to), b);
    if (status == GN_NOT_FINITE || other == GN_NOT_FINITE || !is_finite(t))
        return GN_NOT_FINITE;
    if (status != GN_OK || other != GN_OK)
        return GN_DEGENERATE;
    if (gn_vec4_dot(*a, *b) < 0.0f)
        *b = gn_vec4_negate(*b);
    return GN_OK;
}

/* Writes the direction of v; its components are finite unless something overflowed. */
static gn_status write_direction(gn_vec4 v, gn_quat *result)
{
    if (gn_vec4_normalize(v, &v) != GN_OK)
        return GN_OUT_OF_RANGE;
    *result = quat_of(v);
    return GN_OK;
}

/* a + (b - a) * t, whose error shrinks with the distance between a and b; gn_vec4_mix's does not.
 */
static gn_vec4 on_chord(gn_vec4 a, gn_vec4 b, float t)
{
    gn_vec4 between = {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t,
                       a.w + (b.w - a.w) * t};
    return between;
}

/* sin((1 - t) angle) a + sin(t angle) b has the length sin(angle) and is normalised. The sines of
 * tiny angles could be denormal floats, which have few digits; but there sin(t angle) / sin(angle)
 * is t within a relative error of (t angle)^2 / 6. */
gn_status gn_quat_slerp(gn_quat a, gn_quat b, float t, gn_quat *result)
{
    gn_vec4 first, last;
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = normalize_both(a, b, t, &first, &last);
    if (status != GN_OK)
        return status;
    float angle =
        2.0f * gn_atan2(gn_vec4_distance(first, last), gn_vec4_length(gn_vec4_add(first, last)));
    if (angle < 0x1p-60f && magnitude_of(t * angle) < 0x1p-13f)
        return write_direction(on_chord(first, last, t), result);
    return write_direction(gn_vec4_add(gn_vec4_scale(first, gn_sin((1.0f - t) * angle)),
                                       gn_vec4_scale(last, gn_sin(t * angle))),
                           result);
}

gn_status gn_quat_nlerp(gn_quat a, gn_quat b, float t, gn_quat *result)
{
    gn_vec4 first, last;
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = normalize_both(a, b, t, &first, &last);
    return status == GN_OK ? write_direction(on_chord(first, last, t), result) : status;
}
