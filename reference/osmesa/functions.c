/* Pointers to OpenGL's functions; driver.c sets them. */
#include "functions.h"

#define GL_DEFINE(type, name) type name;
GL_FUNCTIONS(GL_DEFINE)
