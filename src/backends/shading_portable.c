/* Shading in plain C. */
#define GN_LANES_PORTABLE

#include "shading.h"

#if GN_SPECIALISED
#include "shading_form.h"

void gn_shading_portable(gn_fragment_shader *shader, shading_functions *out)
{
    fill_shading(shader, out);
}
#endif
