/* Draws a batch of views. One view is drawn by all threads; of several views, each is drawn by one
 * thread, which takes the next one that nobody has taken. */
#include "views.h"

#include <fenv.h>
#include <stdatomic.h>
#include <string.h>

#include "../../../threads/pool.h"
#include "passes.h"

#define ALIGNMENT 64

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
    atomic_bool shows; /* some view shows something */
} views_run;

static size_t rounded(size_t size)
{
    return (size + ALIGNMENT - 1) & ~(size_t)(ALIGNMENT - 1);
}

/* The parts of a thread's memory: depth, samples of colours, the workspace. */
static size_t depth_size(const views_job *job)
{
    const uint32_t samples = job->smooth_edges ? GN_SAMPLES : 1;

    return rounded((size_t)job->width * job->height * samples * sizeof(float));
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

/* Keeps the first fault. */
static void fail(views_run *run, passes_fault fault)
{
    if (!atomic_flag_test_and_set(&run->failed)) {
        run->job->fault = fault.words;
        run->job->error = fault.status;
    }
}

static passes_tools tools_of(views_run *run, uint32_t part)
{
    unsigned char *const memory = run->memory + run->thread_size * part;
    passes_tools tools;

    memset(&tools, 0, sizeof tools);
    tools.depth = (float *)(void *)memory;
    tools.color = memory + depth_size(run->job);
    tools.pool = run->pool;
    tools.threads = run->threads;
    tools.workspace.memory = tools.color + color_size(run->job);
    tools.workspace.size = run->workspace_size;
    tools.workspace.backend = run->backend;
    if (run->pool) {
        tools.workspace.parallel = thread_pool_run;
        tools.workspace.user = run->pool;
        tools.workspace.threads = run->threads;
    }
    return tools;
}

static void draw_views(void *context, uint32_t part)
{
    views_run *const run = context;
    passes_tools tools = tools_of(run, part);

    for (;;) {
        const uint32_t view = atomic_fetch_add(&run->next, 1);
        passes_fault fault = {GN_OK, NULL};

        if (view >= run->job->count)
            break;
        if (!passes_draw(run->job, view, &tools, &fault)) {
            fail(run, fault);
            break;
        }
        if (!atomic_load(&run->shows) && !passes_are_empty(run->job, &tools))
            atomic_store(&run->shows, true);
    }
}

static void draw_all(views_run *run, thread_pool *pool, uint32_t count)
{
    passes_tools tools = tools_of(run, 0);
    passes_fault fault = {GN_OK, NULL};

    if (run->job->shadow && !passes_draw_shadow(run->job, &tools, &fault))
        fail(run, fault);
    else if (pool && count > 1)
        thread_pool_run(pool, draw_views, run, count);
    else
        draw_views(run, 0);
}

/* Threads inherit the floating-point environment of the one that starts them. */
bool views_draw(views_job *job, void *memory, size_t size, uint32_t threads)
{
    const size_t skipped = (ALIGNMENT - (uintptr_t)memory % ALIGNMENT) % ALIGNMENT;
    const uint32_t count = parts(job, threads);
    const uint32_t started = job->count == 1 ? threads : count;
    thread_pool *const pool = started > 1 ? thread_pool_create(started) : NULL;
    views_run run = {.job = job, .failed = ATOMIC_FLAG_INIT};

    if ((started > 1 && !pool) || size < views_memory(job, threads)) {
        thread_pool_destroy(pool);
        return false;
    }
    if (pool)
        thread_pool_let_move(pool);
    run.memory = (unsigned char *)memory + skipped;
    run.workspace_size = workspace_size(job, threads);
    run.thread_size = depth_size(job) + color_size(job) + run.workspace_size;
    run.threads = threads;
    run.backend = job->backend == GN_BACKEND_AUTO ? gn_backend_best() : job->backend;
    atomic_init(&run.next, 0);
    atomic_init(&run.shows, false);
    job->error = GN_OK;
    job->fault = NULL;
    if (job->count == 1)
        run.pool = pool;
    draw_all(&run, pool, count);
    job->is_empty = !atomic_load(&run.shows);
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
