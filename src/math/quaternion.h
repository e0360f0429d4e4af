/* What the functions of quaternions share. */
#ifndef GNOMON_MATH_QUATERNION_H
#define GNOMON_MATH_QUATERNION_H

#include <gnomon/quat.h>

static inline gn_vec4 gn_quat_components(gn_quat q)
{
    const gn_vec4 v = {q.x, q.y, q.z, q.w};
    return v;
}

static inline gn_quat gn_quat_of(gn_vec4 v)
{
    const gn_quat q = {v.x, v.y, v.z, v.w};
    return q;
}

#endif
