/* Textures: what may be sampled. */
#include "sample.h"

static size_t element_size(gn_format format)
{
    return format == GN_FORMAT_RGBA8 || format == GN_FORMAT_RGBA32F ? 4 : 0;
}

gn_status gn_texture_check(const gn_texture *texture)
{
    if (!texture || !texture->level[0].texels)
        return GN_NULL_POINTER;
    if (!element_size(texture->format))
        return GN_INVALID_FORMAT;
    if (texture->width == 0 || texture->width > GN_MAX_SIZE || texture->height == 0 ||
        texture->height > GN_MAX_SIZE)
        return GN_INVALID_SIZE;

    const size_t element = element_size(texture->format);
    const size_t row = texture->width * gn_format_size(texture->format);
    const size_t stride = texture->level[0].row_stride < 0
                              ? 0 - (size_t)texture->level[0].row_stride
                              : (size_t)texture->level[0].row_stride;
    if ((uintptr_t)texture->level[0].texels % element != 0 || stride % element != 0)
        return GN_MISALIGNED;
    if (texture->height > 1 &&
        (stride < row || stride > (size_t)PTRDIFF_MAX / (texture->height - 1)))
        return GN_INVALID_STRIDE;
    return GN_OK;
}

void gn_fetch(const gn_texture *texture, const int32_t *const coordinate[3], const int32_t *level,
              float texel[4][GN_LANES])
{
    (void)texture;
    (void)coordinate;
    (void)level;
    for (int c = 0; c < 4; ++c)
        GN_EACH_LANE (l)
            texel[c][l] = 0.0f;
}
