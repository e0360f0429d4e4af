/* Formats, their random texels, and textures of the reference. */
#include "texels.h"

#include <string.h>

static float random_value(random_source *r, bool with_specials)
{
    static const uint32_t special[] = {0x7F800000u, 0xFF800000u, 0x7FC00000u,
                                       0xFFC12345u, 0x7F7FFFFFu, 0x80000000u};
    float value;

    if (with_specials && random_chance(r, 3)) {
        memcpy(&value, &special[random_below(r, sizeof special / sizeof *special)], sizeof value);
        return value;
    }
    value = random_octave(r, -12, 12);
    return value * random_sign(r);
}

static uint16_t random_half(random_source *r, bool with_specials)
{
    const uint16_t half = (uint16_t)random_bits(r);

    return (half & 0x7C00u) == 0x7C00u && !with_specials ? half ^ 0x4000u : half;
}

void fill_texels(random_source *r, gn_format format, bool with_specials, void *texels, size_t count)
{
    const size_t bytes = count * gn_format_size(format);
    uint32_t *const word = texels;
    float *const value = texels;
    const bool is_float = scene_is_color_format(format) && scene_is_float_format(format);

    for (size_t i = 0; i < bytes; ++i)
        ((unsigned char *)texels)[i] = (unsigned char)random_bits(r);
    if (is_float && scene_channel_width(format, 0) == 16)
        for (size_t i = 0; i < bytes / 2; ++i)
            ((uint16_t *)texels)[i] = random_half(r, with_specials);
    else if (is_float && scene_channel_width(format, 0) == 32)
        for (size_t i = 0; i < bytes / 4; ++i)
            value[i] = random_value(r, with_specials);
    for (size_t i = 0; i < count; ++i) {
        if (format == GN_FORMAT_R11F_G11F_B10F && !with_specials)
            word[i] &= 0x7FDFFBFFu; /* no exponent of the highest */
        if (format == GN_FORMAT_D24)
            word[i] &= 0xFFFFFFu;
        if (format == GN_FORMAT_D32F)
            value[i] = random_unit(r);
        if (format == GN_FORMAT_D32FS8) {
            value[2 * i] = random_unit(r);
            word[2 * i + 1] &= 255u;
        }
    }
}

/* Words of depth and stencil keep their bits on the way; depths alone would be rounded. */
static reference_image_format upload_format(gn_format format)
{
    reference_image_format f = reference_image_format_of(format);

    if (format == GN_FORMAT_D24) {
        f.format = GL_DEPTH_STENCIL;
        f.type = GL_UNSIGNED_INT_24_8;
    }
    return f;
}

static void turn_words(gn_format format, void *texels, size_t count, bool to_opengl)
{
    reference_turn_pixels(format == GN_FORMAT_D24 ? GN_FORMAT_D24S8 : format, texels, count,
                          to_opengl);
}

void upload_level(gn_texture_target target, gn_format format, uint32_t level,
                  const uint32_t size[3], const void *texels)
{
    const reference_image_format f = upload_format(format);
    const GLsizei w = (GLsizei)size[0], h = (GLsizei)size[1], d = (GLsizei)size[2];
    const GLint internal = (GLint)f.internal;
    const size_t face = (size_t)size[0] * size[1] * gn_format_size(format);
    const size_t count = (size_t)size[0] * size[1] * size[2];
    void *const pixels = (void *)(uintptr_t)texels;
    const GLenum name = reference_texture_target(target);

    turn_words(format, pixels, count, true);
    if (target == GN_TEXTURE_1D)
        glTexImage1D(name, (GLint)level, internal, w, 0, f.format, f.type, texels);
    else if (target == GN_TEXTURE_2D)
        glTexImage2D(name, (GLint)level, internal, w, h, 0, f.format, f.type, texels);
    else if (target != GN_TEXTURE_CUBE)
        glTexImage3D(name, (GLint)level, internal, w, h, d, 0, f.format, f.type, texels);
    for (GLenum n = 0; target == GN_TEXTURE_CUBE && n < 6; ++n)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + n, (GLint)level, internal, w, h, 0, f.format,
                     f.type, (const unsigned char *)texels + n * face);
    turn_words(format, pixels, count, false);
}
