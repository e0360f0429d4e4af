/* Vectors of up to four components in long double. */
#ifndef WIDE_H
#define WIDE_H

#include <math.h>
#include <stdbool.h>

#include <gnomon/quat.h>
#include <gnomon/vec.h>

#include "double_matrix.h"

typedef long double wide;

#define WIDE_U ((wide)U)
#define WIDE_SLACK ((wide)SLACK)

typedef struct wide4 {
    wide v[4];
} wide4;

static inline wide4 wide_vec(gn_vec3 v)
{
    return (wide4){{(wide)v.x, (wide)v.y, (wide)v.z, 0.0L}};
}

static inline wide4 wide_quat(gn_quat q)
{
    return (wide4){{(wide)q.x, (wide)q.y, (wide)q.z, (wide)q.w}};
}

static inline gn_vec3 narrowed(wide4 a)
{
    return (gn_vec3){(float)a.v[0], (float)a.v[1], (float)a.v[2]};
}

/* p a + q b */
static inline wide4 combined(wide p, wide4 a, wide q, wide4 b)
{
    for (int i = 0; i < 4; ++i)
        a.v[i] = p * a.v[i] + q * b.v[i];
    return a;
}

static inline wide4 positive(wide4 a)
{
    for (int i = 0; i < 4; ++i)
        a.v[i] = fabsl(a.v[i]);
    return a;
}

static inline wide dot(wide4 a, wide4 b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2] + a.v[3] * b.v[3];
}

static inline wide length(wide4 a)
{
    return sqrtl(dot(a, a));
}

/* The cross product; with sign = 1, every term is positive if a and b are. */
static inline wide4 crossed(wide4 a, wide4 b, wide sign)
{
    wide4 c = {{0.0L}};
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        c.v[k] = a.v[i] * b.v[j] + sign * a.v[j] * b.v[i];
    }
    return c;
}

#endif
