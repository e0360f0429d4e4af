/* The table of functions. */
#include "functions.h"

#include <gnomon/scalar.h>

#include "../../src/scalars/sqrt.h"

const checked_function checked_functions[] = {
    {"sqrt", gn_sqrt, 0, {REFERENCE_SQRT}},
    {"sqrt_integer", gn_sqrt_integer, 0, {REFERENCE_SQRT}},
    {"rsqrt", gn_rsqrt, 0, {REFERENCE_RSQRT}},
    {"sin", gn_sin, 0, {REFERENCE_SIN}},
    {"sincos", 0, gn_sincos, {REFERENCE_SIN, REFERENCE_COS}},
    {"cos", gn_cos, 0, {REFERENCE_COS}},
    {"tan", gn_tan, 0, {REFERENCE_TAN}},
    {"asin", gn_asin, 0, {REFERENCE_ASIN}},
    {"acos", gn_acos, 0, {REFERENCE_ACOS}},
    {"atan", gn_atan, 0, {REFERENCE_ATAN}},
    {"exp2", gn_exp2, 0, {REFERENCE_EXP2}},
    {"exp", gn_exp, 0, {REFERENCE_EXP}},
    {"log2", gn_log2, 0, {REFERENCE_LOG2}},
    {"log", gn_log, 0, {REFERENCE_LOG}},
    {"degrees", gn_degrees, 0, {REFERENCE_DEGREES}},
    {"radians", gn_radians, 0, {REFERENCE_RADIANS}},
};
const unsigned checked_function_count = sizeof checked_functions / sizeof checked_functions[0];
