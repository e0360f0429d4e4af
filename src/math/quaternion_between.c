/* Interpolation between two rotations. */
#include <gnomon/scalar.h>

#include "../scalars/bits.h"
#include "quaternion.h"

/* Writes both quaternions normalised, with the second in the half space of the first. */
static gn_status prepare(gn_quat from, gn_quat to, float t, gn_vec4 *a, gn_vec4 *b)
{
    gn_status status = gn_vec4_normalize(gn_quat_components(from), a);
    gn_status other = gn_vec4_normalize(gn_quat_components(to), b);
    if (status == GN_NOT_FINITE || other == GN_NOT_FINITE || !gn_is_finite(t))
        return GN_NOT_FINITE;
    if (status != GN_OK || other != GN_OK)
        return GN_DEGENERATE;
    if (gn_vec4_dot(*a, *b) < 0.0f)
        *b = gn_vec4_negate(*b);
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

/* Writes the direction of v; its components are finite unless something overflowed. */
static gn_status finish(gn_vec4 v, gn_quat *result)
{
    if (gn_vec4_normalize(v, &v) != GN_OK)
        return GN_OUT_OF_RANGE;
    *result = gn_quat_of(v);
    return GN_OK;
}

/* sin((1 - t) angle) a + sin(t angle) b has the length sin(angle) and is normalised. The sines of
 * tiny angles could be denormal floats, which have few digits; but there sin(t angle) / sin(angle)
 * is t within a relative error of (t angle)^2 / 6. */
gn_status gn_quat_slerp(gn_quat a, gn_quat b, float t, gn_quat *result)
{
    gn_vec4 first, last;
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = prepare(a, b, t, &first, &last);
    if (status != GN_OK)
        return status;
    float angle =
        2.0f * gn_atan2(gn_vec4_distance(first, last), gn_vec4_length(gn_vec4_add(first, last)));
    if (angle < 0x1p-60f && gn_magnitude(t * angle) < 0x1p-13f)
        return finish(on_chord(first, last, t), result);
    return finish(gn_vec4_add(gn_vec4_scale(first, gn_sin((1.0f - t) * angle)),
                              gn_vec4_scale(last, gn_sin(t * angle))),
                  result);
}

gn_status gn_quat_nlerp(gn_quat a, gn_quat b, float t, gn_quat *result)
{
    gn_vec4 first, last;
    if (!result)
        return GN_NULL_POINTER;
    gn_status status = prepare(a, b, t, &first, &last);
    return status == GN_OK ? finish(on_chord(first, last, t), result) : status;
}
