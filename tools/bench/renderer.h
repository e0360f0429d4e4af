/* A renderer as the benchmark sees it: a child process that draws on request. */
#ifndef BENCH_RENDERER_H
#define BENCH_RENDERER_H

#include <sys/types.h>

#include "protocol.h"

typedef struct renderer {
    renderer_kind kind;
    pid_t process; /* 0: not started */
    int to, from;
    char text[512]; /* the renderer's name; after a fault the reason */
} renderer;

/* How a renderer is to draw; without effect but on Gnomon's. */
typedef struct renderer_way {
    gn_backend backend;
    uint32_t threads;
    bool functions; /* S4's shaders are functions of one fragment, not loops over lanes */
} renderer_way;

/* Each returns false on a fault, with the reason in text. */
bool renderer_start(renderer *r, renderer_kind kind);
bool renderer_load(renderer *r, const bench_scene *b);
bool renderer_draw(renderer *r, const renderer_way *way, double *cpu_ms, double *wall_ms);
bool renderer_frame(renderer *r, const renderer_way *way);

/* Reads rows of the frame that renderer_frame drew into a frame of equally many rows. */
bool renderer_rows(renderer *r, uint32_t first_row, scene_frame *rows);

/* Reads the whole frame that renderer_frame drew, with all its images. */
bool renderer_images(renderer *r, scene_frame *frame);

/* Ends the process; does nothing if it was not started. */
void renderer_stop(renderer *r);

#endif
