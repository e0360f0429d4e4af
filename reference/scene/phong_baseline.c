/* Phong's shaders in the instruction set the program is compiled for. */
#define PHONG(name) phong_##name##_baseline

#include "phong_shader.h"
