/* Times one row: the tuned llvmpipe and every back end draw frames in turn; a frame of every back
 * end is compared with the pinned reference's. */
#ifndef STATES_MEASURE_H
#define STATES_MEASURE_H

#include "../renderer.h"
#include "results.h"

#define MAX_STATE_FRAMES 1000

typedef struct state_children {
    renderer gnomon, tuned, pinned;
} state_children;

typedef struct state_options {
    int frames;
    gn_backend backend; /* GN_BACKEND_AUTO: all that are available */
} state_options;

/* Returns false with a message on standard error. */
bool state_children_start(state_children *c);
void state_children_stop(state_children *c);

bool state_wants(const state_options *o, gn_backend backend);

/* Measures a row of state_rows. Returns false if a child has ended or the row cannot be drawn; the
 * reason is in `fault`. */
bool state_measure(state_children *c, const state_options *o, uint32_t row_number,
                   state_result *result);

#endif
