/* In the module with vectors, stands in for the portable back end: it would be dead weight, since
 * the draw of the page names the other one. */
#include "../../../src/backends/shading_forms.h"
#include "../../../src/backends/stages.h"

gn_status gni_run_portable(const draw_job *job)
{
    return gni_run_wasm_simd128(job);
}

void gni_bulk_portable(const bulk_job *job)
{
    gni_bulk_wasm_simd128(job);
}

void gni_shading_portable(const gn_pipeline *pipeline, shading_functions *out)
{
    gni_shading_wasm_simd128(pipeline, out);
}
