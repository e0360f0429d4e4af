/* Draws a batch of views. One view is drawn by all threads; of several views, each is drawn by one
 * thread, which takes the next one that nobody has taken. */
#include "views.h"

#include <fenv.h>
#include <stdatomic.h>
#include <string.h>

#include "../../../threads/pool.h"

#define ALIGNMENT 64

/* Colours of the geometry pass. */
enum { NORMAL, LABEL, GEOMETRY_COLORS };

/* The varying of the ready-made vertex shader that holds the normal's x. */
enum { VARYING_NORMAL = 6 };

/* What the geometry pass' shaders read; the ready-made one reads the beginning. */
typedef struct geometry_uniforms {
    gn_lit_uniforms lit;
    const views_part *part;
} geometry_uniforms;

/* What the threads share. */
typedef struct views_run {
    views_job *job;
    unsigned char *memory;
    size_t thread_size, workspace_size;
    thread_pool *pool; /* that draws the only view; otherwise null */
    uint32_t threads;
    gn_backend backend; /* asked for once, not for every view */
    atomic_uint next;
    atomic_flag failed;
} views_run;

static size_t rounded(size_t size)
{
    return (size + ALIGNMENT - 1) & ~(size_t)(ALIGNMENT - 1);
}

static uint32_t samples(const views_job *job)
{
    return job->smooth_edges ? GN_SAMPLES : 1;
}

/* The parts of a thread's memory: depth, samples of colours, the workspace. */
static size_t depth_size(const views_job *job)
{
    return rounded((size_t)job->width * job->height * samples(job) * sizeof(float));
}

static size_t color_size(const views_job *job)
{
    return job->smooth_edges ? rounded((size_t)job->width * job->height * GN_SAMPLES * 4) : 0;
}

/* The largest that a part needs: parts are drawn one after the other. */
static size_t workspace_size(const views_job *job, uint32_t threads)
{
    size_t most = 0;

    for (uint32_t i = 0; i < job->part_count; ++i) {
        const gn_mesh *const mesh = &job->part[i].mesh;
        const size_t size = threads > 1 && job->count == 1
                                ? gn_workspace_size_parallel(mesh->vertex_count, mesh->count / 3,
                                                             GN_SHADER_VARYINGS)
                                : gn_workspace_size(mesh->vertex_count, GN_SHADER_VARYINGS);

        most = size > most ? size : most;
    }
    return rounded(most);
}

static uint32_t parts(const views_job *job, uint32_t threads)
{
    return job->count < threads ? job->count : threads;
}

size_t views_memory(const views_job *job, uint32_t threads)
{
    const size_t one = depth_size(job) + color_size(job) + workspace_size(job, threads);

    if (one > (SIZE_MAX - ALIGNMENT) / THREAD_POOL_MOST)
        return SIZE_MAX;
    return one * parts(job, threads) + ALIGNMENT;
}

static void shade_geometry(const void *uniforms, const gn_fragment_input *in,
                           gn_fragment_output *out)
{
    const geometry_uniforms *const u = uniforms;
    const views_part *const part = u->part;
    const uint32_t face = in->primitive_id;
    const int32_t label = part->labels ? part->labels[face] : part->first_label + (int32_t)face;
    const float *const flat = part->face_normals ? part->face_normals + 3 * (size_t)face : NULL;
    float bits;

    memcpy(&bits, &label, sizeof bits);
    for (int l = 0; l < GN_LANES; ++l) {
        gn_vec3 n = {flat ? flat[0] : in->varying[VARYING_NORMAL][l],
                     flat ? flat[1] : in->varying[VARYING_NORMAL + 1][l],
                     flat ? flat[2] : in->varying[VARYING_NORMAL + 2][l]};
        const float square = n.x * n.x + n.y * n.y + n.z * n.z;
        const float scale = square > 0.0f ? gn_rsqrt(square) : 0.0f;

        out->color[4 * NORMAL][l] = n.x * scale;
        out->color[4 * NORMAL + 1][l] = n.y * scale;
        out->color[4 * NORMAL + 2][l] = n.z * scale;
        out->color[4 * LABEL][l] = bits;
    }
}

/* Keeps the first fault. */
static bool fail(views_run *run, gn_status error, const char *fault)
{
    if (!atomic_flag_test_and_set(&run->failed)) {
        run->job->fault = fault;
        run->job->error = error;
    }
    return false;
}

static bool draw(views_run *run, const gn_target *target, const gn_pipeline *pipeline,
                 const gn_mesh *mesh, gn_workspace *workspace)
{
    const gn_status status = gn_draw(target, pipeline, mesh, workspace);

    if (status == GN_OK)
        return true;
    return fail(run, status, gn_draw_fault(target, pipeline, mesh, workspace));
}

static gn_surface picture(const views_job *job, void *pixels, gn_format format, uint32_t view)
{
    const size_t size = gn_format_size(format) * job->width * job->height;

    return gn_surface_top_down(pixels ? (unsigned char *)pixels + size * view : NULL,
                               pixels ? format : GN_FORMAT_NONE, job->width, job->height);
}

static void set_state(gn_pipeline *pipeline, const views_job *job)
{
    pipeline->raster = job->raster;
    pipeline->depth.test_enabled = true;
    if (job->reversed) {
        pipeline->depth.function = GN_GREATER;
        pipeline->depth.clip_depth = GN_ZERO_TO_ONE;
    }
}

static float farthest(const views_job *job)
{
    return job->reversed ? 0.0f : 1.0f;
}

static gn_surface depth_of_view(const views_job *job, void *depth)
{
    return gn_surface_top_down(depth, GN_FORMAT_D32F, job->width, job->height);
}

static gn_mat4 clip_from_model(const views_job *job, uint32_t view, const views_part *part)
{
    gn_mat4 result;

    gn_mat4_multiply(&job->camera[view].clip_from_world, &part->world_from_model, &result);
    return result;
}

/* All passes take positions from the library's vertex shaders, so that their depths are equal. */
static bool draw_geometry_of(views_run *run, uint32_t view, const views_part *part,
                             const gn_target *target, gn_workspace *workspace)
{
    const views_job *const job = run->job;
    const gn_color_uniforms color_uniforms = {clip_from_model(job, view, part)};
    geometry_uniforms uniforms;
    gn_pipeline pipeline;

    memset(&uniforms, 0, sizeof uniforms);
    memset(&pipeline, 0, sizeof pipeline);
    set_state(&pipeline, job);
    if (!job->normals && !job->labels_drawn) {
        gn_use_depth_only(&pipeline, &color_uniforms);
        return draw(run, target, &pipeline, &part->mesh, workspace);
    }
    uniforms.lit.clip_from_model = color_uniforms.clip_from_model;
    uniforms.lit.world_from_model = part->world_from_model;
    uniforms.lit.normal_matrix = part->normal_matrix;
    uniforms.part = part;
    gn_use_normal_color(&pipeline, &uniforms.lit);
    pipeline.program.fragment_shader = shade_geometry;
    pipeline.program.uniforms = &uniforms;
    pipeline.program.color_count = GEOMETRY_COLORS;
    pipeline.program.fragment_reads_primitive = true;
    return draw(run, target, &pipeline, &part->mesh, workspace);
}

/* Draws normals and labels, or only depth if neither is wanted. */
static bool draw_geometry(views_run *run, uint32_t view, void *depth, gn_workspace *workspace)
{
    views_job *const job = run->job;
    gn_target target;

    memset(&target, 0, sizeof target);
    target.depth = depth_of_view(job, depth);
    gn_clear_depth(&target.depth, farthest(job));
    if (job->normals || job->labels_drawn) {
        target.color[NORMAL] = picture(job, job->normals, GN_FORMAT_RGBA32F, view);
        target.color[LABEL] = picture(job, job->labels_drawn, GN_FORMAT_R32F, view);
    }
    if (job->normals)
        gn_clear_color(&target.color[NORMAL], 0, 0, 0, 0);
    if (job->labels_drawn)
        memset(job->labels_drawn + (size_t)job->width * job->height * view, 0xFF,
               sizeof(int32_t) * job->width * job->height);
    for (uint32_t i = 0; i < job->part_count; ++i)
        if (!draw_geometry_of(run, view, &job->part[i], &target, workspace))
            return false;
    return true;
}

/* Writes the distances of a view's pixels. */
static void write_distances(const views_job *job, uint32_t view, const float *depth)
{
    const views_camera *const c = &job->camera[view];
    const size_t count = (size_t)job->width * job->height;
    float *const distance = job->depth + count * view;
    const float nothing = farthest(job);

    for (size_t i = 0; i < count; ++i) {
        const double ndc = job->reversed ? depth[i] : 2.0 * depth[i] - 1.0;

        distance[i] =
            depth[i] == nothing
                ? 0.0f
                : (float)((ndc * c->w - c->z) / (c->z_per_distance - ndc * c->w_per_distance));
    }
}

static gn_status use_shader(gn_pipeline *pipeline, views_shader shader,
                            const gn_unlit_uniforms *unlit, const gn_lit_uniforms *lit)
{
    switch (shader) {
    case VIEWS_FLAT:
        return gn_use_flat(pipeline, lit);
    case VIEWS_GOURAUD:
        return gn_use_gouraud(pipeline, lit);
    case VIEWS_TOON:
        return gn_use_toon(pipeline, lit);
    case VIEWS_PHONG:
        return gn_use_phong(pipeline, lit);
    case VIEWS_BLINN_PHONG:
        return gn_use_blinn_phong(pipeline, lit);
    case VIEWS_NORMAL_COLOR:
        return gn_use_normal_color(pipeline, lit);
    default:
        return gn_use_unlit(pipeline, unlit);
    }
}

static bool draw_colors_of(views_run *run, uint32_t view, const views_part *part,
                           const gn_target *target, gn_workspace *workspace)
{
    const views_job *const job = run->job;
    gn_unlit_uniforms unlit;
    gn_lit_uniforms lit;
    gn_pipeline pipeline;

    memset(&unlit, 0, sizeof unlit);
    memset(&lit, 0, sizeof lit);
    memset(&pipeline, 0, sizeof pipeline);
    unlit.clip_from_model = lit.clip_from_model = clip_from_model(job, view, part);
    unlit.map = part->material.diffuse_map;
    unlit.sampler = part->material.sampler;
    lit.world_from_model = part->world_from_model;
    lit.normal_matrix = part->normal_matrix;
    lit.eye = job->camera[view].eye;
    lit.light = job->light;
    if (job->light_follows) {
        const gn_vec3 forward = job->camera[view].forward;

        lit.light.direction = (gn_vec3){-forward.x, -forward.y, -forward.z};
    }
    lit.material = part->material;
    set_state(&pipeline, job);
    const gn_status status = use_shader(&pipeline, part->shader, &unlit, &lit);
    if (status != GN_OK)
        return fail(run, status, NULL);
    return draw(run, target, &pipeline, &part->mesh, workspace);
}

static bool draw_colors(views_run *run, uint32_t view, void *depth, void *color,
                        gn_workspace *workspace)
{
    const views_job *const job = run->job;
    const float *const back = job->background;
    const gn_surface picture_of_view = picture(job, job->color, GN_FORMAT_RGBA8, view);
    const gn_surface depth_of_pixels = depth_of_view(job, depth);
    const gn_surface color_of_samples =
        gn_surface_top_down(color, GN_FORMAT_RGBA8, job->width, job->height);
    gn_target target;

    memset(&target, 0, sizeof target);
    target.color[0] =
        job->smooth_edges ? gn_surface_multisampled(&color_of_samples) : picture_of_view;
    target.depth = job->smooth_edges ? gn_surface_multisampled(&depth_of_pixels) : depth_of_pixels;
    gn_clear_color(&target.color[0], back[0], back[1], back[2], back[3]);
    gn_clear_depth(&target.depth, farthest(job));
    for (uint32_t i = 0; i < job->part_count; ++i)
        if (!draw_colors_of(run, view, &job->part[i], &target, workspace))
            return false;
    const gn_status status =
        job->smooth_edges ? gn_resolve(&picture_of_view, &target.color[0]) : GN_OK;
    return status == GN_OK || fail(run, status, NULL);
}

static bool draw_view(views_run *run, uint32_t view, unsigned char *memory)
{
    const views_job *const job = run->job;
    unsigned char *const color = memory + depth_size(job);
    gn_workspace workspace;

    memset(&workspace, 0, sizeof workspace);
    workspace.memory = color + color_size(job);
    workspace.size = run->workspace_size;
    workspace.backend = run->backend;
    if (run->pool) {
        workspace.parallel = thread_pool_run;
        workspace.user = run->pool;
        workspace.threads = run->threads;
    }
    const bool has_own_pass =
        job->normals || job->labels_drawn || (job->depth && (!job->color || job->smooth_edges));
    if (has_own_pass && !draw_geometry(run, view, memory, &workspace))
        return false;
    if (has_own_pass && job->depth)
        write_distances(job, view, (const float *)(void *)memory);
    if (job->color && !draw_colors(run, view, memory, color, &workspace))
        return false;
    if (!has_own_pass && job->depth)
        write_distances(job, view, (const float *)(void *)memory);
    return true;
}

static void draw_views(void *context, uint32_t part)
{
    views_run *const run = context;

    for (;;) {
        const uint32_t view = atomic_fetch_add(&run->next, 1);

        if (view >= run->job->count || !draw_view(run, view, run->memory + run->thread_size * part))
            break;
    }
}

/* Threads inherit the floating-point environment of the one that starts them. */
bool views_draw(views_job *job, void *memory, size_t size, uint32_t threads)
{
    const size_t skipped = (ALIGNMENT - (uintptr_t)memory % ALIGNMENT) % ALIGNMENT;
    const uint32_t count = parts(job, threads);
    thread_pool *const pool = threads > 1 ? thread_pool_create(threads) : NULL;
    views_run run = {.job = job, .failed = ATOMIC_FLAG_INIT};

    if ((threads > 1 && !pool) || size < views_memory(job, threads)) {
        thread_pool_destroy(pool);
        return false;
    }
    run.memory = (unsigned char *)memory + skipped;
    run.workspace_size = workspace_size(job, threads);
    run.thread_size = depth_size(job) + color_size(job) + run.workspace_size;
    run.threads = threads;
    run.backend = job->backend == GN_BACKEND_AUTO ? gn_backend_best() : job->backend;
    atomic_init(&run.next, 0);
    job->error = GN_OK;
    job->fault = NULL;
    if (pool && job->count == 1)
        run.pool = pool;
    if (pool && count > 1)
        thread_pool_run(pool, draw_views, &run, count);
    else
        draw_views(&run, 0);
    thread_pool_destroy(pool);
    return true;
}

_Static_assert(sizeof(fenv_t) <= VIEWS_ENVIRONMENT, "an environment fits");

void views_enter(char environment[VIEWS_ENVIRONMENT])
{
    fenv_t kept;

    fegetenv(&kept);
    memcpy(environment, &kept, sizeof kept);
    fesetenv(FE_DFL_ENV);
}

void views_leave(const char environment[VIEWS_ENVIRONMENT])
{
    fenv_t kept;

    memcpy(&kept, environment, sizeof kept);
    fesetenv(&kept);
}
