/* Vertices between the stages: records in the workspace, each named by its offset. A record
 * consists of rows of four words, so that stages that work on 16 vertices at a time gather and
 * scatter by transposing. */
#ifndef GN_KERNEL_GEOMETRY_VERTEX_STORE_H
#define GN_KERNEL_GEOMETRY_VERTEX_STORE_H

#include <stddef.h>
#include <stdint.h>

#include <gnomon/draw.h>

#include "../../config/features.h"

typedef struct stored_vertex {
    float window[4];    /* window coordinates x, y, z and 1 / clip w */
    int32_t snapped[2]; /* window x, y minus half a pixel, in 1/256 pixel */
    uint32_t outcode;   /* bit p: outside clipping_plane p */
    float point_size;   /* if the vertex shader writes one */
    float clip[4];      /* clip space */
    float varying[];    /* stored_values of the pipeline, in rows of four: varyings, then clip
                           distances */
} stored_vertex;

/* Offsets of the rows of a vertex. */
enum {
    VERTEX_WINDOW = offsetof(stored_vertex, window),
    VERTEX_SNAPPED = offsetof(stored_vertex, snapped),
    VERTEX_CLIP = offsetof(stored_vertex, clip),
    VERTEX_VARYING = offsetof(stored_vertex, varying),
    VERTEX_ROW = 16
};

/* Words of the row at VERTEX_SNAPPED. */
enum { SNAPPED_X, SNAPPED_Y, SNAPPED_OUTCODE, SNAPPED_POINT_SIZE, VERTEX_WORDS };

static inline uint32_t distance_count(const gn_pipeline *pipeline)
{
    return GN_HAVE_DISTANCES ? pipeline->program.clip_distance_count : 0;
}

/* Returns how many values, beside the position, a vertex shader writes and a vertex stores. */
static inline uint32_t stored_values(const gn_pipeline *pipeline)
{
    return pipeline->program.varying_count + distance_count(pipeline);
}

/* Returns the bytes from one vertex with `value_count` stored_values to the next. */
static inline uint32_t vertex_stride(uint32_t value_count)
{
    return VERTEX_VARYING + (value_count + 3) / 4 * VERTEX_ROW;
}

static inline stored_vertex *vertex_at(unsigned char *memory, uint32_t offset)
{
    return (stored_vertex *)(void *)(memory + offset);
}

#endif
