/* The binary logarithm in fixed point, which log2, log and pow share. */
#ifndef GNOMON_SCALARS_LOGARITHM_H
#define GNOMON_SCALARS_LOGARITHM_H

#include <stdbool.h>
#include <stdint.h>

/* log2 x = +-significand * 2^(-64 - shift). */
typedef struct gn_logarithm {
    uint64_t significand; /* at least 2^63; 0 where x is 1 */
    int shift;            /* -8 to 23 */
    bool negative;
} gn_logarithm;

/* Returns the logarithm of a positive, finite x, given by its bits. Exact if x is a power of two.
 * The relative error is below 3.7 * 2^-63 if 1 - 2^-7 <= x < 1 + 2^-6. Otherwise the error is below
 * 1.7 * 2^-64 plus 2^-63 of the logarithm, together less than 2^-56.7 of the logarithm. */
gn_logarithm gn_binary_logarithm(uint32_t bits);

#endif
