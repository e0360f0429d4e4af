/* The functions that pipelines with ready-made shaders point to. Back ends recognise these
 * functions and run their own form instead. */
#ifndef GN_KERNEL_SHADERS_READY_MADE_H
#define GN_KERNEL_SHADERS_READY_MADE_H

#include <gnomon/shaders.h>

gn_vertex_shader gni_shade_vertex_position;
gn_vertex_shader gni_shade_vertex_color;
gn_vertex_shader gni_shade_vertex_unlit;
gn_vertex_shader gni_shade_vertex_lit;
gn_vertex_shader gni_shade_vertex_surface;
gn_vertex_shader gni_shade_vertex_metallic;

gn_fragment_shader gni_shade_color;
gn_fragment_shader gni_shade_unlit_texture;
gn_fragment_shader gni_shade_lit_texture;
gn_fragment_shader gni_shade_flat;
gn_fragment_shader gni_shade_toon;
gn_fragment_shader gni_shade_phong;
gn_fragment_shader gni_shade_blinn_phong;
gn_fragment_shader gni_shade_metallic_roughness;
gn_fragment_shader gni_shade_normal_color;
gn_fragment_shader gni_shade_depth_color;

/* Faults of a pipeline with ready-made shaders, from changes after its gn_use_ function. */
typedef enum ready_made_fault {
    GN_READY_MADE_OK,
    GN_READY_MADE_NO_UNIFORMS, /* the uniforms are null */
    GN_READY_MADE_NO_POSITION, /* a shader reads the position, but fragment_reads_position is off */
    GN_READY_MADE_FEW_VARYINGS /* a shader reads or writes varyings beyond varying_count */
} ready_made_fault;

/* Returns the first fault; GN_READY_MADE_OK if both shaders are the user's. Precondition: the
 * pipeline has a vertex shader. The function refers to every ready-made shader, so a program that
 * calls it contains the code of all of them. */
ready_made_fault gni_find_ready_made_fault(const gn_pipeline *pipeline);

#endif
