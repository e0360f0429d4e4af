/* The raster stages: from triangles in window coordinates to blocks of covered
 * fragments.
 *
 *   setup      three vertices -> edge functions and attribute planes
 *   coverage   edge functions -> 4x4 blocks with a mask of covered pixels */
#ifndef GN_RASTER_RASTER_H
#define GN_RASTER_RASTER_H

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
    bool any_clipped;       /* some vertex of the draw is outside the view volume */
} setup_state;

/* False where the triangle is culled, degenerate or covers no pixel of the target;
 * `out` is then unspecified. */
bool gn_setup_triangle(const setup_state *state, const vertex_store *store,
                       const vertex_triangle *triangle, raster_triangle *out);

/* Calls `block` for every 4x4 block with covered pixels, from the bottom up and from
 * left to right. x and y are multiples of 4, bit l of coverage is lane l. */
typedef void block_function(void *context, const raster_triangle *triangle, int32_t x, int32_t y,
                            uint32_t coverage);
void gn_cover_triangle(const raster_triangle *triangle, block_function *block, void *context);

#endif
