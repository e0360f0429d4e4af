/* The kernel over WebAssembly's 128-bit vectors. */
#include "../config/backends.h"

#if GN_HAVE_WASM_SIMD128
#define GN_LANES_WASM_SIMD128
#define GN_DRAW gni_draw_wasm_simd128
#define GN_BULK gni_bulk_wasm_simd128
#include "backend.inl"
#endif
