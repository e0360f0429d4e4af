/* Phong as functions of one vertex and fragment, in the instruction set the program is compiled
 * for. */
#define PHONG_FUNCTIONS_USE phong_use_functions_baseline

#include "phong_function_shader.h"
