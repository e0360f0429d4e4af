/* Square root: the processor's instruction where IEEE 754 makes it exact, elsewhere digit by digit
 * in integers. Both return the same bits. */
#include <gnomon/scalar.h>

#include <stdint.h>

#include "bits.h"
#include "integer_forms.h"
#include "square_root.h"

float gn_sqrt_integer(float x)
{
    uint32_t bits = gn_float_bits(x);
    if ((bits & ~GN_SIGN_BIT) == 0 || bits == GN_EXPONENT_BITS)
        return x; /* both zeros, infinity */
    if (bits > GN_EXPONENT_BITS)
        return gn_float_from_bits(GN_NAN_BITS); /* NaN, or a sign bit */

    /* x = significand * 2^(exponent - 150), 2^23 <= significand < 2^24. */
    int32_t exponent = (int32_t)(bits >> 23);
    uint32_t significand = bits & GN_FRACTION_BITS;
    if (exponent == 0) {
        exponent = 1;
        while (significand < GN_HIDDEN_BIT) {
            significand <<= 1;
            exponent -= 1;
        }
    } else {
        significand |= GN_HIDDEN_BIT;
    }

    /* Let s = significand, doubled if that makes the power of two even. The root is floor(sqrt(s *
     * 2^25)) in 25 bits, found from the top. `root` is the prefix of the root, `remainder` the
     * difference between the digits of s * 2^25 so far and the square of the prefix. s * 2^25 has
     * at most 50 bits; each step brings down two of them. s * 2^25 >= 2^48, so the first of the 25
     * bits is a one. */
    if ((exponent & 1) == 0)
        significand <<= 1;
    uint32_t digits = significand << 7; /* the next bits of s are on top */
    uint32_t root = 0, remainder = 0;
    for (int step = 0; step < 25; ++step) {
        uint32_t trial = root << 2 | 1;
        remainder = remainder << 2 | digits >> 30;
        digits <<= 2;
        root <<= 1;
        if (remainder >= trial) {
            remainder -= trial;
            root |= 1;
        }
    }

    /* Rounds the 25th bit away. A 25-bit root that ends in a one has a square of 50 bits, more than
     * s has, so the exact root is never a tie. */
    uint32_t rounded = (root >> 1) + (root & 1);
    uint32_t result_exponent = (uint32_t)((exponent + 127) >> 1) - 1;
    return gn_float_from_bits((result_exponent << 23) + rounded);
}

float gn_sqrt(float x)
{
#if GN_HAVE_SQUARE_ROOT
    uint32_t bits = gn_float_bits(x); /* compared as integers, which tell one NaN from another */
    if (bits > GN_EXPONENT_BITS && bits != GN_SIGN_BIT)
        return gn_float_from_bits(GN_NAN_BITS);
    return gn_float_square_root(x);
#else
    return gn_sqrt_integer(x);
#endif
}
