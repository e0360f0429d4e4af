/* Sums and products of floats without rounding, as pairs: a number is high + low,
 * where high is the sum rounded to nearest. Barring overflow and underflow; each
 * operation is a statement, since the proofs need every one of them rounded to
 * float. (Dekker, A floating-point technique for extending the available
 * precision, 1971; Knuth, TAOCP 2, section 4.2.2.) */
#ifndef GNOMON_MATH_EXACT_H
#define GNOMON_MATH_EXACT_H

typedef struct gn_pair {
    float high, low;
} gn_pair;

/* a + b exactly. */
static inline gn_pair gn_exact_sum(float a, float b)
{
    const float high = a + b;
    const float b_part = high - a;
    const float a_part = high - b_part;
    const float a_lost = a - a_part;
    const float b_lost = b - b_part;
    const gn_pair sum = {high, a_lost + b_lost};
    return sum;
}

/* a in two halves of 12 bits, exactly. */
static inline gn_pair gn_halves(float a)
{
    const float product = 4097.0f * a;
    const float rest = product - a;
    const float high = product - rest;
    const gn_pair halves = {high, a - high};
    return halves;
}

/* a * b exactly: the products of halves are exact, and so are their sums in this
 * order. */
static inline gn_pair gn_exact_product(float a, float b)
{
    const gn_pair x = gn_halves(a), y = gn_halves(b);
    const float high = a * b;
    const float high_high = x.high * y.high, high_low = x.high * y.low;
    const float low_high = x.low * y.high, low_low = x.low * y.low;
    const float first = high_high - high;
    const float second = first + high_low;
    const float third = second + low_high;
    const gn_pair product = {high, third + low_low};
    return product;
}

/* a + b with an error of 3 u^2 (|a| + |b|), u = 2^-24. */
static inline gn_pair gn_pair_add(gn_pair a, gn_pair b)
{
    const gn_pair sum = gn_exact_sum(a.high, b.high);
    const float lows = a.low + b.low;
    return gn_exact_sum(sum.high, sum.low + lows);
}

/* a * b - c * d, within 4 u^2 (|a b| + |c d|) and the high part within 2 u of itself,
 * however much cancels. Where the products p, q are within a factor of two of each
 * other the difference of their high parts is exact. That of their low parts is at
 * most 2^24 of the smallest unit they can have, thus exact too, unless p and q lie
 * on both sides of a power of two and one is a product of two fractions near 2; such
 * p and q differ by 2^24 times what is then lost. */
static inline gn_pair gn_exact_minor(float a, float b, float c, float d)
{
    const gn_pair p = gn_exact_product(a, b), q = gn_exact_product(c, d);
    const gn_pair highs = gn_exact_sum(p.high, -q.high);
    const float lows = p.low - q.low;
    const gn_pair sum = gn_exact_sum(highs.high, lows);
    return gn_exact_sum(sum.high, sum.low + highs.low);
}

#endif
