/* Results that show whether anything was written to them. */
#ifndef UNIT_UNTOUCHED_H
#define UNIT_UNTOUCHED_H

#include <string.h>

#include "unit.h"

enum { MARK = 0x5A };

/* Marks every byte of a variable, or asserts that every byte has its mark. */
#define mark(variable) memset(&(variable), MARK, sizeof(variable))
#define assert_untouched(variable) assert_marked(&(variable), sizeof(variable))

static inline void assert_marked(const void *variable, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        assert_int_equal(((const unsigned char *)variable)[i], MARK);
}

#endif
