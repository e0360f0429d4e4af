/* Phong as functions of one vertex and fragment in AVX2, where the Makefile asks the compiler for
 * it. */
#define PHONG_FUNCTIONS_USE phong_use_functions_avx2

#include "phong_function_shader.h"
