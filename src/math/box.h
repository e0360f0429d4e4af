/* Helpers of the functions that take boxes. */
#ifndef GN_MATH_BOX_H
#define GN_MATH_BOX_H

#include <gnomon/culling.h>

#include <stdbool.h>

#include "../scalars/bits.h"

/* Return the larger and the smaller of two floats that are not NaN. */
static inline float larger(float a, float b)
{
    return a > b ? a : b;
}

static inline float smaller(float a, float b)
{
    return a < b ? a : b;
}

/* Returns whether no min exceeds its max; false if a number is NaN. */
static inline bool box_is_ordered(const gn_box *box)
{
    return box->min.x <= box->max.x && box->min.y <= box->max.y && box->min.z <= box->max.z;
}

#endif
