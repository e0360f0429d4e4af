/* The passes of one view: clears, geometry, colours, and what is made of their pixels. */
#ifndef PYTHON_PASSES_H
#define PYTHON_PASSES_H

#include "../../../threads/pool.h"
#include "views.h"

/* What a thread draws views with. */
typedef struct passes_tools {
    gn_workspace workspace;
    float *depth;      /* of all samples */
    uint8_t *color;    /* of all samples, if edges are smooth */
    thread_pool *pool; /* whose threads share each pass; null: one thread draws the view */
    uint32_t threads;
} passes_tools;

/* The first fault of a view; GN_OK: none. */
typedef struct passes_fault {
    gn_status status;
    const char *words; /* null: those of the status */
} passes_fault;

/* Draws one view. Returns whether there was no fault. */
bool passes_draw(const views_job *job, uint32_t view, passes_tools *tools, passes_fault *fault);

/* Returns whether a view shows nothing; passes_draw has drawn it with these tools. */
bool passes_are_empty(const views_job *job, const passes_tools *tools);

/* Draws the shadow map. Returns whether there was no fault. */
bool passes_draw_shadow(const views_job *job, passes_tools *tools, passes_fault *fault);

#endif
