/* Prints what the simulation says. */
#ifndef SCALE_PRINT_H
#define SCALE_PRINT_H

#include <stdio.h>

#include "scale_ways.h"

#define PRINT_MOST WORK_LEVELS

/* The runs of a way: on 1, 2, 4 ... ranks. */
typedef struct way_runs {
    way_kind way;
    uint32_t count;
    run_times run[PRINT_MOST];
    double formula[PRINT_MOST], memory[PRINT_MOST];
} way_runs;

/* T(1) / (N T(N)), of the whole run or without what happens once before the first picture. */
double runs_efficiency(const way_runs *r, uint32_t level, bool whole);

/* What more ranks lose most time to: of the times that are not T(1) / N, the largest. *part is its
 * part of all of them. */
time_kind runs_loss(const way_runs *r, uint32_t level, bool whole, double *part);

void print_figures(const figures *f);
void print_scene(const work *w, uint32_t ranks_a_machine);
void print_runs(const work *w, const way_runs *r);

/* Prints the runs as elements of a JSON list; *elements is how many it has. */
void print_json(const work *w, const way_runs *r, uint32_t ranks_a_machine, unsigned int *elements);

#endif
