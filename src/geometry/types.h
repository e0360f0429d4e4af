/* The geometry stages: from a mesh to triangles in window coordinates.
 *
 *   fetch      attribute arrays -> structure of arrays, 16 vertices at a time
 *   viewport   clip space -> outcodes, window coordinates, snapped coordinates
 *   assemble   topology -> triangles of vertices, 16 at a time
 *   clip       a triangle across the view volume -> triangles inside it */
#ifndef GN_GEOMETRY_TYPES_H
#define GN_GEOMETRY_TYPES_H

#include "vertex_store.h"

/* window = ndc * scale + translate, for x, y, z; and what is outside the view volume. */
typedef struct viewport_transform {
    float scale[3];
    float translate[3];
    uint32_t planes;  /* bit p: clip_plane p is asked */
    bool zero_to_one; /* CLIP_NEAR is 0 <= z */
    bool sampled;     /* what snaps is the distance from a pixel's corner, not its centre */
} viewport_transform;

/* What of a mesh is drawn at a time: an instance of elements without a restart, or, as a job
 * has it, of all elements. Members are those of gn_mesh but for `base`, instance and primitive. */
typedef struct mesh_slice {
    const gn_attribute *attribute;
    uint32_t vertex_count;
    const void *indices;
    gn_index_format index_format;
    uint32_t first, count;
    uint32_t base; /* added to indices, with a wrap */
    uint32_t instance;
    uint32_t primitive; /* the number of its first: restarts do not begin anew */
    bool restarts;      /* at restart_index, before the base is added */
    uint32_t restart_index;
} mesh_slice;

/* Up to sixteen triangles as offsets of their vertices, in the order that decides the low
 * bits of their attributes: corner[i][l * step] is vertex i of triangle l. Lanes beyond
 * `count` hold offsets too. */
typedef struct triangle_group {
    const uint32_t *corner[3];
    uint32_t step; /* 1 or 3 */
    uint32_t count;
    uint32_t made[3][GN_LANES]; /* what the corners point to where nothing else serves */
} triangle_group;

static inline uint32_t group_vertex(const triangle_group *group, uint32_t corner, uint32_t lane)
{
    return group->corner[corner][lane * group->step];
}

/* Clipping planes, in the order they are clipped against. Bit p of an outcode is
 * set where the vertex is outside plane p, a NaN counting as outside. */
typedef enum clip_plane {
    CLIP_RIGHT,    /* x <= w */
    CLIP_LEFT,     /* -w <= x */
    CLIP_TOP,      /* y <= w */
    CLIP_BOTTOM,   /* -w <= y */
    CLIP_NEAR,     /* -w <= z, or 0 <= z */
    CLIP_FAR,      /* z <= w */
    CLIP_DISTANCE, /* 0 <= the first clip distance, which is finite; then the others */
    CLIP_PLANE_COUNT = CLIP_DISTANCE + (GN_HAVE_DISTANCES ? GN_MAX_CLIP_DISTANCES : 0)
} clip_plane;

/* A plane adds at most one vertex to a convex polygon, so that 3 + 14 are usual.
 * Rounding can make it slightly concave; a polygon beyond this limit, or needing
 * more new vertices than there is room for, is not drawn. Three remain in CLIP_SCRATCH. */
#define CLIP_MAX_POLYGON (GN_LANES + 2)
#define CLIP_MAX_VERTICES (2 * GN_LANES - 3)

/* Room for the new vertices of a triangle to be clipped to these planes, made sixteen at a time:
 * usually two a plane. */
static inline uint32_t clip_room(uint32_t planes)
{
    return GN_HAVE_DISTANCES && planes >> CLIP_DISTANCE ? 2 * GN_LANES : GN_LANES;
}

#endif
