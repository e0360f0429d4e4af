/* The stages over the registers of 64-bit Arm's Advanced SIMD. */
#include "../config/have.h"
#include "stages.h"

#if GN_HAVE_NEON
#define GN_LANES_NEON
#include "../draw/mesh.h"
#include "../math/bulk.h"

gn_status gn_run_neon(const draw_job *job)
{
    return draw_mesh(job);
}

void gn_bulk_neon(const bulk_job *job)
{
    run_bulk(job);
}
#endif
