/* The geometry stages: from a mesh to triangles in window coordinates.
 *
 *   fetch      attribute arrays -> structure of arrays, 16 vertices at a time
 *   viewport   clip space -> outcodes, window coordinates, snapped coordinates
 *   assemble   topology -> triangles of vertices, 16 at a time
 *   clip       a triangle that crosses the view volume's boundary -> triangles inside it */
#ifndef GN_KERNEL_GEOMETRY_GEOMETRY_H
#define GN_KERNEL_GEOMETRY_GEOMETRY_H

#include "../../lanes/count.h"
#include "mesh_slice.h"
#include "vertex_store.h"

/* window = ndc * scale + translate, for x, y and z; and which planes bound the view volume. */
typedef struct viewport_transform {
    float scale[3];
    float translate[3];
    uint32_t planes;        /* bit p: vertices are compared with clipping_plane p */
    bool zero_to_one;       /* CLIP_NEAR is 0 <= z */
    bool snaps_from_corner; /* of a pixel, not from its centre: the target is multisampled */
} viewport_transform;

/* A group: up to sixteen assembled triangles, as offsets of their vertices, in an order on which
 * the low bits of attributes depend. corner[i][l * stride] is vertex i of triangle l. Lanes beyond
 * `count` hold offsets of vertices too. */
typedef struct triangle_group {
    const uint32_t *corner[3];
    uint32_t stride; /* 1 or 3 */
    uint32_t count;
    uint32_t made[3][LANES]; /* the corners point here if they cannot point to the elements */
} triangle_group;

static inline uint32_t group_vertex(const triangle_group *group, uint32_t corner, uint32_t lane)
{
    return group->corner[corner][lane * group->stride];
}

/* Clipping planes, in the order in which triangles are clipped. Bit p of an outcode is set if the
 * vertex is outside plane p; NaN counts as outside. */
typedef enum clipping_plane {
    CLIP_RIGHT,    /* x <= w */
    CLIP_LEFT,     /* -w <= x */
    CLIP_TOP,      /* y <= w */
    CLIP_BOTTOM,   /* -w <= y */
    CLIP_NEAR,     /* -w <= z, or 0 <= z */
    CLIP_FAR,      /* z <= w */
    CLIP_DISTANCE, /* 0 <= the first clip distance, and it is finite; then the others */
    CLIP_PLANE_COUNT = CLIP_DISTANCE + (GN_HAVE_DISTANCES ? GN_MAX_CLIP_DISTANCES : 0)
} clipping_plane;

/* The room for the new vertices of a triangle that is clipped to the planes of the view volume:
 * usually two vertices a plane. Clip distances take twice the room, which is all that a worker's
 * scratch holds: enough to set up the pieces of several clipped triangles together. */
#define CLIP_ROOM 16
#define CLIP_SCRATCH (2 * CLIP_ROOM)

/* Copies of a piece's vertices, which offset_piece makes in the scratch. */
#define OFFSET_COPIES 3

/* A plane adds at most one vertex to a convex polygon, so 14 planes make at most 3 + 14. Rounding
 * can make a polygon slightly concave. A polygon that exceeds this limit, or needs more new
 * vertices than there is room for, is not drawn. */
#define CLIP_MAX_POLYGON (CLIP_ROOM + 2)
#define CLIP_MAX_VERTICES (CLIP_SCRATCH - OFFSET_COPIES)

/* Returns the room for the new vertices of a triangle that is clipped to these planes. */
static inline uint32_t clip_room(uint32_t planes)
{
    return GN_HAVE_DISTANCES && planes >> CLIP_DISTANCE ? CLIP_SCRATCH : CLIP_ROOM;
}

#endif
