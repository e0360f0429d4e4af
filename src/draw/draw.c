/* gn_draw: prepares the draw, chooses a back end and passes the job to it. */
#include <gnomon/draw.h>

#include "one_lane.h"
#include "prepare.h"
#include "../backends/entry_points.h"

/* Returns the back end of the workspace. Asking the processor can take longer than a draw, so the
 * workspace keeps the answer. */
static gn_backend backend_of(gn_workspace *workspace)
{
    if (workspace->backend != GN_BACKEND_AUTO)
        return workspace->backend;
    if (workspace->chosen_backend == GN_BACKEND_AUTO)
        workspace->chosen_backend = gn_backend_best();
    return workspace->chosen_backend;
}

gn_status gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                  gn_workspace *workspace)
{
    draw_job job;
    mesh_slice whole;
    const gn_status status = gni_prepare_draw(&job, &whole, target, pipeline, mesh, workspace);

    if (status)
        return status;
    const gn_backend backend = backend_of(workspace);

    if (GN_HAVE_ONE_LANE && backend == GN_BACKEND_PORTABLE && draws_one_lane(target, pipeline)) {
        gni_shading_one_lane(pipeline, &job.shading);
        return gni_draw_one_lane(&job);
    }
    shading_on(backend, pipeline, &job.shading);
    return draw_on(backend, &job);
}
