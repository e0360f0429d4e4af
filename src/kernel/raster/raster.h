/* The raster stages: from triangles in window coordinates to blocks of covered fragments.
 *
 *   cull.inl      16 triangles -> those that can be seen, with their bounds in pixels
 *   setup.inl     16 triangles -> edge functions and attribute planes
 *   coverage.inl  edge functions -> spans of squares, and blocks with masks of covered pixels
 *
 * Points and lines have files of their own for set-up and coverage; multisampled targets have one
 * for coverage. */
#ifndef GN_KERNEL_RASTER_RASTER_H
#define GN_KERNEL_RASTER_RASTER_H

#include "../../lanes/square.h"
#include "../geometry/geometry.h"

/* The coverage of a half whose pixels are all covered. */
#define HALF_COVERED ((1u << HALF_LANES) - 1)

/* A block: two halves of 4x2 pixels. Lane l is the pixel (x[l / 8] + l % 4, y[l / 8] + l / 4 % 2).
 * All four coordinates are even, so a block has four whole quads. */
typedef struct pixel_block {
    int32_t x[2], y[2];
} pixel_block;

static inline pixel_block square_block(int32_t x, int32_t y)
{
    const pixel_block block = {{x, x}, {y, y + SQUARE_SIZE / 2}};

    return block;
}

/* No vertex inside a viewport has a snapped coordinate beyond this: GN_MAX_SIZE on either side of
 * an origin within GN_MAX_SIZE. Within the limit a triangle's area and edge functions stay below
 * 2^52. */
#define SNAPPED_LIMIT (2 * GN_MAX_SIZE * 256 + 256)

/* Triangles with snapped extents below this have areas below 2^29. Their edge functions, in the
 * bounds and one square around them, fit 32 bits with room to spare. */
#define SMALL_EXTENT (1 << 14)

/* Triangles below this have edge functions that just fit: 2 * 31000 * (31000 + 1024) < 2^31. */
#define PACKED_EXTENT 31000

/* Pixels, inclusive. */
typedef struct pixel_rectangle {
    int32_t min_x, min_y, max_x, max_y;
} pixel_rectangle;

/* Returns the smallest rectangle that holds both. */
static inline pixel_rectangle join_rectangles(const pixel_rectangle *a, const pixel_rectangle *b)
{
    pixel_rectangle r;

    r.min_x = a->min_x < b->min_x ? a->min_x : b->min_x;
    r.min_y = a->min_y < b->min_y ? a->min_y : b->min_y;
    r.max_x = a->max_x > b->max_x ? a->max_x : b->max_x;
    r.max_y = a->max_y > b->max_y ? a->max_y : b->max_y;
    return r;
}

enum { BOUNDS_MIN_X, BOUNDS_MIN_Y, BOUNDS_MAX_X, BOUNDS_MAX_Y, BOUNDS_COUNT };

static inline pixel_rectangle bounds_of_lane(const int32_t (*bounds)[LANES], uint32_t lane)
{
    const pixel_rectangle r = {bounds[BOUNDS_MIN_X][lane], bounds[BOUNDS_MIN_Y][lane],
                               bounds[BOUNDS_MAX_X][lane], bounds[BOUNDS_MAX_Y][lane]};

    return r;
}

/* A list: up to sixteen primitives that can be seen, in order, all of one kind. Bit l of
 * `deferred`: the bands clip primitive l or make its outline; its bounds are those of what they
 * will draw. */
typedef struct primitive_list {
    uint32_t count;
    uint32_t deferred;
    uint32_t vertex[3][LANES];           /* clockwise: inside is right of every edge */
    uint32_t provoking[LANES];           /* flat varyings come from this vertex */
    int32_t bounds[BOUNDS_COUNT][LANES]; /* pixels whose centres may be inside */
    int32_t primitive[LANES];            /* its number in the instance */
    uint32_t back; /* bit l: back-facing; unspecified where `deferred` has the bit */
} primitive_list;

static inline void start_list(primitive_list *list)
{
    list->count = 0;
    list->deferred = 0;
    list->back = 0;
}

/* Fills lanes beyond a list's count with its first lane. */
static inline void fill_list(primitive_list *list)
{
    for (uint32_t l = list->count; l < LANES; ++l) {
        for (int i = 0; i < 3; ++i)
            list->vertex[i][l] = list->vertex[i][0];
        for (int b = 0; b < BOUNDS_COUNT; ++b)
            list->bounds[b][l] = list->bounds[b][0];
        list->provoking[l] = list->provoking[0];
        list->primitive[l] = list->primitive[0];
    }
}

/* An attribute's plane in window coordinates: its value at the pixel (x, y) is
 * per_y * y + (per_x * x + origin). */
typedef struct attribute_plane {
    float origin, per_x, per_y;
} attribute_plane;

/* Planes of a triangle: depth, 1/w, and the varyings, smooth ones divided by w. */
enum { DEPTH_PLANE, ONE_OVER_W_PLANE, VARYING_PLANES };
enum { PLANE_ORIGIN, PLANE_PER_X, PLANE_PER_Y, PLANE_TERMS };

/* Words of a point: gl_PointCoord divided by w, its increment from pixel to pixel and its values at
 * the pixel (0, 0). */
enum { POINT_PER_PIXEL, POINT_ORIGIN_S, POINT_ORIGIN_T, POINT_WORDS };

/* Triangles and lines have snapped vertices; points have words. */
typedef union corner_lanes {
    int32_t snapped[3][2][LANES];
    float point[POINT_WORDS][LANES];
} corner_lanes;

/* An edge function: the pixel (x, y) is inside where
 * start - per_x * (x - origin[0]) + per_y * (y - origin[1]) >= 0. The tie rule is folded in. */
typedef struct edge_lanes {
    int32_t start[LANES]; /* unspecified from PACKED_EXTENT on, where it needs 64 bits */
    int32_t per_x[LANES]; /* by how much it falls from a pixel to the one on its right */
    int32_t per_y[LANES]; /* by how much it rises from a pixel to the one above */
} edge_lanes;

/* Bits of `flags`, which say what a primitive is. */
enum { PRIMITIVE_IS_BACK = 1, PRIMITIVE_IS_POINT = 2 };

struct shading_functions;

/* A set-up: the primitives of a list with edge functions and planes. */
typedef struct primitive_setup {
    const struct shading_functions *shading; /* the task's, for the fragment stage */
    uint32_t upside_down;                    /* 1: the viewport's height is negative */
    uint32_t large;                          /* bit l: an extent is SMALL_EXTENT or more */
    uint32_t unpacked;                       /* bit l: an extent is PACKED_EXTENT or more */
    int32_t origin[2][LANES];                /* the pixel at which squares begin (place_squares) */
    corner_lanes corner;
    edge_lanes edge[3];
    int32_t primitive[LANES]; /* its number in the instance */
    int32_t flags[LANES];     /* PRIMITIVE_IS_.. */
    int32_t opaque[LANES];    /* -1 or 0: setup_opaque */
    float offset[LANES];      /* polygon offset; written only if the pipeline has one */
    float plane[][PLANE_TERMS][LANES];
} primitive_setup;

static inline size_t primitive_setup_size(uint32_t varying_count)
{
    return sizeof(primitive_setup) +
           (VARYING_PLANES + varying_count) * sizeof(float[PLANE_TERMS][LANES]);
}

/* A primitive as its fragments see it: a lane of a set-up, unnumbered if there is only one. */
typedef struct raster_primitive {
    const primitive_setup *setup;
#if LANES > 1
    uint32_t lane;
#endif
} raster_primitive;

static inline raster_primitive primitive_in(const primitive_setup *setup, uint32_t lane)
{
    raster_primitive p;

    p.setup = setup;
#if LANES > 1
    p.lane = lane;
#else
    (void)lane;
#endif
    return p;
}

static inline uint32_t lane_of(raster_primitive p)
{
#if LANES > 1
    return p.lane;
#else
    (void)p;
    return 0;
#endif
}

static inline attribute_plane primitive_plane(raster_primitive p, uint32_t n)
{
    const uint32_t l = lane_of(p);
    const float(*const term)[LANES] = p.setup->plane[n];
    const attribute_plane plane = {term[PLANE_ORIGIN][l], term[PLANE_PER_X][l],
                                   term[PLANE_PER_Y][l]};

    return plane;
}

/* Returns whether a flag, one of PRIMITIVE_IS_.., is set. */
static inline bool primitive_is(raster_primitive p, int32_t flag)
{
    return (p.setup->flags[lane_of(p)] & flag) != 0;
}

/* A block of a primitive and its covered pixels: bit l of half h is lane l + 8 * h. */
typedef struct covered_block {
    uint32_t lane; /* of the set-up */
    pixel_block at;
    uint32_t covered[2];
} covered_block;

/* Returns the covered pixels of both halves. */
static inline uint32_t covered_lanes(const covered_block *block)
{
    return block->covered[0] | block->covered[1] << HALF_LANES;
}

#endif
