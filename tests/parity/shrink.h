/* Makes a failing scene small, so that it holds only what the failure needs. */
#ifndef PARITY_SHRINK_H
#define PARITY_SHRINK_H

#include "scene.h"

/* Returns whether a scene shows the failure. It is called for scenes that may draw nothing. For one
 * scene it must always return one answer. */
typedef bool shrink_predicate(const scene *s, void *context);

/* Returns a failing scene in which nothing more could be removed or simplified within `attempts`
 * calls of the predicate: no draw, no triangle, no state, no row or column of the target.
 * Precondition: fails(s, context). The caller frees the result. */
scene *shrink_scene(const scene *s, shrink_predicate *fails, void *context, unsigned attempts);

#endif
