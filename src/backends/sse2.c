/* The stages over SSE2 registers. */
#include "have.h"

#include "../draw/job.h"

#if GN_HAVE_SSE2
#include "../draw/run.h"

gn_status gn_run_sse2(const draw_job *job)
{
    return run_draw(job);
}
#endif
