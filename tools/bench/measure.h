/* Timing: every renderer draws a row's frame in turn, as often as asked; frames are compared with
 * the pinned reference's. */
#ifndef BENCH_MEASURE_H
#define BENCH_MEASURE_H

#include "record.h"
#include "renderer.h"

#define MAX_FRAMES 1000

/* States are drawn by the tuned llvmpipe and Gnomon, with one thread; the scale, besides, by the
 * best back end only. Scenes are drawn by all renderers. */
typedef struct measure_options {
    row_table table;
    int frames;
    gn_backend backend; /* GN_BACKEND_AUTO: all that are available */
    int threads;        /* of scenes; 0: both 1 and 2 */
} measure_options;

typedef struct family {
    renderer renderers[RENDERER_COUNT];
} family;

/* Starts the processes that the options need. Returns false with a message on standard error. */
bool family_start(family *f, const measure_options *o);
void family_stop(family *f);

bool measure_wants_backend(const measure_options *o, gn_backend backend);

/* Times a row of the table and adds its records to the list, llvmpipe's first. Returns false with a
 * message. */
bool measure_row(family *f, const measure_options *o, uint32_t row, record_list *list);

#endif
