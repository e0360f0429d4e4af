/* A transform as a result that shows whether anything was written to it. */
#ifndef UNIT_UNTOUCHED_H
#define UNIT_UNTOUCHED_H

#include <string.h>

#include "unit.h"

static inline gn_transform marked(void)
{
    gn_transform transform;
    memset(&transform, 0x5A, sizeof transform);
    return transform;
}

static inline void assert_untouched(const gn_transform *transform)
{
    gn_transform expected = marked();
    assert_memory_equal(transform, &expected, sizeof expected);
}

#endif
