/* A user's shader that multiplies the vertices' colours by the texels of a texture of any target.
 * Its twins in GLSL are in reference/osmesa/sampled_program.c. */
#ifndef SCENE_SAMPLED_H
#define SCENE_SAMPLED_H

#include "scene.h"

/* Varyings: a colour; the coordinates that the target has; the reference value, if depths are
 * compared. The twins in GLSL interpolate these alone too, since the others are not read. */
enum { SAMPLED_COLOR = 0, SAMPLED_COORDINATES = 4 };

static inline uint32_t sampled_coordinates(const scene_uniforms *u)
{
    const gn_texture_target target = u->texture.target;

    return target == GN_TEXTURE_1D ? 1 : target == GN_TEXTURE_2D ? 2 : 3;
}

static inline bool sampled_is_compared(const scene_uniforms *u)
{
    return u->sampler.compare != GN_COMPARE_DEFAULT && !scene_is_color_format(u->texture.format);
}

/* Sets shaders, varyings and uniforms. The shader reads the light's matrix, the texture and the
 * sampler from the uniforms. The first three texture coordinates are the target's
 * (gnomon/lookup.h); the fourth is the reference value of depth comparisons. */
gn_status sampled_use(gn_pipeline *pipeline, const scene_uniforms *uniforms, gn_backend backend);

#endif
