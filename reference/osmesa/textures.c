/* Textures and samplers of scenes as OpenGL's objects. */
#include "gl.h"

#include <stdlib.h>
#include <string.h>

/* Older core headers lack these. */
#define MAX_ANISOTROPY 0x84FE

GLenum reference_texture_target(gn_texture_target target)
{
    static const GLenum targets[] = {GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_2D_ARRAY,
                                     GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};

    return targets[target];
}

/* The row itself, or what OpenGL is given for it, in `converted`: depths of 24 bits fill 32 bits,
 * or stand above the stencil, and bytes of a pixel are in the order of the machine. */
static const void *convert_row(gn_format format, const void *row, uint32_t width,
                               uint32_t *converted)
{
    if (scene_format_of(format)->high_first) {
        memcpy(converted, row, width * gn_format_size(format));
        reference_turn_pixels(format, converted, width, true);
        return converted;
    }
    if (format != GN_FORMAT_D24 && format != GN_FORMAT_D24S8)
        return row;
    for (uint32_t x = 0; x < width; ++x) {
        const uint32_t word = ((const uint32_t *)row)[x];

        converted[x] = format == GN_FORMAT_D24 ? reference_depth32_of(word & 0xFFFFFF)
                                               : word << 8 | word >> 24;
    }
    return converted;
}

static void upload_row(const gn_texture *t, uint32_t level, GLint y, GLint layer, const void *row)
{
    const GLenum target = reference_texture_target(t->target);
    const reference_image_format stored = reference_image_format_of(t->format);
    const GLenum format = stored.format;
    const GLenum type = stored.type;
    const GLsizei width = (GLsizei)scene_level_extent(t, level).width;

    switch (t->target) {
    case GN_TEXTURE_1D:
        glTexSubImage1D(target, (GLint)level, 0, width, format, type, row);
        break;
    case GN_TEXTURE_2D:
        glTexSubImage2D(target, (GLint)level, 0, y, width, 1, format, type, row);
        break;
    case GN_TEXTURE_CUBE:
        glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)layer, (GLint)level, 0, y, width,
                        1, format, type, row);
        break;
    case GN_TEXTURE_2D_ARRAY:
    case GN_TEXTURE_3D:
        glTexSubImage3D(target, (GLint)level, 0, y, layer, width, 1, 1, format, type, row);
        break;
    }
}

static bool upload_levels(const gn_texture *t)
{
    uint32_t *const converted = malloc(t->width * sizeof *converted);

    for (uint32_t level = 0; converted && level < scene_level_count(t); ++level) {
        const scene_extent e = scene_level_extent(t, level);
        const gn_texture_level *const l = &t->level[level];

        for (uint32_t row = 0; row < e.height * e.layers; ++row) {
            const uint32_t y = row % e.height;
            const uint32_t layer = row / e.height;
            const char *const texels = (const char *)l->texels +
                                       (ptrdiff_t)layer * l->layer_stride +
                                       (ptrdiff_t)y * l->row_stride;

            upload_row(t, level, (GLint)y, (GLint)layer,
                       convert_row(t->format, texels, e.width, converted));
        }
    }
    free(converted);
    return converted != NULL;
}

static GLint wrap(gn_wrap w)
{
    static const GLint wraps[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT,
                                  GL_CLAMP_TO_BORDER, GL_MIRROR_CLAMP_TO_EDGE};

    return wraps[w];
}

static GLint minify(gn_minify m)
{
    static const GLint filters[] = {GL_NEAREST_MIPMAP_LINEAR,
                                    GL_NEAREST,
                                    GL_LINEAR,
                                    GL_NEAREST_MIPMAP_NEAREST,
                                    GL_LINEAR_MIPMAP_NEAREST,
                                    GL_LINEAR_MIPMAP_LINEAR};

    return filters[m];
}

static void set_sampler(GLenum target, const gn_sampler *s, bool is_compared)
{
    glTexParameteri(target, GL_TEXTURE_WRAP_S, wrap(s->wrap_s));
    glTexParameteri(target, GL_TEXTURE_WRAP_T, wrap(s->wrap_t));
    glTexParameteri(target, GL_TEXTURE_WRAP_R, wrap(s->wrap_r));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER,
                    s->magnify == GN_MAGNIFY_NEAREST ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify(s->minify));
    glTexParameterf(target, GL_TEXTURE_LOD_BIAS, s->lod_bias);
    if (s->lod_clamp_enabled) {
        glTexParameterf(target, GL_TEXTURE_MIN_LOD, s->min_lod);
        glTexParameterf(target, GL_TEXTURE_MAX_LOD, s->max_lod);
    }
    if (s->max_anisotropy > 1)
        glTexParameterf(target, MAX_ANISOTROPY, (float)s->max_anisotropy);
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, s->border);
    if (is_compared) {
        glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC,
                        (GLint)gl_comparison(s->compare, GL_LEQUAL));
    }
}

bool reference_is_compared(const gn_texture *t, const gn_sampler *sampler)
{
    return !scene_is_color_format(t->format) && sampler->compare != GN_COMPARE_DEFAULT;
}

GLuint reference_upload_texture(const gn_texture *t, const gn_sampler *sampler)
{
    const GLenum target = reference_texture_target(t->target);
    const GLenum format = reference_image_format_of(t->format).internal;
    const GLsizei levels = (GLsizei)scene_level_count(t);
    GLuint texture;

    glGenTextures(1, &texture);
    glBindTexture(target, texture);
    switch (t->target) {
    case GN_TEXTURE_1D:
        glTexStorage1D(target, levels, format, (GLsizei)t->width);
        break;
    case GN_TEXTURE_2D:
    case GN_TEXTURE_CUBE:
        glTexStorage2D(target, levels, format, (GLsizei)t->width, (GLsizei)t->height);
        break;
    case GN_TEXTURE_2D_ARRAY:
    case GN_TEXTURE_3D:
        glTexStorage3D(target, levels, format, (GLsizei)t->width, (GLsizei)t->height,
                       (GLsizei)t->depth);
        break;
    }
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels - 1);
    set_sampler(target, sampler, reference_is_compared(t, sampler));
    if (!upload_levels(t)) {
        glDeleteTextures(1, &texture);
        return 0;
    }
    return texture;
}
