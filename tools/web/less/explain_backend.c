/* In the module that explains pixels, stands in for the library's portable back end and for its
 * sampling: the tracing back end draws shadow maps too, without recording, and samples itself. */
#include "../../../src/backends/shading.h"
#include "../../../src/backends/stages.h"
#include "../../explain/stages.h"

gn_status gn_run_portable(const draw_job *job)
{
    return stages_run(job);
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

void gn_gather(const gn_texture *texture, const gn_sampler *sampler, const gn_lookup *lookup,
               int channel, float texel[4][GN_LANES])
{
    (void)texture, (void)sampler, (void)lookup, (void)channel, (void)texel;
}

void gn_fetch(const gn_texture *texture, const int32_t *const coordinate[3], const int32_t *level,
              float texel[4][GN_LANES])
{
    (void)texture, (void)coordinate, (void)level, (void)texel;
}
