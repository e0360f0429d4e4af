/* The worker: one thread's work on primitives, from assembly to their fragments. A draw on one
 * thread has one worker; in a round every task has its own. */
#ifndef GN_KERNEL_DRAW_WORKER_INL
#define GN_KERNEL_DRAW_WORKER_INL

#include "../geometry/assemble.h"
#include "../geometry/clip.inl"
#include "elements.inl"
#include "../../texture/lookup_state.h"

/* Where full lists go. */
typedef enum list_sink {
    SINK_DRAWS, /* they are drawn */
    SINK_STORES /* they stay in memory, one after the other, until the bands draw them */
} list_sink;

typedef struct worker {
    const draw_state *draw;
    cull_state cull;     /* cull.region is the worker's band, or all that is drawn */
    bool is_quad;        /* assembly takes the segment as a quad (resolve_segment) */
    primitive_kind kind; /* of the primitives in the list */
    list_sink sink;
    primitive_list *list; /* primitives are appended here */
    primitive_setup *setup;
    clipper clipping;
    uint32_t clip_offset;       /* of CLIP_SCRATCH vertices */
    uint32_t clip_used;         /* how many of them the list may need */
    sample_counts samples;      /* if the draw counts them */
    gn_draw_statistics *counts; /* fates are counted here; null: not counted */
    shading_functions shading;
    gn_lookup_memory lookups;
#if GN_SPECIALISED || GN_HAVE_TEXTURES
    lookup_state lookup_states[MOST_LOOKUP_STATES];
#endif
} worker;

static void start_worker(worker *w, const draw_state *draw, uint32_t task)
{
    const uint32_t values = stored_values(draw->pipeline);
    unsigned char *const scratch = task_scratch(draw, task);

    w->draw = draw;
    w->cull = draw->cull;
    w->is_quad = false;
    w->kind = kind_of(draw->pipeline->raster.topology);
    w->sink = SINK_DRAWS;
    w->list = (primitive_list *)(void *)scratch;
    w->setup = (primitive_setup *)(void *)(scratch + scratch_setup_offset());
    w->clipping.pipeline = draw->pipeline;
    w->clipping.viewport = &draw->viewport;
    w->clipping.memory = draw->job->memory;
    w->clip_offset = (uint32_t)(scratch - draw->job->memory) + scratch_vertices_offset(values);
    w->clip_used = 0;
    w->samples.covered = 0;
    w->samples.passed = 0;
    w->counts = NULL;
    w->shading = draw->job->shading;
    w->shading.texture_functions.memory = &w->lookups;
#if GN_SPECIALISED || GN_HAVE_TEXTURES
    start_lookup_memory(&w->lookups, w->lookup_states, MOST_LOOKUP_STATES);
#else
    start_lookup_memory(&w->lookups, 0, 0);
#endif
    start_list(w->list);
}

#endif
