/* A user's shader of several colours: color_count of the pipeline says how many. Colour a is the
 * vertices' colour with its channels turned by a places, and for odd a taken from one. Its twin in
 * GLSL is in reference/osmesa/programs.c. */
#ifndef SCENE_OUTPUTS_H
#define SCENE_OUTPUTS_H

#include <gnomon.h>

/* Sets shaders, varyings and uniforms, for the pipeline's color_count. */
gn_status outputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms);

#endif
