/* What the targets of the readers of models share. */
#ifndef MODEL_INPUT_H
#define MODEL_INPUT_H

#include "../../tools/models/read.h"

/* Reads the bytes as a model within a few megabytes, and requires of it what whoever draws relies
 * on; or a fault in words. In a text, what stands behind the first byte 0x1e is the contents of
 * every file that the model names; else there are no such files. */
void fuzz_read_model(model_format format, const uint8_t *bytes, size_t size);

#endif
