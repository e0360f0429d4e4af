/* Looks at colours and opacity, and combines them. Texels have red in the lowest byte and alpha in
 * the highest. */
#include "image_alpha.h"

#include <stdlib.h>

static size_t texel_count(const image *i)
{
    return (size_t)i->width * i->height;
}

bool image_make_opaque(image *i)
{
    bool had_alpha = false;
    for (size_t k = 0; k < texel_count(i); ++k) {
        had_alpha = had_alpha || i->texels[k] >> 24 != 255;
        i->texels[k] |= 0xff000000u;
    }
    return had_alpha;
}

static bool has_alpha(const image *i)
{
    for (size_t k = 0; k < texel_count(i); ++k)
        if (i->texels[k] >> 24 != 255)
            return true;
    return false;
}

/* The opacity that a texel states. Luminance has the weights of ITU-R BT.709. */
static uint32_t opacity_of(uint32_t texel, char channel)
{
    const uint32_t red = texel & 255, green = texel >> 8 & 255, blue = texel >> 16 & 255;
    switch (channel) {
    case 'r':
        return red;
    case 'g':
        return green;
    case 'b':
        return blue;
    case 'm':
        return texel >> 24;
    default:
        return (2126 * red + 7152 * green + 722 * blue + 5000) / 10000;
    }
}

bool image_is_grey(const image *i)
{
    for (size_t k = 0; k < texel_count(i); ++k)
        if ((i->texels[k] & 0xffff) != (i->texels[k] >> 8 & 0xffff))
            return false;
    return true;
}

bool image_set_alpha(image *i, const image *opacity, char channel)
{
    if (channel == '\0' || channel == 'z')
        channel = has_alpha(opacity) ? 'm' : 'l';
    if (i->texels == NULL) {
        i->texels = malloc(texel_count(opacity) * sizeof *i->texels);
        if (i->texels == NULL)
            return false;
        i->width = opacity->width;
        i->height = opacity->height;
        for (size_t k = 0; k < texel_count(i); ++k)
            i->texels[k] = 0x00ffffffu;
    }
    for (uint32_t y = 0; y < i->height; ++y) {
        const uint32_t *const row =
            opacity->texels + (size_t)((uint64_t)y * opacity->height / i->height) * opacity->width;
        for (uint32_t x = 0; x < i->width; ++x) {
            const uint32_t texel = row[(uint64_t)x * opacity->width / i->width];
            uint32_t *const to = i->texels + (size_t)y * i->width + x;
            *to = (*to & 0x00ffffffu) | opacity_of(texel, channel) << 24;
        }
    }
    return true;
}

bool image_settle_alpha(image *diffuse, const image *opacity, char channel, bool is_opaque,
                        bool has_opacity, bool *left_out)
{
    *left_out = false;
    if (opacity->texels != NULL && !is_opaque)
        return image_set_alpha(diffuse, opacity, channel);
    if (diffuse->texels != NULL && (is_opaque || !has_opacity))
        *left_out = image_make_opaque(diffuse) && !has_opacity;
    return true;
}
