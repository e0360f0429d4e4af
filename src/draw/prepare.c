/* Prepares a draw: checks the arguments. Sizes of workspaces. */
#include "prepare.h"

#include "../config/features.h"
#include "../kernel/draw/workspace.h"
#include "check.h"

/* Offsets of vertices have 32 bits; this is a round number below that. */
#define MEMORY_LIMIT ((uint64_t)UINT32_MAX - 65535)

/* The number of threads that is assumed if the caller does not state it. */
#define UNKNOWN_THREADS 8

static size_t as_size(uint64_t size)
{
    return size < SIZE_MAX ? (size_t)size : SIZE_MAX;
}

size_t gn_workspace_size(uint32_t vertex_count, uint32_t varying_count)
{
    if (varying_count > GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES)
        return SIZE_MAX;
    return as_size(WORKSPACE_ALIGNMENT + scratch_size(varying_count) +
                   vertices_size(vertex_count, varying_count));
}

size_t gn_workspace_size_parallel(uint32_t vertex_count, uint32_t triangle_count,
                                  uint32_t varying_count)
{
    const uint32_t round = triangle_count < ROUND_PRIMITIVES ? triangle_count : ROUND_PRIMITIVES;
    const uint32_t shortest = primitives_of(GN_TRIANGLES, SEGMENT_INDICES);
    const uint32_t longest = primitives_of(GN_POINTS, SEGMENT_ELEMENTS);

    if (varying_count > GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES)
        return SIZE_MAX;
    /* As many of the shortest segments as make a round, and one of the longest. */
    return as_size(WORKSPACE_ALIGNMENT + MAX_TASKS * (uint64_t)scratch_size(varying_count) +
                   (round / shortest + 1) * segment_size(shortest) + segment_size(longest) +
                   vertices_size(vertex_count, varying_count));
}

static void take_workspace(draw_job *job, const gn_workspace *workspace)
{
    const size_t skip = (0 - (uintptr_t)workspace->memory) & (WORKSPACE_ALIGNMENT - 1);
    const uint64_t given = workspace->size - skip;

    job->memory = (unsigned char *)workspace->memory + skip;
    job->memory_size = (uint32_t)(given < MEMORY_LIMIT ? given : MEMORY_LIMIT);
    job->parallel = GN_HAVE_TASKS ? workspace->parallel : NULL;
    job->user = workspace->user;
    job->threads = workspace->threads > 0 ? workspace->threads : UNKNOWN_THREADS;
    job->samples_passed = workspace->samples_passed;
    job->statistics = workspace->statistics;
}

/* Sets `whole` to all elements of the mesh, in the first instance. */
static void set_whole_mesh(mesh_slice *whole, const gn_mesh *mesh)
{
    const bool indexed = mesh->index_format != GN_INDEX_NONE;

    whole->attribute = mesh->attribute;
    whole->vertex_count = mesh->vertex_count;
    whole->indices = mesh->indices;
    whole->index_format = mesh->index_format;
    whole->first = mesh->first;
    whole->count = mesh->count;
    whole->base = indexed ? (uint32_t)mesh->base_vertex : 0;
    whole->instance = 0;
    whole->primitive = 0;
    whole->restarts = indexed && mesh->restart != GN_RESTART_NONE;
    whole->restart_index = GN_HAVE_INSTANCES && whole->restarts ? restart_index_of(mesh) : 0;
}

gn_status gni_prepare_draw(draw_job *job, mesh_slice *whole, const gn_target *target,
                           const gn_pipeline *pipeline, const gn_mesh *mesh,
                           gn_workspace *workspace)
{
    gn_status status = gn_target_check(target);

    if (!status)
        status = gn_pipeline_check(pipeline, target);
    if (!status)
        status = gni_check_mesh_except_indices(mesh);
    if (status)
        return status;
    const size_t least = gn_workspace_size(0, stored_values(pipeline));
    status = gni_check_workspace(workspace, least);
    if (status == GN_WORKSPACE_TOO_SMALL)
        workspace->size_needed = least;
    if (status)
        return status;

    set_whole_mesh(whole, mesh);
    job->target = target;
    job->pipeline = pipeline;
    job->mesh = whole;
    job->instances = mesh->instance_count > 0 ? mesh->instance_count : 1;
    take_workspace(job, workspace);
    return GN_OK;
}
