/* Starts the benchmark's child processes and sends them requests. */
#include "renderer.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const char *const kind_names[RENDERER_COUNT] = {"gnomon", "shipped", "tuned", "tuned-2",
                                                       "pinned"};

const char *renderer_kind_name(renderer_kind kind)
{
    return kind_names[kind];
}

void renderer_serve(int argc, char **argv)
{
    for (int kind = 0; kind < RENDERER_COUNT; ++kind)
        if (argc == 3 && strcmp(argv[1], "--renderer") == 0 &&
            strcmp(argv[2], kind_names[kind]) == 0)
            exit(child_main((renderer_kind)kind));
}

static bool fail(renderer *r, const char *why)
{
    snprintf(r->text, sizeof r->text, "%s", why);
    return false;
}

/* The environment of a child. A user's settings for Mesa or malloc would change the timing, so they
 * are removed. */
static void set_environment(renderer_kind kind)
{
    static const char *const cleared[] = {"GALLIUM_DRIVER",
                                          "GALLIUM_OVERRIDE_CPU_CAPS",
                                          "GALLIVM_PERF",
                                          "GALLIVM_DEBUG",
                                          "LP_NATIVE_VECTOR_WIDTH",
                                          "LP_NUM_THREADS",
                                          "LP_DEBUG",
                                          "LP_PERF",
                                          "MESA_DEBUG",
                                          "MALLOC_TRIM_THRESHOLD_",
                                          "MALLOC_MMAP_THRESHOLD_",
                                          "MALLOC_TOP_PAD_",
                                          "GLIBC_TUNABLES"};

    for (size_t i = 0; i < sizeof cleared / sizeof *cleared; ++i)
        unsetenv(cleared[i]);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LP_NUM_THREADS", kind == RENDERER_TUNED_2 ? "2" : "0", 1);
    if (kind == RENDERER_TUNED || kind == RENDERER_TUNED_2) {
        /* malloc keeps the memory that a frame frees for the next one. */
        setenv("MALLOC_TRIM_THRESHOLD_", "1073741824", 1);
        setenv("MALLOC_MMAP_THRESHOLD_", "1073741824", 1);
        setenv("MALLOC_TOP_PAD_", "67108864", 1);
    }
}

/* Makes a pipe, whose ends no other child holds open. */
static bool make_pipe(int ends[2])
{
    return pipe(ends) == 0 && fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 &&
           fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0;
}

bool renderer_start(renderer *r, renderer_kind kind)
{
    int to[2], from[2];

    memset(r, 0, sizeof *r);
    r->kind = kind;
    if (!make_pipe(to) || !make_pipe(from))
        return fail(r, strerror(errno));
    r->to = fdopen(to[1], "w");
    r->from = fdopen(from[0], "r");
    r->process = r->to && r->from ? fork() : -1;
    if (r->process == 0) {
        dup2(to[0], STDIN_FILENO);
        dup2(from[1], STDOUT_FILENO);
        set_environment(kind);
        execl("/proc/self/exe", "bench", "--renderer", renderer_kind_name(kind), (char *)NULL);
        _exit(127);
    }
    close(to[0]);
    close(from[1]);
    if (r->process < 0) {
        r->process = 0;
        return fail(r, strerror(errno));
    }
    return true;
}

static bool ask(renderer *r, const request *question, answer *a)
{
    if (fwrite(question, sizeof *question, 1, r->to) != 1 || fflush(r->to) != 0 ||
        fread(a, sizeof *a, 1, r->from) != 1)
        return fail(r, "its process has ended");
    return a->good || fail(r, a->text);
}

bool renderer_load(renderer *r, row_table table, uint32_t row)
{
    const request q = {.kind = REQUEST_LOAD, .table = table, .row = row};
    answer a;

    if (!ask(r, &q, &a))
        return false;
    memcpy(r->text, a.text, sizeof r->text);
    return true;
}

bool renderer_draw(renderer *r, const renderer_way *way, double *cpu_ms, double *wall_ms)
{
    const request q = {.kind = REQUEST_DRAW, .way = *way};
    answer a;

    if (!ask(r, &q, &a))
        return false;
    *cpu_ms = a.cpu_ms;
    *wall_ms = a.wall_ms;
    return true;
}

bool renderer_frame(renderer *r, const renderer_way *way, scene_frame *frame)
{
    const request q = {.kind = REQUEST_FRAME, .way = *way};
    answer a;

    if (!ask(r, &q, &a))
        return false;
    for (int i = 0; i <= GN_MAX_COLORS; ++i) {
        size_t size;
        void *const memory = renderer_surface(frame, i, &size);

        if (memory && fread(memory, size, 1, r->from) != 1)
            return fail(r, "its process has ended");
    }
    return true;
}

void renderer_stop(renderer *r)
{
    if (r->process == 0)
        return;
    fclose(r->to);
    fclose(r->from);
    waitpid(r->process, NULL, 0);
    r->process = 0;
}
