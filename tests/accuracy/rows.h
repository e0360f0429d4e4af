/* The functions that other libraries have too: how to call ours and cglm's on the same floats,
 * and what is exact. Two programs read these tables: tests/accuracy/main.c measures errors, also
 * of the libraries of peers.h, tests/differential/test_cglm.c holds ours and cglm's against each
 * other.
 *
 * Errors are measured in units of u * scale, with u = 2^-24 and a scale for every number of the
 * result, which exact() gives: its magnitude (a relative error), one unit in the last place, or
 * the sum of the magnitudes of the terms it is the sum of, as in the public headers.
 *
 * To add a function: a row in the table of its file. */
#ifndef ROWS_H
#define ROWS_H

#include <stdbool.h>
#include <stddef.h>

#include <gnomon.h>

enum { MOST_INPUTS = 32, MOST_OUTPUTS = 16 };

/* Numbers of the exact result and what errors of them are measured by. Of `other_scale`, which
 * starts as a copy of `scale`, the other library's bound is a multiple: where its method is less
 * stable, more. */
struct exact {
    long double value[MOST_OUTPUTS], scale[MOST_OUTPUTS], other_scale[MOST_OUTPUTS];
};

struct row {
    const char *name;

    /* Arguments and results are floats one after the other, matrices column-major. False where
     * the function reports that it has no result. */
    bool (*own)(const float *in, float *out);
    void (*other)(float *in, float *out); /* may write its arguments; null: cglm has none */
    void (*exact)(const float *in, struct exact *exact);

    int inputs, outputs;
    int exponents; /* extreme inputs are of magnitudes 2^-exponents to 2^exponents */

    /* Makes of any numbers arguments that the function is for; null: they are already. */
    void (*prepare)(float *in);

    /* Errors allowed in units of u * scale and u * other_scale, derived where the row stands.
     * Negative: no bound of the other library's is known, it is measured alone. */
    double own_bound, other_bound;

    bool up_to_sign;   /* the result's negative is as right: the same rotation */
    const char *fixed; /* what the contract fixes that others may be closer for; or null */
};

/* A row of a table, of the functions that OWN, OTHER and EXACT (wide.h) make; what follows the
 * texts are the members from `inputs` on. OWN_ROW where cglm has no such function. */
#define ROW(name_, text, ...)                                                                      \
    {                                                                                              \
        .name = text, .own = own_##name_, .other = other_##name_, .exact = exact_##name_,          \
        .inputs = __VA_ARGS__                                                                      \
    }
#define OWN_ROW(name_, text, ...)                                                                  \
    {                                                                                              \
        .name = text, .own = own_##name_, .exact = exact_##name_, .inputs = __VA_ARGS__            \
    }

struct table {
    const struct row *rows;
    size_t count;
};

extern const struct table scalar_rows, vector_rows, surface_rows, matrix_rows, inverse_rows,
    transform_rows, model_rows, projection_rows, quaternion_rows, orientation_rows, ray_rows;

#define ALL_TABLES                                                                                 \
    {                                                                                              \
        &scalar_rows, &vector_rows, &surface_rows, &matrix_rows, &inverse_rows, &transform_rows,   \
            &model_rows, &projection_rows, &quaternion_rows, &orientation_rows, &ray_rows          \
    }

/* Inputs of a kind. */
enum kind { RANDOM, EXTREME, STRUCTURED, KINDS };

/* The next arguments of a row. */
void make_inputs(const struct row *row, enum kind kind, uint64_t *state, float *in);

/* The exact result with its scales. */
void evaluate(const struct row *row, const float *in, struct exact *exact);

/* Of a result that is right up to its sign, the one nearer to the exact result. */
void settle_sign(const struct row *row, const struct exact *exact, float *out);

/* The largest error of a result in units of u * scale; infinite for what is no number. */
double error_of(const struct row *row, const float *out, const struct exact *exact);

#endif
