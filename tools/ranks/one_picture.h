/* `gnomon render` where one process with one target does not do: one picture over many ranks, and
 * pictures larger than a target may be. */
#ifndef ONE_PICTURE_H
#define ONE_PICTURE_H

#include "options.h"

/* Whether render's options and the launcher ask for that. A process that mpirun has started alone
 * counts as one rank, so that its files have the bytes that several ranks write. */
bool one_picture_is_divided(const options *o);

/* Collective. Draws and writes the picture, and prints the summary. `fault` is what this rank has
 * found until now. Returns 0, or the status with the reason printed and nothing left under the
 * outputs' names. */
int one_picture(const options *o, int fault);

#endif
