/* Which draws are drawn over one lane. */
#ifndef GN_DRAW_ONE_LANE_H
#define GN_DRAW_ONE_LANE_H

#include <gnomon/pipeline.h>

#include "../config/features.h"
#include "../formats/surface_memory.h"

/* Returns whether the form of one lane draws the pipeline: no fragment needs its neighbours, and
 * only filled triangles with one sample a pixel are drawn. Precondition: target and pipeline are
 * checked. */
static inline bool draws_one_lane(const gn_target *target, const gn_pipeline *pipeline)
{
    const gn_raster *const raster = &pipeline->raster;
    const gn_program *const program = &pipeline->program;

    return GN_HAVE_ONE_LANE && program->needs_quads && raster->topology <= GN_TRIANGLE_FAN &&
           raster->polygon_mode_front == GN_POLYGON_FILL &&
           raster->polygon_mode_back == GN_POLYGON_FILL && samples_of(first_surface(target)) == 1 &&
           !program->needs_quads(program);
}

#endif
