/* Creates, finds and releases texture objects. */
#include "texture_objects.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "../context/gl_errors.h"

/* What targets are called and how large their images may be. */
static const struct {
    GLenum name, proxy;
    int dimensions;
    GLint greatest;
} targets[TEXTURE_TARGETS] = {
    [TARGET_1D] = {GL_TEXTURE_1D, GL_PROXY_TEXTURE_1D, 1, 16384},
    [TARGET_2D] = {GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D, 2, 16384},
    [TARGET_3D] = {GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D, 3, 2048},
    [TARGET_CUBE] = {GL_TEXTURE_CUBE_MAP, GL_PROXY_TEXTURE_CUBE_MAP, 2, 16384},
};

texture_object *create_texture(GLuint name, GLenum target)
{
    texture_object *const texture = calloc(1, sizeof *texture);

    if (!texture)
        return NULL;
    texture->references = 1;
    texture->name = name;
    texture->target = target;
    texture->minify = GL_NEAREST_MIPMAP_LINEAR;
    texture->magnify = GL_LINEAR;
    for (int i = 0; i < 3; ++i)
        texture->wrap[i] = GL_REPEAT;
    texture->priority = 1.0f;
    texture->min_lod = -1000.0f;
    texture->max_lod = 1000.0f;
    texture->max_level = 1000;
    texture->compare_mode = GL_NONE;
    texture->compare_function = GL_LEQUAL;
    texture->depth_mode = GL_LUMINANCE;
    texture->cube_is_old = true;
    return texture;
}

void release_texture(void *released)
{
    texture_object *const texture = released;

    if (!texture || --texture->references > 0)
        return;
    for (int face = 0; face < CUBE_FACES; ++face)
        for (int level = 0; level < GN_MAX_LEVELS; ++level)
            free(texture->image[face][level].texels);
    free(texture->cube);
    free(texture);
}

bool create_textures(texture_object *texture[TEXTURE_TARGETS])
{
    bool created = true;

    for (int i = 0; i < TEXTURE_TARGETS; ++i) {
        texture[i] = create_texture(0, targets[i].name);
        created = created && texture[i];
    }
    if (!created)
        release_textures(texture);
    return created;
}

void release_textures(texture_object *texture[TEXTURE_TARGETS])
{
    for (int i = 0; i < TEXTURE_TARGETS; ++i) {
        release_texture(texture[i]);
        texture[i] = NULL;
    }
}

int texture_index(GLenum target)
{
    for (int i = 0; i < TEXTURE_TARGETS; ++i)
        if (targets[i].name == target)
            return i;
    return -1;
}

texture_object *bound_texture(context *gl, GLenum target, const char *function)
{
    const int index = texture_index(target);

    if (index >= 0)
        return gl->unit[gl->active_texture].bound[index];
    gl_error(gl, GL_INVALID_ENUM, function);
    return NULL;
}

bool find_image_target(context *gl, GLenum target, int dimensions, const char *function,
                       image_target *to)
{
    const bool is_face =
        target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z;

    *to = (image_target){NULL, 0, false};
    for (int i = 0; i < TEXTURE_TARGETS; ++i) {
        const bool is_proxy = target == targets[i].proxy;
        const bool is_named = i == TARGET_CUBE ? is_face : target == targets[i].name;

        if ((dimensions && dimensions != targets[i].dimensions) || !(is_proxy || is_named))
            continue;
        to->texture = is_proxy ? gl->proxy[i] : gl->unit[gl->active_texture].bound[i];
        to->face = is_face ? (int)(target - GL_TEXTURE_CUBE_MAP_POSITIVE_X) : 0;
        to->is_proxy = is_proxy;
        return true;
    }
    gl_error(gl, GL_INVALID_ENUM, function);
    return false;
}

GLint greatest_size(GLenum target)
{
    return targets[texture_index(target)].greatest;
}

void refer_to_texture(texture_object **place, texture_object *texture)
{
    if (texture)
        ++texture->references;
    release_texture(*place);
    *place = texture;
}

void bind_default_textures(context *gl)
{
    for (int unit = 0; unit < TEXTURE_UNITS; ++unit)
        for (int i = 0; i < TEXTURE_TARGETS; ++i)
            refer_to_texture(&gl->unit[unit].bound[i], gl->shared->default_texture[i]);
}

void unbind_textures(context *gl)
{
    for (int unit = 0; unit < TEXTURE_UNITS; ++unit)
        for (int i = 0; i < TEXTURE_TARGETS; ++i)
            refer_to_texture(&gl->unit[unit].bound[i], NULL);
}
