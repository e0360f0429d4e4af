/* The power function: 2^(y * log2 |x|), in double or in integers, and rounded once. */
#include <gnomon/scalar.h>

#include <stdbool.h>
#include <stdint.h>

#include "bits.h"
#include "double_forms.h"
#include "exponential.h"
#include "integer_forms.h"
#include "logarithm.h"

typedef enum parity { NOT_INTEGER, EVEN, ODD } parity;

/* Returns the parity of a number that is not zero, given by its bits without the sign. Infinity is
 * even. */
static parity parity_of(uint32_t magnitude)
{
    unsigned field = magnitude >> 23;
    if (field < 127)
        return NOT_INTEGER;
    if (field > 150)
        return EVEN;
    uint32_t significand = (magnitude & GN_FRACTION_BITS) | GN_HIDDEN_BIT;
    uint32_t unit = (uint32_t)1 << (150 - field);
    if ((significand & (unit - 1)) != 0)
        return NOT_INTEGER;
    return (significand & unit) != 0 ? ODD : EVEN;
}

/* Let p = y * log2 |x|; |p| <= 150 if the result is neither zero nor infinite. p is off by less
 * than 2^-56.7 of itself (gni_binary_logarithm), which is 2^-49.4. 2^p, including
 * gni_power_of_two's own error, is off by less than 2^-49.9 of itself: 2^-25.9 units in the last
 * place of a float, and less of a denormal one. So the result is within 1/2 + 2^-25 units of the
 * exact value, also where the tolerance takes the farther of two floats.
 *
 * x^y can be a float, or the middle between two floats, without being a power of two only if
 * x = n * 2^a with n odd and at least 3, and n^y is an odd integer below 2^25: 0 < y < 15.8. Then
 * the error of p is below 15.8 * 1.7 * 2^-64 + 150 * 2^-63 (or 3.7 * 2^-63 of a small p) < 2^-55.6.
 * The error of the result, in units of its last place, is below 2^-56 * 2^24 < 2^-30, which is the
 * tolerance. So exact floats are returned exactly, and middles round to the even float. Powers of
 * two have an exact p. */
GN_FALLBACK float gni_pow_integer(float x, float y)
{
    const uint64_t tolerance = (uint64_t)1 << 34;
    uint32_t x_bits = float_bits(x), x_magnitude = x_bits & ~GN_SIGN_BIT;
    uint32_t y_bits = float_bits(y), y_magnitude = y_bits & ~GN_SIGN_BIT;
    bool y_negative = y_bits != y_magnitude;
    if (y_magnitude == 0 || x_bits == GN_ONE_BITS)
        return 1.0f;
    if (x_magnitude > GN_EXPONENT_BITS || y_magnitude > GN_EXPONENT_BITS)
        return float_from_bits(GN_NAN_BITS);
    bool x_extreme = x_magnitude == 0 || x_magnitude == GN_EXPONENT_BITS;
    uint32_t sign = 0;
    if (x_bits != x_magnitude) {
        parity y_parity = parity_of(y_magnitude);
        if (y_parity == NOT_INTEGER && !x_extreme)
            return float_from_bits(GN_NAN_BITS);
        if (y_parity == ODD)
            sign = GN_SIGN_BIT;
    }
    if (x_magnitude == GN_ONE_BITS)
        return float_from_bits(GN_ONE_BITS | sign);
    if (x_extreme) {
        bool grows = (x_magnitude > GN_ONE_BITS) != y_negative;
        return float_from_bits((grows ? GN_EXPONENT_BITS : 0) | sign);
    }
    /* An infinite y makes the shift negative, as a y of 2^128 would. */
    fixed_logarithm logarithm = gni_binary_logarithm(x_magnitude);
    binary_exponent exponent = {
        logarithm.significand, (y_magnitude & GN_FRACTION_BITS) | GN_HIDDEN_BIT,
        150 - (int)(y_magnitude >> 23) + logarithm.shift, logarithm.negative != y_negative};
    return gni_power_of_two(&exponent, sign, tolerance);
}

/* For a positive, normal x and a result in 2^-126 .. 2^126. Let p = y * log2(x). The logarithm's
 * error and a rounding put p off by less than 126 * (2^-42.4 + 2^-53) < 2^-35.4, and 2^p by ln 2
 * times that and 2^-43.4: less than 2^-35.8 of itself. The integer form decides one in 2^10. */
float gn_pow(float x, float y)
{
#if GN_HAVE_DOUBLES
    uint32_t bits = float_bits(x);
    if (GN_LIKELY(bits - GN_HIDDEN_BIT < GN_EXPONENT_BITS - GN_HIDDEN_BIT)) {
        double p = (double)y * double_logarithm(bits);
        if (is_normal_exponent(p)) {
            double result = double_power(p);
            if (rounding_is_certain_within(result, 35))
                return (float)result;
        }
    }
#endif
    return gni_pow_integer(x, y);
}
