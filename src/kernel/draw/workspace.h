/* How a draw divides its workspace. From an aligned address on there are: the scratch of tasks; for
 * a draw with tasks the segments of a round, their lists and the rows of these lists; then
 * vertices. The sizes depend on how many lanes a back end has. */
#ifndef GN_KERNEL_DRAW_WORKSPACE_H
#define GN_KERNEL_DRAW_WORKSPACE_H

#include "../geometry/assemble.h"
#include "../raster/raster.h"
#include "job.h"

/* A cache line. */
#define WORKSPACE_ALIGNMENT 64

/* The most tasks of a phase. Each has scratch of its own. */
#define MAX_TASKS 80

/* The elements of a segment without and with indices. The reference takes a draw in segments of
 * these lengths, and some of its decisions depend on all vertices of a segment (resolve_segment).
 */
#define SEGMENT_ELEMENTS 4096
#define SEGMENT_INDICES 1024

/* Returns a segment's length in elements. A fan without indices that is longer than one segment is
 * divided as if it had indices: only then can each segment have the fan's first vertex. */
static inline uint32_t segment_elements(gn_topology topology, const mesh_slice *mesh)
{
    const bool divides_fan = topology == GN_TRIANGLE_FAN && mesh->count > SEGMENT_ELEMENTS;

    return mesh->index_format != GN_INDEX_NONE || divides_fan ? SEGMENT_INDICES : SEGMENT_ELEMENTS;
}

/* Rows of the target, inclusive. */
typedef struct row_range {
    int32_t min, max;
} row_range;

/* The sums of the lists of a segment, which follow one another. */
typedef struct segment_sums {
    uint32_t list_count;
    uint32_t primitive_count;
    row_range rows;  /* of the bounds of all triangles */
    uint32_t halves; /* estimated; a triangle counts at most MOST_HALVES */
} segment_sums;

/* The rows of the bounds of sixteen lists. The range of a list that does not exist is empty. */
typedef struct rows_of_lists {
    int32_t min[LANES], max[LANES];
} rows_of_lists;

/* About how many triangles a round has: enough to be worth its phases, few enough for their
 * vertices and lists to stay in the cache. A closed surface has half as many vertices as triangles,
 * so the vertices of two rounds fit a ring of 65,536. */
#define ROUND_PRIMITIVES 57344

/* Returns the bytes of a vertex shader's outputs for `value_count` stored_values: a position, the
 * values and a point size for each of GN_LANES vertices. */
static inline size_t staging_size(uint32_t value_count)
{
    return (4 + value_count + 1) * sizeof(float[GN_LANES]);
}

/* The most bytes of what a task keeps in the memory of the set-up when it sets up nothing. */
#define MOST_SUMS (GN_HAVE_TASKS ? 640 : 0)

/* A task's scratch: a primitive_list, its primitive_setup, then new vertices of `value_count`
 * stored_values each. Before triangles are set up, the vertex shader's outputs
 * lie in the memory of the set-up, and with one lane they are larger than it. Outcodes or
 * sample_counts replace the list when a task ends. */
static inline uint32_t scratch_setup_offset(void)
{
    return (uint32_t)(sizeof(primitive_list) + 63) & ~63u;
}

static inline uint32_t scratch_vertices_offset(uint32_t value_count)
{
    const size_t setup = primitive_setup_size(value_count), staging = staging_size(value_count);
    const size_t other = staging > MOST_SUMS ? staging : MOST_SUMS;
    const size_t most = LANES < GN_LANES && other > setup ? other : setup;

    return scratch_setup_offset() + ((uint32_t)(most + 63) & ~63u);
}

static inline uint32_t scratch_size(uint32_t value_count)
{
    const uint32_t size =
        scratch_vertices_offset(value_count) + CLIP_SCRATCH * vertex_stride(value_count);

    return (size + 63) & ~63u;
}

/* A draw stores at least the three vertices of a triangle together. */
static inline uint64_t vertices_size(uint32_t vertex_count, uint32_t varying_count)
{
    const uint32_t stored = vertex_count > 3 ? vertex_count : 3;
    const uint64_t packets = ((uint64_t)stored - 1) / LANES + 1;

    return packets * LANES * vertex_stride(varying_count);
}

/* Returns how many lists hold a segment's primitives; the last one is never full. */
static inline uint32_t lists_per_segment(uint32_t primitives)
{
    return primitives / LANES + 1;
}

static inline uint32_t list_rows_per_segment(uint32_t primitives)
{
    return (lists_per_segment(primitives) - 1) / LANES + 1;
}

static inline uint64_t segment_size(uint32_t primitives)
{
    return sizeof(segment_sums) + (uint64_t)lists_per_segment(primitives) * sizeof(primitive_list) +
           (uint64_t)list_rows_per_segment(primitives) * sizeof(rows_of_lists);
}

/* The division of a workspace. */
typedef struct workspace_division {
    uint32_t slots_offset; /* where slots begin in the job's memory */
    uint32_t capacity;     /* how many vertices fit, a multiple of LANES */

    /* The segments of a round, their lists and the rows of these; unspecified without tasks. */
    bool has_tasks;
    segment_sums *segments;
    uint32_t segment_count;
    primitive_list *lists;
    rows_of_lists *list_rows;
    uint32_t lists_per_segment, list_rows_per_segment;
} workspace_division;

/* Returns how many segments of a round fit `memory`, which the tasks' scratch leaves, beside the
 * vertices: all vertices of the draw if they fit, otherwise those of the round's segments. */
static inline uint64_t round_segments_in(const draw_job *job, uint64_t memory)
{
    const mesh_slice *mesh = job->mesh;
    const bool indexed = mesh->index_format != GN_INDEX_NONE;
    const uint32_t elements = segment_elements(job->pipeline->raster.topology, mesh);
    const uint32_t varyings = stored_values(job->pipeline);
    const uint64_t segment = segment_size(primitives_of(job->pipeline->raster.topology, elements));
    const uint64_t all_vertices =
        vertices_size(indexed ? mesh->vertex_count : mesh->count, varyings);

    if (memory >= all_vertices + segment)
        return (memory - all_vertices) / segment;
    return memory / (segment + vertices_size(elements, varyings));
}

/* Divides the memory for tasks, if tasks are asked for and fit. Returns the bytes before the
 * vertices. */
static inline uint32_t divide_for_tasks(workspace_division *division, const draw_job *job)
{
    const uint32_t varyings = stored_values(job->pipeline);
    const uint32_t elements = segment_elements(job->pipeline->raster.topology, job->mesh);
    const uint32_t per_segment = primitives_of(job->pipeline->raster.topology, elements);
    const uint32_t total = primitive_count(job->pipeline->raster.topology, job->mesh->count);
    const uint64_t scratch = MAX_TASKS * (uint64_t)scratch_size(varyings);
    /* Aligning the end of the lists may take this much more. */
    const uint64_t taken = scratch + WORKSPACE_ALIGNMENT - 1;
    uint64_t segments = 0;

    if (job->memory_size >= taken)
        segments = round_segments_in(job, job->memory_size - taken);

    segments = segments < total / per_segment + 1 ? segments : total / per_segment + 1;
    segments = segments < ROUND_PRIMITIVES / per_segment + 1 ? segments
                                                             : ROUND_PRIMITIVES / per_segment + 1;
    division->has_tasks = GN_HAVE_TASKS && job->parallel && segments > 0;
    if (!division->has_tasks)
        return scratch_size(varyings);
    division->segment_count = (uint32_t)segments;
    division->lists_per_segment = lists_per_segment(per_segment);
    division->list_rows_per_segment = list_rows_per_segment(per_segment);

    const uint64_t lists = scratch + segments * sizeof(segment_sums);
    const uint64_t rows = lists + segments * division->lists_per_segment * sizeof(primitive_list);
    division->segments = (segment_sums *)(void *)(job->memory + scratch);
    division->lists = (primitive_list *)(void *)(job->memory + lists);
    division->list_rows = (rows_of_lists *)(void *)(job->memory + rows);

    const uint64_t end = scratch + segments * segment_size(per_segment);
    return (uint32_t)(end + WORKSPACE_ALIGNMENT - 1) & ~(uint32_t)(WORKSPACE_ALIGNMENT - 1);
}

static inline void divide_workspace(workspace_division *division, const draw_job *job)
{
    const uint32_t packet_size = LANES * vertex_stride(stored_values(job->pipeline));

    division->slots_offset = divide_for_tasks(division, job);
    division->capacity = (job->memory_size - division->slots_offset) / packet_size * LANES;
}

#endif
