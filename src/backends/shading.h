/* What a back end shades fragments with: its own forms of the functions of sampling and of the
 * ready-made shaders. They are compiled apart from the rasterizer, which calls them
 * through this, so that neither makes the other slow to compile. */
#ifndef GN_BACKENDS_SHADING_H
#define GN_BACKENDS_SHADING_H

#include "../config/small.h"
#include "../shaders/shading.h"

/* Fills `out` in for a pipeline's shaders, one function a back end; those of the user's stay what
 * they are. Those that the target's instruction set does not have are not defined, and
 * with GN_SMALL none is. */
void gn_shading_portable(const gn_pipeline *pipeline, shading_functions *out);
void gn_shading_sse2(const gn_pipeline *pipeline, shading_functions *out);
void gn_shading_avx2(const gn_pipeline *pipeline, shading_functions *out);
void gn_shading_avx512(const gn_pipeline *pipeline, shading_functions *out);
void gn_shading_neon(const gn_pipeline *pipeline, shading_functions *out);
void gn_shading_wasm_simd128(const gn_pipeline *pipeline, shading_functions *out);

#endif
