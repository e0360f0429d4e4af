/* Shading over SSE2 registers. */
#include "../config/have.h"

#include "shading.h"

#if GN_HAVE_SSE2 && GN_SPECIALISED
#include "shading_form.h"

void gn_shading_sse2(const gn_pipeline *pipeline, shading_functions *out)
{
    fill_shading(pipeline, out);
}
#endif
