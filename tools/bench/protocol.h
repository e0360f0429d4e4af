/* What the benchmark and its child processes say to each other, through a pair of pipes:
 * a request with a fixed number of bytes, an answer of the same kind, then pixels where
 * rows were asked for. Both ends are one executable. */
#ifndef BENCH_PROTOCOL_H
#define BENCH_PROTOCOL_H

#include "scenes.h"

/* Who draws. Each is a process of its own, since Mesa and malloc read their environment
 * once a process. */
typedef enum renderer_kind {
    RENDERER_GNOMON,
    RENDERER_SHIPPED, /* llvmpipe, one thread, nothing set, depth with a stencil */
    RENDERER_TUNED,   /* llvmpipe, one thread, at its best */
    RENDERER_TUNED_2, /* the same with two threads that rasterize */
    RENDERER_PINNED,  /* the reference for pixels */
    RENDERER_COUNT
} renderer_kind;

/* "gnomon" and so on, the hidden option's value. */
const char *renderer_kind_name(renderer_kind kind);

/* The kind of that name, RENDERER_COUNT where there is none. */
renderer_kind renderer_kind_of(const char *name);

typedef enum request_kind {
    REQUEST_LOAD,  /* a scene: built, uploaded */
    REQUEST_DRAW,  /* a frame, timed */
    REQUEST_FRAME, /* a frame to be read, not timed */
    REQUEST_ROWS   /* its rows first_row to first_row + row_count - 1 */
} request_kind;

typedef struct request {
    request_kind kind;
    bench_scene scene;
    gn_backend backend; /* Gnomon's */
    uint32_t threads;
    uint32_t first_row, row_count;
} request;

typedef struct answer {
    bool good;
    bool is_contract; /* Mesa's version is one that bits are promised for */
    double cpu_ms, wall_ms;
    char text[512]; /* on a fault the reason; of a load, who draws */
} answer;

/* All bytes or nothing: false at the end of the other process. */
bool protocol_write(int file, const void *data, size_t size);
bool protocol_read(int file, void *data, size_t size);

/* The child: serves requests from standard input until its end. The exit status. */
int child_main(renderer_kind kind);

#endif
