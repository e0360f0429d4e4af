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

#endif
