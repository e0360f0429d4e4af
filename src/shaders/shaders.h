/* The functions that pipelines with ready-made shaders point to. Back ends recognise
 * them and run their own form instead. */
#ifndef GN_SHADERS_SHADERS_H
#define GN_SHADERS_SHADERS_H

#include "gnomon/shaders.h"

gn_vertex_shader gn_shade_vertex_color;
gn_vertex_shader gn_shade_lit;
gn_vertex_shader gn_shade_lit_textured;
gn_fragment_shader gn_shade_color;
gn_fragment_shader gn_shade_textured;

#endif
