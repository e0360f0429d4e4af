/* The stages in plain C. */
#include "stages.h"

#define GN_LANES_PORTABLE
#include "../draw/mesh.h"
#include "../math/bulk.h"

gn_status gn_run_portable(const draw_job *job)
{
    return draw_mesh(job);
}

void gn_bulk_portable(const bulk_job *job)
{
    run_bulk(job);
}
