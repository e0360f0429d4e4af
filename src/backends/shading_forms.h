/* The functions that a back end shades fragments with: its own forms of lookups and of the
 * ready-made shaders. They are compiled apart from the rasterizer, which calls them through
 * pointers, so that neither makes the other slow to compile. */
#ifndef GN_BACKENDS_SHADING_FORMS_H
#define GN_BACKENDS_SHADING_FORMS_H

#include "../config/backends.h"
#include "../kernel/shaders/shading.h"

/* Declares gni_shading_portable, gni_shading_sse2 and so on, one function for each row of
 * GN_BACKENDS. The function fills in `out` for a pipeline's shaders; the user's own shaders stay
 * what they are. Functions of back ends that are not compiled are not defined. With GN_SMALL none
 * is defined. */
#define GN_DECLARE_SHADING(name, NAME, have, text)                                                 \
    void gni_shading_##name(const gn_pipeline *pipeline, shading_functions *out);
GN_BACKENDS(GN_DECLARE_SHADING)
#undef GN_DECLARE_SHADING

#endif
