/* Texture objects (OpenGL 2.1 section 3.8). Contexts that share them count references, as with
 * buffers. */
#ifndef OSMESA_TEXTURE_OBJECTS_H
#define OSMESA_TEXTURE_OBJECTS_H

#include "../context/gl_context.h"

enum { CUBE_FACES = 6 };

/* The texels of a level. Colours are kept with all four channels: what their base format lacks is
 * 0, or 1 for alpha, and luminance and intensity are repeated. */
typedef struct texture_image {
    GLint width, height, depth; /* 0: no image */
    GLenum internal_format, base_format;
    gn_format format;
    bool is_fixed_depth;   /* floats stand for depths of 32 bits */
    unsigned char *texels; /* rows without gaps, the lowest first; slices without gaps */
} texture_image;

struct texture_object {
    int references;
    GLuint name;
    GLenum target; /* 0 before it is bound */
    GLenum minify, magnify, wrap[3];
    GLfloat border[4], priority, min_lod, max_lod, lod_bias;
    GLint base_level, max_level;
    GLenum compare_mode, compare_function, depth_mode;
    GLboolean generates_levels;
    texture_image image[CUBE_FACES][GN_MAX_LEVELS]; /* but for cubes only [0] */

    /* The faces of a cube side by side, for draws. Whoever changes texels of a cube sets is_old. */
    unsigned char *cube;
    size_t cube_size;
    bool cube_is_old;
};

/* Returns a texture without images; null if memory is short. */
texture_object *create_texture(GLuint name, GLenum target);

/* Create one texture without a name for each target; false if memory is short. */
bool create_textures(texture_object *texture[TEXTURE_TARGETS]);
void release_textures(texture_object *texture[TEXTURE_TARGETS]);

/* Drops what an object table held, or a reference. */
void release_texture(void *texture);

/* Returns the index of a target by its name; below 0 for another name. */
int texture_index(GLenum target);

/* Makes a place refer to another texture, or to none. */
void refer_to_texture(texture_object **place, texture_object *texture);

/* Returns the texture that is bound to a target of the active unit; null, with an error, if there
 * is no such target. */
texture_object *bound_texture(context *gl, GLenum target, const char *function);

/* What the target of a function that sets or returns images means. */
typedef struct image_target {
    texture_object *texture;
    int face; /* of a cube, otherwise 0 */
    bool is_proxy;
} image_target;

/* Finds what an image's target means: one of `dimensions`, or of any number if that is 0. Returns
 * false, with an error, for another name. */
bool find_image_target(context *gl, GLenum target, int dimensions, const char *function,
                       image_target *to);

/* Returns the greatest size of a level 0 along each dimension. */
GLint greatest_size(GLenum target);

/* Binds the default textures to all units of a new context. */
void bind_default_textures(context *gl);
void unbind_textures(context *gl);

/* Describes the texture that a draw reads with these parameters. Returns false if it is incomplete
 * (section 3.8.10), or if memory is short. */
bool describe_texture(texture_object *object, GLfloat unit_lod_bias, gn_texture *texture,
                      gn_sampler *sampler);

/* Returns how many of the two filters within a level are linear. */
int linear_filters(const texture_object *object);

/* Returns the base format that an environment sees: depths are what GL_DEPTH_TEXTURE_MODE says. */
GLenum read_base_format(const texture_object *object);

/* Makes the levels after the base level, up to max_level, from it. Returns false if memory is
 * short. */
bool generate_levels(texture_object *texture);

/* Does so if the texture asks for it and a base level has changed. */
void texture_changed(context *gl, const image_target *target, GLint level, const char *function);

#endif
