/* Reads the formulas of the report as a reader of C would, and computes them. */
#ifndef EXPLAIN_FORMULA_H
#define EXPLAIN_FORMULA_H

#include "told.h"

/* Computes the formula of value `n` of the report from the bits of values told before it, from
 * value `first` on. Returns null if the result has the bits that are told; otherwise why not, in
 * words that last until the next call. */
const char *formula_fault(uint32_t first, uint32_t n);

#endif
