/* The general inverses of 3x3 and 4x4 matrices: the adjugate over the determinant, in double.
 * No other file computes in double where the processor cannot (config/doubles.h).
 *
 * The product of two floats is exact in double (48 bits), so a 2x2 minor is rounded once, by v =
 * 2^-53 of itself. No product of four floats is above 2^512 or, if not zero, below 2^-596. So
 * nothing overflows or underflows before the result is rounded to float, whatever the scale of the
 * matrix. */
#include <gnomon/mat.h>

#include <float.h>
#include <stdbool.h>

#include "../config/precision.h"
#include "../lanes/double2.h"
#include "../scalars/bits.h"

/* Out of line, so that the code that always runs fits the registers. */
#if defined(__GNUC__)
#define RARELY static __attribute__((noinline, cold))
#else
#define RARELY static
#endif

/* If the terms of a 4x4 determinant cancel by more than this factor, they are summed again. */
#define MOST_CANCELLATION 0x1p24

/* A determinant summed again counts as zero if it is not above this part of the sum of its terms'
 * magnitudes. The second sum is within 2^-99 of that sum, so a determinant above the limit is
 * within 2^-27 of itself. */
#define SINGULAR_BELOW 0x1p-72

/* The limit for a 3x3 determinant, whose sum is within 2^-51 of its terms. */
#define SINGULAR_BELOW3 0x1p-48

static double magnitude(double x)
{
    return x < 0.0 ? -x : x;
}

/* Returns the product of two norms as a float, or infinity. */
static float condition_from(double product)
{
    return product <= (double)FLT_MAX ? (float)product : float_from_bits(GN_EXPONENT_BITS);
}

/* An unevaluated sum, |rest| <= 2^-53 |value|. */
typedef struct split {
    double value, rest;
} split;

/* Returns a + b, exactly (D. E. Knuth, The Art of Computer Programming 2, 4.2.2, theorem B). */
static split add_exactly(double a, double b)
{
    split sum;
    sum.value = a + b;
    double other = sum.value - a;
    sum.rest = (a - (sum.value - other)) + (b - other);
    return sum;
}

/* Returns the upper 26 bits of x (T. J. Dekker, A floating-point technique for extending the
 * available precision, Numerische Mathematik 18, 1971). */
static double upper_half(double x)
{
    double scaled = 0x1.0000002p27 * x; /* 2^27 + 1 */
    return scaled - (scaled - x);
}

/* Returns a * b, exactly, from the products of halves (Dekker 1971, as above). */
static split multiply_exactly(double a, double b)
{
    split product;
    double a_high = upper_half(a), b_high = upper_half(b);
    double a_low = a - a_high, b_low = b - b_high;
    product.value = a * b;
    product.rest =
        ((a_high * b_high - product.value) + a_high * b_low + a_low * b_high) + a_low * b_low;
    return product;
}

static split minor_exactly(const float *left, const float *right, int i, int j)
{
    return add_exactly((double)left[i] * (double)right[j], -((double)left[j] * (double)right[i]));
}

/* Returns the determinant by the Laplace expansion of gn_mat4_determinant with twice the digits.
 * With v = 2^-53, T the sum of the terms' magnitudes, and to first order in v^2: a term leaves out
 * v^2 of itself, and 7 v^2 in the roundings of its rest, which is at most 3 v. The six sums round
 * rests of at most 4 v T and 9 v T. In all 8 + 6 * 13 = 86 v^2 T < 2^-99 T. */
RARELY double determinant_again(const gn_mat4 *m)
{
    static const unsigned char rows[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                             {1, 2, 0, 3}, {3, 1, 0, 2}, {2, 3, 0, 1}};
    double value = 0.0, rest = 0.0;
    for (int i = 0; i < 6; ++i) {
        split first = minor_exactly(m->m[0], m->m[1], rows[i][0], rows[i][1]);
        split last = minor_exactly(m->m[2], m->m[3], rows[i][2], rows[i][3]);
        split term = multiply_exactly(first.value, last.value);
        split sum = add_exactly(value, term.value);
        term.rest += first.value * last.rest + first.rest * last.value;
        value = sum.value;
        rest += sum.rest + term.rest;
    }
    return value + rest;
}

static inline double2 minors(const double2 left[4], const double2 right[4], int i, int j)
{
    return double2_sub(double2_mul(left[i], right[j]), double2_mul(left[j], right[i]));
}

static inline double2 combine(double2 x, double2 p, double2 y, double2 q, double2 z, double2 r)
{
    return double2_add(double2_sub(double2_mul(x, p), double2_mul(y, q)), double2_mul(z, r));
}

/* Returns the negative of `combine`, with the same roundings. */
static inline double2 combine_negated(double2 x, double2 p, double2 y, double2 q, double2 z,
                                      double2 r)
{
    return double2_sub(double2_sub(double2_mul(y, q), double2_mul(x, p)), double2_mul(z, r));
}

static inline double largest(double2 pair)
{
    return double2_first(double2_larger(pair, double2_swap(pair)));
}

/* Returns the largest sum of magnitudes in a row of a matrix whose row i is in left[i] and
 * right[i]. */
static inline double norm_by_rows(const double2 left[4], const double2 right[4])
{
    double2 most = double2_set(0.0);
    for (int i = 0; i < 4; ++i) {
        double2 row = double2_add(double2_magnitude(left[i]), double2_magnitude(right[i]));
        most = double2_larger(most, double2_add(row, double2_swap(row)));
    }
    return double2_first(most);
}

/* Returns the largest sum of magnitudes in a row of a matrix whose column i is in even[i] and
 * odd[i]. */
static inline double norm_by_columns(const double2 even[4], const double2 odd[4])
{
    double2 first = double2_magnitude(even[0]), second = double2_magnitude(odd[0]);
    for (int i = 1; i < 4; ++i) {
        first = double2_add(first, double2_magnitude(even[i]));
        second = double2_add(second, double2_magnitude(odd[i]));
    }
    return largest(double2_larger(first, second));
}

/* Infinity minus itself is NaN; every finite number minus itself is zero. */
static inline bool is_finite4(float4 a)
{
    return !float4_has_nan(float4_sub(a, a));
}

RARELY bool are_finite_one_by_one(float4 a, float4 b, float4 c, float4 d)
{
    return is_finite4(a) && is_finite4(b) && is_finite4(c) && is_finite4(d);
}

/* Finite numbers, too, can have an infinite sum. */
static inline bool are_finite(float4 a, float4 b, float4 c, float4 d)
{
    return is_finite4(float4_add(float4_add(a, b), float4_add(c, d))) ||
           are_finite_one_by_one(a, b, c, d);
}

/* N m = I, so the rows n0 to n3 of N are, but for their length, vector products of three columns.
 * Let s and t be the minors of the columns a, b and c, d. Then n0 is b times t, n1 a times t, n2 d
 * times s and n3 c times s, with alternating signs. So the first two columns and the last two take
 * the same steps, side by side: a pair holds (a, c), (b, d) or (s, t).
 *
 * Bound, with v = 2^-53 and the singular values s1 >= s2 >= s3 >= s4. An entry of the adjugate is
 * the sum of three products of an entry and a minor, off by at most 4 v of their magnitudes. In
 * all, in the Frobenius norm, the adjugate is off by at most sqrt(2) * 2 s1 * sqrt(6) s1 s2 * 4 v <
 * 2^5 s1^2 s2 v. Its norm is at least s1 s2 s3, so the relative error is below 2^-48 s1/s3. The
 * determinant is off by 6 v of its terms: by 2^-26.4 of itself where MOST_CANCELLATION lets it
 * stand, by 2^-27 otherwise. The rounding to float adds 2^-24. */
gn_status gn_mat4_invert(const gn_mat4 *m, gn_mat4 *result, float *condition)
{
    const float4 zero = float4_set(0.0f, 0.0f, 0.0f, 0.0f); /* x + 0 is no negative zero */
    double2 ac[4], bd[4];
    float4 columns[4];
    if (!m || !result)
        return GN_NULL_POINTER;
    double2_load(m->m[0], m->m[2], ac);
    double2_load(m->m[1], m->m[3], bd);
    const double2 st01 = minors(ac, bd, 0, 1), ts01 = double2_swap(st01);
    const double2 st02 = minors(ac, bd, 0, 2), ts02 = double2_swap(st02);
    const double2 st03 = minors(ac, bd, 0, 3), ts03 = double2_swap(st03);
    const double2 ts12 = double2_swap(minors(ac, bd, 1, 2));
    const double2 ts13 = double2_swap(minors(ac, bd, 1, 3));
    const double2 ts23 = double2_swap(minors(ac, bd, 2, 3));

    /* Each of the two places holds half of the terms of the determinant. */
    const double2 first = double2_mul(st01, ts23), second = double2_mul(st02, ts13);
    const double2 third = double2_mul(st03, ts12);
    const double2 half = double2_add(double2_sub(first, second), third);
    double2 determinant = double2_add(half, double2_swap(half)); /* in both places */
    double terms =
        double2_sum(double2_add(double2_add(double2_magnitude(first), double2_magnitude(second)),
                                double2_magnitude(third)));
    if (!(double2_first(double2_magnitude(determinant)) * MOST_CANCELLATION > terms)) {
        if (!(terms <= DBL_MAX))
            return GN_NOT_FINITE; /* every entry is a factor, and infinity times zero is NaN */
        determinant = double2_set(determinant_again(m));
        if (!(double2_first(double2_magnitude(determinant)) > terms * SINGULAR_BELOW))
            return GN_SINGULAR;
    }

    const double2 factor = double2_div(double2_set(1.0), determinant);
    double2 even[4], odd[4]; /* rows 0 and 2, rows 1 and 3 of the inverse's columns */
    even[0] = double2_mul(combine(bd[1], ts23, bd[2], ts13, bd[3], ts12), factor);
    odd[0] = double2_mul(combine_negated(ac[1], ts23, ac[2], ts13, ac[3], ts12), factor);
    even[1] = double2_mul(combine_negated(bd[0], ts23, bd[2], ts03, bd[3], ts02), factor);
    odd[1] = double2_mul(combine(ac[0], ts23, ac[2], ts03, ac[3], ts02), factor);
    even[2] = double2_mul(combine(bd[0], ts13, bd[1], ts03, bd[3], ts01), factor);
    odd[2] = double2_mul(combine_negated(ac[0], ts13, ac[1], ts03, ac[3], ts01), factor);
    even[3] = double2_mul(combine_negated(bd[0], ts12, bd[1], ts02, bd[2], ts01), factor);
    odd[3] = double2_mul(combine(ac[0], ts12, ac[1], ts02, ac[2], ts01), factor);
    /* Before the rounding, so that the doubles need not be kept. */
    double norms = 0.0;
    if (condition)
        norms = norm_by_rows(ac, bd) * norm_by_columns(even, odd);
    for (int i = 0; i < 4; ++i)
        columns[i] = float4_add(double2_round(even[i], odd[i]), zero);
    if (!are_finite(columns[0], columns[1], columns[2], columns[3]))
        return GN_OUT_OF_RANGE;
    for (int i = 0; i < 4; ++i)
        float4_store(result->m[i], columns[i]);
    if (condition)
        *condition = condition_from(norms);
    return GN_OK;
}

/* Returns the largest sum of magnitudes in a row; m is [column][row]. */
static double norm3(double m[3][3])
{
    double most = 0.0;
    for (int row = 0; row < 3; ++row) {
        double sum = magnitude(m[0][row]) + magnitude(m[1][row]) + magnitude(m[2][row]);
        most = sum > most ? sum : most;
    }
    return most;
}

/* The cofactors are minors here, rounded once. The determinant is off by 4 v of its terms, which
 * are at most s1 times the norm of the cofactors, sqrt(3) s1 s2. Together with the roundings of the
 * division, that is below 2^-50 s1/s3 of itself. */
gn_status gn_mat3_invert(const gn_mat3 *m, gn_mat3 *result, float *condition)
{
    double before[3][3], after[3][3];
    bool finite = true;
    if (!m || !result)
        return GN_NULL_POINTER;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            before[column][row] = (double)m->m[column][row];
    for (int row = 0; row < 3; ++row) {
        const double *left = before[(row + 1) % 3], *right = before[(row + 2) % 3];
        for (int column = 0; column < 3; ++column) {
            int i = (column + 1) % 3, j = (column + 2) % 3;
            after[column][row] = left[i] * right[j] - left[j] * right[i];
        }
    }
    double x = before[0][0] * after[0][0], y = before[0][1] * after[1][0];
    double z = before[0][2] * after[2][0];
    double determinant = x + y + z, terms = magnitude(x) + magnitude(y) + magnitude(z);
    if (!(terms <= DBL_MAX))
        return GN_NOT_FINITE;
    if (!(magnitude(determinant) > terms * SINGULAR_BELOW3))
        return GN_SINGULAR;
    double factor = 1.0 / determinant;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            after[column][row] *= factor;
            finite = finite && is_finite((float)after[column][row]);
        }
    }
    if (!finite)
        return GN_OUT_OF_RANGE;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            result->m[column][row] = (float)after[column][row] + 0.0f; /* no negative zero */
    if (condition)
        *condition = condition_from(norm3(before) * norm3(after));
    return GN_OK;
}
