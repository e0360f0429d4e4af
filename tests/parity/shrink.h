/* Making a failing scene small: what is left is what the failure needs. */
#ifndef PARITY_SHRINK_H
#define PARITY_SHRINK_H

#include "scene.h"

/* Whether a scene shows the failure. Called for scenes that may draw nothing; must give
 * the same answer for the same scene. */
typedef bool shrink_predicate(const scene *s, void *context);

/* A scene that fails and of which, within `attempts` calls of the predicate, nothing more
 * could be left out or made simpler: no draw, no triangle, no state, no row or column of
 * the target. Precondition: fails(s, context). The caller frees the result. */
scene *shrink_scene(const scene *s, shrink_predicate *fails, void *context, unsigned attempts);

#endif
