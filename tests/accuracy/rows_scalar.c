/* Scalar functions beside the C library's, which cglm calls, in units in the last place. Ours
 * are correctly rounded; of the C library's no bound is promised (other_bound -1). */
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

static void positive(float *in)
{
    in[0] = fabsf(in[0]);
    in[1] = fabsf(in[1]);
}

#define ROW(name, prepare, exponents)                                                              \
    {                                                                                              \
#name, 1, 1, exponents, prepare, own_##name, other_##name, exact_##name, 0.5, -1.0         \
    }

static const struct row rows[] = {
    ROW(sqrt, positive, 120),
    ROW(sin, NULL, 30),
    ROW(cos, NULL, 30),
    ROW(tan, NULL, 30),
};

const struct table scalar_rows = {rows, sizeof rows / sizeof rows[0]};
