/* Comparison of depth texels over lanes, before they are filtered (OpenGL 4.5 section 8.23.1). */
#ifndef GN_KERNEL_TEXTURE_COMPARE_INL
#define GN_KERNEL_TEXTURE_COMPARE_INL

#include <gnomon/lookup.h>

#include "../../formats/properties.h"
#include "../../lanes/lanes.h"

/* Returns the reference that depths are compared with. Fixed-point depths are 0 to 1, so for these
 * formats the reference is clamped to 0 to 1, and NaN becomes 1. */
static inline lanes_f compared_reference(gn_format format, lanes_f reference)
{
    if (format_is_float(format))
        return reference;
    return lanes_max(lanes_min(reference, lanes_splat(1.0f)), lanes_splat(0.0f));
}

/* Writes the lanes in which `reference FUNCTION depth` holds, for each of `count` depths. With NaN
 * only "not equal" and "always" hold. */
GN_INLINE void compare_depths(gn_compare function, lanes_f reference, const lanes_f *depth,
                              int count, lanes_m *holds)
{
#define HOLDS(condition)                                                                           \
    for (int i = 0; i < count; ++i)                                                                \
        holds[i] = condition;                                                                      \
    break

    switch (function) {
    case GN_LESS_OR_EQUAL:
        HOLDS(lanes_less_equal(reference, depth[i]));
    case GN_GREATER_OR_EQUAL:
        HOLDS(lanes_less_equal(depth[i], reference));
    case GN_LESS:
        HOLDS(lanes_greater(depth[i], reference));
    case GN_GREATER:
        HOLDS(lanes_greater(reference, depth[i]));
    case GN_EQUAL:
        HOLDS(lanes_and(lanes_less_equal(reference, depth[i]),
                        lanes_less_equal(depth[i], reference)));
    case GN_NOT_EQUAL:
        HOLDS(lanes_not(lanes_and(lanes_less_equal(reference, depth[i]),
                                  lanes_less_equal(depth[i], reference))));
    case GN_ALWAYS:
        HOLDS(lanes_from_bits(GN_ALL_LANES));
    default:
        HOLDS(lanes_from_bits(0));
    }
#undef HOLDS
}

/* Returns the texel of a comparison: 1 where it holds, 0 elsewhere. */
static inline lanes_f compared(gn_compare function, lanes_f reference, lanes_f depth)
{
    lanes_m holds;

    compare_depths(function, reference, &depth, 1, &holds);
    return lanes_select(holds, lanes_splat(1.0f), lanes_splat(0.0f));
}

/* Mixes two results of 1 or 0 by adding the weights of those that are 1. mix(weight, a, b) rounds
 * differently. A weight of NaN has no effect if its result is 0. */
static inline lanes_f mix_compared(lanes_f weight, lanes_f first, lanes_f second)
{
    const lanes_f none = lanes_splat(0.0f);
    const lanes_f rest = lanes_sub(lanes_splat(1.0f), weight);

    return lanes_add(lanes_select(lanes_greater(first, none), rest, none),
                     lanes_select(lanes_greater(second, none), weight, none));
}

#endif
