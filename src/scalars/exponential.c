/* Exponentials: the exponent of 2 is split into an integer and a fraction; the power of the
 * fraction comes from a table and a polynomial, in double or in integers, and is rounded once. */
#include <gnomon/scalar.h>

#include "bits.h"
#include "exponential.h"
#include "fixed_point.h"
#include "integer_forms.h"

/* 2^(i/32) in Q63. */
static const uint64_t powers[32] = {
    0x8000000000000000u, 0x82CD8698AC2BA1D7u, 0x85AAC367CC487B15u, 0x88980E8092DA8527u,
    0x8B95C1E3EA8BD6E7u, 0x8EA4398B45CD53C0u, 0x91C3D373AB11C336u, 0x94F4EFA8FEF70961u,
    0x9837F0518DB8A96Fu, 0x9B8D39B9D54E5539u, 0x9EF5326091A111AEu, 0xA27043030C496819u,
    0xA5FED6A9B15138EAu, 0xA9A15AB4EA7C0EF8u, 0xAD583EEA42A14AC6u, 0xB123F581D2AC2590u,
    0xB504F333F9DE6484u, 0xB8FBAF4762FB9EE9u, 0xBD08A39F580C36BFu, 0xC12C4CCA66709456u,
    0xC5672A115506DADDu, 0xC9B9BD866E2F27A3u, 0xCE248C151F8480E4u, 0xD2A81D91F12AE45Au,
    0xD744FCCAD69D6AF4u, 0xDBFBB797DAF23755u, 0xE0CCDEEC2A94E111u, 0xE5B906E77C8348A8u,
    0xEAC0C6E7DD24392Fu, 0xEFE4B99BDCDAF5CBu, 0xF5257D152486CC2Cu, 0xFA83B2DB722A033Au,
};

/* 2^fraction = 2^(i/32) * (1 + v) with v = 2^r - 1; r is the rest, below 2^-5. v = r * (c1 + r *
 * (c2 + ...)) with cn = (ln 2)^n / n!, by Horner's rule with rounded coefficients.
 *
 * The terms after c8 are below 1.01 * (ln 2 / 32)^9 / 9! < 2^-68. The sums of c7 to c5 are in Q48,
 * from the upper 27 bits of r. Those of c7 and c6 are off by less than 3 units, that of c5 by less
 * than 16 (2^-32 of r is lost, of a sum below 2^36 units), which four more factors r reduce to one
 * unit of Q64. From c4 on a step adds at most 1.5 units, and the next step multiplies them by r:
 * the sum of c1 is off by less than 2.6 units, and v by less than 2.6/32 + 1 (its product is
 * cut) + 2^-4 < 1.2. The table is rounded and its product with v is cut. With p = 2^(i/32) the
 * error is 1.2 * p/2 + 0.52 + 1 units of Q63, of p * 2^63: relatively less than 2.2 * 2^-63. r = 0
 * yields v = 0, so the result is exact for i = 0 and r = 0. */
uint64_t gni_fixed_power(uint64_t fraction)
{
    uint64_t power = powers[fraction >> 59];
    uint64_t r = fraction & 0x07FFFFFFFFFFFFFFu, r_high = r >> 32;
    uint64_t sum = 0x162C0224u;                              /* c8 */
    sum = 0x0000FFE5FE2Cu + (r_high * sum >> 32);            /* c7 */
    sum = 0x000A184897C3u + (r_high * sum >> 32);            /* c6 */
    sum = 0x005761FF9E2Au + (r_high * sum >> 32);            /* c5 */
    sum = 0x0276556DF749CEE5u + multiply_high(r, sum << 16); /* c4 */
    sum = 0x0E35846B82505FC6u + multiply_high(r, sum);       /* c3 */
    sum = 0x3D7F7BFF058B1D51u + multiply_high(r, sum);       /* c2 */
    sum = 0xB17217F7D1CF79ACu + multiply_high(r, sum);       /* c1 */
    return power + multiply_high(power, multiply_high(r, sum));
}

/* Returns the float nearest to significand * 2^(exponent - 63), for a significand of at least 2^63;
 * `tolerance` as in gni_power_of_two. A carry out of the fraction runs into the exponent, up to the
 * exponent of infinity. */
static float round_power(uint64_t significand, int exponent, uint32_t sign, uint64_t tolerance)
{
    unsigned dropped = 40;
    uint32_t below = 0; /* the exponent field less the one of the highest bit */
    if (exponent > 127)
        return float_from_bits(GN_EXPONENT_BITS | sign);
    if (exponent >= -126)
        below = (uint32_t)(exponent + 126) << 23;
    else if (exponent >= -150)
        dropped = (unsigned)(-86 - exponent); /* 41 to 64 */
    else
        return float_from_bits(sign);
    uint32_t kept = (uint32_t)(significand >> 1 >> (dropped - 1));
    uint64_t past_middle = (significand << (64 - dropped)) - ((uint64_t)1 << 63);
    if (past_middle + tolerance <= 2 * tolerance)
        kept += kept & 1;
    else if (past_middle >> 63 == 0)
        kept += 1;
    return float_from_bits((below + kept) | sign);
}

/* The product is in [2^86, 2^88). A shift up to 14 makes y at least 2^8. A shift above 48 makes y
 * less than 2^-25; 2^y is then nearer to 1 than to the floats next to 1. Bits of y below 2^-64 are
 * cut off, which together with gni_fixed_power's error is less than (2.2 + 0.5 * ln 2) * 2^-63. */
float gni_power_of_two(const binary_exponent *y, uint32_t sign, uint64_t tolerance)
{
    if (y->shift > 48)
        return float_from_bits(GN_ONE_BITS | sign);
    if (y->shift < 15)
        return float_from_bits((y->negative ? 0 : GN_EXPONENT_BITS) | sign);
    uint64_t low = (y->factor & 0xFFFFFFFFu) * y->significand;
    uint64_t high = (y->factor >> 32) * y->significand + (low >> 32);
    int whole = 0;
    uint64_t fraction;
    if (y->shift < 32) {
        whole = (int)(high >> 32 >> y->shift);
        fraction = (high >> 32 << (64 - y->shift)) | (high << 32 | (low & 0xFFFFFFFFu)) >> y->shift;
    } else {
        fraction = high >> (y->shift - 32);
    }
    if (y->negative) {
        whole = -whole - (fraction != 0);
        fraction = 0 - fraction;
    }
    return round_power(gni_fixed_power(fraction), whole, sign, tolerance);
}

/* Returns 2^(x * factor), with the factor in Q63. A denormal x is given a leading bit that it does
 * not have, and a shift of 149; the result is 1 all the same. */
static float exponential(float x, uint64_t factor)
{
    uint32_t bits = float_bits(x), magnitude = bits & ~GN_SIGN_BIT;
    if (magnitude > GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    binary_exponent y = {factor, (bits & GN_FRACTION_BITS) | GN_HIDDEN_BIT,
                         149 - (int)(magnitude >> 23), bits != magnitude};
    return gni_power_of_two(&y, 0, 0);
}

/* y is exact. The exact result is at least 2^-58.9 of itself away from the middle between two
 * floats, unless it is such a middle: x = -150, which gni_power_of_two handles. (Enumerated with
 * MPFR, for e^x too.) */
GN_FALLBACK float gni_exp2_integer(float x)
{
    return exponential(x, 0x8000000000000000u);
}

/* log2(e) is rounded (2^-65.4 of itself). So y, up to 150 where it matters, is off by less than
 * 2^-58.1, and the result by less than 2^-58.5 of itself. e^x is at least 2^-52.7 of itself away
 * from the middle between two floats. */
GN_FALLBACK float gni_exp_integer(float x)
{
    return exponential(x, 0xB8AA3B295C17F0BCu);
}

#if GN_HAVE_DOUBLES

const uint64_t gni_powers[32] = {
    0x3FF0000000000000u, 0x3FEFD9B0D3158574u, 0x3FEFB5586CF9890Fu, 0x3FEF9301D0125B51u,
    0x3FEF72B83C7D517Bu, 0x3FEF54873168B9AAu, 0x3FEF387A6E756238u, 0x3FEF1E9DF51FDEE1u,
    0x3FEF06FE0A31B715u, 0x3FEEF1A7373AA9CBu, 0x3FEEDEA64C123422u, 0x3FEECE086061892Du,
    0x3FEEBFDAD5362A27u, 0x3FEEB42B569D4F82u, 0x3FEEAB07DD485429u, 0x3FEEA47EB03A5585u,
    0x3FEEA09E667F3BCDu, 0x3FEE9F75E8EC5F74u, 0x3FEEA11473EB0187u, 0x3FEEA589994CCE13u,
    0x3FEEACE5422AA0DBu, 0x3FEEB737B0CDC5E5u, 0x3FEEC49182A3F090u, 0x3FEED503B23E255Du,
    0x3FEEE89F995AD3ADu, 0x3FEEFF76F2FB5E47u, 0x3FEF199BDD85529Cu, 0x3FEF3720DCEF9069u,
    0x3FEF5818DCFBA487u, 0x3FEF7C97337B9B5Fu, 0x3FEFA4AFA2A490DAu, 0x3FEFD0765B6E4540u,
};

#endif

/* From 2^-126 on, results are normal. The integer form has the rest. */
float gn_exp2(float x)
{
#if GN_HAVE_DOUBLES
    double y = (double)x;
    if (is_normal_exponent(y)) {
        double result = double_power(y);
        if (rounding_is_certain(result))
            return (float)result;
    }
#endif
    return gni_exp2_integer(x);
}

/* log2(e) and the product are rounded, so y, up to 126, is off by less than 2^-45. */
float gn_exp(float x)
{
#if GN_HAVE_DOUBLES
    double y = (double)x * 0x1.71547652b82fep0;
    if (is_normal_exponent(y)) {
        double result = double_power(y);
        if (rounding_is_certain(result))
            return (float)result;
    }
#endif
    return gni_exp_integer(x);
}
