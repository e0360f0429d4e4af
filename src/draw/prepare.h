/* From what a caller gives to a job for a back end. */
#ifndef GN_DRAW_PREPARE_H
#define GN_DRAW_PREPARE_H

#include "gnomon/draw.h"

#include "job.h"

/* Checks what gn_draw is given and fills in all of `job` but its shading. Returns what gn_draw
 * documents, but for GN_BACKEND_UNAVAILABLE and what stages find in the indices; with a status
 * other than GN_OK `job` and `whole` are unspecified. The job points to all arguments, and to
 * `whole` for its mesh. */
gn_status gn_prepare_draw(draw_job *job, mesh_run *whole, const gn_target *target,
                          const gn_pipeline *pipeline, const gn_mesh *mesh,
                          gn_workspace *workspace);

#endif
