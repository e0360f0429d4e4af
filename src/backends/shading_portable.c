/* Shading in plain C. */
#define GN_LANES_PORTABLE

#include "shading.h"

#if GN_SPECIALISED
#include "shading_form.h"

void gn_shading_portable(const gn_pipeline *pipeline, shading_functions *out)
{
    fill_shading(pipeline, out);
}
#endif
