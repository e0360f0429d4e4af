/* The rotation matrices of quaternions. */
#include "quaternion.h"

/* Squared lengths between these two neither overflow nor lose bits in products with components. */
#define SQUARE_SMALL 0x1p-60f
#define SQUARE_LARGE 0x1p60f

/* s = 2 / |q|^2 is off by 5 u of itself, four of them for the sum of squares; the products,
 * their sum and the product with s add 3 u. On the diagonal s (y^2 + z^2) is at most 2, so the
 * error is 16 u and the last rounding. Off the diagonal s (|x y| + |z w|) is at most 1, so the
 * error is 8 u. */
gn_status gn_quat_to_mat3(gn_quat q, gn_mat3 *result)
{
    if (!result)
        return GN_NULL_POINTER;
    float square = gn_quat_dot(q, q);
    if (!(square >= SQUARE_SMALL && square <= SQUARE_LARGE)) {
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
