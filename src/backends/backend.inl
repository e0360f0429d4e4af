/* A back end: the text that each back end compiles for its own lanes. The file that includes this
 * first defines its form of lanes and the names of its entry points (entry_points.h): GN_DRAW,
 * GN_BULK and GN_SHADING. Without GN_SHADING there is no shading. */
#include "../lanes/target_begin.inl"

#include "entry_points.h"

#include "../kernel/draw/mesh.inl"
#include "../kernel/math/bulk.inl"

gn_status GN_DRAW(const draw_job *job)
{
    return draw_mesh(job);
}

void GN_BULK(const bulk_job *job)
{
    run_bulk(job);
}

#include "../lanes/target_end.inl"
