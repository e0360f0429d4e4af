/* The teapot as a model of the command: what is counted, measured and written as a file. */
#ifndef SCALE_MODEL_H
#define SCALE_MODEL_H

#include <stdbool.h>
#include <stdint.h>

#include "drawing.h"
#include "picture.h"

typedef struct scale_model {
    options o;
    contents c;
    picture p;
    drawing d;
} scale_model;

/* Makes the teapot with 64 level^2 triangles, and its picture, as `gnomon render` would from a
 * file; `divided` gives every triangle vertices of its own. Returns false with a message if memory
 * is short; free with scale_model_free either way. */
bool scale_model_make(uint32_t level, uint32_t side, bool divided, scale_model *result);

/* Turns it as frame i of n of `gnomon spin`. Returns false with a message. */
bool scale_model_turn(scale_model *m, uint32_t frame, uint32_t frames);

void scale_model_free(scale_model *m);

/* Writes it as an OBJ file. Returns false with a message, and leaves no file. */
bool scale_model_write(const scale_model *m, const char *path);

#endif
