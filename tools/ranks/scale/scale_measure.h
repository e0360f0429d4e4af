/* Measures the figures of the cost model with the library and the command's own functions. */
#ifndef SCALE_MEASURE_H
#define SCALE_MEASURE_H

#include <stdbool.h>

/* Measures what one process can measure, and writes it to a new file; a model and pictures are
 * written beside it and removed. `quick` takes less care, for tests. Returns false with a message.
 */
bool measure_figures(const char *path, bool quick);

#endif
