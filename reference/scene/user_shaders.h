/* The shaders that scenes draw with as a user's program would: written against the public headers,
 * and compiled once per instruction set.
 *
 * The library cannot compile a user's function for wider vectors. A user who wants speed compiles a
 * shader once per instruction set, and takes the one for the back end that will run it: that a back
 * end is available shows that the processor has the instruction set. */
#ifndef SCENE_USER_SHADERS_H
#define SCENE_USER_SHADERS_H

#include <gnomon.h>

#include "phong.h"

typedef struct user_shaders {
    gn_vertex_shader *phong_vertices, *sampled_vertices;
    gn_fragment_shader *phong, *sampled, *inputs, *sample_inputs, *derivatives;
    gn_fragment_shader *outputs[GN_MAX_COLORS]; /* by the number of colours, minus one */
    gn_status (*use_phong_functions)(gn_pipeline *pipeline, const phong_uniforms *uniforms);
} user_shaders;

/* Returns the shaders for draws on a back end, which may be GN_BACKEND_AUTO. The pixels are the
 * same with any form. */
const user_shaders *user_shaders_for(gn_backend backend);

#endif
