/* Common header of the unit tests: CMocka with its prerequisites, and the library. */
#ifndef UNIT_H
#define UNIT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <gnomon.h>

#endif
