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

/* Simulates. Returns false with a message. ranks is a power of two up to 1,024. Of many pictures
 * that sort-first or sort-last draw one after another, one is simulated and counted as often. */
bool way_run(way_kind way, const work *w, const figures *f, uint32_t ranks,
             uint32_t ranks_a_machine, run_times *result);

/* The time by formula: the sum of what the slowest rank pays in each phase,
 *
 *   start + read + share + prepare + draw + exchange and merge + compress + write + agreements
 *
 * with, for N ranks, latency L, bandwidth B, a model of S bytes and a picture of P pixels:
 *
 *   share          (ceil(log2 N) + N - 1) L + 2 S (N - 1) / (N B)   scattered, then round a ring
 *   sort-first     vertices V, triangles T; the largest band's drawn triangles and fragments
 *   sort-last      V / N, T / N; the largest part's drawn triangles and fragments; P pixels cleared
 *   exchange       (N - 1) (L + 8 P / (N B)) and (N - 1) P / N pixels merged
 *   agreements     ceil(log2 N) L each
 *   frames         ceil(F / N) times a picture, and at rank 0 what it answers meanwhile
 *
 * The formula knows no contention of ports. It equals the simulation if there is one rank, or if
 * every rank has a machine of its own, loads are equal and writing takes no time; for frames, if
 * messages take no time too. Otherwise it is a lower bound but for the waiting at rank 0. */
double way_formula(way_kind way, const work *w, const figures *f, uint32_t ranks,
                   uint32_t ranks_a_machine);

/* Bytes of the largest rank: the model, colour and depth, what is exchanged, the compressed rows. */
double way_memory(way_kind way, const work *w, const figures *f, uint32_t ranks);

#endif
