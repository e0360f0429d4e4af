/* Floats as integers, as the reference converts them where they do not fit. */
#ifndef OSMESA_INTEGERS_H
#define OSMESA_INTEGERS_H

#include <math.h>
#include <stdint.h>

#include "gl_types.h"

/* Returns a number without its fraction; the least integer if it does not fit. */
static inline GLint truncated_integer(GLdouble value)
{
    return value > -2147483649.0 && value < 2147483648.0 ? (GLint)value : INT32_MIN;
}

/* Returns the nearest integer, halves away from zero. One beyond 32 bits keeps the lowest 32; one
 * beyond 64 bits, and NaN, become 0. */
static inline GLint rounded_integer(GLdouble value)
{
    return fabs(value) < 0x1p63 ? (GLint)(GLuint)(GLint64)(value >= 0.0 ? value + 0.5 : value - 0.5)
                                : 0;
}

/* Returns the nearest integer, halves away from zero; NaN is the least one. */
static inline GLint saturated_integer(GLdouble value)
{
    return value >= 2147483647.0   ? INT32_MAX
           : value > -2147483648.0 ? (GLint)(value >= 0.0 ? value + 0.5 : value - 0.5)
                                   : INT32_MIN;
}

#endif
