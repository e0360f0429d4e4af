/* Logarithms: the significand times a tabulated reciprocal is near 1, where a polynomial converges
 * fast, in double or in integers. The result is rounded once. */
#include <gnomon/scalar.h>

#include "bits.h"
#include "fixed_point.h"
#include "integer_forms.h"
#include "logarithm.h"

/* c = 1 / (1 + i/32) rounded to Q15, and -log2(c) in Q64. The last -log2(c) is 1, which is carried
 * into the integer. */
static const uint16_t reciprocals[33] = {
    0x8000, 0x7C1F, 0x7878, 0x7507, 0x71C7, 0x6EB4, 0x6BCA, 0x6907, 0x6666, 0x63E7, 0x6186,
    0x5F41, 0x5D17, 0x5B06, 0x590B, 0x5726, 0x5555, 0x5398, 0x51EC, 0x5050, 0x4EC5, 0x4D48,
    0x4BDA, 0x4A79, 0x4925, 0x47DC, 0x469F, 0x456C, 0x4444, 0x4326, 0x4211, 0x4104, 0x4000,
};
static const uint64_t logarithms[33] = {
    0x0000000000000000u, 0x0B5D80D00F9C995Eu, 0x1665684FF81084F3u, 0x2119AF041D9543C5u,
    0x2B8090C920CC62EAu, 0x359E600657CF1B9Au, 0x3F7889C72DEF67F2u, 0x490E96434ADC9B76u,
    0x526B5284636B9A6Fu, 0x5B889E4BBC514F24u, 0x646F4679A57B767Eu, 0x6D21949CFB756A94u,
    0x759E64808C463B54u, 0x7DE8D279D1F4DCE1u, 0x8608B286782C2EA6u, 0x8DFA137474D76AFFu,
    0x95C18B8F2AD3F615u, 0x9D5B75D7EF0C87BEu, 0xA4D1986156DDA94Au, 0xAC258289F3E70C92u,
    0xB34FA81D2A3C5224u, 0xBA5B28B2C137571Du, 0xC140AB031CA2EA8Au, 0xC80747C548343DB8u,
    0xCEACA5ED6E86EC8Bu, 0xD538A40129C5EF92u, 0xDBA419FB172FB71Cu, 0xE1F76B6D119F54ECu,
    0xE82B6CBE5F42220Fu, 0xEE438A30A585049Cu, 0xF443811F3EABC875u, 0xFA2F60B3A151FE1Du,
    0x0000000000000000u,
};

/* log2(x) = whole + log2(m) and log2(m) = -log2(c) + log2(1 +- r), with 1 +- r = m * c and
 * log2(1 +- r) = +-r * log2(e) * (1 -+ r/2 + r^2/3 -+ ...), by Horner's rule with rounded
 * coefficients. r is at most 2^-6.
 *
 * The terms after 1/10 are below 1.02 * r^10 * log2(e)/11, 1.1 units of Q63. The sums of 1/9 to 1/6
 * are in Q40, from the upper bits of r. They are off by less than 60 units (2^-32 of r is lost, of
 * a sum below 0.22 * 2^40 units), which five more factors r reduce to 0.5 units of Q63. From 1/5 on
 * a step adds at most 1.5 units (coefficient and product, whose complement is its negative less
 * one), and the next step multiplies them by r. The sum is off by less than 3.2 units of more than
 * 1.43 * 2^63, and its product with r, normalized to at least 2^63, is cut by one unit. The
 * relative error is less than (3.2/1.43 + 1/0.71) * 2^-63 < 3.7 * 2^-63.
 *
 * Near 1, where whole and log2(c) are 0, this is the result. Elsewhere it is added in Q64: 0.5
 * units from the table, 1 unit from cutting, and 0.2 units from log2(1 +- r) < 2^-5.4, in all 1.7
 * units. For results of 1 and more, 64 bits are kept. The least of the other results is -log2(1 -
 * 2^-7) = 2^-6.46. Powers of two have r = 0. */
fixed_logarithm gni_binary_logarithm(uint32_t bits)
{
    const uint64_t one = (uint64_t)1 << 38;
    int whole;
    uint32_t m = normal_significand(bits, &whole); /* Q23, of [1, 2) */
    unsigned nearest = (m - GN_HIDDEN_BIT + 0x20000u) >> 18;
    uint64_t product = (uint64_t)m * reciprocals[nearest]; /* Q38 */
    bool less = product < one;
    uint64_t r = (less ? one - product : product - one) << 26, r_high = r >> 32;
    uint64_t fraction = logarithms[nearest];
    whole += (int)(nearest >> 5);

    uint64_t flip = less ? 0 : ~(uint64_t)0;
    uint64_t sum = 0x24EED8A1DFu;                                     /* 1/10 */
    sum = 0x2909627AF8u + ((r_high * sum >> 32) ^ flip);              /* 1/9 */
    sum = 0x2E2A8ECA57u + ((r_high * sum >> 32) ^ flip);              /* 1/8 */
    sum = 0x34C2EC54F6u + ((r_high * sum >> 32) ^ flip);              /* 1/7 */
    sum = 0x3D8E13B874u + ((r_high * sum >> 32) ^ flip);              /* 1/6 */
    sum = 0x24EED8A1DF37FCF2u + (multiply_high(r, sum << 23) ^ flip); /* 1/5 */
    sum = 0x2E2A8ECA5705FC2Fu + (multiply_high(r, sum) ^ flip);       /* 1/4 */
    sum = 0x3D8E13B87407FAE9u + (multiply_high(r, sum) ^ flip);       /* 1/3 */
    sum = 0x5C551D94AE0BF85Eu + (multiply_high(r, sum) ^ flip);       /* 1/2 */
    sum = 0xB8AA3B295C17F0BCu + (multiply_high(r, sum) ^ flip);       /* 1 */

    fixed_logarithm result;
    unsigned zeros = leading_zeros(r); /* at least 5 */
    uint64_t small = multiply_high(r << zeros, sum);
    if (whole == 0 && fraction == 0) {
        result.significand = small;
        result.shift = (int)zeros - 1;
        result.negative = less;
    } else {
        small >>= zeros - 1;
        if (less) {
            whole -= fraction < small;
            fraction -= small;
        } else {
            fraction += small; /* below 1, as m is below 2 */
        }
        result.negative = whole < 0;
        if (result.negative) {
            whole = -whole - (fraction != 0);
            fraction = 0 - fraction;
        }
        result.significand = fraction;
        result.shift = 0;
        if (whole != 0) {
            unsigned unused = leading_zeros((uint64_t)whole);
            result.significand = (uint64_t)whole << unused | fraction >> (64 - unused);
            result.shift = (int)unused - 64;
        }
    }
    if (result.significand != 0) {
        zeros = leading_zeros(result.significand);
        result.significand <<= zeros;
        result.shift += (int)zeros;
    }
    return result;
}

static float logarithm(float x, bool natural)
{
    const uint64_t ln_2 = 0xB17217F7D1CF79ACu;
    uint32_t bits = float_bits(x);
    if ((bits & ~GN_SIGN_BIT) == 0)
        return float_from_bits(GN_SIGN_BIT | GN_EXPONENT_BITS);
    if (bits >= GN_EXPONENT_BITS) /* infinity, NaN, or a sign bit */
        return bits == GN_EXPONENT_BITS ? x : float_from_bits(GN_NAN_BITS);
    fixed_logarithm result = gni_binary_logarithm(bits);
    if (result.significand == 0)
        return 0.0f;
    if (natural)
        result.significand = multiply_high(result.significand, ln_2);
    return round_to_float(result.significand, (unsigned)result.shift,
                          result.negative ? GN_SIGN_BIT : 0);
}

/* The exact logarithm of a float that is no power of two is at least 2^-51.4 of itself away from
 * the middle between two floats; the value that is rounded is off by less than 2^-56.7 of itself.
 * (Enumerated with MPFR, for gn_log too.) */
GN_FALLBACK float gni_log2_integer(float x)
{
    return logarithm(x, false);
}

/* The exact natural logarithm is at least 2^-57.8 of itself away from the middle between two
 * floats; where |log2 x| is in 2^-7 .. 2^-4, at least 2^-43.4. The product with ln 2 is off by
 * 2^-62.3 more. So the value that is rounded is off by less than 2^-56.6 of itself in that range,
 * and elsewhere by less than 2^-58.8 (from 1.7 * 2^-60 + 2^-63). */
GN_FALLBACK float gni_log_integer(float x)
{
    return logarithm(x, true);
}

#if GN_HAVE_DOUBLES

const tabulated_reciprocal gni_reciprocals[32] = {
    {0x1p0, 0.0},
    {0x1.f07cp-1, 0x1.6bb01a01f3933p-5},
    {0x1.e1ep-1, 0x1.665684ff81085p-4},
    {0x1.d41cp-1, 0x1.08cd7820ecaa2p-3},
    {0x1.c71cp-1, 0x1.5c04864906631p-3},
    {0x1.badp-1, 0x1.acf30032be78ep-3},
    {0x1.af28p-1, 0x1.fbc44e396f7b4p-3},
    {0x1.a41cp-1, 0x1.243a590d2b727p-2},
    {0x1.9998p-1, 0x1.49ad4a118dae7p-2},
    {0x1.8f9cp-1, 0x1.6e22792ef1454p-2},
    {0x1.8618p-1, 0x1.91bd19e695edep-2},
    {0x1.7d04p-1, 0x1.b4865273edd5bp-2},
    {0x1.745cp-1, 0x1.d67992023118fp-2},
    {0x1.6c18p-1, 0x1.f7a349e747d37p-2},
    {0x1.642cp-1, 0x1.0c11650cf0586p-1},
    {0x1.5c98p-1, 0x1.1bf426e8e9aedp-1},
    {0x1.5554p-1, 0x1.2b83171e55a7fp-1},
    {0x1.4e6p-1, 0x1.3ab6ebafde191p-1},
    {0x1.47bp-1, 0x1.49a330c2adbb5p-1},
    {0x1.414p-1, 0x1.584b0513e7ce2p-1},
    {0x1.3b14p-1, 0x1.669f503a5478ap-1},
    {0x1.352p-1, 0x1.74b65165826ebp-1},
    {0x1.2f68p-1, 0x1.828156063945dp-1},
    {0x1.29e4p-1, 0x1.900e8f8a90688p-1},
    {0x1.2494p-1, 0x1.9d594bdadd0dep-1},
    {0x1.1f7p-1, 0x1.aa714802538bep-1},
    {0x1.1a7cp-1, 0x1.b74833f62e5f7p-1},
    {0x1.15bp-1, 0x1.c3eed6da233ebp-1},
    {0x1.111p-1, 0x1.d056d97cbe844p-1},
    {0x1.0c98p-1, 0x1.dc8714614b0a1p-1},
    {0x1.0844p-1, 0x1.e887023e7d579p-1},
    {0x1.041p-1, 0x1.f45ec16742a4p-1},
};

#endif

float gn_log2(float x)
{
#if GN_HAVE_DOUBLES
    uint32_t bits = float_bits(x);
    if (GN_LIKELY(bits - GN_HIDDEN_BIT < GN_EXPONENT_BITS - GN_HIDDEN_BIT)) {
        double result = double_logarithm(bits);
        if (rounding_is_certain(result))
            return (float)result;
    }
#endif
    return gni_log2_integer(x);
}

float gn_log(float x)
{
#if GN_HAVE_DOUBLES
    uint32_t bits = float_bits(x);
    if (GN_LIKELY(bits - GN_HIDDEN_BIT < GN_EXPONENT_BITS - GN_HIDDEN_BIT)) {
        double result = double_logarithm(bits) * 0x1.62e42fefa39efp-1; /* ln 2 */
        if (rounding_is_certain(result))
            return (float)result;
    }
#endif
    return gni_log_integer(x);
}
