/* A checked draw, as a back end gets it, and how its workspace is divided. */
#ifndef GN_DRAW_JOB_H
#define GN_DRAW_JOB_H

#include "../raster/types.h"
#include "../shaders/shading.h"

/* Tasks that a step of a draw is divided into at most, each with scratch of its own. */
#define MAX_TASKS 32

/* New vertices that a task keeps, so that the pieces of several clipped triangles are set
 * up together where there is room for them. */
#define CLIP_SCRATCH (2 * GN_LANES)

/* The reference takes a draw in segments of this many elements, without indices and with them,
 * and some of its decisions depend on all vertices of a segment (resolve_segment). */
#define SEGMENT_ELEMENTS 4096
#define SEGMENT_INDICES 1024

/* Elements of a segment. A fan without indices that is longer than one segment is divided as if
 * it had indices, since only then can each segment have the fan's first vertex. */
static inline uint32_t segment_elements(gn_topology topology, const mesh_slice *mesh)
{
    const bool divides_fan = topology == GN_TRIANGLE_FAN && mesh->count > SEGMENT_ELEMENTS;

    return mesh->index_format != GN_INDEX_NONE || divides_fan ? SEGMENT_INDICES : SEGMENT_ELEMENTS;
}

/* Rows of the target, inclusive. */
typedef struct pixel_rows {
    int32_t min, max;
} pixel_rows;

/* The triangles of a segment that can be seen, in consecutive lists. */
typedef struct segment_lists {
    uint32_t list_count;
    uint32_t triangle_count;
    pixel_rows rows; /* of their bounds */
    uint32_t area;   /* about the sum of their bounds', each counted up to LARGEST_AREA */
} segment_lists;

/* As much as makes a draw worth all strips. The sum of a segment fits 32 bits. */
#define LARGEST_AREA (1 << 19)

/* The rows of the bounds of sixteen lists; of a list that is not there, none. */
typedef struct list_rows {
    int32_t min[GN_LANES], max[GN_LANES];
} list_rows;

/* The workspace from an aligned address on: the scratch of tasks, then for a draw with
 * tasks the segments of a round, their lists and the rows of those, then vertices. */
typedef struct draw_job {
    const gn_target *target;
    const gn_pipeline *pipeline;
    shading_functions shading;
    const mesh_slice *mesh; /* all elements, of the first instance */
    uint32_t instances;
    unsigned char *memory; /* vertices are named by their offset from here */
    uint32_t vertices;     /* offset of the first */
    uint32_t capacity;     /* vertices there is room for, a multiple of GN_LANES */

    gn_parallel *parallel; /* null: one task, no segments kept */
    void *user;
    uint32_t threads;         /* that run tasks; 0: not known */
    uint64_t *samples_passed; /* null: not counted */
    segment_lists *segments;  /* of a round */
    uint32_t segment_count;
    triangle_list *lists;
    list_rows *rows; /* of the lists */
    uint32_t lists_per_segment, rows_per_segment;
} draw_job;

/* A task's scratch, for so many stored_values: a triangle_list, its triangle_setup, new vertices.
 */
static inline uint32_t scratch_setup_offset(void)
{
    return (uint32_t)(sizeof(triangle_list) + 63) & ~63u;
}

static inline uint32_t scratch_vertices_offset(uint32_t value_count)
{
    return scratch_setup_offset() + ((uint32_t)(triangle_setup_size(value_count) + 63) & ~63u);
}

static inline uint32_t scratch_size(uint32_t value_count)
{
    const uint32_t size =
        scratch_vertices_offset(value_count) + CLIP_SCRATCH * vertex_stride(value_count);

    return (size + 63) & ~63u;
}

#endif
