/* The functions that other libraries have too: how to call Gnomon's and cglm's with equal floats,
 * and the exact result. Two programs read these tables: tests/accuracy/main.c measures errors, also
 * those of the libraries of peers.h; tests/accuracy/cglm/test_cglm.c compares Gnomon's results with
 * cglm's.
 *
 * Errors are measured in units of u * scale, with u = 2^-24 and a scale for every number of the
 * result. exact() sets the scale: the number's magnitude (a relative error), one unit in the last
 * place, or the sum of the magnitudes of the terms that the number is the sum of, as in the public
 * headers.
 *
 * To add a function, add a row to the table of its file. */
#ifndef ROWS_H
#define ROWS_H

#include <stdbool.h>
#include <stddef.h>

#include <gnomon.h>

enum { MOST_INPUTS = 32, MOST_OUTPUTS = 16 };

/* Numbers of the exact result, and the scales of their errors. The other library's bound is a
 * multiple of `other_scale`, which starts as a copy of `scale` and is greater if that library's
 * method is less stable. */
struct exact {
    long double value[MOST_OUTPUTS], scale[MOST_OUTPUTS], other_scale[MOST_OUTPUTS];
};

struct row {
    const char *name;

    /* Arguments and results are floats one after the other, matrices column-major. Returns false if
     * the function reports that it has no result. */
    bool (*own)(const float *in, float *out);
    void (*other)(float *in, float *out); /* may write its arguments; null: cglm has none */
    void (*exact)(const float *in, struct exact *exact);

    int inputs, outputs;
    int exponents; /* extreme inputs are of magnitudes 2^-exponents to 2^exponents */

    /* Turns any numbers into arguments that the function accepts; null: they are already. */
    void (*prepare)(float *in);

    /* Errors allowed in units of u * scale and u * other_scale, derived at the row. Negative: no
     * bound of the other library is known; its errors are only measured. */
    double own_bound, other_bound;

    bool up_to_sign;   /* the result's negative is equally right: the same rotation */
    const char *fixed; /* what the contract fixes, so that others may be closer; or null */
};

/* A row of a table, for the functions that OWN, OTHER and EXACT (wide.h) define. The arguments
 * after the texts are the members from `inputs` on. OWN_ROW is for functions that cglm lacks. */
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

/* One kind of inputs. */
enum kind { RANDOM, EXTREME, STRUCTURED, KINDS };

/* Makes the next arguments of a row. */
void make_inputs(const struct row *row, enum kind kind, uint64_t *state, float *in);

/* Computes the exact result with its scales. */
void evaluate(const struct row *row, const float *in, struct exact *exact);

/* If a result is right up to its sign, changes the sign to the one nearer to the exact result. */
void settle_sign(const struct row *row, const struct exact *exact, float *out);

/* The largest error of a result in units of u * scale; infinite for NaN. */
double error_of(const struct row *row, const float *out, const struct exact *exact);

#endif
