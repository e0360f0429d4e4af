/* A user's shader with several colours; the pipeline's color_count is their number. Colour a is the
 * vertices' colour with its channels turned by a places; for odd a it is one minus that. Its twin
 * in GLSL is in reference/osmesa/programs.c. */
#ifndef SCENE_OUTPUTS_H
#define SCENE_OUTPUTS_H

#include <gnomon.h>

/* Sets shaders, varyings and uniforms for the pipeline's color_count. */
gn_status outputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms, gn_backend backend);

#endif
