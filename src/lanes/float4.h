/* Four floats at a time, for single vectors and matrices: a column or a vector. They are held in
 * the vectors of GNU C where every processor of the target has such registers and computes in them
 * as IEEE 754 says, otherwise in four variables. */
#ifndef GN_LANES_FLOAT4_H
#define GN_LANES_FLOAT4_H

#include <stdbool.h>
#include <stdint.h>

#include <gnomon/vec.h>

#if defined(__GNUC__) && !defined(GN_ONLY_PORTABLE) &&                                             \
    (defined(__SSE2_MATH__) || (defined(__aarch64__) && !defined(__AARCH64EB__)) ||                \
     defined(__wasm_simd128__))

typedef float float4 __attribute__((__vector_size__(16)));

/* float4_stored is four floats at any address of a float; two_floats is two floats as one double,
 * as registers pass them, and float4_doubles two of these. */
typedef float float4_stored __attribute__((__vector_size__(16), __aligned__(4), __may_alias__));
typedef double two_floats __attribute__((__aligned__(4), __may_alias__));
typedef double float4_doubles __attribute__((__vector_size__(16)));

/* Indices 0 to 3 select from a, 4 to 7 from b. */
typedef int32_t float4_ints __attribute__((__vector_size__(16)));
#if defined(__clang__)
#define FLOAT4_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define FLOAT4_SHUFFLE(a, b, i, j, k, l) __builtin_shuffle(a, b, (float4_ints){i, j, k, l})
#endif

/* Repeats component i in all four, as integers, which x86 shuffles without a copy. */
#define FLOAT4_SPREAD(a, i) ((float4)FLOAT4_SHUFFLE((float4_ints)(a), (float4_ints)(a), i, i, i, i))

static inline float4 float4_set(float x, float y, float z, float w)
{
    const float4 r = {x, y, z, w};

    return r;
}

static inline float4 float4_load(const float p[4])
{
    return *(const float4_stored *)p;
}

static inline void float4_store(float p[4], float4 a)
{
    *(float4_stored *)p = a;
}

static inline float4 float4_add(float4 a, float4 b)
{
    return a + b;
}

static inline float4 float4_sub(float4 a, float4 b)
{
    return a - b;
}

static inline float4 float4_mul(float4 a, float4 b)
{
    return a * b;
}

static inline void float4_spread(float4 a, float4 spread[4])
{
    spread[0] = FLOAT4_SPREAD(a, 0);
    spread[1] = FLOAT4_SPREAD(a, 1);
    spread[2] = FLOAT4_SPREAD(a, 2);
    spread[3] = FLOAT4_SPREAD(a, 3);
}

/* Transposes the 3x3 matrix in the first three components of a, b and c; the fourth components
 * become 0. */
static inline void float4_transpose3(float4 *a, float4 *b, float4 *c)
{
    const float4_ints xyz = {-1, -1, -1, 0};
    const float4 low = FLOAT4_SHUFFLE(*a, *b, 0, 4, 1, 5);  /* a.x b.x a.y b.y */
    const float4 high = FLOAT4_SHUFFLE(*a, *b, 2, 6, 3, 7); /* a.z b.z a.w b.w */
    const float4 last = (float4)((float4_ints)*c & xyz);

    *a = FLOAT4_SHUFFLE(low, last, 0, 1, 4, 7);
    *b = FLOAT4_SHUFFLE(low, last, 2, 3, 5, 7);
    *c = FLOAT4_SHUFFLE(high, last, 0, 1, 6, 7);
}

/* Compilers pass structures of floats as pairs in two registers; loading pairs leaves them
 * there. */
static inline void float4_spread_vec4(gn_vec4 v, float4 spread[4])
{
    const float4_doubles xy = {*(const two_floats *)&v.x, 0.0},
                         zw = {*(const two_floats *)&v.z, 0.0};

    spread[0] = FLOAT4_SPREAD(xy, 0);
    spread[1] = FLOAT4_SPREAD(xy, 1);
    spread[2] = FLOAT4_SPREAD(zw, 0);
    spread[3] = FLOAT4_SPREAD(zw, 1);
}

static inline void float4_spread_vec3(gn_vec3 v, float4 spread[3])
{
    const float4_doubles xy = {*(const two_floats *)&v.x, 0.0};

    spread[0] = FLOAT4_SPREAD(xy, 0);
    spread[1] = FLOAT4_SPREAD(xy, 1);
    spread[2] = float4_set(v.z, v.z, v.z, v.z);
}

static inline gn_vec3 float4_to_vec3(float4 a)
{
    gn_vec3 v;

    *(two_floats *)&v.x = ((float4_doubles)a)[0];
    v.z = a[2];
    return v;
}

static inline gn_vec4 float4_to_vec4(float4 a)
{
    gn_vec4 v;

    *(two_floats *)&v.x = ((float4_doubles)a)[0];
    *(two_floats *)&v.z = ((float4_doubles)a)[1];
    return v;
}

#else

typedef struct float4 {
    float x, y, z, w;
} float4;

static inline float4 float4_set(float x, float y, float z, float w)
{
    const float4 r = {x, y, z, w};

    return r;
}

static inline float4 float4_load(const float p[4])
{
    return float4_set(p[0], p[1], p[2], p[3]);
}

static inline void float4_store(float p[4], float4 a)
{
    p[0] = a.x;
    p[1] = a.y;
    p[2] = a.z;
    p[3] = a.w;
}

static inline float4 float4_add(float4 a, float4 b)
{
    return float4_set(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);
}

static inline float4 float4_sub(float4 a, float4 b)
{
    return float4_set(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);
}

static inline float4 float4_mul(float4 a, float4 b)
{
    return float4_set(a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w);
}

static inline void float4_spread(float4 a, float4 spread[4])
{
    spread[0] = float4_set(a.x, a.x, a.x, a.x);
    spread[1] = float4_set(a.y, a.y, a.y, a.y);
    spread[2] = float4_set(a.z, a.z, a.z, a.z);
    spread[3] = float4_set(a.w, a.w, a.w, a.w);
}

static inline void float4_transpose3(float4 *a, float4 *b, float4 *c)
{
    const float4 x = float4_set(a->x, b->x, c->x, 0.0f);
    const float4 y = float4_set(a->y, b->y, c->y, 0.0f);

    *c = float4_set(a->z, b->z, c->z, 0.0f);
    *a = x;
    *b = y;
}

static inline void float4_spread_vec4(gn_vec4 v, float4 spread[4])
{
    float4_spread(float4_set(v.x, v.y, v.z, v.w), spread);
}

static inline void float4_spread_vec3(gn_vec3 v, float4 spread[3])
{
    spread[0] = float4_set(v.x, v.x, v.x, v.x);
    spread[1] = float4_set(v.y, v.y, v.y, v.y);
    spread[2] = float4_set(v.z, v.z, v.z, v.z);
}

static inline gn_vec3 float4_to_vec3(float4 a)
{
    const gn_vec3 v = {a.x, a.y, a.z};

    return v;
}

static inline gn_vec4 float4_to_vec4(float4 a)
{
    const gn_vec4 v = {a.x, a.y, a.z, a.w};

    return v;
}

#endif

static inline bool float4_has_nan(float4 a)
{
#if defined(__GNUC__) && defined(__SSE2_MATH__) && !defined(GN_ONLY_PORTABLE)
    return __builtin_ia32_movmskps((float4)(a != a)) != 0;
#else
    float x[4];

    float4_store(x, a);
    return x[0] != x[0] || x[1] != x[1] || x[2] != x[2] || x[3] != x[3];
#endif
}

#endif
