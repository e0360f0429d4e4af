/* What the stages of a draw share: the resolved state, and where vertices are stored. */
#ifndef GN_KERNEL_DRAW_DRAW_STATE_INL
#define GN_KERNEL_DRAW_DRAW_STATE_INL

#include "../fragment/samples.inl"
#include "../fragment/steps.inl"
#include "../geometry/assemble.h"
#include "../geometry/viewport.inl"
#include "../raster/cull.inl"
#include "../raster/offset.inl"
#include "../../formats/surface_memory.h"
#include "workspace.h"

/* Where vertices are stored. If `shared`, slot n holds the vertex base + n, and an element finds
 * its slot by its index. Otherwise slots hold consecutive elements of the slice from `first` on,
 * each shaded for itself; slot 0 of a fan holds the slice's first element. Slot n of a shared draw
 * lies at the place n & ring: if indices rise with the vertices, a ring of a few thousand places
 * serves any number of vertices and stays in the cache. */
typedef struct slot_map {
    bool shared;
    uint32_t base;
    uint32_t ring;     /* places - 1, where `places` is a power of two; UINT32_MAX: no ring */
    uint32_t count;    /* slots of a shared draw */
    uint32_t shaded;   /* slots that are shaded: a multiple of sixteen, or all */
    uint32_t outcodes; /* the union over shaded slots */
    uint32_t first;
} slot_map;

/* Vertices low to high, inclusive; empty if low > high. */
typedef struct vertex_range {
    uint32_t low, high;
} vertex_range;

static inline vertex_range join_ranges(vertex_range a, vertex_range b)
{
    const vertex_range r = {a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};

    return r;
}

/* Vertices are shaded up to the end of a chunk of the indices. With so many chunks, they are still
 * in the near cache when triangles are assembled. */
#define INDEX_CHUNKS (GN_STATES_SPECIALISED ? 512 : 8)

/* The shortest chunk. Tests divide small scenes too. */
#if defined(GN_SMALLEST_TASKS)
#define CHUNK_INDICES 16
#else
#define CHUNK_INDICES SEGMENT_INDICES
#endif

/* A mesh's indices in chunks of `size`. A chunk's range runs from the lowest vertex that it names
 * to the highest vertex that it or a chunk before it names. */
typedef struct index_chunks {
    const mesh_slice *mesh;
    uint32_t size, count;
    vertex_range range[INDEX_CHUNKS];
} index_chunks;

typedef struct draw_state {
    const draw_job *job;
    const gn_pipeline *pipeline;
    mesh_slice slice;  /* which is drawn */
    uint32_t next;     /* the element of the instance at which the next slice begins */
    bool slices_share; /* of an instance: they share one set of vertices */
    uint32_t stride;   /* bytes from one vertex to the next */
    workspace_division workspace;
    uint32_t slots_offset; /* of slot 0 */
    uint32_t used; /* slots from the job's first that may hold vertices which a list needs */
    slot_map map;
    index_chunks chunks; /* used by a draw with indices */
    viewport_transform viewport;
    cull_state cull;
    offset_state offset;
    gn_status lookup_status; /* the first fault of a texture or sampler that a shader looked up */
    bool is_sampled;         /* the target is multisampled */
    float center;            /* a plane at (x, y) has the value at (x, y) + center of the window */
    fragment_state fragment[SAMPLE_STATES]; /* one for each sample; only the first if the target is
                                               not multisampled */
    fragment_functions shade;
} draw_state;

GN_ONCE void set_sample_state(draw_state *draw, uint32_t sample)
{
    fragment_state *const state = &draw->fragment[sample];

    set_fragment_state(state, draw->job->target, first_surface(draw->job->target), draw->pipeline,
                       &draw->viewport);
    state->is_ready_made =
        draw->job->shading.fragment_shader != draw->pipeline->program.fragment_shader;
    if (DRAWS_LINES && draw->cull.is_unfilled)
        state->moves_depth = false; /* offset_piece moves the vertices instead */
}

GN_SHARED void set_draw_state(draw_state *draw, const draw_job *job)
{
    const gn_surface *any = first_surface(job->target);

    draw->job = job;
    draw->pipeline = job->pipeline;
    draw->slice = *job->mesh;
    draw->stride = vertex_stride(stored_values(job->pipeline));
    divide_workspace(&draw->workspace, job);
    draw->slots_offset = draw->workspace.slots_offset;
    draw->used = 0;
    draw->slices_share = false;
    draw->map.shared = false;
    draw->map.ring = UINT32_MAX;
    draw->viewport = viewport_transform_of(job->pipeline, any->width, any->height);
    draw->cull = cull_state_of(job->pipeline, any->width, any->height);
    set_sample_state(draw, 0);
    if (GN_HAVE_OFFSET)
        draw->offset = offset_state_of(job->pipeline, job->target->depth.format,
                                       draw->fragment[0].moves_depth);
    draw->shade = fragment_functions_of(&draw->fragment[0], counts_samples(job));
    draw->is_sampled = DRAWS_SAMPLES && samples_of(any) > 1;
    draw->center = 0.5f;
    if (draw->is_sampled) {
        draw->center = 0.0f;
        draw->viewport.snaps_from_corner = true;
        draw->cull.box.reach = SAMPLE_REACH;
        for (uint32_t s = 0; s < SAMPLE_STATES; ++s) {
            set_sample_state(draw, s);
            view_sample(&draw->fragment[s], s);
        }
    }
}

/* Returns how many primitives the elements of a segment make. */
static inline uint32_t segment_primitives(const draw_state *draw)
{
    const gn_topology topology = draw->pipeline->raster.topology;

    return primitives_of(topology, segment_elements(topology, &draw->slice));
}

/* The scratch of a task. */
static inline unsigned char *task_scratch(const draw_state *draw, uint32_t task)
{
    return draw->job->memory + (size_t)task * scratch_size(stored_values(draw->pipeline));
}

#endif
