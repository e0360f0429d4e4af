/* A renderer as the benchmark sees it: a child process that draws on request. The two send each
 * other requests and answers of fixed size through a pair of pipes, and the pixels of frames. Each
 * renderer is a process of its own, since Mesa and malloc read their environment once per process;
 * all are one executable. */
#ifndef BENCH_RENDERER_H
#define BENCH_RENDERER_H

#include <stdio.h>
#include <sys/types.h>

#include "rows/rows.h"

typedef enum renderer_kind {
    RENDERER_GNOMON,
    RENDERER_SHIPPED, /* llvmpipe, one thread, as shipped, depth with a stencil */
    RENDERER_TUNED,   /* llvmpipe, one thread, tuned */
    RENDERER_TUNED_2, /* llvmpipe, tuned, with two threads that rasterize */
    RENDERER_PINNED,  /* the pinned reference, for comparing pixels */
    RENDERER_COUNT
} renderer_kind;

typedef struct renderer {
    renderer_kind kind;
    pid_t process; /* 0: not started */
    FILE *to, *from;
    char text[512]; /* the renderer's name; after a fault the reason */
} renderer;

/* How a renderer is to draw; without effect but on Gnomon's. */
typedef struct renderer_way {
    gn_backend backend;
    uint32_t threads;
    bool functions; /* a user's shaders are functions of one fragment, not loops over lanes */
} renderer_way;

typedef enum request_kind {
    REQUEST_LOAD, /* builds and uploads a row's scene */
    REQUEST_DRAW, /* draws frames, timed */
    REQUEST_FRAME /* draws a frame, not timed; its pixels follow the answer */
} request_kind;

typedef struct request {
    request_kind kind;
    row_table table;
    uint32_t row;
    renderer_way way;
} request;

typedef struct answer {
    bool good;
    double cpu_ms, wall_ms;
    char text[512]; /* after a fault the reason; after a load the renderer's name */
} answer;

/* "gnomon" and so on, which is the hidden option's value. */
const char *renderer_kind_name(renderer_kind kind);

/* If a command line is that of a renderer which renderer_start starts, serves requests until the
 * end of standard input, and ends the program. */
void renderer_serve(int argc, char **argv);

/* Each returns false on a fault, with the reason in text. */
bool renderer_start(renderer *r, renderer_kind kind);
bool renderer_load(renderer *r, row_table table, uint32_t row);
bool renderer_draw(renderer *r, const renderer_way *way, double *cpu_ms, double *wall_ms);

/* Draws and reads a frame, with all its images. */
bool renderer_frame(renderer *r, const renderer_way *way, scene_frame *frame);

/* Ends the process; does nothing if it was not started. */
void renderer_stop(renderer *r);

/* The surfaces of a frame in their order in the pipe: 0 to GN_MAX_COLORS, the last of them depth.
 * Returns the memory, null if there is none, and sets its size. */
static inline void *renderer_surface(const scene_frame *frame, int surface, size_t *size)
{
    const bool is_depth = surface == GN_MAX_COLORS;
    const gn_format format = is_depth ? frame->depth_format : scene_frame_format(frame, surface);

    *size = (size_t)frame->width * frame->height * frame->images * gn_format_size(format);
    return is_depth ? frame->depth : scene_frame_color(frame, surface);
}

/* The child (child.c). Returns the exit status. */
int child_main(renderer_kind kind);

#endif
