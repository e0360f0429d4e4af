/* Textures and samplers: what may be sampled, and sampling for callers. */
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
    const size_t stride =
        texture->level[0].row_stride < 0 ? 0 - (size_t)texture->level[0].row_stride : (size_t)texture->level[0].row_stride;
    if ((uintptr_t)texture->level[0].texels % element != 0 || stride % element != 0)
        return GN_MISALIGNED;
    if (texture->height > 1 &&
        (stride < row || stride > (size_t)PTRDIFF_MAX / (texture->height - 1)))
        return GN_INVALID_STRIDE;
    return GN_OK;
}

gn_status gn_sampler_check(const gn_sampler *sampler)
{
    if (!sampler)
        return GN_NULL_POINTER;
    if ((unsigned)sampler->wrap_s > GN_WRAP_CLAMP_TO_EDGE ||
        (unsigned)sampler->wrap_t > GN_WRAP_CLAMP_TO_EDGE ||
        (unsigned)sampler->magnify > GN_MAGNIFY_NEAREST ||
        (unsigned)sampler->minify > GN_MINIFY_LINEAR)
        return GN_INVALID_ENUM;
    return GN_OK;
}

void gn_sample_2d(const gn_texture *texture, const gn_sampler *sampler, const float s[GN_LANES],
                  const float t[GN_LANES], float texel[4][GN_LANES])
{
    sample_2d(texture, sampler, s, t, texel);
}
