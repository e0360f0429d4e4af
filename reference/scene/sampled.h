/* A user's shader that multiplies the vertices' colours by the texels of a texture of any target.
 * Its twins in GLSL are in reference/osmesa/sampled_program.c. */
#ifndef SCENE_SAMPLED_H
#define SCENE_SAMPLED_H

#include "scene.h"

/* Sets shaders, varyings and uniforms. The shader reads the light's matrix, the texture and the
 * sampler from the uniforms. The first three texture coordinates are the target's
 * (gnomon/sampling.h); the fourth is the reference value of depth comparisons. */
gn_status sampled_use(gn_pipeline *pipeline, const scene_uniforms *uniforms);

#endif
