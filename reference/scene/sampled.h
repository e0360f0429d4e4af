/* A user's shader that multiplies the vertices' colours by the texels of a texture of any target.
 * Its twins in GLSL are in reference/osmesa/sampled_program.c. */
#ifndef SCENE_SAMPLED_H
#define SCENE_SAMPLED_H

#include "scene.h"

/* Varyings: a colour, then four texture coordinates. */
enum {
    SAMPLED_COLOR = 0,
    SAMPLED_COORDINATES = 4,
    SAMPLED_REFERENCE = 7,
    SAMPLED_VARYINGS = 8 /* scalars */
};

/* Sets shaders, varyings and uniforms. The shader reads the light's matrix, the texture and the
 * sampler from the uniforms. The first three texture coordinates are the target's
 * (gnomon/sampling.h); the fourth is the reference value of depth comparisons. */
gn_status sampled_use(gn_pipeline *pipeline, const scene_uniforms *uniforms, gn_backend backend);

#endif
