/* Range reduction with the bits of 2/pi (M. H. Payne and R. N. Hanek, Radian reduction for
 * trigonometric functions, SIGNUM Newsletter 18, 1983), and the series of sine and cosine, in
 * integers. */
#include "angle.h"

#include "bits.h"
#include "fixed_point.h"

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

/* Let |x| = significand * 2^e with e = exponent field - 150; 2^-12 <= |x| < 2^128 means -35 <= e <=
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
gn_reduced_angle gn_reduce_angle(uint32_t magnitude_bits)
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

    gn_reduced_angle angle;
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

    unsigned zeros = gn_leading_zeros(high | 1);
    high = high << zeros | low >> 1 >> (63 - zeros);
    angle.significand = gn_multiply_high(high, quarter_pi);
    angle.shift = zeros - 1; /* fraction < 1/2: at least one zero */
    return angle;
}

/* Returns r^2 in Q64, off by 10 units. r as a Q64 fraction is off by 6 units: 3 * 2^-63 of r <=
 * 0.786 are 5 units, and every product is cut. */
static uint64_t squared(const gn_reduced_angle *angle)
{
    uint64_t r = angle->significand >> angle->shift;
    return gn_multiply_high(r, r);
}

/* Both series are summed by Horner's rule in Q64 with the coefficients 1/n! rounded. A step adds at
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
uint64_t gn_fixed_sine(const gn_reduced_angle *angle)
{
    uint64_t z = squared(angle), z_high = z >> 32;
    uint64_t sum = 0x98;                                  /* 1/19! */
    sum = 0xCA96u - (z_high * sum >> 32);                 /* 1/17! */
    sum = 0xD73F9Fu - (z_high * sum >> 32);               /* 1/15! */
    sum = 0xB092309Du - (z_high * sum >> 32);             /* 1/13! */
    sum = 0x0000006B99159FD5u - (z_high * sum >> 32);     /* 1/11! */
    sum = 0x00002E3BC74AAD8Eu - gn_multiply_high(z, sum); /* 1/9! */
    sum = 0x000D00D00D00D00Du - gn_multiply_high(z, sum); /* 1/7! */
    sum = 0x0222222222222222u - gn_multiply_high(z, sum); /* 1/5! */
    sum = 0x2AAAAAAAAAAAAAABu - gn_multiply_high(z, sum); /* 1/3! */
    sum = 0xFFFFFFFFFFFFFFFFu - gn_multiply_high(z, sum); /* 1 */
    return gn_multiply_high(angle->significand, sum);
}

uint64_t gn_fixed_cosine(const gn_reduced_angle *angle)
{
    uint64_t z = squared(angle), z_high = z >> 32;
    uint64_t sum = 0xB41;                                  /* 1/18! */
    sum = 0x000D73FAu - (z_high * sum >> 32);              /* 1/16! */
    sum = 0x0C9CBA54u - (z_high * sum >> 32);              /* 1/14! */
    sum = 0x00000008F76C77FCu - (z_high * sum >> 32);      /* 1/12! */
    sum = 0x0000049F93EDDE28u - gn_multiply_high(z, sum);  /* 1/10! */
    sum = 0x0001A01A01A01A02u - gn_multiply_high(z, sum);  /* 1/8! */
    sum = 0x005B05B05B05B05Bu - gn_multiply_high(z, sum);  /* 1/6! */
    sum = 0x0AAAAAAAAAAAAAABu - gn_multiply_high(z, sum);  /* 1/4! */
    sum = 0x8000000000000000u - gn_multiply_high(z, sum);  /* 1/2! */
    return 0xFFFFFFFFFFFFFFFFu - gn_multiply_high(z, sum); /* 1 */
}

#if GN_HAVE_DOUBLES

const uint64_t gn_two_over_pi_upper[15] = {
    0x0000A2F9836E4E44u, 0x00A2F9836E4E4415u, 0xA2F9836E4E441529u, 0xF9836E4E441529FCu,
    0x836E4E441529FC27u, 0x6E4E441529FC2757u, 0x4E441529FC2757D1u, 0x441529FC2757D1F5u,
    0x1529FC2757D1F534u, 0x29FC2757D1F534DDu, 0xFC2757D1F534DDC0u, 0x2757D1F534DDC0DBu,
    0x57D1F534DDC0DB62u, 0xD1F534DDC0DB6295u, 0xF534DDC0DB629599u,
};
const uint32_t gn_two_over_pi_lower[15] = {
    0x1529FC27u, 0x29FC2757u, 0xFC2757D1u, 0x2757D1F5u, 0x57D1F534u,
    0xD1F534DDu, 0xF534DDC0u, 0x34DDC0DBu, 0xDDC0DB62u, 0xC0DB6295u,
    0xDB629599u, 0x6295993Cu, 0x95993C43u, 0x993C4390u, 0x3C439041u,
};

#endif
