/* The table of functions: the public ones, which compute in double where the processor does, and
 * the integer forms. */
#include "functions.h"

#include <gnomon/scalar.h>

#include "../../src/scalars/integer_forms.h"

const checked_function checked_functions[] = {
    {"sqrt", gn_sqrt, 0, {REFERENCE_SQRT}},
    {"sqrt_integer", gni_sqrt_integer, 0, {REFERENCE_SQRT}},
    {"rsqrt", gn_rsqrt, 0, {REFERENCE_RSQRT}},
    {"rsqrt_integer", gni_rsqrt_integer, 0, {REFERENCE_RSQRT}},
    {"sin", gn_sin, 0, {REFERENCE_SIN}},
    {"sin_integer", gni_sin_integer, 0, {REFERENCE_SIN}},
    {"sincos", 0, gn_sincos, {REFERENCE_SIN, REFERENCE_COS}},
    {"sincos_integer", 0, gni_sincos_integer, {REFERENCE_SIN, REFERENCE_COS}},
    {"cos", gn_cos, 0, {REFERENCE_COS}},
    {"cos_integer", gni_cos_integer, 0, {REFERENCE_COS}},
    {"tan", gn_tan, 0, {REFERENCE_TAN}},
    {"tan_integer", gni_tan_integer, 0, {REFERENCE_TAN}},
    {"asin", gn_asin, 0, {REFERENCE_ASIN}},
    {"asin_integer", gni_asin_integer, 0, {REFERENCE_ASIN}},
    {"acos", gn_acos, 0, {REFERENCE_ACOS}},
    {"acos_integer", gni_acos_integer, 0, {REFERENCE_ACOS}},
    {"atan", gn_atan, 0, {REFERENCE_ATAN}},
    {"atan_integer", gni_atan_integer, 0, {REFERENCE_ATAN}},
    {"exp2", gn_exp2, 0, {REFERENCE_EXP2}},
    {"exp2_integer", gni_exp2_integer, 0, {REFERENCE_EXP2}},
    {"exp", gn_exp, 0, {REFERENCE_EXP}},
    {"exp_integer", gni_exp_integer, 0, {REFERENCE_EXP}},
    {"log2", gn_log2, 0, {REFERENCE_LOG2}},
    {"log2_integer", gni_log2_integer, 0, {REFERENCE_LOG2}},
    {"log", gn_log, 0, {REFERENCE_LOG}},
    {"log_integer", gni_log_integer, 0, {REFERENCE_LOG}},
    {"degrees", gn_degrees, 0, {REFERENCE_DEGREES}},
    {"degrees_integer", gni_degrees_integer, 0, {REFERENCE_DEGREES}},
    {"radians", gn_radians, 0, {REFERENCE_RADIANS}},
    {"radians_integer", gni_radians_integer, 0, {REFERENCE_RADIANS}},
};
const unsigned checked_function_count = sizeof checked_functions / sizeof checked_functions[0];
