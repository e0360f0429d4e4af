/* A user's shader that shows derivatives. Its twin in GLSL is in reference/osmesa/programs.c. */
#ifndef SCENE_DERIVATIVES_H
#define SCENE_DERIVATIVES_H

#include <gnomon.h>

/* Sets shaders, varyings and uniforms: those of vertex colours, but the fragment shader writes the
 * colours' derivatives instead of the colours. */
gn_status derivatives_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms,
                          gn_backend backend);

#endif
