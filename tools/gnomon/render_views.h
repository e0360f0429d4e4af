/* gnomon render --views: one picture for each camera of a list. */
#ifndef RENDER_VIEWS_H
#define RENDER_VIEWS_H

#include "options.h"

/* Collective. Draws and writes the pictures at all ranks. Returns 0, or the exit status with the
 * reason printed. */
int render_views(const options *o);

#endif
