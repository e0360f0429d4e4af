/* Cuts lines and triangles to the view volume and the program's clip planes. */
#ifndef OSMESA_PRIMITIVE_CLIP_H
#define OSMESA_PRIMITIVE_CLIP_H

#include "shaded_vertices.h"

/* Each plane adds one vertex to three, and makes two. */
enum {
    MOST_CLIPPED = 3 + VOLUME_PLANES + CLIP_PLANES,
    MOST_MADE = 2 * (VOLUME_PLANES + CLIP_PLANES)
};

/* A convex polygon; edge i goes from vertex i to the next. */
typedef struct clipped_polygon {
    uint32_t count; /* 0: nothing is left */
    const shaded_vertex *vertex[MOST_CLIPPED + 1];
    bool has_edge[MOST_CLIPPED + 1];
    const shaded_vertex *provoking; /* of the triangle: has the flat varyings */
    uint32_t made;                  /* vertices on planes */
    shaded_vertex memory[MOST_MADE + 1];
} clipped_polygon;

/* Sets what is left of a line. Returns false if that is nothing. */
bool clip_line(const placement *place, const shaded_vertex *a, const shaded_vertex *b,
               shaded_vertex to[2]);

/* Sets what is left of a triangle whose edges are marked by bits. Flat varyings of the first vertex
 * become those of the triangle's last one. */
void clip_triangle(const placement *place, const shaded_vertex *const v[3], unsigned edges,
                   clipped_polygon *polygon);

#endif
