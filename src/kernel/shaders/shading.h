/* The functions that a draw shades with: lookup functions and shaders, in the forms chosen for
 * the draw. */
#ifndef GN_KERNEL_SHADERS_SHADING_H
#define GN_KERNEL_SHADERS_SHADING_H

#include <gnomon/pipeline.h>

typedef struct shading_functions {
    gn_texture_functions texture_functions;
    gn_vertex_shader *vertex_shader;
    gn_fragment_shader *fragment_shader;
} shading_functions;

#endif
