/* What ranks do, step by step, in each way of dividing work; and the formulas beside it.
 *
 * Sort-first and sort-last are named as by Molnar, Cox, Ellsworth and Fuchs, "A Sorting
 * Classification of Parallel Rendering", 1994. */
#ifndef SCALE_WAYS_H
#define SCALE_WAYS_H

#include "scale_engine.h"
#include "scale_figures.h"
#include "scale_work.h"

typedef enum way_kind {
    WAY_SORT_FIRST, /* each rank draws a band of rows */
    WAY_SORT_LAST,  /* each rank draws a part of the triangles; bands are exchanged by direct send
                       (Hsu, 1993) and merged */
    WAY_FRAMES,     /* rank 0 hands out pictures; each is a file of its own */
    WAY_ANIMATION,  /* likewise, but rank 0 writes all of them to one file */
    WAY_COUNT
} way_kind;

const char *way_name(way_kind way);

/* Whether a way is for many pictures. */
bool way_has_frames(way_kind way);

/* Where ranks are. */
typedef struct way_place {
    uint32_t ranks_a_machine;
    bool one_machine; /* no run uses a second one: files are on its disk */
} way_place;

/* Simulates. Returns false with a message. ranks is a power of two up to 1,024. Of many pictures
 * that sort-first or sort-last draw one after another, one is simulated and counted as often. */
bool way_run(way_kind way, const work *w, const figures *f, uint32_t ranks, const way_place *place,
             run_times *result);

/* The time by formula: the sum of what the slowest rank pays in each phase,
 *
 *   start + read + share + prepare + draw + exchange and merge + compress + write + agreements
 *
 * with, for N ranks, latency L, bandwidth B, a model of S bytes and a picture of P pixels:
 *
 *   share          (ceil(log2 N) + N - 1) L + 2 S (N - 1) / (N B)   scattered, then round a ring;
 *                  sort-last: N extract V + (N - 1) S / (N B)       each rank's part, in turn
 *   sort-first     vertices V, triangles T; the largest band's drawn triangles and fragments
 *   sort-last      V / N, T / N; the largest part's drawn triangles and fragments; P pixels cleared
 *   exchange       (N - 1) (pieces L + 8 P / (N B)) and (N - 1) P / N pixels merged
 *   agreements     ceil(log2 N) L each: one before the first picture, then 3 a picture, or 4
 *   frames         ceil(F / N) times the mean picture
 *
 * The formula knows no contention of ports and takes the slowest rank of each phase. It equals the
 * simulation if there is one rank; for pictures also if loads are equal, no machine has several
 * ranks and writing takes no time. Equal frames take up to one frame longer than their formula,
 * since ranks above 0 have asked for their next frame before they need it. */
double way_formula(way_kind way, const work *w, const figures *f, uint32_t ranks,
                   const way_place *place);

/* Bytes of the largest rank: the model, colour and depth, what is exchanged, the compressed rows.
 */
double way_memory(way_kind way, const work *w, const figures *f, uint32_t ranks);

#endif
