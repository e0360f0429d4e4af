/* What every back end compiles for its own lanes: a whole draw, and blocks of vectors or matrices.
 * Functions of back ends that this target does not have are not defined. */
#ifndef GN_BACKENDS_STAGES_H
#define GN_BACKENDS_STAGES_H

#include "../draw/job.h"
#include "../math/bulk_job.h"

/* Returns GN_INDEX_OUT_OF_RANGE, and nothing is drawn, where an index is at or beyond the mesh's
 * vertex_count. */
gn_status gn_run_portable(const draw_job *job);
gn_status gn_run_sse2(const draw_job *job);
gn_status gn_run_avx2(const draw_job *job);
gn_status gn_run_avx512(const draw_job *job);
gn_status gn_run_neon(const draw_job *job);
gn_status gn_run_wasm_simd128(const draw_job *job);

void gn_bulk_portable(const bulk_job *job);
void gn_bulk_sse2(const bulk_job *job);
void gn_bulk_avx2(const bulk_job *job);
void gn_bulk_avx512(const bulk_job *job);
void gn_bulk_neon(const bulk_job *job);
void gn_bulk_wasm_simd128(const bulk_job *job);

#endif
