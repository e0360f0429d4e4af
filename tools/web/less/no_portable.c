/* In the module with vectors, stands in for the portable back end: it would be dead weight, since
 * the draw of the page names the other one. */
#include "../../../src/backends/entry_points.h"

gn_status gni_draw_portable(const draw_job *job)
{
    return gni_draw_wasm_simd128(job);
}

void gni_bulk_portable(const bulk_job *job)
{
    gni_bulk_wasm_simd128(job);
}

void gni_shading_portable(const gn_pipeline *pipeline, shading_functions *out)
{
    gni_shading_wasm_simd128(pipeline, out);
}
