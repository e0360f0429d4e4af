/* In the module that explains pixels, stands in for src/backends/draw.c and the library's back ends:
 * the tracing back end draws everything, shadow maps without recording and the picture at its pixel
 * alone. */
#include "../../../src/backends/stages.h"
#include "../../explain/stages.h"
#include "../../explain/traced_scene.h"
#include "../../explain/tracing.h"

gn_status gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                  gn_workspace *workspace)
{
    return pixel.is_drawn ? traced_draw(target, pipeline, mesh, workspace)
                          : stages_draw(target, pipeline, mesh, workspace);
}

gn_status traced_scene_draw(const scene *s, const gn_target *target, gn_workspace *workspace)
{
    pixel.is_drawn = true;
    const gn_status status = scene_draw_to_target(s, target, workspace);

    pixel.is_drawn = false;
    return status;
}

/* No function of the page works on blocks of vectors. */
void gn_bulk_portable(const bulk_job *job)
{
    (void)job;
}

/* Nothing outside the stages samples. */
void gn_sample_2d(const gn_texture *texture, const gn_sampler *sampler, const float s[GN_LANES],
                  const float t[GN_LANES], float texel[4][GN_LANES])
{
    (void)texture, (void)sampler, (void)s, (void)t, (void)texel;
}

void gn_sample(const gn_texture *texture, const gn_sampler *sampler, const gn_lookup *lookup,
               float texel[4][GN_LANES])
{
    (void)texture, (void)sampler, (void)lookup, (void)texel;
}
