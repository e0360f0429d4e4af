/* Four floats at a time, for single vectors and matrices: a column or a vector. They are held in
 * the vectors of GNU C where every processor of the target has such registers and computes in them
 * as IEEE 754 says, otherwise in four variables. */
#ifndef GN_LANES_QUAD_H
#define GN_LANES_QUAD_H

#include <stdint.h>

#include <gnomon/vec.h>

#if defined(__GNUC__) && !defined(GN_ONLY_PORTABLE) &&                                             \
    (defined(__SSE2_MATH__) || (defined(__aarch64__) && !defined(__AARCH64EB__)) ||                \
     defined(__wasm_simd128__))

typedef float quad_f __attribute__((__vector_size__(16)));

/* quad_stored is four floats at any address of a float; quad_pair is two floats as one double, as
 * registers pass them. */
typedef float quad_stored __attribute__((__vector_size__(16), __aligned__(4), __may_alias__));
typedef double quad_pair __attribute__((__aligned__(4), __may_alias__));
typedef double quad_pairs __attribute__((__vector_size__(16)));

/* Indices 0 to 3 select from a, 4 to 7 from b. */
typedef int32_t quad_places __attribute__((__vector_size__(16)));
#if defined(__clang__)
#define QUAD_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define QUAD_SHUFFLE(a, b, i, j, k, l) __builtin_shuffle(a, b, (quad_places){i, j, k, l})
#endif

/* Repeats component i in all four, as integers, which x86 shuffles without a copy. */
#define QUAD_SPREAD(a, i) ((quad_f)QUAD_SHUFFLE((quad_places)(a), (quad_places)(a), i, i, i, i))

static inline quad_f quad_set(float x, float y, float z, float w)
{
    const quad_f r = {x, y, z, w};

    return r;
}

static inline quad_f quad_load(const float p[4])
{
    return *(const quad_stored *)p;
}

static inline void quad_store(float p[4], quad_f a)
{
    *(quad_stored *)p = a;
}

static inline quad_f quad_add(quad_f a, quad_f b)
{
    return a + b;
}

static inline quad_f quad_sub(quad_f a, quad_f b)
{
    return a - b;
}

static inline quad_f quad_mul(quad_f a, quad_f b)
{
    return a * b;
}

static inline void quad_spread(quad_f a, quad_f spread[4])
{
    spread[0] = QUAD_SPREAD(a, 0);
    spread[1] = QUAD_SPREAD(a, 1);
    spread[2] = QUAD_SPREAD(a, 2);
    spread[3] = QUAD_SPREAD(a, 3);
}

/* Transposes the 3x3 matrix in the first three components of a, b and c; the fourth components
 * become 0. */
static inline void quad_transpose3(quad_f *a, quad_f *b, quad_f *c)
{
    const quad_places xyz = {-1, -1, -1, 0};
    const quad_f low = QUAD_SHUFFLE(*a, *b, 0, 4, 1, 5);  /* a.x b.x a.y b.y */
    const quad_f high = QUAD_SHUFFLE(*a, *b, 2, 6, 3, 7); /* a.z b.z a.w b.w */
    const quad_f last = (quad_f)((quad_places)*c & xyz);

    *a = QUAD_SHUFFLE(low, last, 0, 1, 4, 7);
    *b = QUAD_SHUFFLE(low, last, 2, 3, 5, 7);
    *c = QUAD_SHUFFLE(high, last, 0, 1, 6, 7);
}

/* Compilers pass structures of floats as pairs in two registers; loading pairs leaves them
 * there. */
static inline void quad_spread_vec4(gn_vec4 v, quad_f spread[4])
{
    const quad_pairs xy = {*(const quad_pair *)&v.x, 0.0}, zw = {*(const quad_pair *)&v.z, 0.0};

    spread[0] = QUAD_SPREAD(xy, 0);
    spread[1] = QUAD_SPREAD(xy, 1);
    spread[2] = QUAD_SPREAD(zw, 0);
    spread[3] = QUAD_SPREAD(zw, 1);
}

static inline void quad_spread_vec3(gn_vec3 v, quad_f spread[3])
{
    const quad_pairs xy = {*(const quad_pair *)&v.x, 0.0};

    spread[0] = QUAD_SPREAD(xy, 0);
    spread[1] = QUAD_SPREAD(xy, 1);
    spread[2] = quad_set(v.z, v.z, v.z, v.z);
}

static inline gn_vec3 quad_to_vec3(quad_f a)
{
    gn_vec3 v;

    *(quad_pair *)&v.x = ((quad_pairs)a)[0];
    v.z = a[2];
    return v;
}

static inline gn_vec4 quad_to_vec4(quad_f a)
{
    gn_vec4 v;

    *(quad_pair *)&v.x = ((quad_pairs)a)[0];
    *(quad_pair *)&v.z = ((quad_pairs)a)[1];
    return v;
}

#else

typedef struct quad_f {
    float x, y, z, w;
} quad_f;

static inline quad_f quad_set(float x, float y, float z, float w)
{
    const quad_f r = {x, y, z, w};

    return r;
}

static inline quad_f quad_load(const float p[4])
{
    return quad_set(p[0], p[1], p[2], p[3]);
}

static inline void quad_store(float p[4], quad_f a)
{
    p[0] = a.x;
    p[1] = a.y;
    p[2] = a.z;
    p[3] = a.w;
}

static inline quad_f quad_add(quad_f a, quad_f b)
{
    return quad_set(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);
}

static inline quad_f quad_sub(quad_f a, quad_f b)
{
    return quad_set(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);
}

static inline quad_f quad_mul(quad_f a, quad_f b)
{
    return quad_set(a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w);
}

static inline void quad_spread(quad_f a, quad_f spread[4])
{
    spread[0] = quad_set(a.x, a.x, a.x, a.x);
    spread[1] = quad_set(a.y, a.y, a.y, a.y);
    spread[2] = quad_set(a.z, a.z, a.z, a.z);
    spread[3] = quad_set(a.w, a.w, a.w, a.w);
}

static inline void quad_transpose3(quad_f *a, quad_f *b, quad_f *c)
{
    const quad_f x = quad_set(a->x, b->x, c->x, 0.0f);
    const quad_f y = quad_set(a->y, b->y, c->y, 0.0f);

    *c = quad_set(a->z, b->z, c->z, 0.0f);
    *a = x;
    *b = y;
}

static inline void quad_spread_vec4(gn_vec4 v, quad_f spread[4])
{
    quad_spread(quad_set(v.x, v.y, v.z, v.w), spread);
}

static inline void quad_spread_vec3(gn_vec3 v, quad_f spread[3])
{
    spread[0] = quad_set(v.x, v.x, v.x, v.x);
    spread[1] = quad_set(v.y, v.y, v.y, v.y);
    spread[2] = quad_set(v.z, v.z, v.z, v.z);
}

static inline gn_vec3 quad_to_vec3(quad_f a)
{
    const gn_vec3 v = {a.x, a.y, a.z};

    return v;
}

static inline gn_vec4 quad_to_vec4(quad_f a)
{
    const gn_vec4 v = {a.x, a.y, a.z, a.w};

    return v;
}

#endif

#endif
