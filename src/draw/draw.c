/* gn_draw: prepares the draw, chooses a back end and passes the job to it. */
#include <gnomon/draw.h>

#include "../config/backends.h"
#include "../config/features.h"
#include "prepare.h"
#include "../backends/shading_forms.h"
#include "../backends/stages.h"

#if GN_SPECIALISED
#define FILL_SHADING(name, job) gni_shading_##name((job)->pipeline, &(job)->shading)
#else
#define FILL_SHADING(name, job) fill_shading((job)->pipeline, &(job)->shading)

/* Fills in the public functions of lookups and the pipeline's shaders. With GN_BASIC only
 * gn_texture_lookup_2d is there. */
static void fill_shading(const gn_pipeline *pipeline, shading_functions *out)
{
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

    /* Calls gni_shading_<name> and gni_run_<name> of the back end, by name: some compilers turn a
     * choice of function into a table that needs relocation. */
#define RUN_ON(name, NAME)                                                                         \
    if (backend == GN_BACKEND_##NAME) {                                                            \
        FILL_SHADING(name, &job);                                                                  \
        return gni_run_##name(&job);                                                               \
    }
    GN_COMPILED_BACKENDS(RUN_ON)
#undef RUN_ON
    return GN_BACKEND_UNAVAILABLE;
}
