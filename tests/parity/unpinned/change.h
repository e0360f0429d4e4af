/* Known changes of one pixel, which the measurement must find. */
#ifndef DISTANCE_CHANGE_H
#define DISTANCE_CHANGE_H

#include "measure.h"

typedef enum distance_change {
    CHANGE_COLOR,       /* the lowest bit of red */
    CHANGE_FLOAT_COLOR, /* likewise, of a float */
    CHANGE_DEPTH,       /* the lowest bit of the depth */
    CHANGE_COVERAGE,    /* back to the clear values */
    CHANGE_COUNT
} distance_change;

const char *distance_change_name(distance_change change);

/* Changes one covered pixel of b, whose frame equals a's, measures and changes it back.
 * Returns false if the frames have no such pixel. `found` says whether the measurement found this
 * change and no other. */
bool distance_check_change(const distance_side *a, distance_side *b, distance_change change,
                           bool *found);

#endif
