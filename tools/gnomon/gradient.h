/* A background of two colours. */
#ifndef GRADIENT_H
#define GRADIENT_H

#include "scene.h"

/* Adds a draw that fills the target, to be drawn first: the top row has the upper colour, the
 * bottom row the lower one, and each row between has the nearest colour of 8 bits a channel.
 * Colours are those of the display; in a linear target they are stored with the same bytes. A
 * target of one row has the upper colour. */
void gradient_add(scene *s, const float upper[4], const float lower[4], bool is_linear);

#endif
