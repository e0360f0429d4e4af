/* Which lane holds which pixel of a square. */
#ifndef GN_LANES_SQUARE_H
#define GN_LANES_SQUARE_H

#include "count.h"

/* The side of a square in pixels: a square has a pixel for each lane. Lane l of a square is the
 * pixel (x + l % SQUARE_SIZE, y + l / SQUARE_SIZE). */
#define SQUARE_SIZE (LANES == 1 ? 1 : 4)

/* The number of lanes of half a square. With one lane the first half is the whole square. */
#define HALF_LANES (LANES == 1 ? 1 : LANES / 2)

#endif
