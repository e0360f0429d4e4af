/* The shading of a back end: its own forms of lookups and of the ready-made shaders, which the draw
 * calls through pointers. The file that includes this first defines its form of lanes and the name
 * of the entry point, GN_SHADING. Shading is compiled apart from the stages: in one unit, compilers
 * inline less of either (AVX2's depth test by D16 took 18 % longer). */
#include "../lanes/target_begin.inl"

#include "entry_points.h"

#include "../kernel/shaders/own_form.inl"
#include "../kernel/texture/lookup.inl"

/* Returns the back end's form of the vertex shaders of surfaces, and any other shader as it is. */
static inline gn_vertex_shader *own_vertex_shader(gn_vertex_shader *shader)
{
    return shader == gni_shade_vertex_surface    ? shade_vertex_surface
           : shader == gni_shade_vertex_metallic ? shade_vertex_metallic
                                                 : shader;
}

void GN_SHADING(const gn_pipeline *pipeline, shading_functions *out)
{
    out->texture_functions.lookup_2d = lookup_any_2d;
    out->texture_functions.lookup = lookup_any;
    out->texture_functions.gather = gather_any;
    out->texture_functions.fetch = fetch_numbered;
#if defined(GN_LANES_VECTORS) || defined(GN_LANES_ARRAYS)
    /* The public shaders are of the portable form. */
    out->vertex_shader = pipeline->program.vertex_shader;
    out->fragment_shader = pipeline->program.fragment_shader;
#else
    out->vertex_shader = own_vertex_shader(pipeline->program.vertex_shader);
    out->fragment_shader = own_fragment_shader(pipeline->program.fragment_shader);
#endif
}

#include "../lanes/target_end.inl"
