/* The table of the mathematics: every operation timed in turn with the library, and with cglm and
 * the C library, compiled for the target's instructions and for the machine's. */
#include "maths.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "maths_passes.h"
#include "timing.h"

#define MAX_REPEATS 1000
#define SHORTEST 50e3 /* nanoseconds of a timing, much longer than the clock takes */

#define MOST_RESULTS (MATHS_NUMBERS > 4 * MATHS_MANY ? MATHS_NUMBERS : 4 * MATHS_MANY)

enum contestant { OURS, BASELINE, BEST, CONTESTANTS };

#define MATRICES(number, function, name, count, bulk, arrays)                                      \
    [MATHS_##number] = {name, count, bulk, arrays},
#define SCALARS(number, function, name, count, ...) [MATHS_##number] = {name, count, false, false},

static const struct {
    const char *name;
    int count; /* operations of a pass */
    bool bulk, arrays;
} operations[MATHS_OPERATIONS] = {MATHS_MATRICES(MATRICES) MATHS_SCALARS(SCALARS)};

/* -1 to 1, from a sequence that its start determines (Numerical Recipes' generator). */
static float number(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (float)(int32_t)*state * 0x1p-31f;
}

/* An argument of a scalar function. */
static float argument(maths_operation operation, uint32_t *state)
{
    const float x = number(state);

    switch (operation) {
    case MATHS_SINE_LARGE:
        return ldexpf(1.5f + 0.5f * x, 20 + (int)(*state >> 8) % 80);
    case MATHS_ARCSINE:
    case MATHS_ARCCOSINE:
        return x;
    case MATHS_EXP2:
    case MATHS_EXP:
    case MATHS_ARCTANGENT:
    case MATHS_ARCTANGENT2:
        return 8.0f * x;
    default:
        return 8.0f + 7.9f * x;
    }
}

static void fill_numbers(maths_data *d, maths_operation operation, uint32_t start)
{
    uint32_t state = start;

    for (int i = 0; i < operations[operation].count; ++i) {
        d->x[i] = argument(operation, &state);
        d->y[i] = 4.0f * number(&state);
    }
}

static void fill(maths_data *d, maths_operation operation, bool arrays)
{
    const size_t components = operation >= MATHS_POINTS_PACKED ? 3 : 4;
    uint32_t state = 1;

    if (operation >= MATHS_FIRST_SCALAR) {
        fill_numbers(d, operation, 1);
        return;
    }

    for (int i = 0; i < MATHS_FEW; ++i) {
        const float x = number(&state), y = number(&state);
        const gn_vec3 axis = {x, y, 1.0f};
        gn_transform turn;

        gn_rotate_axis(axis, 3.0f * number(&state), &turn);
        for (int k = 0; k < 16; ++k) {
            /* Far from singular. */
            d->a[i][k / 4][k % 4] = number(&state) + (k % 5 == 0 ? 3.0f : 0.0f);
            d->b[i][k / 4][k % 4] = number(&state);
            d->rigid[i][k / 4][k % 4] = turn.matrix.m[k / 4][k % 4];
        }
        for (int k = 0; k < 4; ++k) {
            d->v[i][k] = number(&state);
            d->rigid[i][3][k] = k < 3 ? number(&state) : 1.0f;
        }
    }
    for (size_t i = 0; i < MATHS_MANY; ++i)
        for (size_t k = 0; k < components; ++k)
            d->many[arrays ? k * MATHS_MANY + i : i * components + k] = number(&state);
}

/* The results of a pass, with vectors packed; returns their number. */
static size_t results(const maths_data *d, maths_operation operation, bool arrays, float *out)
{
    const size_t components = operation >= MATHS_POINTS_PACKED ? 3 : 4;
    const float *from = NULL;
    size_t count = 0;

    switch (operation) {
    case MATHS_MULTIPLY:
    case MATHS_MULTIPLY_PACKED:
    case MATHS_INVERT:
        from = d->product[0][0];
        count = 16 * MATHS_FEW;
        break;
    case MATHS_INVERT_RIGID:
        from = d->rigid[0][0];
        count = 16 * MATHS_FEW;
        break;
    case MATHS_MULTIPLY_VECTOR:
    case MATHS_INLINE_VECTOR:
        from = d->moved[0];
        count = 4 * MATHS_FEW;
        break;
    case MATHS_BULK_PACKED:
    case MATHS_BULK_ARRAYS:
    case MATHS_POINTS_PACKED:
    case MATHS_POINTS_ARRAYS:
        from = d->many_moved;
        count = components * MATHS_MANY;
        break;
    default:
        from = operation == MATHS_SINE_COSINE || operation == MATHS_SINE_COSINE_FEW ? d->cosine
                                                                                    : d->value;
        count = (size_t)operations[operation].count;
        break;
    }
    for (size_t i = 0; i < count; ++i)
        out[i] = from[arrays ? i % components * MATHS_MANY + i / components : i];
    return count;
}

/* Whether both compute equal results: one pass of each from equal numbers. */
static bool agree(maths_data *ours, maths_data *theirs, maths_operation operation, maths_pass *our,
                  maths_pass *their)
{
    static float a[MOST_RESULTS], b[MOST_RESULTS];

    fill(ours, operation, operations[operation].arrays);
    fill(theirs, operation, false);
    our(ours);
    their(theirs);
    const size_t count = results(ours, operation, operations[operation].arrays, a);
    results(theirs, operation, false, b);
    for (size_t i = 0; i < count; ++i)
        if (!(fabsf(a[i] - b[i]) <= 1e-5f * (1.0f + fabsf(b[i]))))
            return false;
    return true;
}

static double time_passes(maths_pass *pass, maths_data *d, int passes)
{
    const double start = milliseconds(CLOCK_THREAD_CPUTIME_ID);

    for (int i = 0; i < passes; ++i)
        pass(d);
    return (milliseconds(CLOCK_THREAD_CPUTIME_ID) - start) * 1e6;
}

static void print_number(FILE *out, const char *format, double number)
{
    char text[32] = "-"; /* if there is nothing to time */

    if (number > 0.0)
        snprintf(text, sizeof text, format, number);
    fprintf(out, " %10s", text);
}

/* One line: the medians of interleaved timings, and the other libraries' times over Gnomon's. */
static int measure(FILE *out, maths_operation operation, gn_backend backend, int repeats)
{
    static maths_data data[2]; /* Gnomon's, the other library's */
    static double times[CONTESTANTS][MAX_REPEATS];
    maths_pass *const pass[CONTESTANTS] = {maths_gnomon(operation), maths_cglm_baseline(operation),
                                           maths_cglm_best(operation)};
    double medians[CONTESTANTS] = {0.0};
    int passes[CONTESTANTS] = {0};
    char name[64];

    snprintf(name, sizeof name, operations[operation].bulk ? "%s, %s" : "%s",
             operations[operation].name, gn_backend_name(backend));
    fprintf(stderr, "\rbench: %-40s", name);
    data[0].backend = backend;
    for (int c = BASELINE; c < CONTESTANTS; ++c) {
        if (pass[OURS] && pass[c] && !agree(&data[0], &data[1], operation, pass[OURS], pass[c])) {
            fprintf(stderr, "\rbench: %s: results disagree\n", name);
            return EXIT_FAILURE;
        }
    }
    fill(&data[0], operation, operations[operation].arrays);
    fill(&data[1], operation, false);
    for (int c = 0; c < CONTESTANTS; ++c)
        for (passes[c] = 1; pass[c] && time_passes(pass[c], &data[c != OURS], passes[c]) < SHORTEST;
             passes[c] *= 2)
            ;
    for (int i = 0; i < repeats; ++i) {
        for (int c = 0; c < CONTESTANTS; ++c) {
            if (!pass[c])
                continue;
            if (operations[operation].count == MATHS_NUMBERS)
                fill_numbers(&data[c != OURS], operation, (uint32_t)i);
            times[c][i] = time_passes(pass[c], &data[c != OURS], passes[c]) / passes[c] /
                          operations[operation].count;
        }
    }
    fprintf(stderr, "\r%50s\r", "");
    fprintf(out, "%-32s", name);
    for (int c = 0; c < CONTESTANTS; ++c) {
        medians[c] = pass[c] ? median(times[c], repeats) : 0.0;
        print_number(out, "%.3f", medians[c]);
    }
    for (int c = BASELINE; c < CONTESTANTS; ++c)
        print_number(out, "%.2f", pass[OURS] ? medians[c] / medians[OURS] : 0.0);
    fputc('\n', out);
    fflush(out);
    return EXIT_SUCCESS;
}

int bench_maths(FILE *out, int repeats)
{
    int status = EXIT_SUCCESS;

    if (repeats < 1 || repeats > MAX_REPEATS) {
        fprintf(stderr, "bench: 1 to %d repeats\n", MAX_REPEATS);
        return EXIT_FAILURE;
    }
    fprintf(out,
            "CPU nanoseconds an operation (a vector, in bulk), median of %d timings. Beside cglm,\n"
            "compiled into the loop, and the C library's scalar functions: with the instructions\n"
            "every processor of the target has, and with AVX2 and FMA. Ratios: their time over\n"
            "Gnomon's; above 1 Gnomon is faster.\n",
            repeats);
    fprintf(out, "%-32s %10s %10s %10s %10s %10s\n", "operation", "Gnomon", "cglm", "cglm AVX2",
            "ratio", "ratio AVX2");
    for (int o = 0; o < MATHS_OPERATIONS && status == EXIT_SUCCESS; ++o) {
        if (!operations[o].bulk) {
            status = measure(out, (maths_operation)o, GN_BACKEND_AUTO, repeats);
            continue;
        }
        for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT && status == EXIT_SUCCESS; ++b)
            if (gn_backend_available((gn_backend)b))
                status = measure(out, (maths_operation)o, (gn_backend)b, repeats);
    }
    return status;
}
