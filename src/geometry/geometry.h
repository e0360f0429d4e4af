/* The geometry stages: from a mesh to triangles in window coordinates.
 *
 *   fetch      attribute arrays -> structure of arrays, 16 vertices at a time
 *   viewport   clip space -> outcodes, window coordinates, snapped coordinates
 *   assemble   topology -> triangles of vertices
 *   clip       a triangle across the view volume -> triangles inside it */
#ifndef GN_GEOMETRY_GEOMETRY_H
#define GN_GEOMETRY_GEOMETRY_H

#include "vertex_store.h"

/* window = ndc * scale + translate, for x, y, z. */
typedef struct viewport_transform {
    float scale[3];
    float translate[3];
} viewport_transform;

/* Clipping planes, in the order they are clipped against. Bit p of an outcode is
 * set where the vertex is outside plane p, a NaN counting as outside. */
typedef enum clip_plane {
    CLIP_RIGHT,  /* x <= w */
    CLIP_LEFT,   /* -w <= x */
    CLIP_TOP,    /* y <= w */
    CLIP_BOTTOM, /* -w <= y */
    CLIP_NEAR,   /* -w <= z */
    CLIP_FAR,    /* z <= w */
    CLIP_PLANE_COUNT
} clip_plane;

/* A plane adds at most one vertex to a convex polygon, so that 3 + 6 are usual.
 * Rounding can make it slightly concave; a polygon beyond this limit, or needing
 * more new vertices than a batch holds, is not drawn. */
#define CLIP_MAX_POLYGON 12

/* Sixteen vertices' attributes, components that an array lacks being 0, 0, 0, 1. */
void gn_fetch_attributes(const gn_mesh *mesh, const uint32_t vertex_id[GN_LANES],
                         float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES]);

viewport_transform gn_viewport_transform(const gn_pipeline *pipeline, uint32_t target_width,
                                         uint32_t target_height);

/* Outcodes, window and snapped coordinates of a batch, from its clip coordinates. */
void gn_transform_batch(const viewport_transform *viewport, vertex_batch *batch);

/* Triangles that count elements make, and the elements of triangle i. */
uint32_t gn_triangle_count(gn_topology topology, uint32_t count);
vertex_triangle gn_assemble_triangle(gn_topology topology, gn_provoking_vertex provoking,
                                     uint32_t i);

/* Triangle i, 0 or 1, of a fan of four vertices as the reference splits a quad, with
 * the vertex of slot 0 first. */
vertex_triangle gn_assemble_quad(uint32_t i);

/* Clips a triangle to the planes set in `planes`. New vertices are written to the
 * batch `scratch`, whole (clip, window, snapped, varyings). Gives the number of
 * triangles written to `out`, 0 to CLIP_MAX_POLYGON - 2. */
uint32_t gn_clip_triangle(const gn_pipeline *pipeline, const viewport_transform *viewport,
                          const vertex_store *store, uint32_t scratch, uint32_t planes,
                          const vertex_triangle *triangle,
                          vertex_triangle out[CLIP_MAX_POLYGON - 2]);

#endif
