/* src/backends/wasm_simd128.c with fewer fused states: the page's depths are floats. Other states
 * take the steps that every state can take. */
#define GN_LANES_WASM_SIMD128
#define GN_DRAW gni_draw_wasm_simd128
#define GN_BULK gni_bulk_wasm_simd128

#include "formats.h"

#include "../../../src/kernel/fragment/fused.inl"

#undef GN_FUSED_STATES
#define GN_FUSED_STATES(STATE)                                                                     \
    STATE(shader_d32f_blocks, shader_d32f_span, GN_FORMAT_D32F, SOURCE_SHADER, OUTPUT_RGBA8)       \
    STATE(color_d32f_blocks, color_d32f_span, GN_FORMAT_D32F, SOURCE_COLOR, OUTPUT_RGBA8)          \
    STATE(texture_d32f_blocks, texture_d32f_span, GN_FORMAT_D32F, SOURCE_TEXTURE, OUTPUT_RGBA8)    \
    STATE(depth_d32f_blocks, depth_d32f_span, GN_FORMAT_D32F, SOURCE_COLOR, OUTPUT_NOTHING)

#include "../../../src/backends/backend.inl"
