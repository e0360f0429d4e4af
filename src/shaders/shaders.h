/* The functions that pipelines with ready-made shaders point to. Back ends recognise
 * them and run their own form instead. */
#ifndef GN_SHADERS_SHADERS_H
#define GN_SHADERS_SHADERS_H

#include "gnomon/shaders.h"

gn_vertex_shader gn_shade_position;
gn_vertex_shader gn_shade_vertex_color;
gn_vertex_shader gn_shade_unlit;
gn_vertex_shader gn_shade_lit;
gn_vertex_shader gn_shade_surface;

gn_fragment_shader gn_shade_color;
gn_fragment_shader gn_shade_unlit_texture;
gn_fragment_shader gn_shade_lit_texture;
gn_fragment_shader gn_shade_flat;
gn_fragment_shader gn_shade_toon;
gn_fragment_shader gn_shade_phong;
gn_fragment_shader gn_shade_blinn_phong;
gn_fragment_shader gn_shade_normal_color;
gn_fragment_shader gn_shade_depth_color;

#endif
