/* A user's shader that multiplies the vertices' colours by what it reads from a texture of any
 * target. Its twins in GLSL are in reference/osmesa/sampled_program.c. */
#ifndef SCENE_SAMPLED_H
#define SCENE_SAMPLED_H

#include "scene.h"

/* Sets shaders, varyings and uniforms, of which the light's matrix, the texture and the sampler are
 * looked at. The first three of the texture coordinates are the target's (gnomon/sampling.h), the
 * fourth is what depths are compared with. */
gn_status sampled_use(gn_pipeline *pipeline, const scene_uniforms *uniforms);

#endif
