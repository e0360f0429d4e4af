/* Two doubles at a time, for the general inverse: in an SSE2 register where x86 computes in these,
 * otherwise in two variables. */
#ifndef GN_LANES_DOUBLE2_H
#define GN_LANES_DOUBLE2_H

#include "float4.h"

#if defined(__GNUC__) && defined(__SSE2_MATH__) && !defined(GN_ONLY_PORTABLE)

#include <emmintrin.h>

typedef __m128d double2;

static inline double2 double2_set(double x)
{
    return _mm_set1_pd(x);
}

static inline double2 double2_add(double2 a, double2 b)
{
    return _mm_add_pd(a, b);
}

static inline double2 double2_sub(double2 a, double2 b)
{
    return _mm_sub_pd(a, b);
}

static inline double2 double2_mul(double2 a, double2 b)
{
    return _mm_mul_pd(a, b);
}

static inline double2 double2_div(double2 a, double2 b)
{
    return _mm_div_pd(a, b);
}

static inline double2 double2_magnitude(double2 a)
{
    return _mm_andnot_pd(_mm_set1_pd(-0.0), a);
}

static inline double2 double2_swap(double2 a)
{
    return _mm_shuffle_pd(a, a, 1);
}

static inline double double2_first(double2 a)
{
    return _mm_cvtsd_f64(a);
}

static inline double double2_sum(double2 a)
{
    return _mm_cvtsd_f64(_mm_add_sd(a, _mm_unpackhi_pd(a, a)));
}

/* Returns the larger number of each place. Precondition: no number is NaN. */
static inline double2 double2_larger(double2 a, double2 b)
{
    return _mm_max_pd(a, b);
}

/* Writes (a[i], b[i]) for each i. */
static inline void double2_load(const float a[4], const float b[4], double2 pairs[4])
{
    const __m128 x = _mm_loadu_ps(a), y = _mm_loadu_ps(b);
    const __m128 low = _mm_unpacklo_ps(x, y), high = _mm_unpackhi_ps(x, y);

    pairs[0] = _mm_cvtps_pd(low);
    pairs[1] = _mm_cvtps_pd(_mm_movehl_ps(low, low));
    pairs[2] = _mm_cvtps_pd(high);
    pairs[3] = _mm_cvtps_pd(_mm_movehl_ps(high, high));
}

/* Returns (first of a, first of b, second of a, second of b), rounded to floats. */
static inline float4 double2_round(double2 a, double2 b)
{
    return (float4)_mm_unpacklo_ps(_mm_cvtpd_ps(a), _mm_cvtpd_ps(b));
}

#else

typedef struct double2 {
    double first, second;
} double2;

static inline double2 double2_of(double first, double second)
{
    const double2 r = {first, second};

    return r;
}

static inline double2 double2_set(double x)
{
    return double2_of(x, x);
}

static inline double2 double2_add(double2 a, double2 b)
{
    return double2_of(a.first + b.first, a.second + b.second);
}

static inline double2 double2_sub(double2 a, double2 b)
{
    return double2_of(a.first - b.first, a.second - b.second);
}

static inline double2 double2_mul(double2 a, double2 b)
{
    return double2_of(a.first * b.first, a.second * b.second);
}

static inline double2 double2_div(double2 a, double2 b)
{
    return double2_of(a.first / b.first, a.second / b.second);
}

static inline double2 double2_magnitude(double2 a)
{
    return double2_of(a.first < 0.0 ? -a.first : a.first, a.second < 0.0 ? -a.second : a.second);
}

static inline double2 double2_swap(double2 a)
{
    return double2_of(a.second, a.first);
}

static inline double double2_first(double2 a)
{
    return a.first;
}

static inline double double2_sum(double2 a)
{
    return a.first + a.second;
}

static inline double2 double2_larger(double2 a, double2 b)
{
    return double2_of(a.first > b.first ? a.first : b.first,
                      a.second > b.second ? a.second : b.second);
}

static inline void double2_load(const float a[4], const float b[4], double2 pairs[4])
{
    for (int i = 0; i < 4; ++i)
        pairs[i] = double2_of((double)a[i], (double)b[i]);
}

static inline float4 double2_round(double2 a, double2 b)
{
    return float4_set((float)a.first, (float)b.first, (float)a.second, (float)b.second);
}

#endif

#endif
