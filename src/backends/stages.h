/* What every back end compiles for its own lanes: a whole draw, and blocks of vectors or matrices.
 */
#ifndef GN_BACKENDS_STAGES_H
#define GN_BACKENDS_STAGES_H

#include "../config/backends.h"
#include "../kernel/draw/job.h"
#include "../kernel/math/bulk_job.h"

/* Declares gni_run_portable and gni_bulk_portable, gni_run_sse2 and gni_bulk_sse2 and so on, a pair
 * for each row of GN_BACKENDS. Functions of back ends that are not compiled are not defined.
 *
 * gni_run_<name> runs a whole draw. If an index is at or beyond the mesh's vertex_count, returns
 * GN_INDEX_OUT_OF_RANGE and draws nothing. gni_bulk_<name> works on whole blocks of vectors or
 * matrices. */
#define GN_DECLARE_STAGES(name, NAME, have, text)                                                  \
    gn_status gni_run_##name(const draw_job *job);                                                 \
    void gni_bulk_##name(const bulk_job *job);
GN_BACKENDS(GN_DECLARE_STAGES)
#undef GN_DECLARE_STAGES

#endif
