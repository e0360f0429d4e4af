/* Makes a job for a back end from the arguments of gn_draw. */
#ifndef GN_DRAW_PREPARE_H
#define GN_DRAW_PREPARE_H

#include <gnomon/draw.h>

#include "../kernel/draw/job.h"

/* Checks the arguments of gn_draw and fills in all of `job` but its shading and, if its `parallel`
 * becomes null, the segments of a round. Returns the statuses of gn_draw except
 * GN_BACKEND_UNAVAILABLE and faults of index values. With GN_WORKSPACE_TOO_SMALL,
 * workspace->size_needed is written. With any status but GN_OK, `job` and `whole` are unspecified.
 * The job points to target, pipeline and `whole`, and to what mesh and workspace point to. */
gn_status gni_prepare_draw(draw_job *job, mesh_slice *whole, const gn_target *target,
                           const gn_pipeline *pipeline, const gn_mesh *mesh,
                           gn_workspace *workspace);

#endif
