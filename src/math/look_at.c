/* Views: a camera at one point that looks at another point or in a direction, in a space of either
 * handedness. */
#include "../scalars/bits.h"
#include "transform.h"
#include "vector.h"

/* The square of the sine below which up counts as parallel to the view. */
#define PARALLEL_SQUARED 0x1p-40f

/* Writes side = forward x up, of length one and perpendicular to forward. The cross product of two
 * nearly parallel vectors is off by their rounding, 2 u over the sine of their angle, and part of
 * this error is along forward. Subtracting that part once leaves 6 u. */
static gn_status side_of(gn_vec3 forward, gn_vec3 up, gn_vec3 *side)
{
    gn_status status = gni_vec3_unit(up, &up);
    if (status != GN_OK)
        return status;
    gn_vec3 across = gn_vec3_cross(forward, up);
    if (gn_vec3_dot(across, across) <= PARALLEL_SQUARED)
        return GN_DEGENERATE;
    gni_vec3_unit(across, &across);
    across = gn_vec3_subtract(across, gn_vec3_scale(forward, gn_vec3_dot(across, forward)));
    return gni_vec3_unit(across, side);
}

/* Bound, with u = 2^-24. Each row has a squared length within 7 u of 1 (gni_vec3_unit). side and
 * forward are within 6 u of perpendicular; the cross product upward = side x forward, its rounding
 * and its normalisation leave 3.2 u against either. So R R^T - I has entries of at most 7 u and row
 * sums of at most 17 u. The row sums bound the eigenvalues, and thereby the entries of R^T R - I
 * too. The translation t = -R*eye is rounded three times, 3 u * |eye|_1 at most, which is the error
 * of R*eye + t. R^T*t + eye adds 17 u * |eye|_1 to sqrt(3) times that error. */
static gn_status look(gn_vec3 eye, gn_vec3 view, gn_vec3 up, bool left_handed, gn_transform *result)
{
    gn_vec3 forward, side, upward;
    gn_status status = gni_vec3_unit(view, &forward);
    if (status == GN_OK)
        status = side_of(forward, up, &side);
    if (status == GN_OK)
        status = gni_vec3_unit(gn_vec3_cross(side, forward), &upward);
    if (status != GN_OK)
        return status;
    /* z is forward in a left-handed space and backward in a right-handed one. The formula of the
     * cross product is the same in both; in a left-handed space it points to the left. */
    const gn_vec3 origin = {0.0f, 0.0f, 0.0f}; /* 0 - x is no negative zero */
    const gn_vec3 x = left_handed ? gn_vec3_subtract(origin, side) : side;
    const gn_vec3 z = left_handed ? forward : gn_vec3_subtract(origin, forward);
    gn_vec3 moved = {0.0f - gn_vec3_dot(x, eye), 0.0f - gn_vec3_dot(upward, eye),
                     0.0f - gn_vec3_dot(z, eye)};
    if (!gni_vec3_is_finite(moved))
        return GN_OUT_OF_RANGE;

    /* The camera's axes are the columns of the inverse, so they are the rows of the view. The
     * inverse of the translation t = -R*eye is -R^T*t, which is the eye. */
    gn_transform placed;
    gni_transform_from_rotation(x, upward, z, &placed);
    gn_transform_invert(&placed, result);
    result->matrix.m[3][0] = moved.x;
    result->matrix.m[3][1] = moved.y;
    result->matrix.m[3][2] = moved.z;
    result->inverse.m[3][0] = eye.x;
    result->inverse.m[3][1] = eye.y;
    result->inverse.m[3][2] = eye.z;
    return GN_OK;
}

static gn_status look_at(gn_vec3 eye, gn_vec3 target, gn_vec3 up, bool left_handed,
                         gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    if (!gni_vec3_is_finite(eye) || !gni_vec3_is_finite(target) || !gni_vec3_is_finite(up))
        return GN_NOT_FINITE;
    const gn_vec3 view = gn_vec3_subtract(target, eye);
    if (!gni_vec3_is_finite(view))
        return GN_OUT_OF_RANGE;
    return look(eye, view, up, left_handed, result);
}

static gn_status look_to(gn_vec3 eye, gn_vec3 direction, gn_vec3 up, bool left_handed,
                         gn_transform *result)
{
    if (!result)
        return GN_NULL_POINTER;
    if (!gni_vec3_is_finite(eye) || !gni_vec3_is_finite(direction) || !gni_vec3_is_finite(up))
        return GN_NOT_FINITE;
    return look(eye, direction, up, left_handed, result);
}

gn_status gn_look_at_rh(gn_vec3 eye, gn_vec3 target, gn_vec3 up, gn_transform *result)
{
    return look_at(eye, target, up, false, result);
}

gn_status gn_look_at_lh(gn_vec3 eye, gn_vec3 target, gn_vec3 up, gn_transform *result)
{
    return look_at(eye, target, up, true, result);
}

gn_status gn_look_to_rh(gn_vec3 eye, gn_vec3 direction, gn_vec3 up, gn_transform *result)
{
    return look_to(eye, direction, up, false, result);
}

gn_status gn_look_to_lh(gn_vec3 eye, gn_vec3 direction, gn_vec3 up, gn_transform *result)
{
    return look_to(eye, direction, up, true, result);
}
