/* The stages over SSE2 registers. */
#include "../config/have.h"
#include "stages.h"

#if GN_HAVE_SSE2
#include "../draw/mesh.h"
#include "../math/bulk.h"

gn_status gn_run_sse2(const draw_job *job)
{
    return draw_mesh(job);
}

void gn_bulk_sse2(const bulk_job *job)
{
    run_bulk(job);
}
#endif
