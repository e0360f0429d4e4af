/* A user's shaders in AVX-512, where the Makefile asks the compiler for it. */
#define USER_SHADERS user_shaders_avx512
#define USE_PHONG_FUNCTIONS phong_use_functions_avx512

#include "user_shaders_form.h"
