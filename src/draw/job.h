/* A checked draw, as a back end gets it. */
#ifndef GN_DRAW_JOB_H
#define GN_DRAW_JOB_H

#include "../geometry/vertex_store.h"

typedef struct draw_job {
    const gn_target *target;
    const gn_pipeline *pipeline;
    const gn_mesh *mesh;
    vertex_store store;
    uint32_t capacity; /* batches for vertices; the one after them is the clipper's */
} draw_job;

/* The whole of a draw, one function a back end; those the target's instruction set
 * does not have are not defined. */
void gn_run_portable(const draw_job *job);
void gn_run_sse2(const draw_job *job);
void gn_run_avx2(const draw_job *job);

#endif
