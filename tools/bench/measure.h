/* Timing: every renderer draws a frame in turn, as often as asked; every frame is compared with the
 * pinned reference's. */
#ifndef BENCH_MEASURE_H
#define BENCH_MEASURE_H

#include "record.h"
#include "renderer.h"

#define MAX_FRAMES 1000

typedef struct measure_options {
    int frames;
    gn_backend backend; /* GN_BACKEND_AUTO: all that are available */
    uint32_t threads;   /* 0: both 1 and 2 */
    bool scale;         /* only one thread, the best back end and the tuned llvmpipe */
} measure_options;

typedef struct family {
    renderer renderers[RENDERER_COUNT];
} family;

/* Starts the processes that the options need. Returns false with a message on standard error. */
bool family_start(family *f, const measure_options *o);
void family_stop(family *f);

/* Times a scene, prints its lines and adds them to the list. Returns false with a message. */
bool measure_scene(family *f, const measure_options *o, const bench_scene *b, record_list *list);

#endif
