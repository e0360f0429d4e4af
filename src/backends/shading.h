/* What a back end shades fragments with: its own forms of the functions of sampling and of the
 * ready-made fragment shaders. They are compiled apart from the rasterizer, which calls them
 * through this, so that neither makes the other slow to compile. */
#ifndef GN_BACKENDS_SHADING_H
#define GN_BACKENDS_SHADING_H

#include "gnomon/pipeline.h"

#include "../lanes/small.h"

typedef struct shading_functions {
    gn_sampling sampling;
    gn_fragment_shader *fragment_shader;
} shading_functions;

/* Fills `out` in for a pipeline's fragment shader, one function a back end; a shader of the user's
 * stays what it is. Those that the target's instruction set does not have are not defined, and
 * with GN_SMALL none is. */
void gn_shading_portable(gn_fragment_shader *shader, shading_functions *out);
void gn_shading_sse2(gn_fragment_shader *shader, shading_functions *out);
void gn_shading_avx2(gn_fragment_shader *shader, shading_functions *out);
void gn_shading_avx512(gn_fragment_shader *shader, shading_functions *out);
void gn_shading_neon(gn_fragment_shader *shader, shading_functions *out);
void gn_shading_wasm_simd128(gn_fragment_shader *shader, shading_functions *out);

#endif
