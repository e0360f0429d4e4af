/* Starts the benchmark's child processes and sends them requests. */
#include "renderer.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

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

bool renderer_start(renderer *r, renderer_kind kind)
{
    int to[2], from[2];

    memset(r, 0, sizeof *r);
    r->kind = kind;
    if (pipe(to) != 0)
        return fail(r, strerror(errno));
    if (pipe(from) != 0) {
        close(to[0]);
        close(to[1]);
        return fail(r, strerror(errno));
    }
    r->process = fork();
    if (r->process == 0) {
        dup2(to[0], STDIN_FILENO);
        dup2(from[1], STDOUT_FILENO);
        close(to[0]);
        close(to[1]);
        close(from[0]);
        close(from[1]);
        set_environment(kind);
        execl("/proc/self/exe", "bench", "--renderer", renderer_kind_name(kind), (char *)NULL);
        _exit(127);
    }
    close(to[0]);
    close(from[1]);
    r->to = to[1];
    r->from = from[0];
    /* Otherwise a child that is started later would hold this child's pipes open. */
    fcntl(r->to, F_SETFD, FD_CLOEXEC);
    fcntl(r->from, F_SETFD, FD_CLOEXEC);
    if (r->process < 0) {
        r->process = 0;
        close(r->to);
        close(r->from);
        return fail(r, strerror(errno));
    }
    return true;
}

static bool ask(renderer *r, const request *question, answer *a)
{
    if (!protocol_write(r->to, question, sizeof *question) || !protocol_read(r->from, a, sizeof *a))
        return fail(r, "its process has ended");
    if (!a->good)
        return fail(r, a->text);
    return true;
}

/* Returns a zeroed request, since its padding goes through the pipe too. */
static request request_of(request_kind kind)
{
    request q;

    memset(&q, 0, sizeof q);
    q.kind = kind;
    return q;
}

static request drawing_request(request_kind kind, const renderer_way *way)
{
    request q = request_of(kind);

    q.backend = way->backend;
    q.threads = way->threads;
    q.functions = way->functions;
    return q;
}

bool renderer_load(renderer *r, const bench_scene *b)
{
    request q = request_of(REQUEST_LOAD);
    answer a;

    q.scene = *b;
    if (!ask(r, &q, &a))
        return false;
    memcpy(r->text, a.text, sizeof r->text);
    return true;
}

bool renderer_draw(renderer *r, const renderer_way *way, double *cpu_ms, double *wall_ms)
{
    const request q = drawing_request(REQUEST_DRAW, way);
    answer a;

    if (!ask(r, &q, &a))
        return false;
    *cpu_ms = a.cpu_ms;
    *wall_ms = a.wall_ms;
    return true;
}

bool renderer_frame(renderer *r, const renderer_way *way)
{
    const request q = drawing_request(REQUEST_FRAME, way);
    answer a;

    return ask(r, &q, &a);
}

bool renderer_rows(renderer *r, uint32_t first_row, scene_frame *rows)
{
    request q = request_of(REQUEST_ROWS);
    const size_t pixels = (size_t)rows->width * rows->height;
    answer a;

    q.first_row = first_row;
    q.row_count = rows->height;
    if (!ask(r, &q, &a))
        return false;
    return (protocol_read(r->from, rows->color, pixels * gn_format_size(rows->color_format)) &&
            protocol_read(r->from, rows->depth, pixels * gn_format_size(rows->depth_format))) ||
           fail(r, "its process has ended");
}

bool renderer_images(renderer *r, scene_frame *frame)
{
    const request q = request_of(REQUEST_ROWS);
    const size_t pixels = (size_t)frame->width * frame->height * frame->images;
    answer a;

    if (!ask(r, &q, &a))
        return false;
    for (int i = 0; i <= GN_MAX_COLORS; ++i) {
        const bool is_depth = i == GN_MAX_COLORS;
        const gn_format format = is_depth ? frame->depth_format : scene_frame_format(frame, i);
        void *const to = is_depth ? frame->depth : scene_frame_color(frame, i);

        if (to && !protocol_read(r->from, to, pixels * gn_format_size(format)))
            return fail(r, "its process has ended");
    }
    return true;
}

void renderer_stop(renderer *r)
{
    if (r->process == 0)
        return;
    close(r->to);
    close(r->from);
    waitpid(r->process, NULL, 0);
    r->process = 0;
}
