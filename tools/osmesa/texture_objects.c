#include "texture_objects.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "gl_errors.h"
#include "object_names.h"

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
    return texture;
}

void release_texture(void *released)
{
    texture_object *const texture = released;

    if (!texture || --texture->references > 0)
        return;
    for (int level = 0; level < GN_MAX_LEVELS; ++level)
        free(texture->image[level].texels);
    free(texture);
}

int texture_index(GLenum target)
{
    return target == GL_TEXTURE_1D ? 0 : target == GL_TEXTURE_2D ? 1 : -1;
}

texture_object *bound_texture(context *gl, GLenum target, const char *function)
{
    const int index = texture_index(target);

    if (index >= 0)
        return gl->unit[gl->active_texture].bound[index];
    gl_error(gl, GL_INVALID_ENUM, function);
    return NULL;
}

static void refer_to_texture(texture_object **place, texture_object *texture)
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

void glGenTextures(GLsizei count, GLuint *names)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (count < 0)
        gl_error(gl, GL_INVALID_VALUE, __func__);
    else if (names && !reserve_names(gl->shared->textures, count, names))
        gl_error(gl, GL_OUT_OF_MEMORY, __func__);
}

void glDeleteTextures(GLsizei count, const GLuint *names)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (count < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    for (GLsizei n = 0; n < count && names; ++n) {
        texture_object *const texture = remove_name(gl->shared->textures, names[n]);

        for (int unit = 0; texture && unit < TEXTURE_UNITS; ++unit)
            for (int i = 0; i < TEXTURE_TARGETS; ++i)
                if (gl->unit[unit].bound[i] == texture)
                    refer_to_texture(&gl->unit[unit].bound[i], gl->shared->default_texture[i]);
        release_texture(texture);
    }
}

void glBindTexture(GLenum target, GLuint name)
{
    context *const gl = enter(__func__);
    const int index = texture_index(target);
    texture_object *texture;

    if (!gl)
        return;
    if (index < 0) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    texture = name ? find_object(gl->shared->textures, name) : gl->shared->default_texture[index];
    if (texture && texture->target != target) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    if (!texture) {
        texture = create_texture(name, target);
        if (!texture || !set_object(gl->shared->textures, name, texture)) {
            free(texture);
            gl_error(gl, GL_OUT_OF_MEMORY, __func__);
            return;
        }
    }
    refer_to_texture(&gl->unit[gl->active_texture].bound[index], texture);
}

GLboolean glIsTexture(GLuint name)
{
    context *const gl = enter(__func__);

    return gl && find_object(gl->shared->textures, name) != NULL;
}

/* What a draw reads */

static gn_wrap wrap_of(GLenum wrap, bool is_nearest)
{
    switch (wrap) {
    case GL_CLAMP:
        return is_nearest ? GN_WRAP_CLAMP_TO_EDGE : GN_WRAP_CLAMP_TO_BORDER;
    case GL_CLAMP_TO_EDGE:
        return GN_WRAP_CLAMP_TO_EDGE;
    case GL_CLAMP_TO_BORDER:
        return GN_WRAP_CLAMP_TO_BORDER;
    case GL_MIRRORED_REPEAT:
        return GN_WRAP_MIRRORED_REPEAT;
    default:
        return GN_WRAP_REPEAT;
    }
}

static gn_minify minify_of(GLenum filter)
{
    switch (filter) {
    case GL_NEAREST:
        return GN_MINIFY_NEAREST;
    case GL_LINEAR:
        return GN_MINIFY_LINEAR;
    case GL_NEAREST_MIPMAP_NEAREST:
        return GN_MINIFY_NEAREST_MIPMAP_NEAREST;
    case GL_LINEAR_MIPMAP_NEAREST:
        return GN_MINIFY_LINEAR_MIPMAP_NEAREST;
    case GL_LINEAR_MIPMAP_LINEAR:
        return GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    default:
        return GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    }
}

/* The border as a texel of the image. */
static void set_border(const texture_image *image, const GLfloat from[4], float to[4])
{
    const GLenum base_format = image->base_format;
    const bool is_alpha = base_format == GL_ALPHA;
    const bool is_grey = base_format == GL_LUMINANCE || base_format == GL_LUMINANCE_ALPHA ||
                         base_format == GL_INTENSITY;

    for (int c = 0; c < 3; ++c)
        to[c] = is_alpha ? 0.0f : is_grey ? from[0] : from[c];
    to[3] = base_format == GL_INTENSITY                            ? from[0]
            : base_format == GL_LUMINANCE || base_format == GL_RGB ? 1.0f
                                                                   : from[3];
    for (int c = 0; c < 4 && image->format != GN_FORMAT_RGBA32F; ++c)
        to[c] = !(to[c] > 0.0f) ? 0.0f : to[c] > 1.0f ? 1.0f : to[c];
}

int linear_filters(const texture_object *object)
{
    return (object->magnify == GL_LINEAR) + (object->minify == GL_LINEAR ||
                                             object->minify == GL_LINEAR_MIPMAP_NEAREST ||
                                             object->minify == GL_LINEAR_MIPMAP_LINEAR);
}

static void set_sampler(const texture_object *object, GLfloat unit_lod_bias, gn_sampler *sampler)
{
    const bool is_nearest = linear_filters(object) == 0;

    memset(sampler, 0, sizeof *sampler);
    sampler->wrap_s = wrap_of(object->wrap[0], is_nearest);
    sampler->wrap_t = wrap_of(object->wrap[1], is_nearest);
    sampler->magnify = object->magnify == GL_NEAREST ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR;
    sampler->minify = minify_of(object->minify);
    sampler->lod_bias = object->lod_bias + unit_lod_bias;
    sampler->lod_clamp_enabled = object->min_lod > 0.0f || object->max_lod < 1000.0f;
    sampler->min_lod = object->min_lod > 0.0f ? object->min_lod : 0.0f;
    sampler->max_lod = object->max_lod > sampler->min_lod ? object->max_lod : sampler->min_lod;
    set_border(&object->image[object->base_level], object->border, sampler->border);
}

static GLint halved(GLint size)
{
    return size > 1 ? size / 2 : 1;
}

bool describe_texture(const texture_object *object, GLfloat unit_lod_bias, gn_texture *texture,
                      gn_sampler *sampler)
{
    const bool has_levels = object->minify != GL_NEAREST && object->minify != GL_LINEAR;
    const GLint base = object->base_level;
    const texture_image *const first = base < GN_MAX_LEVELS ? &object->image[base] : NULL;
    GLint width, height;

    if (!first || !first->texels || object->max_level < base)
        return false;
    memset(texture, 0, sizeof *texture);
    texture->target = object->target == GL_TEXTURE_1D ? GN_TEXTURE_1D : GN_TEXTURE_2D;
    texture->format = first->format;
    texture->width = (uint32_t)first->width;
    texture->height = (uint32_t)first->height;
    width = first->width;
    height = first->height;
    for (GLint level = base; level < GN_MAX_LEVELS; ++level) {
        const texture_image *const image = &object->image[level];
        gn_texture_level *const to = &texture->level[texture->level_count];

        if (!image->texels || image->width != width || image->height != height ||
            image->internal_format != first->internal_format)
            return false;
        to->texels = image->texels;
        to->row_stride = image->width * (ptrdiff_t)gn_format_size(image->format);
        ++texture->level_count;
        if (!has_levels || (width == 1 && height == 1) || level >= object->max_level)
            break;
        width = halved(width);
        height = halved(height);
    }
    set_sampler(object, unit_lod_bias, sampler);
    return true;
}
