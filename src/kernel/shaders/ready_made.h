/* The functions that pipelines with ready-made shaders point to. Back ends recognise these
 * functions and run their own form instead. */
#ifndef GN_KERNEL_SHADERS_READY_MADE_H
#define GN_KERNEL_SHADERS_READY_MADE_H

#include <gnomon/shaders.h>

/* The names of all of them. */
#define GN_VERTEX_SHADERS(X)                                                                       \
    X(shade_vertex_position)                                                                       \
    X(shade_vertex_color)                                                                          \
    X(shade_vertex_unlit)                                                                          \
    X(shade_vertex_lit)                                                                            \
    X(shade_vertex_surface)                                                                        \
    X(shade_vertex_metallic)

#define GN_FRAGMENT_SHADERS(X)                                                                     \
    X(shade_color)                                                                                 \
    X(shade_unlit_texture)                                                                         \
    X(shade_lit_texture)                                                                           \
    X(shade_flat)                                                                                  \
    X(shade_toon)                                                                                  \
    X(shade_phong)                                                                                 \
    X(shade_blinn_phong)                                                                           \
    X(shade_metallic_roughness)                                                                    \
    X(shade_normal_color)                                                                          \
    X(shade_depth_color)

/* The forms of one lane are those that the functions call for a single vertex or fragment. */
#define DECLARE_VERTEX_SHADER(name) gn_vertex_shader gni_##name, gni_one_lane_##name;
#define DECLARE_FRAGMENT_SHADER(name) gn_fragment_shader gni_##name, gni_one_lane_##name;
GN_VERTEX_SHADERS(DECLARE_VERTEX_SHADER)
GN_FRAGMENT_SHADERS(DECLARE_FRAGMENT_SHADER)

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
