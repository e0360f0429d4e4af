/* Phong as functions of one vertex and fragment in AVX-512, where the Makefile asks the compiler
 * for it. */
#define PHONG_FUNCTIONS_USE phong_use_functions_avx512

#include "phong_function_shader.h"
