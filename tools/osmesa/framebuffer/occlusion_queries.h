/* Occlusion queries (OpenGL 1.5 section 4.1.7; GL_ARB_occlusion_query2 for whether any sample
 * passed): they count the samples that pass the depth test. Drawing waits for nothing here, so that
 * a result is there as soon as its query ends. Contexts do not share queries. */
#ifndef OSMESA_OCCLUSION_QUERIES_H
#define OSMESA_OCCLUSION_QUERIES_H

#include "../context/gl_context.h"

struct occlusion_query {
    GLuint name;
    GLenum target;
    uint64_t samples;
};

#endif
