/* What a draw reads of a texture object: its levels, if it is complete (OpenGL 2.1 section 3.8.10),
 * and how it is sampled. */
#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "texture_objects.h"

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

/* The border as a texel of the image. Depths are red. */
static void set_border(const texture_image *image, const GLfloat from[4], float to[4])
{
    const GLenum base_format = image->base_format;
    const bool is_alpha = base_format == GL_ALPHA;
    const bool is_grey = base_format == GL_LUMINANCE || base_format == GL_LUMINANCE_ALPHA ||
                         base_format == GL_INTENSITY;
    const bool has_floats = image->format == GN_FORMAT_RGBA32F ||
                            image->format == GN_FORMAT_D32FS8 ||
                            (image->format == GN_FORMAT_D32F && !image->is_fixed_depth);

    for (int c = 0; c < 3; ++c)
        to[c] = is_alpha ? 0.0f : is_grey ? from[0] : from[c];
    to[3] = base_format == GL_INTENSITY                            ? from[0]
            : base_format == GL_LUMINANCE || base_format == GL_RGB ? 1.0f
                                                                   : from[3];
    for (int c = 0; c < 4 && !has_floats; ++c)
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
    sampler->wrap_r = wrap_of(object->wrap[2], is_nearest);
    sampler->magnify = object->magnify == GL_NEAREST ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR;
    sampler->minify = minify_of(object->minify);
    sampler->lod_bias = object->lod_bias + unit_lod_bias;
    sampler->lod_clamp_enabled = object->min_lod > 0.0f || object->max_lod < 1000.0f;
    sampler->min_lod = object->min_lod > 0.0f ? object->min_lod : 0.0f;
    sampler->max_lod = object->max_lod > sampler->min_lod ? object->max_lod : sampler->min_lod;
    if (object->compare_mode != GL_NONE)
        sampler->compare = (gn_compare)(GN_NEVER + (object->compare_function - GL_NEVER));
    set_border(&object->image[0][object->base_level], object->border, sampler->border);
}

GLenum read_base_format(const texture_object *object)
{
    const GLenum format = object->image[0][object->base_level].base_format;

    return format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL ? object->depth_mode : format;
}

static GLint halved(GLint size)
{
    return size > 1 ? size / 2 : 1;
}

static bool is_like(const texture_image *image, const texture_image *other)
{
    return image->texels && image->width == other->width && image->height == other->height &&
           image->depth == other->depth && image->internal_format == other->internal_format;
}

/* Whether a level has the size that follows from the first one's, on all faces. */
static bool is_complete(const texture_object *object, GLint level, const texture_image *expected)
{
    for (int face = 0; face < (object->target == GL_TEXTURE_CUBE_MAP ? CUBE_FACES : 1); ++face)
        if (!is_like(&object->image[face][level], expected))
            return false;
    return true;
}

static size_t image_size(const texture_image *image)
{
    return (size_t)image->width * (size_t)image->height * (size_t)image->depth *
           gn_format_size(image->format);
}

static size_t gathered_size(const texture_object *object, GLint level)
{
    const size_t size = CUBE_FACES * image_size(&object->image[0][level]);

    return (size + 15) / 16 * 16; /* aligned for every format */
}

/* Copies the faces of `count` complete levels of a cube side by side. Returns false if memory is
 * short. */
static bool gather_faces(texture_object *object, GLint base, uint32_t count)
{
    unsigned char *to;
    size_t size = 0;

    for (uint32_t n = 0; n < count; ++n)
        size += gathered_size(object, base + (GLint)n);
    if (!object->cube_is_old && object->cube_size == size)
        return true;
    to = realloc(object->cube, size);
    if (!to)
        return false;
    object->cube = to;
    object->cube_size = size;
    object->cube_is_old = false;
    for (uint32_t n = 0; n < count; ++n) {
        const GLint level = base + (GLint)n;
        const size_t size_of_face = image_size(&object->image[0][level]);

        for (size_t face = 0; face < CUBE_FACES; ++face)
            memcpy(to + face * size_of_face, object->image[face][level].texels, size_of_face);
        to += gathered_size(object, level);
    }
    return true;
}

/* Sets where the levels of a texture are. */
static void set_levels(const texture_object *object, GLint base, gn_texture *texture)
{
    const unsigned char *cube = object->cube;

    for (uint32_t n = 0; n < texture->level_count; ++n) {
        const texture_image *const image = &object->image[0][base + (GLint)n];
        gn_texture_level *const to = &texture->level[n];

        to->texels = image->texels;
        to->row_stride = image->width * (ptrdiff_t)gn_format_size(image->format);
        to->layer_stride = to->row_stride * image->height;
        if (object->target == GL_TEXTURE_CUBE_MAP) {
            to->texels = cube;
            cube += gathered_size(object, base + (GLint)n);
        }
    }
}

static gn_texture_target target_of(GLenum target)
{
    return target == GL_TEXTURE_1D         ? GN_TEXTURE_1D
           : target == GL_TEXTURE_3D       ? GN_TEXTURE_3D
           : target == GL_TEXTURE_CUBE_MAP ? GN_TEXTURE_CUBE
                                           : GN_TEXTURE_2D;
}

bool describe_texture(texture_object *object, GLfloat unit_lod_bias, gn_texture *texture,
                      gn_sampler *sampler)
{
    const bool has_levels = object->minify != GL_NEAREST && object->minify != GL_LINEAR;
    const GLint base = object->base_level;
    const texture_image *const first = base < GN_MAX_LEVELS ? &object->image[0][base] : NULL;
    texture_image expected;

    if (!first || !first->texels || object->max_level < base)
        return false;
    memset(texture, 0, sizeof *texture);
    texture->target = target_of(object->target);
    texture->format = first->format;
    texture->width = (uint32_t)first->width;
    texture->height = (uint32_t)first->height;
    texture->depth = (uint32_t)first->depth;
    expected = *first;
    for (GLint level = base; level < GN_MAX_LEVELS; ++level) {
        if (!is_complete(object, level, &expected))
            return false;
        ++texture->level_count;
        if (!has_levels || level >= object->max_level ||
            (expected.width == 1 && expected.height == 1 && expected.depth == 1))
            break;
        expected.width = halved(expected.width);
        expected.height = halved(expected.height);
        expected.depth = halved(expected.depth);
    }
    if (object->target == GL_TEXTURE_CUBE_MAP && !gather_faces(object, base, texture->level_count))
        return false;
    set_levels(object, base, texture);
    set_sampler(object, unit_lod_bias, sampler);
    return true;
}
