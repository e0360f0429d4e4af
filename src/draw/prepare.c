/* Prepares a draw: checks the arguments and divides the workspace. */
#include "prepare.h"

#include "../config/features.h"
#include "../kernel/geometry/assemble.h"
#include "check.h"

/* A cache line. */
#define WORKSPACE_ALIGNMENT 64

/* About how many triangles a round has: enough to be worth its phases, few enough for their
 * vertices and lists to stay in the cache. A closed surface has half as many vertices as triangles,
 * so the vertices of two rounds fit a ring of 65,536. */
#define ROUND_PRIMITIVES 57344

/* The number of threads that is assumed if the caller does not state it. */
#define UNKNOWN_THREADS 8

/* Offsets of vertices have 32 bits; this is a round number below that. */
#define MEMORY_LIMIT ((uint64_t)UINT32_MAX - 65535)

/* A draw stores at least the three vertices of a triangle together. */
static uint64_t vertices_size(uint32_t vertex_count, uint32_t varying_count)
{
    const uint32_t stored = vertex_count > 3 ? vertex_count : 3;
    const uint64_t packets = ((uint64_t)stored - 1) / GN_LANES + 1;

    return packets * GN_LANES * vertex_stride(varying_count);
}

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

/* Returns how many lists hold a segment's primitives; the last one is never full. */
static uint32_t lists_per_segment(uint32_t primitives)
{
    return primitives / GN_LANES + 1;
}

static uint32_t list_rows_per_segment(uint32_t primitives)
{
    return (lists_per_segment(primitives) - 1) / GN_LANES + 1;
}

static uint64_t segment_size(uint32_t primitives)
{
    return sizeof(segment_sums) + (uint64_t)lists_per_segment(primitives) * sizeof(primitive_list) +
           (uint64_t)list_rows_per_segment(primitives) * sizeof(rows_of_lists);
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

/* Returns how many segments of a round fit `memory`, which the tasks' scratch leaves, beside the
 * vertices: all vertices of the draw if they fit, otherwise those of the round's segments. */
static uint64_t round_segments_in(const draw_job *job, uint64_t memory)
{
    const mesh_slice *mesh = job->mesh;
    const bool indexed = mesh->index_format != GN_INDEX_NONE;
    const uint32_t elements = segment_elements(job->pipeline->raster.topology, mesh);
    const uint32_t varyings = stored_values(job->pipeline);
    const uint64_t segment = segment_size(primitives_of(job->pipeline->raster.topology, elements));
    const uint64_t all_vertices =
        vertices_size(indexed ? mesh->vertex_count : mesh->count, varyings);

    if (memory >= all_vertices + segment)
        return (memory - all_vertices) / segment;
    return memory / (segment + vertices_size(elements, varyings));
}

/* Divides the memory for tasks, if tasks are asked for and fit. Returns the bytes before the
 * vertices. */
static uint32_t divide_for_tasks(draw_job *job, uint64_t available)
{
    const uint32_t varyings = stored_values(job->pipeline);
    const uint32_t elements = segment_elements(job->pipeline->raster.topology, job->mesh);
    const uint32_t per_segment = primitives_of(job->pipeline->raster.topology, elements);
    const uint32_t total = primitive_count(job->pipeline->raster.topology, job->mesh->count);
    const uint64_t scratch = MAX_TASKS * (uint64_t)scratch_size(varyings);
    /* Aligning the end of the lists may take this much more. */
    const uint64_t taken = scratch + WORKSPACE_ALIGNMENT - 1;
    uint64_t segments = 0;

    if (GN_HAVE_TASKS && available >= taken)
        segments = round_segments_in(job, available - taken);

    segments = segments < total / per_segment + 1 ? segments : total / per_segment + 1;
    segments = segments < ROUND_PRIMITIVES / per_segment + 1 ? segments
                                                             : ROUND_PRIMITIVES / per_segment + 1;
    if (!job->parallel || segments == 0) {
        job->parallel = NULL;
        return scratch_size(varyings);
    }
    job->segment_count = (uint32_t)segments;
    job->lists_per_segment = lists_per_segment(per_segment);
    job->list_rows_per_segment = list_rows_per_segment(per_segment);

    const uint64_t lists = scratch + segments * sizeof(segment_sums);
    const uint64_t rows = lists + segments * job->lists_per_segment * sizeof(primitive_list);
    job->segments = (segment_sums *)(void *)(job->memory + scratch);
    job->lists = (primitive_list *)(void *)(job->memory + lists);
    job->list_rows = (rows_of_lists *)(void *)(job->memory + rows);

    const uint64_t end = scratch + segments * segment_size(per_segment);
    return (uint32_t)(end + WORKSPACE_ALIGNMENT - 1) & ~(uint32_t)(WORKSPACE_ALIGNMENT - 1);
}

static void divide_workspace(draw_job *job, const gn_workspace *workspace)
{
    const size_t skip = (0 - (uintptr_t)workspace->memory) & (WORKSPACE_ALIGNMENT - 1);
    const uint64_t given = workspace->size - skip;
    const uint32_t available = (uint32_t)(given < MEMORY_LIMIT ? given : MEMORY_LIMIT);
    const uint32_t packet_size = GN_LANES * vertex_stride(stored_values(job->pipeline));

    job->memory = (unsigned char *)workspace->memory + skip;
    job->parallel = GN_HAVE_TASKS ? workspace->parallel : NULL;
    job->user = workspace->user;
    job->threads = workspace->threads > 0 ? workspace->threads : UNKNOWN_THREADS;
    job->samples_passed = workspace->samples_passed;
    job->statistics = workspace->statistics;
    job->slots_offset = divide_for_tasks(job, available);
    job->capacity = (available - job->slots_offset) / packet_size * GN_LANES;
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
    divide_workspace(job, workspace);
    return GN_OK;
}
