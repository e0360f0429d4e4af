/* Random calls of this project's libOSMesa, for the sanitizers and the fuzzers.
 *
 * Not alone: registry.py writes gl_registry.h, which it includes. */
#ifndef OSMESA_PLAY_H
#define OSMESA_PLAY_H

#include "scenes.h"

/* Sets the functions of the library that the program is linked with. */
void set_own_functions(library *gl);

/* Makes a context, calls random functions, draws a scene of the class, and reads pixels. Returns
 * false if there is no context. */
bool play(library *gl, const scene_class *class, uint64_t seed);

#endif
