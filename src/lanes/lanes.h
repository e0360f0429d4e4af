/* Sixteen-wide floats, integers and masks: the only place that knows how they are
 * held. Stages are written once over these operations.
 *
 * This is the portable form, plain arrays in C99. Every operation is one IEEE
 * operation a lane, rounded to nearest, so that every form gives the same bits. */
#ifndef GN_LANES_LANES_H
#define GN_LANES_LANES_H

#include <stdint.h>

#include "gnomon/texture.h"

#define GN_EACH_LANE(l) for (int l = 0; l < GN_LANES; ++l)

/* All lanes set, as lanes_bits gives it. */
#define GN_ALL_LANES 0xFFFFu

typedef struct lanes_f {
    float v[GN_LANES];
} lanes_f;

typedef struct lanes_i {
    int32_t v[GN_LANES];
} lanes_i;

/* A lane is all ones or all zeros. */
typedef struct lanes_m {
    uint32_t v[GN_LANES];
} lanes_m;

static inline lanes_f lanes_load(const float *p)
{
    lanes_f r;
    GN_EACH_LANE(l) r.v[l] = p[l];
    return r;
}

static inline void lanes_store(float *p, lanes_f a)
{
    GN_EACH_LANE(l) p[l] = a.v[l];
}

static inline lanes_f lanes_splat(float a)
{
    lanes_f r;
    GN_EACH_LANE(l) r.v[l] = a;
    return r;
}

static inline lanes_f lanes_add(lanes_f a, lanes_f b)
{
    GN_EACH_LANE(l) a.v[l] = a.v[l] + b.v[l];
    return a;
}

static inline lanes_f lanes_sub(lanes_f a, lanes_f b)
{
    GN_EACH_LANE(l) a.v[l] = a.v[l] - b.v[l];
    return a;
}

static inline lanes_f lanes_mul(lanes_f a, lanes_f b)
{
    GN_EACH_LANE(l) a.v[l] = a.v[l] * b.v[l];
    return a;
}

static inline lanes_f lanes_div(lanes_f a, lanes_f b)
{
    GN_EACH_LANE(l) a.v[l] = a.v[l] / b.v[l];
    return a;
}

/* a > b; false where either is NaN. */
static inline lanes_m lanes_greater(lanes_f a, lanes_f b)
{
    lanes_m r;
    GN_EACH_LANE(l) r.v[l] = a.v[l] > b.v[l] ? UINT32_MAX : 0;
    return r;
}

static inline lanes_m lanes_greater_or_equal(lanes_f a, lanes_f b)
{
    lanes_m r;
    GN_EACH_LANE(l) r.v[l] = a.v[l] >= b.v[l] ? UINT32_MAX : 0;
    return r;
}

static inline lanes_m lanes_equal(lanes_f a, lanes_f b)
{
    lanes_m r;
    GN_EACH_LANE(l) r.v[l] = a.v[l] == b.v[l] ? UINT32_MAX : 0;
    return r;
}

static inline lanes_m lanes_and(lanes_m a, lanes_m b)
{
    GN_EACH_LANE(l) a.v[l] &= b.v[l];
    return a;
}

static inline lanes_m lanes_not(lanes_m a)
{
    GN_EACH_LANE(l) a.v[l] = ~a.v[l];
    return a;
}

/* Bit l of the result is lane l. */
static inline uint32_t lanes_bits(lanes_m a)
{
    uint32_t r = 0;
    GN_EACH_LANE(l) r |= (a.v[l] & 1u) << l;
    return r;
}

static inline lanes_f lanes_select(lanes_m m, lanes_f a, lanes_f b)
{
    lanes_f r;
    GN_EACH_LANE(l) r.v[l] = m.v[l] ? a.v[l] : b.v[l];
    return r;
}

/* The reference clamps by min and max instructions, which give their second
 * operand where either is NaN: so does this, lane > bound ? bound : lane being
 * written the other way round. */
static inline lanes_f lanes_min(lanes_f a, lanes_f b)
{
    return lanes_select(lanes_greater(b, a), a, b);
}

static inline lanes_f lanes_max(lanes_f a, lanes_f b)
{
    return lanes_select(lanes_greater(a, b), a, b);
}

static inline lanes_i lanes_i_splat(int32_t a)
{
    lanes_i r;
    GN_EACH_LANE(l) r.v[l] = a;
    return r;
}

static inline lanes_i lanes_i_load(const int32_t *p)
{
    lanes_i r;
    GN_EACH_LANE(l) r.v[l] = p[l];
    return r;
}

static inline void lanes_i_store(int32_t *p, lanes_i a)
{
    GN_EACH_LANE(l) p[l] = a.v[l];
}

/* Wraps around, as unsigned arithmetic does. */
static inline lanes_i lanes_i_add(lanes_i a, lanes_i b)
{
    GN_EACH_LANE(l) a.v[l] = (int32_t)((uint32_t)a.v[l] + (uint32_t)b.v[l]);
    return a;
}

static inline lanes_i lanes_i_or(lanes_i a, lanes_i b)
{
    GN_EACH_LANE(l) a.v[l] |= b.v[l];
    return a;
}

static inline lanes_i lanes_i_and(lanes_i a, lanes_i b)
{
    GN_EACH_LANE(l) a.v[l] &= b.v[l];
    return a;
}

static inline lanes_m lanes_i_greater(lanes_i a, lanes_i b)
{
    lanes_m r;
    GN_EACH_LANE(l) r.v[l] = a.v[l] > b.v[l] ? UINT32_MAX : 0;
    return r;
}

static inline lanes_m lanes_i_equal(lanes_i a, lanes_i b)
{
    lanes_m r;
    GN_EACH_LANE(l) r.v[l] = a.v[l] == b.v[l] ? UINT32_MAX : 0;
    return r;
}

static inline lanes_i lanes_i_select(lanes_m m, lanes_i a, lanes_i b)
{
    lanes_i r;
    GN_EACH_LANE(l) r.v[l] = m.v[l] ? a.v[l] : b.v[l];
    return r;
}

/* Bit l of the result is set where lane l is negative. */
static inline uint32_t lanes_i_sign_bits(lanes_i a)
{
    uint32_t r = 0;
    GN_EACH_LANE(l) r |= ((uint32_t)a.v[l] >> 31) << l;
    return r;
}

static inline lanes_f lanes_to_float(lanes_i a)
{
    lanes_f r;
    GN_EACH_LANE(l) r.v[l] = (float)a.v[l];
    return r;
}

/* Toward zero; INT32_MIN where NaN or out of range. */
static inline lanes_i lanes_truncate(lanes_f a)
{
    lanes_i r;
    GN_EACH_LANE(l)
    {
        const int inside = a.v[l] > -2147483648.0f && a.v[l] < 2147483648.0f;
        const int32_t t = (int32_t)(inside ? a.v[l] : 0.0f);
        r.v[l] = inside ? t : INT32_MIN;
    }
    return r;
}

/* To nearest, halves to even; INT32_MIN where NaN or out of range. The
 * remainder a - trunc(a) is exact, and where |a| >= 2^23 it is 0. */
static inline lanes_i lanes_round(lanes_f a)
{
    lanes_i r;
    GN_EACH_LANE(l)
    {
        const int inside = a.v[l] > -2147483648.0f && a.v[l] < 2147483648.0f;
        const float x = inside ? a.v[l] : 0.0f;
        const int32_t t = (int32_t)x;
        const float rest = x - (float)t;
        const int32_t odd = t & 1;
        const int32_t up = (rest > 0.5f) | ((rest == 0.5f) & odd);
        const int32_t down = (rest < -0.5f) | ((rest == -0.5f) & odd);
        r.v[l] = inside ? t + up - down : INT32_MIN;
    }
    return r;
}

/* The largest integer not above a, for |a| < 2^31; otherwise INT32_MIN. */
static inline lanes_i lanes_floor(lanes_f a)
{
    lanes_i r = lanes_truncate(a);
    GN_EACH_LANE(l) r.v[l] -= (r.v[l] != INT32_MIN) & ((float)r.v[l] > a.v[l]);
    return r;
}

#endif
