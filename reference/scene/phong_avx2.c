/* Phong's shaders in AVX2, where the Makefile asks the compiler for it. */
#define PHONG(name) phong_##name##_avx2

#include "phong_shader.h"
