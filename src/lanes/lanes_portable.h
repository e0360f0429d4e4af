/* Lanes as plain arrays in C99, for every target; with vector registers and GNU C,
 * registers_vectors.h takes its place. This file defines the operations that lanes.h lists. Every
 * operation is one IEEE operation per lane, rounded to nearest, so that every other form returns
 * the same bits.
 *
 * Not alone: lanes.h chooses one form and includes it after LANES and GN_EACH_LANE. */
#ifndef GN_LANES_LANES_PORTABLE_H
#define GN_LANES_LANES_PORTABLE_H

#include <gnomon/scalar.h>

/* Operations are loops without branches or calls, which compilers can turn into vector instructions
 * if the target has any. Floats are compared with constants by their bits, and masks select by
 * `and` and `or`. gcc unrolls loops of 16 before it looks for vectors, and then finds few. With
 * less unrolling it vectorises the loops first. */
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__) && !defined(__OPTIMIZE_SIZE__)
#undef GN_EACH_LANE
#define GN_EACH_LANE(l) _Pragma("GCC unroll 4") for (int l = 0; l < LANES; ++l)
#define GN_EACH_ELEMENT(n, per_lane)                                                               \
    _Pragma("GCC unroll 4") for (int n = 0; n < LANES * (per_lane); ++n)
#else
#define GN_EACH_ELEMENT(n, per_lane) for (int n = 0; n < LANES * (per_lane); ++n)
#endif

#if (-1 >> 1) != -1
#error "right shifts of negative numbers must round down"
#endif

typedef struct lanes_f {
    float v[LANES];
} lanes_f;

typedef struct lanes_i {
    int32_t v[LANES];
} lanes_i;

/* Each lane is all ones or all zeros. */
typedef struct lanes_m {
    uint32_t v[LANES];
} lanes_m;

/* Lane l holds bit l. */
#define LANE_BIT(l) 1u << (l)
static const uint32_t lanes_lane_bit[LANES] = GN_NUMBERS(LANE_BIT);

static inline int32_t lane_as_int(float a)
{
    union {
        float f;
        int32_t i;
    } bits;

    bits.f = a;
    return bits.i;
}

static inline float lane_as_float(int32_t a)
{
    union {
        int32_t i;
        float f;
    } bits;

    bits.i = a;
    return bits.f;
}

/* Returns a where the mask is set, otherwise b. A single lane is chosen by a branch or a
 * conditional instruction. */
static inline int32_t lane_select(uint32_t mask, int32_t a, int32_t b)
{
    if (LANES == 1)
        return mask ? a : b;
    return (a & (int32_t)mask) | (b & (int32_t)~mask);
}

/* Returns all ones if true, otherwise 0. */
static inline int32_t lane_mask(int truth)
{
    return -truth;
}

static inline lanes_f lanes_load(const float p[LANES])
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = p[l];
    return r;
}

static inline void lanes_store(float *p, lanes_f a)
{
    GN_EACH_LANE (l)
        p[l] = a.v[l];
}

static inline lanes_f lanes_splat(float a)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = a;
    return r;
}

/* Over a 4x4 block, lanes_columns returns per_x * (x + column) + origin and lanes_rows returns
 * per_y * (y + row). */
static inline lanes_f lanes_columns(float per_x, float x, float origin)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = per_x * (x + (float)(l % 4)) + origin;
    return r;
}

static inline lanes_f lanes_rows(float per_y, float y)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = per_y * (y + (float)(l / 4));
    return r;
}

static inline lanes_f lanes_add(lanes_f a, lanes_f b)
{
    GN_EACH_LANE (l)
        a.v[l] = a.v[l] + b.v[l];
    return a;
}

static inline lanes_f lanes_sub(lanes_f a, lanes_f b)
{
    GN_EACH_LANE (l)
        a.v[l] = a.v[l] - b.v[l];
    return a;
}

static inline lanes_f lanes_mul(lanes_f a, lanes_f b)
{
    GN_EACH_LANE (l)
        a.v[l] = a.v[l] * b.v[l];
    return a;
}

static inline lanes_f lanes_div(lanes_f a, lanes_f b)
{
    GN_EACH_LANE (l)
        a.v[l] = a.v[l] / b.v[l];
    return a;
}

/* Returns the square root, correctly rounded; some NaN if a is negative or NaN. */
static inline lanes_f lanes_sqrt(lanes_f a)
{
    GN_EACH_LANE (l)
        a.v[l] = gn_sqrt(a.v[l]);
    return a;
}

/* Returns a > b; false if either is NaN. */
static inline lanes_m lanes_greater(lanes_f a, lanes_f b)
{
    lanes_m r;
    GN_EACH_LANE (l)
        r.v[l] = a.v[l] > b.v[l] ? UINT32_MAX : 0;
    return r;
}

/* Returns a <= b; false if either is NaN. */
static inline lanes_m lanes_less_equal(lanes_f a, lanes_f b)
{
    lanes_m r;
    GN_EACH_LANE (l)
        r.v[l] = a.v[l] <= b.v[l] ? UINT32_MAX : 0;
    return r;
}

static inline lanes_m lanes_and(lanes_m a, lanes_m b)
{
    GN_EACH_LANE (l)
        a.v[l] &= b.v[l];
    return a;
}

static inline lanes_m lanes_not(lanes_m a)
{
    GN_EACH_LANE (l)
        a.v[l] = ~a.v[l];
    return a;
}

/* Returns bit l set if lane l is set. */
static inline uint32_t lanes_bits(lanes_m a)
{
    uint32_t r = 0;
    GN_EACH_LANE (l)
        r |= a.v[l] & lanes_lane_bit[l];
    return r;
}

static inline lanes_f lanes_select(lanes_m m, lanes_f a, lanes_f b)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = LANES == 1
                     ? (m.v[l] ? a.v[l] : b.v[l])
                     : lane_as_float(lane_select(m.v[l], lane_as_int(a.v[l]), lane_as_int(b.v[l])));
    return r;
}

/* Returns the smaller of two; b if either is NaN or both are zero, as MINPS does. */
static inline lanes_f lanes_min(lanes_f a, lanes_f b)
{
    GN_EACH_LANE (l)
        a.v[l] = b.v[l] > a.v[l] ? a.v[l] : b.v[l];
    return a;
}

/* Returns the larger of two; b if either is NaN or both are zero. */
static inline lanes_f lanes_max(lanes_f a, lanes_f b)
{
    GN_EACH_LANE (l)
        a.v[l] = a.v[l] > b.v[l] ? a.v[l] : b.v[l];
    return a;
}

/* The four functions return in every lane the value of a lane of the same 2x2 quad: the one in the
 * left or right column of the lane's row, or in the lower or upper row of the lane's column. */
static inline lanes_f lanes_quad_left(lanes_f a)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = a.v[l & ~1];
    return r;
}

static inline lanes_f lanes_quad_right(lanes_f a)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = a.v[(l | 1) % LANES];
    return r;
}

static inline lanes_f lanes_quad_lower(lanes_f a)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = a.v[l & ~4];
    return r;
}

static inline lanes_f lanes_quad_upper(lanes_f a)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = a.v[(l | 4) % LANES];
    return r;
}

static inline lanes_i lanes_i_splat(int32_t a)
{
    lanes_i r;
    GN_EACH_LANE (l)
        r.v[l] = a;
    return r;
}

static inline lanes_i lanes_i_splat_two(int32_t lower, int32_t upper)
{
    lanes_i r;
    GN_EACH_LANE (l)
        r.v[l] = l < LANES / 2 ? lower : upper;
    return r;
}

/* Returns per_column * column + per_row * row over a 4x4 block. */
static inline lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    lanes_i r;
    GN_EACH_LANE (l)
        r.v[l] = per_column * (l % 4) + per_row * (l / 4);
    return r;
}

static inline lanes_i lanes_i_load(const stored_word *p)
{
    lanes_i r;
    GN_EACH_LANE (l)
        r.v[l] = p[l];
    return r;
}

static inline void lanes_i_store(stored_word *p, lanes_i a)
{
    GN_EACH_LANE (l)
        p[l] = a.v[l];
}

/* Sums and differences wrap around. */
static inline lanes_i lanes_i_add(lanes_i a, lanes_i b)
{
    GN_EACH_LANE (l)
        a.v[l] = (int32_t)((uint32_t)a.v[l] + (uint32_t)b.v[l]);
    return a;
}

static inline lanes_i lanes_i_sub(lanes_i a, lanes_i b)
{
    GN_EACH_LANE (l)
        a.v[l] = (int32_t)((uint32_t)a.v[l] - (uint32_t)b.v[l]);
    return a;
}

/* Returns the low 32 bits of the products. */
static inline lanes_i lanes_i_mul(lanes_i a, lanes_i b)
{
    GN_EACH_LANE (l)
        a.v[l] = (int32_t)((uint32_t)a.v[l] * (uint32_t)b.v[l]);
    return a;
}

/* Returns a * b. Precondition: the lanes and b are -2^15 to 2^15 - 1. */
static inline lanes_i lanes_i_mul_short(lanes_i a, int32_t b)
{
    return lanes_i_mul(a, lanes_i_splat(b));
}

/* Shifts bits to the left. count must be a constant. */
static inline lanes_i lanes_i_shift_left(lanes_i a, int count)
{
    GN_EACH_LANE (l)
        a.v[l] = (int32_t)((uint32_t)a.v[l] << count);
    return a;
}

/* Shifts two's complement numbers to the right, which rounds down. count must be a constant. */
static inline lanes_i lanes_i_shift_right(lanes_i a, int count)
{
    GN_EACH_LANE (l)
        a.v[l] = a.v[l] >> count;
    return a;
}

static inline lanes_i lanes_i_min(lanes_i a, lanes_i b)
{
    GN_EACH_LANE (l)
        a.v[l] = a.v[l] < b.v[l] ? a.v[l] : b.v[l];
    return a;
}

static inline lanes_i lanes_i_max(lanes_i a, lanes_i b)
{
    GN_EACH_LANE (l)
        a.v[l] = a.v[l] > b.v[l] ? a.v[l] : b.v[l];
    return a;
}

static inline lanes_i lanes_i_or(lanes_i a, lanes_i b)
{
    GN_EACH_LANE (l)
        a.v[l] |= b.v[l];
    return a;
}

static inline lanes_i lanes_i_and(lanes_i a, lanes_i b)
{
    GN_EACH_LANE (l)
        a.v[l] &= b.v[l];
    return a;
}

static inline lanes_i lanes_i_xor(lanes_i a, lanes_i b)
{
    GN_EACH_LANE (l)
        a.v[l] ^= b.v[l];
    return a;
}

static inline lanes_m lanes_i_greater(lanes_i a, lanes_i b)
{
    lanes_m r;
    GN_EACH_LANE (l)
        r.v[l] = a.v[l] > b.v[l] ? UINT32_MAX : 0;
    return r;
}

static inline lanes_m lanes_i_equal(lanes_i a, lanes_i b)
{
    lanes_m r;
    GN_EACH_LANE (l)
        r.v[l] = a.v[l] == b.v[l] ? UINT32_MAX : 0;
    return r;
}

static inline lanes_i lanes_i_select(lanes_m m, lanes_i a, lanes_i b)
{
    lanes_i r;
    GN_EACH_LANE (l)
        r.v[l] = lane_select(m.v[l], a.v[l], b.v[l]);
    return r;
}

/* Returns bit l set if lane l is negative. */
static inline uint32_t lanes_i_sign_bits(lanes_i a)
{
    uint32_t r = 0;
    GN_EACH_LANE (l)
        r |= (uint32_t)(a.v[l] >> 31) & lanes_lane_bit[l];
    return r;
}

static inline lanes_f lanes_to_float(lanes_i a)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = (float)a.v[l];
    return r;
}

/* Converts toward zero; INT32_MIN if NaN or out of range. */
static inline lanes_i lanes_truncate(lanes_f a)
{
    lanes_i r;
    GN_EACH_LANE (l) {
        const int32_t bits = lane_as_int(a.v[l]);
        const int32_t outside = lane_mask((bits & INT32_MAX) >= LANE_BITS_2_31);
        r.v[l] = (int32_t)lane_as_float(bits & ~outside) | (outside & INT32_MIN);
    }
    return r;
}

/* Converts to nearest, halves to even; INT32_MIN if NaN or out of range. From 2^23 on, floats are
 * integers. Between 2^23 and 2^24 the last place is 1, so adding 2^23 rounds. */
static inline lanes_i lanes_round(lanes_f a)
{
    lanes_i r;
    GN_EACH_LANE (l) {
        const int32_t bits = lane_as_int(a.v[l]);
        const int32_t magnitude = bits & INT32_MAX;
        const int32_t outside = lane_mask(magnitude >= LANE_BITS_2_31);
        const int32_t integer = lane_mask(magnitude >= LANE_BITS_2_23);
        const float rounder = lane_as_float((LANE_BITS_2_23 & ~integer) | (bits & INT32_MIN));
        const float rounded = (lane_as_float(bits & ~outside) + rounder) - rounder;
        r.v[l] = (int32_t)rounded | (outside & INT32_MIN);
    }
    return r;
}

/* Returns the largest integer not above a. A zero may have either sign; NaN and infinities are
 * returned unchanged. */
static inline lanes_f lanes_floor(lanes_f a)
{
    GN_EACH_LANE (l) {
        const int inside = a.v[l] > -2147483648.0f && a.v[l] < 2147483648.0f;
        const float t = (float)(int32_t)(inside ? a.v[l] : 0.0f);
        a.v[l] = inside ? t - (float)(t > a.v[l]) : a.v[l];
    }
    return a;
}

/* Returns truncate(floor(a)). */
static inline lanes_i lanes_floor_to_int(lanes_f a)
{
    if (LANES > 1)
        return lanes_truncate(lanes_floor(a));
    const float x = a.v[0];
    const uint32_t bits = (uint32_t)lane_as_int(x);

    if (bits < LANE_BITS_2_31) /* not negative, and an int32_t */
        return lanes_i_splat((int32_t)x);
    const int32_t whole = (bits & INT32_MAX) < LANE_BITS_2_31 ? (int32_t)x : INT32_MIN;
    return lanes_i_splat(whole != INT32_MIN && (float)whole > x ? whole - 1 : whole);
}

/* Returns the bits of the floats. */
static inline lanes_i lanes_as_int(lanes_f a)
{
    lanes_i r;
    GN_EACH_LANE (l)
        r.v[l] = lane_as_int(a.v[l]);
    return r;
}

/* Returns the floats with these bits. */
static inline lanes_f lanes_as_float(lanes_i a)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = lane_as_float(a.v[l]);
    return r;
}

static inline lanes_i lanes_m_as_int(lanes_m a)
{
    lanes_i r;
    GN_EACH_LANE (l)
        r.v[l] = (int32_t)a.v[l];
    return r;
}

/* Returns lane l set if bit l is set. */
static inline lanes_m lanes_from_bits(uint32_t bits)
{
    lanes_m r;
    GN_EACH_LANE (l)
        r.v[l] = bits & lanes_lane_bit[l] ? UINT32_MAX : 0;
    return r;
}

#include "lanes_portable_elements.h"
#include "lanes_portable_memory.h"

#endif
