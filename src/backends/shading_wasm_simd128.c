/* Shading over WebAssembly's registers of 128 bits. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_WASM_SIMD128 && GN_SPECIALISED
#define GN_LANES_WASM_SIMD128
#define GN_SHADING gni_shading_wasm_simd128
#include "shading.inl"
#endif
