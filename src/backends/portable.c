/* The stages in plain C. */
#define GN_LANES_PORTABLE

#include "../draw/run.h"

void gn_run_portable(const draw_job *job)
{
    run_draw(job);
}
