/* Exact coverage of a triangle whose vertices lie on the grid of snapping, 1/256 pixel: oracle A.
 *
 * The mathematics. Places are pairs of integers in 1/256 pixel, counted from the target's lower
 * left corner, y up. For an edge from a to b and a place s, the determinant
 *
 *     |b - a, s - a| = (b.x - a.x)(s.y - a.y) - (b.y - a.y)(s.x - a.x)
 *
 * is twice the area of the triangle a, b, s: positive if s lies left of the edge, negative if s
 * lies right of it, zero on it. A place is inside a triangle if it lies on the same side of all
 * three edges as the triangle itself. Products of integers of 128 bits make this exact.
 *
 * Ties. If a place lies on an edge that two triangles share, exactly one of the two must own it.
 * The reference's rule (RULES.md, Coverage) is that left edges and horizontal bottom edges own
 * their ties. There is another way to say so: a triangle has the place if it has a point a little
 * to the right of the place and very little above it, (s.x + e, s.y + e^2), for every small enough
 * e > 0. Such a point lies on no edge, so nothing is left to be decided, and neighbours cannot
 * disagree.
 * - A step to the right leads from a left edge into the triangle, and from a right edge out of it.
 *   A horizontal edge is parallel to that step.
 * - The step up is so much smaller that it decides only for horizontal edges. It leads from a
 *   bottom edge into the triangle, and from a top edge out of it.
 * For the moved point the determinant changes by (b.x - a.x) e^2 - (b.y - a.y) e. So where the
 * determinant is zero its sign is that of -(b.y - a.y), or of b.x - a.x if the edge is horizontal.
 * The library and RULES.md add 1 to some edge functions instead, and never move a place. */
#ifndef EXACT_SNAPPED_TRIANGLE_H
#define EXACT_SNAPPED_TRIANGLE_H

#include <stdbool.h>
#include <stdint.h>

/* Corners as x, y. Precondition: coordinates are within +-2^40. */
typedef struct snapped_triangle {
    int64_t corner[3][2];
} snapped_triangle;

/* Returns 1 if the corners are in counter-clockwise order, -1 if they are clockwise, 0 if they lie
 * on one line. */
int exact_winding(const snapped_triangle *t);

/* Where a place lies. All places are outside a triangle without area. */
typedef enum exact_place {
    EXACT_OUTSIDE,
    EXACT_INSIDE,
    EXACT_TIE_LOST, /* on an edge that does not own it */
    EXACT_TIE_OWNED /* on one edge or two, which own it */
} exact_place;

/* Returns where the place (x, y) lies. `winding` is the triangle's. */
exact_place exact_place_in(const snapped_triangle *t, int winding, int64_t x, int64_t y);

static inline bool exact_covers(exact_place p)
{
    return p == EXACT_INSIDE || p == EXACT_TIE_OWNED;
}

/* Returns where a window coordinate snaps to, in 1/256 pixel: with one sample a pixel rne((window -
 * 0.5) * 256) + 128, the difference rounded to binary32; with several rne(window * 256). Computed
 * in integers. Precondition: |window| is 0 or from 2^-76 to 2^24. */
int64_t exact_snap(float window, bool sampled);

/* Returns a sample's place in its pixel in 1/256 pixel, x for axis 0 and y for axis 1: the centre
 * with one sample a pixel, otherwise one of the four of RULES.md. */
int64_t exact_sample_place(uint32_t samples, uint32_t sample, int axis);

#endif
