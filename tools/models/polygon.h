/* Cuts polygons into triangles. */
#ifndef POLYGON_H
#define POLYGON_H

#include "reader.h"

/* A corner of a polygon. What stands behind the position is used while the polygon is cut. */
typedef struct polygon_corner {
    double position[3];
    double x, y;             /* in the polygon's plane */
    double turn;             /* twice the area of the triangle with its neighbours */
    uint32_t previous, next; /* of those that are left */
    uint32_t blocker;        /* lies in that triangle; UINT32_MAX: none is known */
} polygon_corner;

/* A polygon and its triangles; for one polygon after another, so that memory is allocated once.
 * Zeroed but for work_left it is empty. */
typedef struct polygon {
    polygon_corner *corners;
    size_t count, room;
    uint32_t *triangles; /* three numbers of corners each, in the polygon's winding */
    size_t index_count, triangle_room;
    double normal[3];   /* Newell's: as long as twice the area */
    uint64_t work_left; /* tests of corners against triangles, over all polygons of a file */
} polygon;

/* The work that a file's polygons may take: some seconds. */
#define POLYGON_MOST_WORK ((uint64_t)1 << 31)

/* Makes room for corners, at least three, whose positions the caller then writes. Returns false
 * with the fault recorded. */
bool polygon_begin(model_reader *r, polygon *p, size_t count);

/* Writes the triangles, at most count - 2. A simple polygon, convex or not, is covered exactly
 * once; corners at which the border goes back on itself get no triangle. Sets *is_simple to false
 * if the polygon crosses itself or the work is used up: triangles may then overlap. Returns false
 * with the fault recorded. */
bool polygon_cut(model_reader *r, polygon *p, bool *is_simple);

void polygon_release(model_reader *r, polygon *p);

#endif
