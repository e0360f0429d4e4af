/* Surfaces out of a fuzzer's input, right and wrong ones, in memory of exactly the bytes that they
 * describe. */
#ifndef FUZZ_SURFACE_INPUT_H
#define FUZZ_SURFACE_INPUT_H

#include "fuzz.h"

typedef struct surface_input {
    gn_surface surface;
    unsigned char *memory; /* null: none */
    size_t size;
    unsigned char *before; /* the memory's first contents */
    bool overlaps;         /* samples may share memory, so that pixels depend on the order */
} surface_input;

/* Makes a surface of this size and number of samples, unless the input spoils one of its members.
 * Returns false, with nothing to free, if the surface would take more memory than fuzzing has. */
bool surface_make(fuzz_input *in, gn_format format, uint32_t width, uint32_t height,
                  uint32_t samples, surface_input *result);
void surface_free(surface_input *s);

/* Puts the first contents back. */
void surface_restore(surface_input *s);

/* Returns a copy of the present contents, which the caller frees. */
unsigned char *surface_copy(const surface_input *s);

/* Whether the memory holds its first contents, except in the pixels of the rectangle x0 <= x < x1,
 * y0 <= y < y1 and the samples of the mask. An empty rectangle is allowed. */
bool surface_holds_outside(const surface_input *s, int64_t x0, int64_t y0, int64_t x1, int64_t y1,
                           uint32_t samples);

/* Returns a format: mostly one of colours or, if `depth`, one of depth or stencil; rarely another,
 * or none. */
gn_format surface_format(fuzz_input *in, bool depth);

#endif
