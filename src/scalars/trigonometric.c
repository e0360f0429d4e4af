/* Sine, cosine and tangent: the angle is reduced to an octant by the bits of 2/pi (M. H. Payne and
 * R. N. Hanek, Radian reduction for trigonometric functions, SIGNUM Newsletter 18, 1983), the
 * series are summed in double or in fixed point, and the result is rounded once. */
#include <gnomon/scalar.h>

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "double_forms.h"
#include "fixed_point.h"
#include "integer_forms.h"

/* Below 2^-12 the second term of each series, x^3/6, x^3/3 or x^2/2, is less than half a unit in
 * the last place of the result: sine and tangent round to the angle, cosine to one. */
#define SMALL_ANGLE_BITS 0x39800000u

/* |x| = quadrant * pi/2 + r, where |r| = significand * 2^(-64 - shift) <= pi/4. */
typedef struct reduced_angle {
    uint64_t significand; /* at least 0.39 * 2^64 */
    unsigned shift;       /* at most 28 for a float */
    unsigned quadrant;    /* 0 to 3 */
    bool negative;        /* r is below zero */
} reduced_angle;

/* 2/pi after 64 zeros: bit i, counted from the top of word 0, has the weight 2^(63 - i). */
static const uint32_t two_over_pi[10] = {
    0x00000000u, 0x00000000u, 0xA2F9836Eu, 0x4E441529u, 0xFC2757D1u,
    0xF534DDC0u, 0xDB629599u, 0x3C439041u, 0xFE5163ABu, 0xDEBBC561u,
};

static uint32_t two_over_pi_bits(unsigned first)
{
    unsigned word = first >> 5, offset = first & 31;
    uint64_t pair = (uint64_t)two_over_pi[word] << 32 | two_over_pi[word + 1];
    return (uint32_t)(pair >> (32 - offset));
}

/* Reduces a finite x of at least 2^-12 in magnitude, given as bits without the sign. The relative
 * error of r is below 3 * 2^-63.
 *
 * Let |x| = significand * 2^e with e = exponent field - 150; 2^-12 <= |x| < 2^128 means -35 <= e <=
 * 104. In y = |x| * 2/pi, the bits of 2/pi of weight 2^(2 - e) and above contribute multiples of 4,
 * which are whole turns; they are left out. So y modulo 4, in units of 2^-126, is the product of
 * the significand with the 128 bits from weight 2^(1 - e) on, modulo 2^128. The bits after those
 * are worth less than 2^24 units: y is low by less than 2^-102. No float in this range has a y
 * within 2^-30 of an integer (measured over all of them), so the relative error of the fraction is
 * below 2^-71.
 *
 * Then |r| = fraction * pi/2. The fraction is cut to 64 significant bits (2^-63 relative), pi/4 is
 * rounded (2^-64), and so is their product, which is at least 0.39 * 2^64 units (2^-62.6): less
 * than 3 * 2^-63 in all. */
static reduced_angle reduce_angle(uint32_t magnitude_bits)
{
    const uint64_t quarter_pi = 0xC90FDAA22168C235u; /* pi/4 in Q64 */

    uint64_t significand = (magnitude_bits & GN_FRACTION_BITS) | GN_HIDDEN_BIT;
    unsigned first = (magnitude_bits >> 23) - 88; /* 63 - first = 1 - e */

    uint64_t word0 = significand * two_over_pi_bits(first + 96);
    uint64_t word1 = significand * two_over_pi_bits(first + 64) + (word0 >> 32);
    uint64_t word2 = significand * two_over_pi_bits(first + 32) + (word1 >> 32);
    uint64_t word3 = significand * two_over_pi_bits(first) + (word2 >> 32);
    uint64_t low = word1 << 32 | (word0 & 0xFFFFFFFFu);
    uint64_t high = word3 << 32 | (word2 & 0xFFFFFFFFu);

    reduced_angle angle;
    angle.quadrant = (unsigned)(high >> 62);
    high = high << 2 | low >> 62;
    low <<= 2;

    /* Reduces to the nearest quadrant. The complement is one unit less than 1 - y. */
    angle.negative = high >> 63 != 0;
    if (angle.negative) {
        angle.quadrant = (angle.quadrant + 1) & 3;
        high = ~high;
        low = ~low;
    }

    unsigned zeros = leading_zeros(high | 1);
    high = high << zeros | low >> 1 >> (63 - zeros);
    angle.significand = multiply_high(high, quarter_pi);
    angle.shift = zeros - 1; /* fraction < 1/2: at least one zero */
    return angle;
}

/* Returns r^2 in Q64, off by 10 units. r as a Q64 fraction is off by 6 units: 3 * 2^-63 of r <=
 * 0.786 are 5 units, and every product is cut. */
static uint64_t squared(const reduced_angle *angle)
{
    uint64_t r = angle->significand >> angle->shift;
    return multiply_high(r, r);
}

/* Returns |sin r| * 2^(64 + shift), at least 0.35 * 2^64. The relative error, including that of r,
 * is below 17 * 2^-64, here and in fixed_cosine. The exact sine, cosine and tangent of every
 * float are at least 2^-56 of themselves away from the middle between two floats (enumerated with
 * MPFR), so results rounded from these values are correctly rounded.
 *
 * Both series are summed by Horner's rule in Q64 with the coefficients 1/n! rounded. A step adds at
 * most 1.5 units of error (coefficient and product) and multiplies the error so far by z = r^2 <=
 * 0.617, so the error stays below 1.5 / (1 - 0.617) < 4 units. z itself, off by 10 units, adds 10/6
 * units to the sine and 10/2 to the cosine, and the leading 1 is one unit short. The truncated rest
 * of a series is less than its first term, z^10/21! < 2^-72 and z^10/20! < 2^-68. While a partial
 * sum is below 2^32 units, half of z is enough for its product. Every partial sum is positive
 * because z < 1.
 *
 * In all: for the sine, 7 units of a sum of at least 0.9, which with r's 6 units and the last
 * product's 3 are below 17 * 2^-64 of the sine; for the cosine, 10 units of a sum of at least 0.7,
 * which are below 17 * 2^-64 of the cosine. */
static uint64_t fixed_sine(const reduced_angle *angle)
{
    uint64_t z = squared(angle), z_high = z >> 32;
    uint64_t sum = 0x98;                               /* 1/19! */
    sum = 0xCA96u - (z_high * sum >> 32);              /* 1/17! */
    sum = 0xD73F9Fu - (z_high * sum >> 32);            /* 1/15! */
    sum = 0xB092309Du - (z_high * sum >> 32);          /* 1/13! */
    sum = 0x0000006B99159FD5u - (z_high * sum >> 32);  /* 1/11! */
    sum = 0x00002E3BC74AAD8Eu - multiply_high(z, sum); /* 1/9! */
    sum = 0x000D00D00D00D00Du - multiply_high(z, sum); /* 1/7! */
    sum = 0x0222222222222222u - multiply_high(z, sum); /* 1/5! */
    sum = 0x2AAAAAAAAAAAAAABu - multiply_high(z, sum); /* 1/3! */
    sum = 0xFFFFFFFFFFFFFFFFu - multiply_high(z, sum); /* 1 */
    return multiply_high(angle->significand, sum);
}

/* Returns cos r * 2^64, at least 0.7 * 2^64. */
static uint64_t fixed_cosine(const reduced_angle *angle)
{
    uint64_t z = squared(angle), z_high = z >> 32;
    uint64_t sum = 0xB41;                               /* 1/18! */
    sum = 0x000D73FAu - (z_high * sum >> 32);           /* 1/16! */
    sum = 0x0C9CBA54u - (z_high * sum >> 32);           /* 1/14! */
    sum = 0x00000008F76C77FCu - (z_high * sum >> 32);   /* 1/12! */
    sum = 0x0000049F93EDDE28u - multiply_high(z, sum);  /* 1/10! */
    sum = 0x0001A01A01A01A02u - multiply_high(z, sum);  /* 1/8! */
    sum = 0x005B05B05B05B05Bu - multiply_high(z, sum);  /* 1/6! */
    sum = 0x0AAAAAAAAAAAAAABu - multiply_high(z, sum);  /* 1/4! */
    sum = 0x8000000000000000u - multiply_high(z, sum);  /* 1/2! */
    return 0xFFFFFFFFFFFFFFFFu - multiply_high(z, sum); /* 1 */
}

#if GN_HAVE_DOUBLES

/* x = (quadrant + r) * pi/2 modulo 2 pi, |r| <= 1/2 * (1 + 2^-16); only the last two bits of
 * quadrant count. */
typedef struct double_angle {
    double r;
    uint32_t quadrant;
    bool known; /* r's relative error is below 2^-45 */
} double_angle;

#define MODERATE_ANGLE_END 0x45800000u /* 2^12 */

/* Returns whether |x| < 2^12. */
static inline bool is_moderate_angle(float x)
{
    return GN_LIKELY((float_bits(x) & ~GN_SIGN_BIT) < MODERATE_ANGLE_END);
}

/* Reduces a moderate angle and turns it by `turn` quadrants, 0 or 1. 2/pi is split into 29 bits and
 * a rest below 2^-29, both positive, so that -0 stays -0. x times the first part is exact, and so
 * is its difference from the nearest integer, which the sum with 1.5 * 2^52 leaves in its last
 * bits. x times the rest is below 2^-17; it and the sum are rounded. Over all moderate floats r is
 * off by at most 2^-46.7 of itself (measured). */
static inline double_angle reduce_moderate_angle(float x, unsigned turn)
{
    const double shift = 0x1.8p52 + (double)turn;
    double wide = (double)x, turns = wide * 0x1.45f306dp-1, sum = turns + shift;
    double_angle angle;
    angle.r = (turns - (sum - shift)) + wide * 0x1.9391054a7f09dp-30;
    angle.quadrant = (uint32_t)double_bits(sum);
    angle.known = true;
    return angle;
}

/* Element i holds 64 bits of 2/pi from the bit of weight 2^(15 - 8 i) on, or the next 32 bits. */
static const uint64_t two_over_pi_upper[15] = {
    0x0000A2F9836E4E44u, 0x00A2F9836E4E4415u, 0xA2F9836E4E441529u, 0xF9836E4E441529FCu,
    0x836E4E441529FC27u, 0x6E4E441529FC2757u, 0x4E441529FC2757D1u, 0x441529FC2757D1F5u,
    0x1529FC2757D1F534u, 0x29FC2757D1F534DDu, 0xFC2757D1F534DDC0u, 0x2757D1F534DDC0DBu,
    0x57D1F534DDC0DB62u, 0xD1F534DDC0DB6295u, 0xF534DDC0DB629599u,
};
static const uint32_t two_over_pi_lower[15] = {
    0x1529FC27u, 0x29FC2757u, 0xFC2757D1u, 0x2757D1F5u, 0x57D1F534u,
    0xD1F534DDu, 0xF534DDC0u, 0x34DDC0DBu, 0xDDC0DB62u, 0xC0DB6295u,
    0xDB629599u, 0x6295993Cu, 0x95993C43u, 0x993C4390u, 0x3C439041u,
};

/* Reduces and turns any other float; `known` is false if the integer form must compute it.
 *
 * As in reduce_angle, y = |x| * 2/pi modulo 4 is a product with the bits of 2/pi from weight
 * 2^(1 - e) on. Here the bits begin at a multiple of 8, to which the significand is shifted. y has
 * units of 2^-62. The product with the next 32 bits is cut, and those after them are left out: two
 * errors of less than a unit. So a fraction of at least 2^47 of these units is known to 2^-46 of
 * itself. Smaller ones are rare. */
static inline double_angle reduce_other_angle(float x, unsigned turn)
{
    const uint64_t least = (uint64_t)1 << 49;
    uint32_t bits = float_bits(x), magnitude = bits & ~GN_SIGN_BIT;
    double_angle angle;
    angle.r = 0.0;
    angle.quadrant = 0;
    angle.known = false;
    if (magnitude < MODERATE_ANGLE_END || magnitude >= GN_EXPONENT_BITS)
        return angle;
    unsigned first = (magnitude >> 23) - 136, i = first >> 3;
    uint64_t significand = (uint64_t)((magnitude & GN_FRACTION_BITS) | GN_HIDDEN_BIT)
                           << (first & 7);
    uint64_t y = significand * two_over_pi_upper[i] + (significand * two_over_pi_lower[i] >> 32);
    if (bits != magnitude)
        y = 0 - y;
    uint64_t fraction = y << 2; /* from the nearest quadrant, in two's complement */
    angle.quadrant = (uint32_t)(((y >> 61) + 1) >> 1) + turn;
    angle.r = double_from_integer((int64_t)fraction) * 0x1p-64;
    angle.known = fraction + least > 2 * least;
    return angle;
}

typedef double double_pair __attribute__((__vector_size__(16), __may_alias__));

/* Rows of four pairs: for each quadrant, the numbers for it and for the next. The first two rows
 * are what r is multiplied by and what is added then, the others the coefficients of r^0 to r^10.
 */
#define BY_QUADRANT(first, second, third, last)                                                    \
    first, second, second, third, third, last, last, first
#define ALTERNATELY(sine, cosine) BY_QUADRANT(sine, cosine, sine, cosine)
static const double sine_series[8 * 8] __attribute__((__aligned__(16))) = {
    BY_QUADRANT(1.0, 0.0, -1.0, 0.0),
    BY_QUADRANT(-0.0, 1.0, -0.0, -1.0),
    ALTERNATELY(0x1.921fb54442cf8p0, 0x1.ffffffffffdb1p-1),
    ALTERNATELY(-0x1.4abbce6257776p-1, -0x1.3bd3cc9bd098bp0),
    ALTERNATELY(0x1.466bc670fa1afp-4, 0x1.03c1f073ccff8p-2),
    ALTERNATELY(-0x1.32d2c627d0283p-8, -0x1.55d3b9721edcbp-6),
    ALTERNATELY(0x1.5071bdf251bc8p-13, 0x1.e1e76102f1d58p-11),
    ALTERNATELY(-0x1.dd4e002cfd0bdp-19, -0x1.a0d8a1be2a172p-16),
};

/* The sine of (quadrant + r) * pi/2, in numbers or in pairs; C(i) is of row i of the table. Even
 * quadrants take the sine of r * pi/2, odd ones its cosine: first * polynomial(z) with z = r^2 and
 * first = r, 1 or a negative of these. The quadrant selects all of it from the table, since a
 * branch would be mispredicted. Products with 0 and 1 are exact.
 *
 * The polynomials' errors are 2^-47.6 of the sine and 2^-43.7 of the cosine (on [0, 1/2 * (1 +
 * 2^-16)]). r's error, up to 2^-45, is an error of the sine of at most that size, and of the cosine
 * of 0.8 times that. The terms after the first are together below 0.31 of the polynomial and off by
 * less than 8 units of themselves, and two more roundings follow: less than 6 units in all.
 * Together the error is below 2^-43. */
#define SINE(C, r, z, zz)                                                                          \
    (((r)*C(0) + C(1)) *                                                                           \
     ((C(2) + (z)*C(3)) + (zz) * ((C(4) + (z)*C(5)) + (zz) * (C(6) + (z)*C(7)))))

static inline double double_sine(double_angle angle)
{
#define SINE_NUMBER(i) row[8 * (i)]
    const double *row = sine_series + 2 * (angle.quadrant & 3);
    const double z = angle.r * angle.r, zz = z * z;
    return SINE(SINE_NUMBER, angle.r, z, zz);
}

/* Returns the sine and the cosine. */
static inline double_pair double_sine_and_cosine(double_angle angle)
{
#define SINE_PAIR(i) row[4 * (i)]
    const double_pair *row = (const double_pair *)sine_series + (angle.quadrant & 3);
    const double_pair r = {angle.r, angle.r}, z = r * r, zz = z * z;
    return SINE(SINE_PAIR, r, z, zz);
}

#endif

/* Returns the sine of quadrant * pi/2 + r. Odd quadrants take the cosine of r, and quadrants from
 * pi on the opposite sign. The cosine is even in r. */
static float sine_in_quadrant(const reduced_angle *angle, unsigned quadrant, uint32_t sign)
{
    if ((quadrant & 2) != 0)
        sign ^= GN_SIGN_BIT;
    if ((quadrant & 1) != 0)
        return round_to_float(fixed_cosine(angle), 0, sign);
    if (angle->negative)
        sign ^= GN_SIGN_BIT;
    return round_to_float(fixed_sine(angle), angle->shift, sign);
}

GN_FALLBACK void gni_sincos_integer(float x, float *sine, float *cosine)
{
    uint32_t sign = float_bits(x) & GN_SIGN_BIT;
    uint32_t magnitude = float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS) {
        *sine = *cosine = float_from_bits(GN_NAN_BITS);
    } else if (magnitude < SMALL_ANGLE_BITS) {
        *sine = x;
        *cosine = 1.0f;
    } else {
        reduced_angle angle = reduce_angle(magnitude);
        *sine = sine_in_quadrant(&angle, angle.quadrant, sign);
        *cosine = sine_in_quadrant(&angle, angle.quadrant + 1, 0);
    }
}

GN_FALLBACK float gni_sin_integer(float x)
{
    uint32_t magnitude = float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    if (magnitude < SMALL_ANGLE_BITS)
        return x;
    reduced_angle angle = reduce_angle(magnitude);
    return sine_in_quadrant(&angle, angle.quadrant, float_bits(x) & GN_SIGN_BIT);
}

/* cos |x| = sin(|x| + pi/2). */
GN_FALLBACK float gni_cos_integer(float x)
{
    uint32_t magnitude = float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    if (magnitude < SMALL_ANGLE_BITS)
        return 1.0f;
    reduced_angle angle = reduce_angle(magnitude);
    return sine_in_quadrant(&angle, angle.quadrant + 1, 0);
}

#if GN_HAVE_DOUBLES

/* Returns the sine of x + turn * pi/2, given x and its angle, reduced and turned. */
static inline float reduced_sine(float x, double_angle angle, unsigned turn)
{
    double sine = double_sine(angle);
    if (GN_LIKELY(angle.known) && rounding_is_certain(sine))
        return (float)sine;
    return turn != 0 ? gni_cos_integer(x) : gni_sin_integer(x);
}

static GN_FALLBACK float other_sine(float x, unsigned turn)
{
    return reduced_sine(x, reduce_other_angle(x, turn), turn);
}

static inline void reduced_sincos(float x, double_angle angle, float *sine, float *cosine)
{
    double_pair both = double_sine_and_cosine(angle);
    if (GN_LIKELY(angle.known) && rounding_is_certain(both[0]) && rounding_is_certain(both[1])) {
        *sine = (float)both[0];
        *cosine = (float)both[1];
    } else {
        gni_sincos_integer(x, sine, cosine);
    }
}

static GN_FALLBACK void other_sincos(float x, float *sine, float *cosine)
{
    reduced_sincos(x, reduce_other_angle(x, 0), sine, cosine);
}

#endif

void gn_sincos(float x, float *sine, float *cosine)
{
#if GN_HAVE_DOUBLES
    if (is_moderate_angle(x))
        reduced_sincos(x, reduce_moderate_angle(x, 0), sine, cosine);
    else
        other_sincos(x, sine, cosine);
#else
    gni_sincos_integer(x, sine, cosine);
#endif
}

float gn_sin(float x)
{
#if GN_HAVE_DOUBLES
    if (!is_moderate_angle(x))
        return other_sine(x, 0);
    return reduced_sine(x, reduce_moderate_angle(x, 0), 0);
#else
    return gni_sin_integer(x);
#endif
}

float gn_cos(float x)
{
#if GN_HAVE_DOUBLES
    if (!is_moderate_angle(x))
        return other_sine(x, 1);
    return reduced_sine(x, reduce_moderate_angle(x, 1), 1);
#else
    return gni_cos_integer(x);
#endif
}

/* Returns the float nearest to numerator / denominator * 2^exponent, for two numbers in [2^62,
 * 2^64), by long division: 24 bits of the quotient and the next bit, which decides the rounding
 * (the quotient is irrational, so it is never a tie). Halving both numbers first leaves the top bit
 * free for the doubled remainder and costs at most 3 * 2^-64 of each. With their own 17 * 2^-64,
 * the error is below 2^-58 in all. */
static float quotient_to_float(uint64_t numerator, uint64_t denominator, int exponent,
                               uint32_t sign)
{
    uint64_t remainder = numerator >> 1, divisor = denominator >> 1;
    /* Brings the quotient into [1, 2). Both numbers are within 2^62 .. 2^64, so this takes at most
     * two steps either way. */
    while (remainder < divisor) {
        remainder <<= 1;
        exponent -= 1;
    }
    while (remainder >> 1 >= divisor) {
        divisor <<= 1;
        exponent += 1;
    }
    uint32_t quotient = 0;
    for (int step = 0; step < 25; ++step) {
        quotient <<= 1;
        if (remainder >= divisor) {
            remainder -= divisor;
            quotient |= 1;
        }
        remainder <<= 1;
    }
    uint32_t rounded = (quotient >> 1) + (quotient & 1);
    return float_from_bits(((uint32_t)(exponent + 126) << 23) + rounded + sign);
}

GN_FALLBACK float gni_tan_integer(float x)
{
    uint32_t sign = float_bits(x) & GN_SIGN_BIT;
    uint32_t magnitude = float_bits(x) & ~GN_SIGN_BIT;
    if (magnitude >= GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    if (magnitude < SMALL_ANGLE_BITS)
        return x;
    reduced_angle angle = reduce_angle(magnitude);
    uint64_t sine = fixed_sine(&angle), cosine = fixed_cosine(&angle);
    if (angle.negative)
        sign ^= GN_SIGN_BIT;
    if ((angle.quadrant & 1) != 0) /* tan(pi/2 + r) = -cos r / sin r */
        return quotient_to_float(cosine, sine, (int)angle.shift, sign ^ GN_SIGN_BIT);
    return quotient_to_float(sine, cosine, -(int)angle.shift, sign);
}

#if GN_HAVE_DOUBLES

/* The sine and the cosine are each off by less than 2^-43. */
static inline float reduced_tangent(float x, double_angle angle)
{
    double_pair both = double_sine_and_cosine(angle);
    double tangent = both[0] / both[1];
    if (GN_LIKELY(angle.known) && rounding_is_certain(tangent))
        return (float)tangent;
    return gni_tan_integer(x);
}

static GN_FALLBACK float other_tangent(float x)
{
    return reduced_tangent(x, reduce_other_angle(x, 0));
}

#endif

float gn_tan(float x)
{
#if GN_HAVE_DOUBLES
    if (!is_moderate_angle(x))
        return other_tangent(x);
    return reduced_tangent(x, reduce_moderate_angle(x, 0));
#else
    return gni_tan_integer(x);
#endif
}
