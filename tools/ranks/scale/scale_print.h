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

/* The first level at which efficiency is below a half; r->count if there is none. */
uint32_t runs_stop(const way_runs *r, bool whole);

/* What more ranks lose time to: the times above T(1) / N, means of all ranks. Finds the largest of
 * them and the second largest, as parts of all of them. */
typedef struct runs_losses {
    time_kind kind[2];
    double part[2];
} runs_losses;

runs_losses runs_lose(const way_runs *r, uint32_t level, bool whole);

void print_figures(const figures *f);
void print_scene(const work *w, uint32_t ranks_a_machine);
void print_runs(const work *w, const way_runs *r);

/* Prints the rows of a table for Markdown; the first one is its head. */
void print_table_head(void);
void print_table_row(const work *w, const way_runs *r);

/* Prints the runs as elements of a JSON list; *elements is how many it has. */
void print_json(const work *w, const way_runs *r, uint32_t ranks_a_machine, unsigned int *elements);

#endif
