/* Inputs of the tables and errors of results; rows.h describes them. */
#include "rows.h"

#include <math.h>
#include <stdint.h>

#define U 0x1p-24L

/* G. Marsaglia's xorshift, with S. Vigna's multiplier. */
static uint32_t next(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (uint32_t)(*state * 0x2545F4914F6CDD1Du >> 32);
}

static float number(uint64_t *state, int exponents)
{
    const uint32_t bits = next(state);
    const int exponent = (int)(next(state) % (uint32_t)(2 * exponents + 1)) - exponents;
    const float magnitude = ldexpf(1.0f + (float)(bits >> 9) * 0x1p-23f, exponent);
    return (bits & 1) != 0 ? -magnitude : magnitude;
}

/* Whole numbers of -4 to 4, powers of two, and a neighbour of the previous number: these make sums
 * cancel and results exact. */
static float structured(uint64_t *state, float before)
{
    const uint32_t choice = next(state);
    if (choice % 8 == 0 && before != 0.0f)
        return nextafterf(before, 8.0f);
    if (choice % 8 == 1)
        return ldexpf(choice >> 31 ? -1.0f : 1.0f, (int)(choice >> 8 & 7) - 4);
    return (float)((choice >> 8) % 9) - 4.0f;
}

void make_inputs(const struct row *row, enum kind kind, uint64_t *state, float *in)
{
    for (int i = 0; i < row->inputs; ++i)
        in[i] = kind == RANDOM    ? number(state, 3)
                : kind == EXTREME ? number(state, row->exponents)
                                  : structured(state, i == 0 ? 1.0f : in[i - 1]);
    if (row->prepare)
        row->prepare(in);
}

void evaluate(const struct row *row, const float *in, struct exact *exact)
{
    for (int i = 0; i < MOST_OUTPUTS; ++i) {
        exact->value[i] = exact->scale[i] = 0.0L;
        exact->other_scale[i] = -1.0L;
    }
    row->exact(in, exact);
    for (int i = 0; i < MOST_OUTPUTS; ++i)
        if (exact->other_scale[i] < 0.0L)
            exact->other_scale[i] = exact->scale[i];
}

void settle_sign(const struct row *row, const struct exact *exact, float *out)
{
    long double cosine = 0.0L;
    for (int i = 0; i < row->outputs; ++i)
        cosine += (long double)out[i] * exact->value[i];
    for (int i = 0; i < row->outputs && row->up_to_sign && cosine < 0.0L; ++i)
        out[i] = -out[i];
}

double error_of(const struct row *row, const float *out, const struct exact *exact)
{
    double largest = 0.0;
    for (int i = 0; i < row->outputs; ++i) {
        const long double error = fabsl((long double)out[i] - exact->value[i]);
        if (!isfinite(out[i]) || (exact->scale[i] == 0.0L && error != 0.0L))
            return INFINITY;
        if (error != 0.0L && (double)(error / (U * exact->scale[i])) > largest)
            largest = (double)(error / (U * exact->scale[i]));
    }
    return largest;
}
