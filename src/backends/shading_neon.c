/* Shading over 64-bit Arm's Advanced SIMD registers. */
#include "../config/have.h"

#include "shading.h"

#if GN_HAVE_NEON && GN_SPECIALISED
#define GN_LANES_NEON
#include "shading_form.h"

void gn_shading_neon(const gn_pipeline *pipeline, shading_functions *out)
{
    fill_shading(pipeline, out);
}
#endif
