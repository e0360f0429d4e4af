/* src/backends/shading_wasm_simd128.c with less (texture_parts.h): shaders receive no
 * gn_texture_gather and no gn_texture_fetch. */
#define GN_LANES_WASM_SIMD128
#define GN_SHADING gni_shading_wasm_simd128

#include "texture_parts.h"

#define gather_any 0
#define fetch_numbered 0

#include "../../../src/backends/shading.inl"
