/* Divides polygons into triangles. */
#ifndef POLYGON_H
#define POLYGON_H

#include "reader.h"

/* Polygons with more corners are divided into a fan, which is right only if they are convex. */
#define POLYGON_MAX_CORNERS 4096

/* Writes the 3 * (count - 2) corner numbers of the triangles of a polygon with `count` corners, at
 * least 3; `corners` holds x, y, z of each. The triangles have the polygon's winding. A simple
 * polygon, convex or not, is covered exactly once: ears are cut off in the plane of Newell's normal
 * (Meisters, "Polygons Have Ears", 1975). One that crosses itself or has no area gets triangles
 * too. A warning names a polygon with too many corners that is not convex. Time grows with the
 * square of the corners. Returns false with the fault recorded if there is not enough memory. */
bool polygon_triangulate(model_reader *r, const double *corners, size_t count, uint32_t *triangles);

#endif
