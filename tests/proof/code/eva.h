/* Values that an analysis takes to be anything of their type; and what every driver includes.
 * Not alone: Frama-C has the header of its built-in functions. */
#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

static volatile uint32_t any_uint32;
static volatile int32_t any_int32;
#include "__fc_builtin.h"
#define finite_float() Frama_C_float_interval(-FLT_MAX, FLT_MAX)
static volatile float any_float; /* infinities and NaN too */
static volatile int32_t any_bit;
#define any_bool (any_bit > 0)

/* Returns any number from least to greatest. */
static inline uint32_t uint32_from(uint32_t least, uint32_t greatest)
{
    const uint32_t n = any_uint32;

    return n < least ? least : n > greatest ? greatest : n;
}

static inline int32_t int32_from(int32_t least, int32_t greatest)
{
    const int32_t n = any_int32;

    return n < least ? least : n > greatest ? greatest : n;
}
