/* The program's clip planes (OpenGL 2.1 section 2.12). */
#ifndef OSMESA_CLIP_PLANES_H
#define OSMESA_CLIP_PLANES_H

#include "../context/gl_context.h"

/* Writes the planes that are enabled, in clip space. Returns how many there are. */
uint32_t derive_clip_planes(context *gl, GLfloat plane[CLIP_PLANES][4]);

/* Returns the signed distance of a place to a plane, both in clip space; not negative inside. The
 * order of operations is the reference's. */
static inline GLfloat clip_distance(const GLfloat plane[4], GLfloat x, GLfloat y, GLfloat z,
                                    GLfloat w)
{
    return ((x * plane[0] + y * plane[1]) + z * plane[2]) + w * plane[3];
}

#endif
