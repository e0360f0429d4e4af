/* Batches of triangles for oracle A. */
#ifndef TESTS_EXACT_BATCH_H
#define TESTS_EXACT_BATCH_H

#include "exact.h"
#include "snapped_triangle.h"

/* What a batch is drawn with, which decides on the library's way to a pixel. */
typedef enum batch_mode {
    MODE_SUM,    /* triangle i adds 2^(i % 24) to channel i / 24: the coverage of each is known */
    MODE_LAST,   /* RGBA8 of smooth vertex colours: the number of the last triangle shows */
    MODE_SHADER, /* as before, with a fragment shader of the user's */
    MODE_COUNT
} batch_mode;

typedef struct batch {
    batch_mode mode;
    uint32_t width, height, samples;
    gn_format depth; /* written always, so that it changes nothing but the library's way */
    gn_viewport viewport;
    gn_cull cull;
    gn_front_face front_face;
    uint32_t count;
    snapped_triangle triangle[BATCH_TRIANGLES];
    float position[3 * BATCH_TRIANGLES][4];
    float color[3 * BATCH_TRIANGLES][4];
} batch;

static inline gn_format batch_color_format(const batch *b)
{
    return b->mode == MODE_SUM ? GN_FORMAT_RGBA32F : GN_FORMAT_RGBA8;
}

/* Makes a random batch of at most `most` triangles. */
void random_batch(random_source *r, uint32_t most, batch *b);

#endif
