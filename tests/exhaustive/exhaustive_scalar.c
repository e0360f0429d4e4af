/* Every float through every scalar function, against a correctly rounded
 * reference.
 *
 * The reference is the C library's double result d, whose error is below one
 * part in 2^51 (glibc states under 1 ulp for sin, cos and tan). Where
 * d * (1 - 2^-50) and d * (1 + 2^-50) round to the same float, so does the exact
 * value. Else a wider reference decides: MPFR when compiled with
 * GN_REFERENCE_MPFR (link with -lmpfr -lgmp), or libquadmath when compiled with
 * GN_REFERENCE_QUADMATH (link with -lquadmath), filtered in the same way at
 * 2^-100. Without either, such inputs are reported as undecided.
 * The square root needs no filter: 53 bits are more than 2 * 24 + 1, so rounding
 * twice is rounding once (S. A. Figueroa, When is double rounding innocuous?,
 * SIGNUM Newsletter 30, 1995).
 *
 * Compile without value-changing optimisations. */
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if defined(GN_REFERENCE_MPFR)
#include <mpfr.h>
#elif defined(GN_REFERENCE_QUADMATH)
#include <quadmath.h>
__extension__ typedef __float128 wide_float;
#endif

#include <gnomon/scalar.h>

#include "../../src/math/sqrt.h"

#define SHOWN 10 /* misrounded inputs named on stderr for each function */

typedef enum reference { REFERENCE_SQRT, REFERENCE_SIN, REFERENCE_COS, REFERENCE_TAN } reference;

static float sincos_sine(float x)
{
    float sine, cosine;
    gn_sincos(x, &sine, &cosine);
    return sine;
}

static float sincos_cosine(float x)
{
    float sine, cosine;
    gn_sincos(x, &sine, &cosine);
    return cosine;
}

static const struct checked {
    const char *name;
    float (*function)(float);
    reference reference;
} functions[] = {
    {"sqrt", gn_sqrt, REFERENCE_SQRT},
    {"sqrt_integer", gn_sqrt_integer, REFERENCE_SQRT},
    {"sin", gn_sin, REFERENCE_SIN},
    {"cos", gn_cos, REFERENCE_COS},
    {"tan", gn_tan, REFERENCE_TAN},
    {"sincos_sine", sincos_sine, REFERENCE_SIN},
    {"sincos_cosine", sincos_cosine, REFERENCE_COS},
};
enum { FUNCTION_COUNT = sizeof functions / sizeof functions[0] };

static uint32_t bits_of(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float from_bits(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static double reference_double(reference which, double x)
{
    switch (which) {
    case REFERENCE_SQRT:
        return sqrt(x);
    case REFERENCE_SIN:
        return sin(x);
    case REFERENCE_COS:
        return cos(x);
    default:
        return tan(x);
    }
}

/* The correctly rounded value, from more precision; false where undecided. */
static bool decide(reference which, float x, float *value)
{
#if defined(GN_REFERENCE_MPFR)
    mpfr_t wide;
    mpfr_init2(wide, 24);
    mpfr_set_flt(wide, x, MPFR_RNDN);
    if (which == REFERENCE_SIN) {
        mpfr_sin(wide, wide, MPFR_RNDN);
    } else if (which == REFERENCE_COS) {
        mpfr_cos(wide, wide, MPFR_RNDN);
    } else {
        mpfr_tan(wide, wide, MPFR_RNDN);
    }
    /* 24 bits are a float's; tiny results would be denormal, where d decides. */
    *value = mpfr_get_flt(wide, MPFR_RNDN);
    mpfr_clear(wide);
    return fabsf(*value) >= 0x1p-126f;
#elif defined(GN_REFERENCE_QUADMATH)
    wide_float wide = which == REFERENCE_SIN ? sinq(x) : which == REFERENCE_COS ? cosq(x) : tanq(x);
    wide_float margin = wide * (wide_float)0x1p-100;
    *value = (float)(wide - margin);
    return *value == (float)(wide + margin);
#else
    (void)which;
    (void)x;
    (void)value;
    return false;
#endif
}

static bool correctly_rounded(reference which, float x, float *value)
{
    double d = reference_double(which, (double)x);
    *value = (float)d;
    if (which == REFERENCE_SQRT || isnan(d) || d == 0.0) {
        return true;
    }
    /* sin x and tan x differ from x by less than 2^-60 of it here, so only the
     * side matters and x is the nearest float. */
    if (which != REFERENCE_COS && fabsf(x) < 0x1p-30f) {
        *value = x;
        return true;
    }
    float below = (float)(d - d * 0x1p-50);
    float above = (float)(d + d * 0x1p-50);
    return below == above || decide(which, x, value);
}

/* The number of misrounded inputs; undecided ones are counted apart. */
static uint64_t check(const struct checked *checked, uint64_t first, uint64_t stride)
{
    const bool terminal = isatty(STDERR_FILENO);
    uint64_t inputs = 0, misrounded = 0, undecided = 0, next_report = 0;
    for (uint64_t i = first; i < (uint64_t)1 << 32; i += stride) {
        float x = from_bits((uint32_t)i);
        float got = checked->function(x), expected = 0.0f;
        ++inputs;
        if (!correctly_rounded(checked->reference, x, &expected)) {
            ++undecided;
        } else if (bits_of(got) != (isnan(expected) ? 0x7FC00000u : bits_of(expected))) {
            if (misrounded++ < SHOWN) {
                fprintf(stderr, "\n%s(%a): %a, should be %a\n", checked->name, (double)x,
                        (double)got, (double)expected);
            }
        }
        if (i >= next_report && terminal) {
            fprintf(stderr, "\r%s: %3u %%", checked->name, (unsigned)(i * 100 >> 32));
            next_report = i + ((uint64_t)1 << 25);
        } else if (i >= next_report) {
            fprintf(stderr, "%s: %u %%\n", checked->name, (unsigned)(i * 100 >> 32));
            next_report = i + ((uint64_t)1 << 30);
        }
    }
    fprintf(stderr, terminal ? "\r%s: 100 %%\n" : "%s: 100 %%\n", checked->name);
    printf("%s: %" PRIu64 " inputs, %" PRIu64 " misrounded", checked->name, inputs, misrounded);
    if (undecided > 0) {
        printf(", %" PRIu64 " undecided", undecided);
    }
    printf("\n");
    fflush(stdout);
    return misrounded;
}

static void help(FILE *stream)
{
    fprintf(stream, "usage: exhaustive_scalar [--stride N] [--first M] [FUNCTION ...]\n"
                    "Checks that scalar functions are correctly rounded, for the floats whose\n"
                    "bits are M, M + N, M + 2 N ... (all 2^32 by default).\nFunctions:");
    for (int i = 0; i < FUNCTION_COUNT; ++i) {
        fprintf(stream, " %s", functions[i].name);
    }
    fprintf(stream, "\nExit status: 0 all are, 1 some are not, 2 usage.\n");
}

/* A number of 32 bits, or false. */
static bool parse(const char *text, uint64_t *number)
{
    char *end;
    if (text == NULL || text[0] < '0' || text[0] > '9') {
        return false;
    }
    *number = strtoull(text, &end, 0);
    return *end == '\0' && *number <= UINT32_MAX;
}

int main(int argc, char **argv)
{
    uint64_t first = 0, stride = 1;
    bool chosen[FUNCTION_COUNT] = {false};
    bool any = false;
    for (int i = 1; i < argc; ++i) {
        int f = 0;
        if (strcmp(argv[i], "--help") == 0) {
            help(stdout);
            return 0;
        }
        if (strcmp(argv[i], "--stride") == 0 && parse(argv[i + 1], &stride) && stride > 0) {
            ++i;
            continue;
        }
        if (strcmp(argv[i], "--first") == 0 && parse(argv[i + 1], &first)) {
            ++i;
            continue;
        }
        while (f < FUNCTION_COUNT && strcmp(argv[i], functions[f].name) != 0) {
            ++f;
        }
        if (f == FUNCTION_COUNT) {
            fprintf(stderr, "exhaustive_scalar: cannot use '%s'\n", argv[i]);
            help(stderr);
            return 2;
        }
        chosen[f] = any = true;
    }
    uint64_t misrounded = 0;
    for (int f = 0; f < FUNCTION_COUNT; ++f) {
        if (!any || chosen[f]) {
            misrounded += check(&functions[f], first, stride);
        }
    }
    return misrounded > 0;
}
