/* The raster stages: from triangles in window coordinates to blocks of covered
 * fragments.
 *
 *   setup      three vertices -> edge functions and attribute planes
 *   coverage   edge functions -> runs of 4x4 blocks with a mask of covered pixels */
#ifndef GN_RASTER_TYPES_H
#define GN_RASTER_TYPES_H

#include "../geometry/vertex_store.h"

/* Blocks are 4x4 pixels: lane l is the pixel (x + l % 4, y + l / 4). */
#define BLOCK_SIZE 4

/* An attribute's plane in window coordinates: its value at the pixel (x, y) is
 * per_y * y + (per_x * x + origin). */
typedef struct attribute_plane {
    float origin, per_x, per_y;
} attribute_plane;

/* An edge function: the pixel (x, y) is inside where
 * constant - per_x * x + per_y * y >= 0. Ties are folded into the constant. */
typedef struct edge_function {
    int64_t constant;
    int32_t per_x, per_y;
} edge_function;

typedef struct raster_triangle {
    int32_t min_x, min_y, max_x, max_y; /* pixels, inclusive, inside the target */
    edge_function edge[3];
    attribute_plane depth;
    attribute_plane one_over_w;
    attribute_plane varying[GN_MAX_VARYINGS]; /* smooth ones divided by w */
} raster_triangle;

/* What triangle set-up needs of a draw. */
typedef struct setup_state {
    const gn_pipeline *pipeline;
    uint32_t width, height; /* of the target */
    bool any_clipped;       /* some vertex of the segment is outside the view volume */
} setup_state;

/* Called for runs of `count` neighbouring 4x4 blocks in a row, the first at (x, y),
 * multiples of 4; bit l of coverage is lane l, the same in every block. More than one
 * block is only called for where all pixels are covered. */
typedef void run_function(const void *context, const raster_triangle *triangle, int32_t x,
                          int32_t y, uint32_t count, uint32_t coverage);

#endif
