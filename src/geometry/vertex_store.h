/* Vertices between the stages: batches of sixteen, each a structure of arrays, as
 * the vertex shader wrote them. A vertex is named by its slot: batch slot / 16,
 * lane slot % 16. */
#ifndef GN_GEOMETRY_VERTEX_STORE_H
#define GN_GEOMETRY_VERTEX_STORE_H

#include <stddef.h>
#include <stdint.h>

#include "gnomon/draw.h"

typedef struct vertex_batch {
    float clip[4][GN_LANES];      /* clip space */
    float window[4][GN_LANES];    /* window coordinates x, y, z and 1 / clip w */
    int32_t snapped[2][GN_LANES]; /* window x, y minus half a pixel, in 1/256 pixel */
    uint32_t outcode[GN_LANES];   /* bit p: outside clip_plane p */
    float varying[][GN_LANES];    /* as many as the pipeline has */
} vertex_batch;

typedef struct vertex_store {
    unsigned char *memory;
    size_t batch_size; /* bytes */
} vertex_store;

/* A triangle as three slots, in the order that decides the low bits of its
 * attributes, and the slot flat varyings come from. */
typedef struct vertex_triangle {
    uint32_t slot[3];
    uint32_t provoking;
} vertex_triangle;

static inline size_t vertex_batch_size(uint32_t varying_count)
{
    return sizeof(vertex_batch) + varying_count * sizeof(float[GN_LANES]);
}

static inline vertex_batch *vertex_batch_at(const vertex_store *store, uint32_t batch)
{
    return (vertex_batch *)(void *)(store->memory + batch * store->batch_size);
}

static inline vertex_batch *vertex_batch_of(const vertex_store *store, uint32_t slot)
{
    return vertex_batch_at(store, slot / GN_LANES);
}

#endif
