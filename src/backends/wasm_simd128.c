/* The stages over WebAssembly's 128-bit vectors. */
#include "../config/backends.h"

#if GN_HAVE_WASM_SIMD128
#define GN_LANES_WASM_SIMD128
#define GN_RUN gni_run_wasm_simd128
#define GN_BULK gni_bulk_wasm_simd128
#include "stages.inl"
#endif
