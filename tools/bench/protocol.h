/* What the benchmark and its child processes send through a pair of pipes: a request of fixed size,
 * an answer of fixed size, then pixels if rows were asked for. Both ends are one executable. */
#ifndef BENCH_PROTOCOL_H
#define BENCH_PROTOCOL_H

#include "scenes.h"

/* The renderers. Each is a process of its own, since Mesa and malloc read their environment once
 * per process. */
typedef enum renderer_kind {
    RENDERER_GNOMON,
    RENDERER_SHIPPED, /* llvmpipe, one thread, as shipped, depth with a stencil */
    RENDERER_TUNED,   /* llvmpipe, one thread, tuned */
    RENDERER_TUNED_2, /* llvmpipe, tuned, with two threads that rasterize */
    RENDERER_PINNED,  /* the pinned reference, for comparing pixels */
    RENDERER_COUNT
} renderer_kind;

/* The name, "gnomon" and so on, which is the hidden option's value. */
const char *renderer_kind_name(renderer_kind kind);

/* The renderer of this name, RENDERER_COUNT if there is none. */
renderer_kind renderer_kind_of(const char *name);

typedef enum request_kind {
    REQUEST_LOAD,  /* builds and uploads a scene */
    REQUEST_DRAW,  /* draws a frame, timed */
    REQUEST_FRAME, /* draws a frame to be read, not timed */
    REQUEST_ROWS   /* reads that frame's rows first_row to first_row + row_count - 1 */
} request_kind;

typedef struct request {
    request_kind kind;
    bench_scene scene;
    gn_backend backend; /* Gnomon's back end */
    uint32_t threads;
    bool functions; /* Gnomon's user's shaders are functions of one fragment */
    uint32_t first_row, row_count;
} request;

typedef struct answer {
    bool good;
    double cpu_ms, wall_ms;
    char text[512]; /* after a fault the reason; after a load the renderer's name */
} answer;

/* Transfer all bytes; return false if the other process has ended. */
bool protocol_write(int file, const void *data, size_t size);
bool protocol_read(int file, void *data, size_t size);

/* The child: serves requests from standard input until its end. Returns the exit status. */
int child_main(renderer_kind kind);

#endif
