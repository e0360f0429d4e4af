/* How the samples of a pixel become one word. */
#ifndef EXPLAIN_RESOLVE_H
#define EXPLAIN_RESOLVE_H

#include <stdint.h>

/* Adds a stage to the last fragment of the report, if there is one; checks that the mean of the
 * samples is the resolved word. */
void tell_resolve(const uint32_t *sample_word, uint32_t samples, uint32_t resolved);

#endif
