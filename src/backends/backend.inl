/* A back end: the text that each back end compiles for its own lanes. The file that includes this
 * first defines its form of lanes and the names of its entry points (entry_points.h): GN_DRAW,
 * GN_BULK. Without GN_BULK there are no operations on many vectors. */
#include "../lanes/target_begin.inl"

#include "entry_points.h"

#include "../kernel/draw/mesh.inl"
#if defined(GN_BULK)
#include "../kernel/math/bulk.inl"
#endif

gn_status GN_DRAW(const draw_job *job)
{
    return draw_mesh(job);
}

#if defined(GN_BULK)
void GN_BULK(const bulk_job *job)
{
    run_bulk(job);
}
#endif

#include "../lanes/target_end.inl"
