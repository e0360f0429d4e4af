/* Shared by the exact results of several tables, in long double: 64 bits and more, so that products
 * of two floats are exact. */
#ifndef WIDE_H
#define WIDE_H

#include <math.h>
#include <stdbool.h>

#include "rows.h"

/* The functions that a row calls with arguments `in`. */
#define OWN(name) static bool own_##name(const float *in, float *out)
#define OTHER(name) static void other_##name(float *in, float *out)
#define EXACT(name) static void exact_##name(const float *in, struct exact *exact)

static inline gn_vec2 vec2_of(const float *in)
{
    return (gn_vec2){in[0], in[1]};
}

static inline gn_vec3 vec3_of(const float *in)
{
    return (gn_vec3){in[0], in[1], in[2]};
}

static inline gn_vec4 vec4_of(const float *in)
{
    return (gn_vec4){in[0], in[1], in[2], in[3]};
}

static inline bool put_vec3(gn_vec3 v, float *out)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
    return true;
}

static inline bool put_vec4(gn_vec4 v, float *out)
{
    out[3] = v.w;
    return put_vec3((gn_vec3){v.x, v.y, v.z}, out);
}

static inline bool put(float x, float *out)
{
    *out = x;
    return true;
}

/* Makes a vector longer by powers of two, exactly, for functions of its direction: cglm 0.9 takes
 * vectors and products for 0 whose length, or its square, is below FLT_EPSILON. */
static inline void lengthen(float *v, int count)
{
    float longest = 0.0f;

    for (int i = 0; i < count; ++i)
        longest = fmaxf(longest, fabsf(v[i]));
    for (; longest > 0.0f && longest < 0x1p20f; longest *= 0x1p24f)
        for (int i = 0; i < count; ++i)
            v[i] *= 0x1p24f;
}

typedef long double wide;

/* Sets entry i of the exact result to x, with errors relative to it. */
static inline void relative(struct exact *exact, int i, wide x)
{
    exact->value[i] = x;
    exact->scale[i] = fabsl(x);
}

/* Sets an entry with an error in units of u * scale. */
static inline void absolute(struct exact *exact, int i, wide x, wide scale)
{
    exact->value[i] = x;
    exact->scale[i] = scale;
}

/* The sum of products of count pairs, and of their magnitudes. */
static inline wide sum_of_products(const float *a, int a_stride, const float *b, int b_stride,
                                   int count, wide *magnitudes)
{
    wide sum = 0.0L;
    *magnitudes = 0.0L;
    for (int i = 0; i < count; ++i) {
        const wide term = (wide)a[i * a_stride] * (wide)b[i * b_stride];
        sum += term;
        *magnitudes += fabsl(term);
    }
    return sum;
}

static inline wide wide_length(const float *v, int count)
{
    wide magnitudes;
    return sqrtl(sum_of_products(v, 1, v, 1, count, &magnitudes));
}

/* Angles from -10 to 10, more than a turn and a half, made from any number. */
static inline float as_angle(float x)
{
    return remainderf(x, 20.0f);
}

#endif
