/* Texture objects (OpenGL 2.1 section 3.8). Contexts that share them count references, as with
 * buffers. */
#ifndef OSMESA_TEXTURE_OBJECTS_H
#define OSMESA_TEXTURE_OBJECTS_H

#include "gl_context.h"

/* The texels of a level. Each is kept with all four channels: what its base format lacks is 0, or 1
 * for alpha, and luminance and intensity are repeated. */
typedef struct texture_image {
    GLint width, height; /* 0: no image */
    GLenum internal_format, base_format;
    gn_format format;
    unsigned char *texels; /* rows without gaps, the lowest first */
} texture_image;

struct texture_object {
    int references;
    GLuint name;
    GLenum target; /* 0 before it is bound */
    GLenum minify, magnify, wrap[3];
    GLfloat border[4], priority, min_lod, max_lod, lod_bias;
    GLint base_level, max_level;
    texture_image image[GN_MAX_LEVELS];
};

/* Returns a texture without images; null if memory is short. */
texture_object *create_texture(GLuint name, GLenum target);

/* Drops what an object table held, or a reference. */
void release_texture(void *texture);

/* Returns the index of a target, -1 if it is none. */
int texture_index(GLenum target);

/* Returns the texture that is bound to a target of the active unit; null, with an error, if there
 * is no such target. */
texture_object *bound_texture(context *gl, GLenum target, const char *function);

/* Binds the default textures to all units of a new context. */
void bind_default_textures(context *gl);
void unbind_textures(context *gl);

/* Describes the texture that a draw reads with these parameters. Returns false if it is incomplete
 * (section 3.8.10). */
bool describe_texture(const texture_object *object, GLfloat unit_lod_bias, gn_texture *texture,
                      gn_sampler *sampler);

/* Returns how many of the two filters within a level are linear. */
int linear_filters(const texture_object *object);

#endif
