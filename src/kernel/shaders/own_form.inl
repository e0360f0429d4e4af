/* Finds a back end's own form of a ready-made fragment shader. */
#ifndef GN_KERNEL_SHADERS_OWN_FORM_INL
#define GN_KERNEL_SHADERS_OWN_FORM_INL

#include "metallic_roughness.inl"
#include "ready_made.h"
#include "unlit.inl"

/* Returns the own form of a ready-made shader, and any other shader as it is. It compares, since a
 * table of functions would need relocation. */
static inline gn_fragment_shader *own_fragment_shader(gn_fragment_shader *shader)
{
    return shader == gni_shade_phong                ? shade_phong
           : shader == gni_shade_blinn_phong        ? shade_blinn_phong
           : shader == gni_shade_metallic_roughness ? shade_metallic_roughness
           : shader == gni_shade_toon               ? shade_toon
           : shader == gni_shade_flat               ? shade_flat
           : shader == gni_shade_color              ? shade_color
           : shader == gni_shade_lit_texture        ? shade_lit_texture
           : shader == gni_shade_unlit_texture      ? shade_unlit_texture
           : shader == gni_shade_normal_color       ? shade_normal_color
           : shader == gni_shade_depth_color        ? shade_depth_color
                                                    : shader;
}

#endif
