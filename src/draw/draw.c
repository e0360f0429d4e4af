/* The draw: validates, chooses a back end and hands it the job. */
#include "gnomon/draw.h"

#include "../backends/have.h"
#include "job.h"

/* Batches must be aligned for their floats; a cache line serves lanes best. */
#define BATCH_ALIGNMENT 64

size_t gn_workspace_size(uint32_t vertex_count, uint32_t varying_count)
{
    const uint64_t batches =
        ((uint64_t)vertex_count + GN_LANES - 1) / GN_LANES + (vertex_count == 0 ? 2 : 1);
    const uint64_t batch = (GN_WORKSPACE_VERTEX_SIZE + 4 * (uint64_t)varying_count) * GN_LANES;

    /* At most 2^28 batches of 2752 bytes, where varying_count is within its limit. */
    if (varying_count > GN_MAX_VARYINGS || batches * batch > SIZE_MAX - BATCH_ALIGNMENT)
        return SIZE_MAX;
    return (size_t)(batches * batch) + BATCH_ALIGNMENT;
}

static void run_on(gn_backend backend, const draw_job *job)
{
    switch (backend) {
#if GN_HAVE_AVX2
    case GN_BACKEND_AVX2:
        gn_run_avx2(job);
        break;
#endif
#if GN_HAVE_SSE2
    case GN_BACKEND_SSE2:
        gn_run_sse2(job);
        break;
#endif
    default:
        gn_run_portable(job);
        break;
    }
}

gn_status gn_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                  gn_workspace *workspace)
{
    gn_status status = gn_target_check(target);

    if (!status)
        status = gn_pipeline_check(pipeline);
    if (!status)
        status = gn_mesh_check(mesh);
    if (status)
        return status;
    if (target->color.format != GN_FORMAT_NONE && !pipeline->fragment_shader)
        return GN_NO_SHADER;
    if (!workspace || !workspace->memory)
        return GN_NULL_POINTER;
    const size_t least = gn_workspace_size(0, pipeline->varying_count);
    if (workspace->size < least) {
        workspace->needed = least;
        return GN_WORKSPACE_TOO_SMALL;
    }

    gn_backend backend = workspace->backend;
    if (backend == GN_BACKEND_AUTO)
        backend = gn_backend_best();
    else if (!gn_backend_available(backend))
        return GN_BACKEND_UNAVAILABLE;

    const size_t skip = (0 - (uintptr_t)workspace->memory) & (BATCH_ALIGNMENT - 1);
    const size_t batch_size = vertex_batch_size(pipeline->varying_count);
    const size_t batches = (workspace->size - skip) / batch_size - 1;
    const uint32_t limit = UINT32_MAX / GN_LANES / 2;
    draw_job job;

    job.target = target;
    job.pipeline = pipeline;
    job.mesh = mesh;
    job.store.memory = (unsigned char *)workspace->memory + skip;
    job.store.batch_size = batch_size;
    job.capacity = batches < limit ? (uint32_t)batches : limit;
    run_on(backend, &job);
    return GN_OK;
}
