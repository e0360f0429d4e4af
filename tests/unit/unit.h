/* Common header of the unit tests: CMocka with its prerequisites, and the library. */
#ifndef UNIT_H
#define UNIT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__has_include)
#if !__has_include(<cmocka.h>)
#error "The tests need CMocka: 'make setup' installs it."
#endif
#endif
#include <cmocka.h>

#include <gnomon.h>

/* No test uses CMocka's state, and few shaders of tests use all that they get. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* Returns the available back end that follows, or GN_BACKEND_COUNT. */
static inline gn_backend next_backend(gn_backend b)
{
    while (++b < GN_BACKEND_COUNT && !gn_backend_available(b)) {
    }
    return b;
}

#endif
