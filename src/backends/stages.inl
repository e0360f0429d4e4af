/* The stages of a back end: the text that each back end compiles for its own lanes. The file that
 * includes this first defines its form of lanes and the names of its two functions, GN_RUN and
 * GN_BULK. */
#include "../lanes/target_begin.inl"

#include "stages.h"

#include "../kernel/draw/mesh.inl"
#include "../kernel/math/bulk.inl"

gn_status GN_RUN(const draw_job *job)
{
    return draw_mesh(job);
}

void GN_BULK(const bulk_job *job)
{
    run_bulk(job);
}

#include "../lanes/target_end.inl"
