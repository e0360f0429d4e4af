/* Scalar functions beside the C library's, which cglm calls, in units in the last place. Gnomon's
 * are correctly rounded, atan2 and pow within 0.5000001. The C library promises no bound
 * (other_bound -1). */
#include "rows.h"
#include "wide.h"

/* One unit in the last place of x, in units of u. */
static void in_ulps(struct exact *exact, wide x)
{
    int exponent;
    frexpl(x, &exponent);
    absolute(exact, 0, x, x == 0.0L ? 0.0L : ldexpl(1.0L, exponent < -125 ? -125 : exponent));
}

#define FUNCTION(name)                                                                             \
    static bool own_##name(const float *in, float *out)                                            \
    {                                                                                              \
        return put(gn_##name(in[0]), out);                                                         \
    }                                                                                              \
    static void other_##name(float *in, float *out)                                                \
    {                                                                                              \
        *out = name##f(in[0]);                                                                     \
    }                                                                                              \
    static void exact_##name(const float *in, struct exact *exact)                                 \
    {                                                                                              \
        in_ulps(exact, name##l((wide)in[0]));                                                      \
    }

FUNCTION(sqrt)
FUNCTION(sin)
FUNCTION(cos)
FUNCTION(tan)
FUNCTION(asin)
FUNCTION(acos)
FUNCTION(atan)
FUNCTION(exp2)
FUNCTION(exp)
FUNCTION(log2)
FUNCTION(log)

OWN(rsqrt)
{
    return put(gn_rsqrt(in[0]), out);
}
OTHER(rsqrt)
{
    *out = 1.0f / sqrtf(in[0]);
}
EXACT(rsqrt)
{
    in_ulps(exact, 1.0L / sqrtl((wide)in[0]));
}

OWN(atan2)
{
    return put(gn_atan2(in[0], in[1]), out);
}
OTHER(atan2)
{
    *out = atan2f(in[0], in[1]);
}
EXACT(atan2)
{
    in_ulps(exact, atan2l((wide)in[0], (wide)in[1]));
}

OWN(pow)
{
    return put(gn_pow(in[0], in[1]), out);
}
OTHER(pow)
{
    *out = powf(in[0], in[1]);
}
EXACT(pow)
{
    in_ulps(exact, powl((wide)in[0], (wide)in[1]));
}

static void positive(float *in)
{
    in[0] = in[0] == 0.0f ? 1.0f : fabsf(in[0]);
}

static void at_most_1(float *in)
{
    in[0] = remainderf(in[0], 2.0f);
}

/* Results from 2^-121 to 2^121, with exponents of at most 20.2. */
static void prepare_pow(float *in)
{
    positive(in);
    in[1] = remainderf(in[1], 242.0f / (fabsf(log2f(in[0])) + 6.0f));
}

#define SCALAR(name, inputs, exponents, prepare)                                                   \
    ROW(name, #name, inputs, 1, exponents, prepare, 0.5000001, -1.0)

static const struct row rows[] = {
    SCALAR(sqrt, 1, 120, positive),  SCALAR(sin, 1, 30, NULL),
    SCALAR(cos, 1, 30, NULL),        SCALAR(tan, 1, 30, NULL),
    SCALAR(asin, 1, 10, at_most_1),  SCALAR(acos, 1, 10, at_most_1),
    SCALAR(atan, 1, 30, NULL),       SCALAR(atan2, 2, 30, NULL),
    SCALAR(rsqrt, 1, 120, positive), SCALAR(exp2, 1, 5, NULL),
    SCALAR(exp, 1, 5, NULL),         SCALAR(log2, 1, 120, positive),
    SCALAR(log, 1, 120, positive),   SCALAR(pow, 2, 20, prepare_pow),
};

const struct table scalar_rows = {rows, sizeof rows / sizeof rows[0]};
