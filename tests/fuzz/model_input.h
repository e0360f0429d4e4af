/* What the targets of the readers of models share. */
#ifndef MODEL_INPUT_H
#define MODEL_INPUT_H

#include "../../tools/models/read.h"

/* Reads the bytes as a model within a few megabytes, and requires of it what whoever draws relies
 * on; or a fault in words. Files that it names do not exist. */
void fuzz_read_model(model_format format, const uint8_t *bytes, size_t size);

#endif
