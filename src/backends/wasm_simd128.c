/* The stages over WebAssembly's 128-bit vectors. A module is valid on a machine as a
 * whole or not at all, so that the choice falls where the program is compiled
 * (-msimd128). */
#include "../config/have.h"
#include "stages.h"

#if GN_HAVE_WASM_SIMD128
#define GN_LANES_WASM_SIMD128
#include "../draw/mesh.h"
#include "../math/bulk.h"

gn_status gn_run_wasm_simd128(const draw_job *job)
{
    return draw_mesh(job);
}

void gn_bulk_wasm_simd128(const bulk_job *job)
{
    run_bulk(job);
}
#endif
