/* A back end's shading: the text that each compiles for its own lanes. */
#ifndef GN_BACKENDS_SHADING_FORM_H
#define GN_BACKENDS_SHADING_FORM_H

#include "../shaders/shaders.h"
#include "../texture/fetch.h"
#include "../texture/sampling.h"

#include "shading.h"

/* The back end's form of a ready-made shader; of others the shader itself. */
static inline gn_fragment_shader *own_fragment_shader(gn_fragment_shader *shader)
{
    return shader;
}

static inline void fill_shading(gn_fragment_shader *shader, shading_functions *out)
{
    out->sampling.sample_2d = sample_any_2d;
    out->sampling.sample = sample_any;
    out->sampling.gather = gather_any;
    out->sampling.fetch = fetch_numbered;
    out->fragment_shader = own_fragment_shader(shader);
}

#endif
