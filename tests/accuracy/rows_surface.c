/* Distances beside cglm's, and rays at a surface, which cglm lacks. Bounds are vec.h's. */
#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "rows.h"
#include "wide.h"

static void unit(float *v, int count)
{
    const wide length = wide_length(v, count);
    if (length == 0.0L)
        v[0] = 1.0f;
    for (int i = 0; i < count && length != 0.0L; ++i)
        v[i] = (float)((wide)v[i] / length);
}

static wide wide_dot(const float *a, const float *b, int count)
{
    wide magnitudes;
    return sum_of_products(a, 1, b, 1, count, &magnitudes);
}

static void exact_distance(const float *in, int count, struct exact *exact)
{
    wide squares = 0.0L;
    for (int i = 0; i < count; ++i)
        squares += ((wide)in[i] - (wide)in[count + i]) * ((wide)in[i] - (wide)in[count + i]);
    relative(exact, 0, sqrtl(squares));
}

/* An error of at most (2 n + 4) u |v|. */
static void exact_reflect(const float *in, int count, struct exact *exact)
{
    const wide twice = 2.0L * wide_dot(in, in + count, count);
    for (int i = 0; i < count; ++i)
        absolute(exact, i, (wide)in[i] - twice * (wide)in[count + i], wide_length(in, count));
}

static void prepare_reflect(float *in, int count)
{
    unit(in + count, count);
}

/* The square of the refracted direction's part along the normal. */
static wide square_along(const float *in, int count)
{
    const wide eta = (wide)in[2 * count], d = wide_dot(in, in + count, count);
    return 1.0L - eta * eta * (1.0L - d * d);
}

/* An error of one unit is the contract's bound. */
static void exact_refract(const float *in, int count, struct exact *exact)
{
    const wide eta = (wide)in[2 * count], k = square_along(in, count);
    const wide along = eta * wide_dot(in, in + count, count) + (k < 0.0L ? 0.0L : sqrtl(k));
    for (int i = 0; i < count && k >= 0.0L; ++i)
        absolute(exact, i, eta * (wide)in[i] - along * (wide)in[count + i],
                 8.0L * eta + 4.0L + (6.0L * eta * eta + 1.0L) / sqrtl(k));
}

/* Unit vectors on both sides of the surface, eta 0.125 to 2.125, nowhere near total reflection. */
static void prepare_refract(float *in, int count)
{
    unit(in, count);
    unit(in + count, count);
    for (int i = 0; i < count && wide_dot(in, in + count, count) > 0.0L; ++i)
        in[i] = -in[i];
    in[2 * count] = 0.125f + fabsf(remainderf(in[2 * count], 4.0f));
    if (fabsl(square_along(in, count)) < 0x1p-8L)
        in[2 * count] = 0.5f;
}

static bool put_vec2(gn_vec2 v, float *out)
{
    out[0] = v.x;
    out[1] = v.y;
    return true;
}

/* Rows for vectors of n components. */
#define COMPONENTS(n)                                                                              \
    OWN(distance##n)                                                                               \
    {                                                                                              \
        return put(gn_vec##n##_distance(vec##n##_of(in), vec##n##_of(in + n)), out);               \
    }                                                                                              \
    OTHER(distance##n)                                                                             \
    {                                                                                              \
        *out = glm_vec##n##_distance(in, in + n);                                                  \
    }                                                                                              \
    EXACT(distance##n)                                                                             \
    {                                                                                              \
        exact_distance(in, n, exact);                                                              \
    }                                                                                              \
    static void prepare_reflect##n(float *in)                                                      \
    {                                                                                              \
        prepare_reflect(in, n);                                                                    \
    }                                                                                              \
    OWN(reflect##n)                                                                                \
    {                                                                                              \
        return put_vec##n(gn_vec##n##_reflect(vec##n##_of(in), vec##n##_of(in + n)), out);         \
    }                                                                                              \
    EXACT(reflect##n)                                                                              \
    {                                                                                              \
        exact_reflect(in, n, exact);                                                               \
    }                                                                                              \
    static void prepare_refract##n(float *in)                                                      \
    {                                                                                              \
        prepare_refract(in, n);                                                                    \
    }                                                                                              \
    OWN(refract##n)                                                                                \
    {                                                                                              \
        return put_vec##n(gn_vec##n##_refract(vec##n##_of(in), vec##n##_of(in + n), in[2 * n]),    \
                          out);                                                                    \
    }                                                                                              \
    EXACT(refract##n)                                                                              \
    {                                                                                              \
        exact_refract(in, n, exact);                                                               \
    }

COMPONENTS(2)
COMPONENTS(3)
COMPONENTS(4)

/* cglm rounds the difference, u, and the length, n/2 + 1. */
static const struct row rows[] = {
    ROW(distance2, "vec2 distance", 4, 1, 30, NULL, 4.5, 3),
    ROW(distance3, "vec3 distance", 6, 1, 30, NULL, 4.5, 3.5),
    ROW(distance4, "vec4 distance", 8, 1, 30, NULL, 4.5, 4),
    OWN_ROW(reflect2, "vec2 reflect", 4, 2, 30, prepare_reflect2, 8, -1),
    OWN_ROW(reflect3, "vec3 reflect", 6, 3, 30, prepare_reflect3, 10, -1),
    OWN_ROW(reflect4, "vec4 reflect", 8, 4, 30, prepare_reflect4, 12, -1),
    OWN_ROW(refract2, "vec2 refract", 5, 2, 5, prepare_refract2, 1, -1),
    OWN_ROW(refract3, "vec3 refract", 7, 3, 5, prepare_refract3, 1, -1),
    OWN_ROW(refract4, "vec4 refract", 9, 4, 5, prepare_refract4, 1, -1),
};

const struct table surface_rows = {rows, sizeof rows / sizeof rows[0]};
