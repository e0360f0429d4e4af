/* Quaternions from an axis and an angle, a matrix, two directions, a view. */
#include <gnomon/quat.h>
#include <gnomon/scalar.h>
#include <gnomon/transform.h>

#include "../scalars/bits.h"
#include "vector.h"

/* The largest magnitude that an entry of m^T*m - I may have. */
#define ROTATION_TOLERANCE 0x1p-10f

/* Directions whose cosine is below this are more than a third of a turn apart. */
#define OBTUSE -0.5f

gn_status gn_quat_from_axis_angle(gn_vec3 axis, float radians, gn_quat *result)
{
    gn_vec3 n;
    float s, c;
    if (!result)
        return GN_NULL_POINTER;
    if (!is_finite(radians))
        return GN_NOT_FINITE;
    gn_status status = gni_vec3_unit(axis, &n);
    if (status != GN_OK)
        return status;
    gn_sincos(0.5f * radians, &s, &c);
    const gn_quat q = {n.x * s, n.y * s, n.z * s, c};
    *result = q;
    return GN_OK;
}

static gn_vec3 column_of(const gn_mat3 *m, int column)
{
    const gn_vec3 v = {m->m[column][0], m->m[column][1], m->m[column][2]};
    return v;
}

static bool is_rotation(const gn_mat3 *m)
{
    bool rotation = gn_mat3_determinant(m) > 0.0f;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
            float lack = gn_vec3_dot(column_of(m, i), column_of(m, j)) - (i == j ? 1.0f : 0.0f);
            rotation = rotation && magnitude_of(lack) <= ROTATION_TOLERANCE;
        }
    }
    return rotation;
}

/* How far from 1 the squared length of a quotient may be. The computed square is off by 4 u of
 * itself, so the length is within 5.5 u of 1. */
#define UNIT_TOLERANCE 0x1.cp-22f

/* Returns `part` over the length of a column, length = 2 sqrt(square). For part == square the
 * quotient is a quarter of the length. */
static float quotient_of(float part, float square, float length)
{
    return part == square ? 0.25f * length : part / length;
}

/* Writes the direction of a column of 4 q q^T (gn_quat_from_mat3), whose diagonal entry is
 * `square`. For an exact rotation the length is 2 sqrt(square), which is nearer to the exact length
 * than the root of a rounded sum of squares. */
static gn_status normalized_column(gn_quat column, float square, gn_quat *result)
{
    const float length = 2.0f * gn_sqrt(square);
    const gn_quat q = {quotient_of(column.x, square, length), quotient_of(column.y, square, length),
                       quotient_of(column.z, square, length),
                       quotient_of(column.w, square, length)};
    if (magnitude_of(gn_quat_dot(q, q) - 1.0f) > UNIT_TOLERANCE)
        return gn_quat_normalize(column, result);
    *result = q;
    return GN_OK;
}

/* For q = (x, y, z, w) of length one, sums and differences of m's entries are 4 q w, 4 q x, 4 q y
 * and 4 q z (S. W. Shepperd, Quaternion from rotation matrix, Journal of Guidance and Control 1,
 * 1978). The largest of the squares among them is at least 1, so that column is the one to
 * normalise; each of its entries is off by at most the error of m's entries. */
gn_status gn_quat_from_mat3(const gn_mat3 *m, gn_quat *result)
{
    if (!m || !result)
        return GN_NULL_POINTER;
    const gn_vec3 x = column_of(m, 0), y = column_of(m, 1), z = column_of(m, 2);
    if (!gni_vec3_is_finite(x) || !gni_vec3_is_finite(y) || !gni_vec3_is_finite(z))
        return GN_NOT_FINITE;
    if (!is_rotation(m))
        return GN_OUT_OF_RANGE;
    const gn_quat by_w = {y.z - z.y, z.x - x.z, x.y - y.x, (x.x + y.y) + (z.z + 1.0f)};
    const gn_quat by_x = {(x.x - y.y) + (1.0f - z.z), x.y + y.x, z.x + x.z, y.z - z.y};
    const gn_quat by_y = {x.y + y.x, (y.y - x.x) + (1.0f - z.z), y.z + z.y, z.x - x.z};
    const gn_quat by_z = {z.x + x.z, y.z + z.y, (z.z - x.x) + (1.0f - y.y), x.y - y.x};
    gn_quat most = by_w;
    float square = by_w.w;
    if (by_x.x > square) {
        square = by_x.x;
        most = by_x;
    }
    if (by_y.y > square) {
        square = by_y.y;
        most = by_y;
    }
    if (by_z.z > square) {
        square = by_z.z;
        most = by_z;
    }
    return normalized_column(most, square, result);
}

/* Returns the rotation from a to b: (a x b, 1 + a.b), of length 2 cos(angle / 2), normalised. */
static gn_quat rotation_between(gn_vec3 a, gn_vec3 b)
{
    const gn_vec3 cross = gn_vec3_cross(a, b);
    gn_quat q = {cross.x, cross.y, cross.z, 1.0f + gn_vec3_dot(a, b)};
    gn_quat_normalize(q, &q);
    return q;
}

/* Returns the direction of the part of n that is perpendicular to the unit vector a. */
static gn_vec3 perpendicular_part(gn_vec3 n, gn_vec3 a)
{
    gn_vec3 part = gn_vec3_subtract(n, gn_vec3_scale(a, gn_vec3_dot(a, n)));
    gni_vec3_unit(part, &part);
    return part;
}

/* Returns a direction perpendicular to the unit vector a: the perpendicular part of v, or, if v is
 * zero or mostly along a, the perpendicular part of a coordinate axis that is not mostly along a.
 * The second step takes away what rounding leaves along a in the first. */
static gn_vec3 perpendicular_to(gn_vec3 a, gn_vec3 v)
{
    gn_vec3 y = {0.0f, 1.0f, 0.0f}, z = {0.0f, 0.0f, 1.0f}, n;
    if (gni_vec3_unit(v, &n) != GN_OK || magnitude_of(gn_vec3_dot(a, n)) > 0.5f)
        n = magnitude_of(a.y) <= 0.6f ? y : z;
    return perpendicular_part(perpendicular_part(n, a), a);
}

/* If the directions are nearly opposite, 1 + a.b is mostly rounding. A half turn about an axis
 * perpendicular to a takes a to -a, which is near b. a x b is that axis, as far as it is
 * determined. */
gn_status gn_quat_from_directions(gn_vec3 from, gn_vec3 to, gn_quat *result)
{
    gn_vec3 a, b;
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = gni_vec3_unit(from, &a);
    gn_status other = gni_vec3_unit(to, &b);
    if (status == GN_NOT_FINITE || other == GN_NOT_FINITE)
        return GN_NOT_FINITE;
    if (status != GN_OK || other != GN_OK)
        return GN_DEGENERATE;
    if (gn_vec3_dot(a, b) >= OBTUSE) {
        *result = rotation_between(a, b);
        return GN_OK;
    }
    const gn_vec3 axis = perpendicular_to(a, gn_vec3_cross(a, b));
    const gn_quat half_turn = {axis.x, axis.y, axis.z, 0.0f};
    return gn_quat_normalize(gn_quat_multiply(rotation_between(gn_vec3_negate(a), b), half_turn),
                             result);
}

gn_status gn_quat_look_rh(gn_vec3 forward, gn_vec3 up, gn_quat *result)
{
    const gn_vec3 origin = {0.0f, 0.0f, 0.0f};
    gn_transform view;
    gn_mat3 orientation;
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = gn_look_at_rh(origin, forward, up, &view);
    if (status != GN_OK)
        return status;
    gn_mat4_upper_left(&view.inverse, &orientation);
    return gn_quat_from_mat3(&orientation, result);
}
