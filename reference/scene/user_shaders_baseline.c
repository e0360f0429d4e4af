/* A user's shaders in the instruction set that every processor of the target has. */
#define USER_SHADERS user_shaders_baseline
#define USE_PHONG_FUNCTIONS phong_use_functions_baseline

#include "user_shaders_form.h"
