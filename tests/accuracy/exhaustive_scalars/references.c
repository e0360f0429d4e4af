/* The reference is the C library's double result d, whose error is below one part in 2^51 (glibc
 * states at most 1 ulp for each of its functions here; a division or a product by pi adds half of
 * one). If d * (1 - 2^-50) and d * (1 + 2^-50) round to one float, the exact value rounds to it
 * too; otherwise MPFR decides. MPFR also decides for one magnitude in 2^14, which checks this
 * filter. One evaluation gives the values at x and -x where the mathematics has that symmetry; that
 * assumes nothing about the functions under test. */
#include "references.h"

#include <math.h>
#include <stdbool.h>

#include <mpfr.h>

#define NAN_BITS 0x7FC00000u
#define SIGN_BIT 0x80000000u

/* Enough precision that no result is rounded to a middle between two floats unless it is one. */
enum { PRECISION = 160 };

/* For arguments without a value the library would also set errno, which takes time. */
static double double_sqrt(double x)
{
    return x < 0.0 ? NAN : sqrt(x);
}

static double double_rsqrt(double x)
{
    return x < 0.0 ? NAN : 1.0 / sqrt(x);
}

static double double_log2(double x)
{
    return x < 0.0 ? NAN : log2(x);
}

static double double_log(double x)
{
    return x < 0.0 ? NAN : log(x);
}

static double double_asin(double x)
{
    return fabs(x) > 1.0 ? NAN : asin(x);
}

static double double_acos(double x)
{
    return fabs(x) > 1.0 ? NAN : acos(x);
}

static double double_degrees(double x)
{
    return x * (180.0 / 3.14159265358979323846);
}

static double double_radians(double x)
{
    return x * (3.14159265358979323846 / 180.0);
}

/* MPFR returns +infinity for both zeros; IEEE 754 has the sign. */
static int wide_rsqrt(mpfr_t result, mpfr_srcptr x, mpfr_rnd_t mode)
{
    return mpfr_zero_p(x) ? mpfr_ui_div(result, 1, x, mode) : mpfr_rec_sqrt(result, x, mode);
}

static int wide_degrees(mpfr_t result, mpfr_srcptr x, mpfr_rnd_t mode)
{
    mpfr_t pi;
    mpfr_init2(pi, PRECISION);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul_ui(result, x, 180, mode);
    int inexact = mpfr_div(result, result, pi, mode);
    mpfr_clear(pi);
    return inexact;
}

static int wide_radians(mpfr_t result, mpfr_srcptr x, mpfr_rnd_t mode)
{
    mpfr_t pi;
    mpfr_init2(pi, PRECISION);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul(result, x, pi, mode);
    int inexact = mpfr_div_ui(result, result, 180, mode);
    mpfr_clear(pi);
    return inexact;
}

typedef enum symmetry { NEITHER, ODD, EVEN } symmetry;

static const struct definition {
    double (*narrow)(double);
    int (*wide)(mpfr_t, mpfr_srcptr, mpfr_rnd_t);
    symmetry symmetry;
} definitions[REFERENCE_COUNT] = {
    [REFERENCE_SQRT] = {double_sqrt, mpfr_sqrt, NEITHER},
    [REFERENCE_RSQRT] = {double_rsqrt, wide_rsqrt, NEITHER},
    [REFERENCE_SIN] = {sin, mpfr_sin, ODD},
    [REFERENCE_COS] = {cos, mpfr_cos, EVEN},
    [REFERENCE_TAN] = {tan, mpfr_tan, ODD},
    [REFERENCE_ASIN] = {double_asin, mpfr_asin, ODD},
    [REFERENCE_ACOS] = {double_acos, mpfr_acos, NEITHER},
    [REFERENCE_ATAN] = {atan, mpfr_atan, ODD},
    [REFERENCE_EXP2] = {exp2, mpfr_exp2, NEITHER},
    [REFERENCE_EXP] = {exp, mpfr_exp, NEITHER},
    [REFERENCE_LOG2] = {double_log2, mpfr_log2, NEITHER},
    [REFERENCE_LOG] = {double_log, mpfr_log, NEITHER},
    [REFERENCE_DEGREES] = {double_degrees, wide_degrees, ODD},
    [REFERENCE_RADIANS] = {double_radians, wide_radians, ODD},
};

static uint32_t canonical(float value)
{
    return isnan(value) ? NAN_BITS : bits_of(value);
}

/* mpfr_get_flt rounds only once also to a denormal. */
static uint32_t decide(const struct definition *function, float x)
{
    mpfr_t wide;
    mpfr_init2(wide, PRECISION);
    mpfr_set_flt(wide, x, MPFR_RNDN);
    function->wide(wide, wide, MPFR_RNDN);
    uint32_t bits = canonical(mpfr_get_flt(wide, MPFR_RNDN));
    mpfr_clear(wide);
    return bits;
}

static uint64_t evaluate(const struct definition *function, const uint32_t magnitudes[],
                         unsigned count, uint32_t sign, uint32_t values[])
{
    double d[BLOCK];
    uint64_t decided = 0;
    for (unsigned i = 0; i < count; ++i)
        d[i] = function->narrow((double)from_bits(magnitudes[i] | sign));
    for (unsigned i = 0; i < count; ++i) {
        float low = (float)(d[i] * (1.0 - 0x1p-50)), high = (float)(d[i] * (1.0 + 0x1p-50));
        bool agreed = bits_of(low) == bits_of(high) || isnan(d[i]);
        values[i] = canonical(high);
        if (!agreed || magnitudes[i] % 16384 == 0) {
            values[i] = decide(function, from_bits(magnitudes[i] | sign));
            ++decided;
        }
    }
    return decided;
}

uint64_t reference_values(reference which, const uint32_t magnitudes[], unsigned count,
                          uint32_t positive[], uint32_t negative[])
{
    const struct definition *function = &definitions[which];
    uint64_t decided = evaluate(function, magnitudes, count, 0, positive);
    if (function->symmetry == NEITHER)
        return decided + evaluate(function, magnitudes, count, SIGN_BIT, negative);
    for (unsigned i = 0; i < count; ++i) {
        bool flip = function->symmetry == ODD && positive[i] != NAN_BITS;
        negative[i] = positive[i] ^ (flip ? SIGN_BIT : 0);
    }
    return decided;
}
