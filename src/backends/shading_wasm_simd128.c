/* Shading over WebAssembly's 128-bit vectors. */
#include "../config/have.h"

#include "shading.h"

#if GN_HAVE_WASM_SIMD128 && GN_SPECIALISED
#define GN_LANES_WASM_SIMD128
#include "shading_form.h"

void gn_shading_wasm_simd128(const gn_pipeline *pipeline, shading_functions *out)
{
    fill_shading(pipeline, out);
}
#endif
