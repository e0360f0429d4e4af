/* The origin of a model whose coordinates are far from zero. */
#ifndef ORIGIN_H
#define ORIGIN_H

/* A box around points; empty after origin_empty. */
typedef struct origin_bounds {
    double low[3], high[3];
} origin_bounds;

origin_bounds origin_empty(void);

/* Widens the box to hold a point. Coordinates that are not finite are left out. */
void origin_add(origin_bounds *b, const double position[3]);

/* Sets the origin to the middle of the box if that is farther from zero than 16 times the longest
 * half side: a float then keeps at least 4 bits less of a position than of its distance from the
 * middle. Otherwise, and of an empty box, the origin is zero. */
void origin_choose(const origin_bounds *b, double origin[3]);

#endif
