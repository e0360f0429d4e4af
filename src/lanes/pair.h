/* Two doubles at a time, for the general inverse: in an SSE2 register where x86 computes in these,
 * otherwise in two variables. */
#ifndef GN_LANES_PAIR_H
#define GN_LANES_PAIR_H

#include <stdbool.h>

#include "quad.h"

#if defined(__GNUC__) && defined(__SSE2_MATH__) && !defined(GN_ONLY_PORTABLE)

#include <emmintrin.h>

typedef __m128d pair_d;

static inline pair_d pair_set(double x)
{
    return _mm_set1_pd(x);
}

static inline pair_d pair_add(pair_d a, pair_d b)
{
    return _mm_add_pd(a, b);
}

static inline pair_d pair_sub(pair_d a, pair_d b)
{
    return _mm_sub_pd(a, b);
}

static inline pair_d pair_mul(pair_d a, pair_d b)
{
    return _mm_mul_pd(a, b);
}

static inline pair_d pair_magnitude(pair_d a)
{
    return _mm_andnot_pd(_mm_set1_pd(-0.0), a);
}

static inline pair_d pair_swap(pair_d a)
{
    return _mm_shuffle_pd(a, a, 1);
}

static inline double pair_first(pair_d a)
{
    return _mm_cvtsd_f64(a);
}

static inline double pair_sum(pair_d a)
{
    return _mm_cvtsd_f64(_mm_add_sd(a, _mm_unpackhi_pd(a, a)));
}

/* Returns the larger number of each place. Precondition: no number is NaN. */
static inline pair_d pair_larger(pair_d a, pair_d b)
{
    return _mm_max_pd(a, b);
}

/* Writes (a[i], b[i]) for each i. */
static inline void pair_load(const float a[4], const float b[4], pair_d pairs[4])
{
    const __m128 x = _mm_loadu_ps(a), y = _mm_loadu_ps(b);
    const __m128 low = _mm_unpacklo_ps(x, y), high = _mm_unpackhi_ps(x, y);

    pairs[0] = _mm_cvtps_pd(low);
    pairs[1] = _mm_cvtps_pd(_mm_movehl_ps(low, low));
    pairs[2] = _mm_cvtps_pd(high);
    pairs[3] = _mm_cvtps_pd(_mm_movehl_ps(high, high));
}

/* Returns (first of a, first of b, second of a, second of b), rounded to floats. */
static inline quad_f pair_round(pair_d a, pair_d b)
{
    return (quad_f)_mm_unpacklo_ps(_mm_cvtpd_ps(a), _mm_cvtpd_ps(b));
}

static inline bool quad_has_nan(quad_f a)
{
    return _mm_movemask_ps(_mm_cmpunord_ps((__m128)a, (__m128)a)) != 0;
}

#else

typedef struct pair_d {
    double first, second;
} pair_d;

static inline pair_d pair_of(double first, double second)
{
    const pair_d r = {first, second};

    return r;
}

static inline pair_d pair_set(double x)
{
    return pair_of(x, x);
}

static inline pair_d pair_add(pair_d a, pair_d b)
{
    return pair_of(a.first + b.first, a.second + b.second);
}

static inline pair_d pair_sub(pair_d a, pair_d b)
{
    return pair_of(a.first - b.first, a.second - b.second);
}

static inline pair_d pair_mul(pair_d a, pair_d b)
{
    return pair_of(a.first * b.first, a.second * b.second);
}

static inline pair_d pair_magnitude(pair_d a)
{
    return pair_of(a.first < 0.0 ? -a.first : a.first, a.second < 0.0 ? -a.second : a.second);
}

static inline pair_d pair_swap(pair_d a)
{
    return pair_of(a.second, a.first);
}

static inline double pair_first(pair_d a)
{
    return a.first;
}

static inline double pair_sum(pair_d a)
{
    return a.first + a.second;
}

static inline pair_d pair_larger(pair_d a, pair_d b)
{
    return pair_of(a.first > b.first ? a.first : b.first,
                   a.second > b.second ? a.second : b.second);
}

static inline void pair_load(const float a[4], const float b[4], pair_d pairs[4])
{
    for (int i = 0; i < 4; ++i)
        pairs[i] = pair_of((double)a[i], (double)b[i]);
}

static inline quad_f pair_round(pair_d a, pair_d b)
{
    return quad_set((float)a.first, (float)b.first, (float)a.second, (float)b.second);
}

static inline bool quad_has_nan(quad_f a)
{
    float x[4];

    quad_store(x, a);
    return x[0] != x[0] || x[1] != x[1] || x[2] != x[2] || x[3] != x[3];
}

#endif

#endif
