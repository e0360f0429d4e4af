/* The draw: prepares it, chooses a back end and hands it the job. */
#include "gnomon/draw.h"

#include "../config/have.h"
#include "../config/small.h"
#include "../draw/prepare.h"
#include "shading.h"
#include "stages.h"

/* Where the back end is none of these, run_on says so. Small builds take the functions that every
 * caller has: with GN_BASIC those for 2D textures alone. */
static void fill_shading_of(gn_backend backend, const gn_pipeline *pipeline, shading_functions *out)
{
#if !GN_SPECIALISED
    (void)backend;
    out->sampling.sample_2d = gn_sample_2d;
    out->sampling.sample = GN_HAVE_TEXTURES ? gn_sample : 0;
    out->sampling.gather = GN_HAVE_TEXTURES ? gn_gather : 0;
    out->sampling.fetch = GN_HAVE_TEXTURES ? gn_fetch : 0;
    out->vertex_shader = pipeline->vertex_shader;
    out->fragment_shader = pipeline->fragment_shader;
#else
    switch (backend) {
#if GN_HAVE_WASM_SIMD128
    case GN_BACKEND_WASM_SIMD128:
        gn_shading_wasm_simd128(pipeline, out);
        return;
#endif
#if GN_HAVE_NEON
    case GN_BACKEND_NEON:
        gn_shading_neon(pipeline, out);
        return;
#endif
#if GN_HAVE_AVX512
    case GN_BACKEND_AVX512:
        gn_shading_avx512(pipeline, out);
        return;
#endif
#if GN_HAVE_AVX2
    case GN_BACKEND_AVX2:
        gn_shading_avx2(pipeline, out);
        return;
#endif
#if GN_HAVE_SSE2
    case GN_BACKEND_SSE2:
        gn_shading_sse2(pipeline, out);
        return;
#endif
    default:
        gn_shading_portable(pipeline, out);
    }
#endif
}

/* Calls, not a choice of function: some compilers make a table of that, to be relocated. */
static gn_status run_on(gn_backend backend, const draw_job *job)
{
    switch (backend) {
#if GN_HAVE_WASM_SIMD128
    case GN_BACKEND_WASM_SIMD128:
        return gn_run_wasm_simd128(job);
#endif
#if GN_HAVE_NEON
    case GN_BACKEND_NEON:
        return gn_run_neon(job);
#endif
#if GN_HAVE_AVX512
    case GN_BACKEND_AVX512:
        return gn_run_avx512(job);
#endif
#if GN_HAVE_AVX2
    case GN_BACKEND_AVX2:
        return gn_run_avx2(job);
#endif
#if GN_HAVE_SSE2
    case GN_BACKEND_SSE2:
        return gn_run_sse2(job);
#endif
    case GN_BACKEND_PORTABLE:
        return gn_run_portable(job);
    default:
        return GN_BACKEND_UNAVAILABLE;
    }
}

gn_status gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                  gn_workspace *workspace)
{
    draw_job job;
    mesh_slice whole;
    const gn_status status = gn_prepare_draw(&job, &whole, target, pipeline, mesh, workspace);

    if (status)
        return status;
    const gn_backend backend =
        workspace->backend == GN_BACKEND_AUTO ? gn_backend_best() : workspace->backend;

    fill_shading_of(backend, pipeline, &job.shading);
    return run_on(backend, &job);
}
