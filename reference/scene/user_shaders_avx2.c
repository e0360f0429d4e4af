/* A user's shaders in AVX2, where the Makefile asks the compiler for it. */
#define USER_SHADERS user_shaders_avx2
#define USE_PHONG_FUNCTIONS phong_use_functions_avx2

#include "user_shaders_form.h"
