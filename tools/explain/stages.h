/* The tracing back end: the library's own stages, compiled over lanes that record. */
#ifndef EXPLAIN_STAGES_H
#define EXPLAIN_STAGES_H

#include <gnomon.h>

/* Does what gn_draw does. `pixel` (tracing.h) says what is told and found meanwhile. */
gn_status stages_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                      gn_workspace *workspace);

#endif
