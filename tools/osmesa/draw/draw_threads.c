/* The threads of each workspace are a pool, since contexts may draw in several threads at once. */
#include "draw_threads.h"

#include <stdlib.h>

#include "../../threads/pool.h"
#include "../context/gl_errors.h"

/* Returns the number that the environment asks for: 1 if it asks for none, or in another way. */
static uint32_t wanted_threads(void)
{
    const char *const text = getenv("GNOMON_THREADS");
    char *end;
    long threads;

    if (!text || !*text)
        return 1;
    threads = strtol(text, &end, 10);
    if (!*end && threads >= 1 && threads <= THREAD_POOL_MOST)
        return (uint32_t)threads;
    debug_line("GNOMON_THREADS", "is not a number from 1 to 64; one thread draws");
    return 1;
}

void start_draw_threads(gn_workspace *workspace)
{
    thread_pool *pool;

    if (workspace->threads > 0)
        return;
    workspace->threads = wanted_threads();
    if (workspace->threads == 1)
        return;
    pool = thread_pool_create(workspace->threads);
    if (!pool) {
        debug_line("GNOMON_THREADS", "threads cannot be started; one thread draws");
        workspace->threads = 1;
        return;
    }
    /* The program's own threads use the processors too. */
    thread_pool_let_move(pool);
    workspace->user = pool;
    workspace->parallel = thread_pool_run;
}

void end_draw_threads(gn_workspace *workspace)
{
    thread_pool_destroy(workspace->user);
}
