/* Every operation of lanes, in every form, with equal inputs. lanes_form.c is compiled once for
 * each form, with LANES_FORM as its name; test_lanes.c compares. */
#ifndef PORTABILITY_LANES_TEST_H
#define PORTABILITY_LANES_TEST_H

#include <stdint.h>

#include <gnomon/lookup.h>

enum { LANES_OPERATIONS_MAX = 160, LANES_STRIDE = 28, LANES_MEMORY = 3 * LANES_STRIDE + 16 };

typedef struct lanes_input {
    float a[GN_LANES], b[GN_LANES], c[GN_LANES], d[GN_LANES];
    int32_t i[GN_LANES], j[GN_LANES];
    float x, z;
    float pixel; /* a whole number, exact with the columns and rows of a block added */
    int32_t low, high, per_column, per_row; /* low <= high; the last two within 2^24 */
    uint32_t bits;
    unsigned char memory[LANES_MEMORY]; /* of a block of words, LANES_STRIDE bytes a row */
} lanes_input;

/* The result of an operation as bits; all NaN are equal. */
typedef struct lanes_output {
    const char *operation;
    uint32_t word[GN_LANES];
} lanes_output;

/* Runs all operations; returns their number. */
typedef int lanes_form(const lanes_input *in, lanes_output out[LANES_OPERATIONS_MAX]);

#endif
