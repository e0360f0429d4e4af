/* A model for the benchmark of tasks, as a scene. */
#ifndef BENCH_TASKS_MODEL_H
#define BENCH_TASKS_MODEL_H

#include <stdint.h>

#include "scene.h"

/* Returns a picture of a model's file as `gnomon render` draws it, or of the teapot if the path is
 * null, with `side` pixels a side; the caller frees it with scene_free. Returns null with a message
 * if the file cannot be read. Precondition: no threads have been started. */
scene *tasks_model(const char *path, uint32_t side);

#endif
