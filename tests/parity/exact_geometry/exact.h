/* make exact-geometry: what the library draws against exact coverage, depth and colour. */
#ifndef TESTS_EXACT_H
#define TESTS_EXACT_H

#include <stdbool.h>
#include <stdint.h>

#include "osmesa.h"
#include "random.h"

/* ---- Oracle A: triangles on the grid of snapping (snapped.c) ---- */

/* The most triangles of a batch: each has a power of two in a channel of RGBA32F. */
#define BATCH_TRIANGLES 96

typedef struct snapped_totals {
    uint64_t triangles, batches, frames;
    uint64_t samples;   /* asked of the oracle */
    uint64_t covered;   /* of them */
    uint64_t ties;      /* of them, places exactly on an edge of a triangle with area */
    uint64_t different; /* between the library and the oracle, over all frames */
    uint64_t reference_frames, reference_different;
    bool broken; /* a draw failed */
} snapped_totals;

/* Draws `triangles` random triangles, with every back end, and every 32nd batch with the reference
 * too. Prints the first differences on stderr. */
void test_snapped(reference *r, uint64_t seed, uint64_t triangles, snapped_totals *totals);

/* ---- Oracle B: triangles in clip space (clip_space.c) ---- */

/* The most that a pixel's centre may lie from an exact edge if it is covered differently, in
 * pixels. Snapping moves a vertex by up to sqrt(2) / 512 = 0.00276. */
#define LARGEST_DISTANCE 0.003

typedef struct clip_totals {
    uint64_t triangles, pixels;
    uint64_t different;      /* centres that the library covers and the oracle does not, or the
                                other way round */
    double largest;          /* distance of such a centre from an exact edge */
    double largest_of_vast;  /* likewise, of triangles of 2^17 pixels and more */
    uint64_t beyond;         /* such centres beyond the bound of their class */
    uint64_t errors_beyond;  /* classes of triangles whose depths or colours are beyond the bound */
    uint64_t unequal_pixels; /* between the library and the reference, or two back ends */
    bool broken;             /* a draw failed */
} clip_totals;

/* Draws `triangles` random triangles with every back end and the reference, and prints the tables
 * of coverage and of errors on stdout. */
void test_clip_space(reference *r, uint64_t seed, uint64_t triangles, clip_totals *totals);

/* ---- Common parts ---- */

/* Prints progress on stderr: on a terminal in one line, otherwise every ten seconds. */
void show_progress(const char *what, uint64_t done, uint64_t all);

#endif
