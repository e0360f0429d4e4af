/* Phong's shaders in AVX-512, where the Makefile asks the compiler for it. */
#define PHONG(name) phong_##name##_avx512

#include "phong_shader.h"
