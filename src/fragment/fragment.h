/* The fragment stages: from a block of covered fragments to the surfaces.
 *
 *   block   interpolates, runs the fragment shader, hands on
 *   depth   depth test and depth write
 *   color   conversion to the colour format and write */
#ifndef GN_FRAGMENT_FRAGMENT_H
#define GN_FRAGMENT_FRAGMENT_H

#include "../lanes/lanes.h"
#include "../raster/raster.h"

/* The depth test of a draw, resolved once: which outcomes of incoming against
 * stored pass, each all ones or zero. */
typedef struct depth_state {
    bool enabled;
    bool write;
    uint32_t pass_less, pass_equal, pass_greater;
} depth_state;

typedef struct fragment_state {
    const gn_pipeline *pipeline;
    const gn_target *target;
    depth_state depth;
} fragment_state;

fragment_state gn_fragment_state(const gn_target *target, const gn_pipeline *pipeline);

/* A block_function (raster.h); the context is a fragment_state. */
void gn_shade_block(void *context, const raster_triangle *triangle, int32_t x, int32_t y,
                    uint32_t coverage);

depth_state gn_depth_state(const gn_target *target, const gn_pipeline *pipeline);

/* Tests a block's depths against a surface and writes those that pass, where the
 * state says so. Gives the part of coverage that passed. */
uint32_t gn_test_depth(const depth_state *state, const gn_surface *surface, int32_t x, int32_t y,
                       uint32_t coverage, lanes_f depth);

/* Depths as a surface's format holds them, in the low bits: D16 and D24 rounded,
 * D32F as the float's bits, which order as integers do. Clamped to 0..1. */
lanes_i gn_quantize_depth(gn_format format, lanes_f depth);

/* Converts a block's colour and writes the covered pixels. */
void gn_write_color(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                    float (*color)[GN_LANES]);

/* Whether all of the block at (x, y) lies on a surface, so that it may be loaded and
 * stored whole; blocks hang over the right and the top edge of odd sizes. */
static inline bool surface_holds_block(const gn_surface *surface, int32_t x, int32_t y)
{
    return (uint32_t)x + BLOCK_SIZE <= surface->width &&
           (uint32_t)y + BLOCK_SIZE <= surface->height;
}

/* The memory of row y of a surface. */
static inline unsigned char *surface_row(const gn_surface *surface, uint32_t y)
{
    return (unsigned char *)surface->pixels + (ptrdiff_t)y * surface->row_stride;
}

#endif
