/* Scenes that every library draws, also one compiled with GN_BASIC. */
#ifndef PORTABILITY_BASIC_H
#define PORTABILITY_BASIC_H

#include "generate.h"

/* Whether a class has scenes that make_basic can turn into such scenes. In the other classes, the
 * generator itself draws with features that a GN_BASIC library lacks, as shadow maps, or the class
 * is about such features. */
bool class_is_basic(scene_class c);

/* Leaves out of a scene what a GN_BASIC library lacks. Makes the filters of samplers the same,
 * since a library of one lane refuses samplers whose filters differ. Shaders that ask the library
 * for derivatives, or for lookups that it lacks, become others. Returns whether a GN_BASIC library
 * draws the scene; if not, nothing can be left out without changing what the class is about. */
bool make_basic(scene *s);

#endif
