/* gn_draw: prepares the draw, chooses a back end and passes the job to it. */
#include <gnomon/draw.h>

#include "../config/backends.h"
#include "../config/features.h"
#include "prepare.h"
#include "../backends/entry_points.h"

#if !GN_SPECIALISED
/* Fills in the public functions of lookups and the pipeline's shaders, whatever the back end.
 * With GN_BASIC only gn_texture_lookup_2d is there. */
static void shading_on(gn_backend backend, const gn_pipeline *pipeline, shading_functions *out)
{
    (void)backend;
    out->texture_functions.lookup_2d = gn_texture_lookup_2d;
    out->texture_functions.lookup = GN_HAVE_TEXTURES ? gn_texture_lookup : 0;
    out->texture_functions.gather = GN_HAVE_TEXTURES ? gn_texture_gather : 0;
    out->texture_functions.fetch = GN_HAVE_TEXTURES ? gn_texture_fetch : 0;
    out->vertex_shader = pipeline->program.vertex_shader;
    out->fragment_shader = pipeline->program.fragment_shader;
}
#endif

/* Returns the back end of the workspace. Asking the processor can take longer than a draw, so the
 * workspace keeps the answer. */
static gn_backend chosen(gn_workspace *workspace)
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
    const gn_backend backend = chosen(workspace);

    shading_on(backend, pipeline, &job.shading);
    return draw_on(backend, &job);
}
