/* The shading of a back end: the text that each back end compiles for its own lanes. The file that
 * includes this first defines its form of lanes and the name of its function, GN_SHADING. */
#include "../lanes/target_begin.h"

#include "shading.h"

#include "../shaders/metallic_roughness.h"
#include "../shaders/unlit.h"
#include "../texture/fetch.h"
#include "../texture/sample_any.h"

/* Returns the back end's form of a ready-made shader, and any other shader as it is. The public
 * shaders are of SSE2's form where there is one (lanes.h). By comparisons, since a table of
 * functions would need relocation. */
static inline gn_fragment_shader *own_fragment_shader(gn_fragment_shader *shader)
{
#if defined(GN_LANES_SSE2)
    return shader;
#else
    return shader == gn_shade_phong                ? shade_phong
           : shader == gn_shade_blinn_phong        ? shade_blinn_phong
           : shader == gn_shade_metallic_roughness ? shade_metallic_roughness
           : shader == gn_shade_toon               ? shade_toon
           : shader == gn_shade_flat               ? shade_flat
           : shader == gn_shade_color              ? shade_color
           : shader == gn_shade_lit_texture        ? shade_lit_texture
           : shader == gn_shade_unlit_texture      ? shade_unlit_texture
           : shader == gn_shade_normal_color       ? shade_normal_color
           : shader == gn_shade_depth_color        ? shade_depth_color
                                                   : shader;
#endif
}

static inline gn_vertex_shader *own_vertex_shader(gn_vertex_shader *shader)
{
#if defined(GN_LANES_SSE2)
    return shader;
#else
    return shader == gn_shade_surface            ? shade_surface
           : shader == gn_shade_metallic_surface ? shade_metallic_surface
                                                 : shader;
#endif
}

void GN_SHADING(const gn_pipeline *pipeline, shading_functions *out)
{
    out->sampling.sample_2d = sample_any_2d;
    out->sampling.sample = sample_any;
    out->sampling.gather = gather_any;
    out->sampling.fetch = fetch_numbered;
    out->vertex_shader = own_vertex_shader(pipeline->program.vertex_shader);
    out->fragment_shader = own_fragment_shader(pipeline->program.fragment_shader);
}

#include "../lanes/target_end.h"
