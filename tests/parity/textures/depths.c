/* Depth textures: their texels, the values that they are compared with, and the lookups that
 * compare in GLSL. */
#include <math.h>
#include <string.h>

#include "lookups.h"

/* How many depths occur often, 0 and 1 among them. */
#define STEPS 8

static bool is_fixed_point(gn_format format)
{
    return format != GN_FORMAT_D32F && format != GN_FORMAT_D32FS8;
}

static uint32_t largest_of(gn_format format)
{
    return format == GN_FORMAT_D16 ? 0xFFFF : 0xFFFFFF;
}

/* In units of the largest depth, for fixed-point formats. */
static uint32_t random_depth(random_source *r, gn_format format)
{
    const uint32_t largest = largest_of(format);

    if (random_chance(r, 50))
        return random_below(r, largest + 1);
    return (uint32_t)((uint64_t)largest * random_below(r, STEPS + 1) / STEPS);
}

/* OpenGL clamps depths as they are uploaded, floats too. */
static float random_float_depth(random_source *r)
{
    if (random_chance(r, 50))
        return random_float(r, 0.0f, 1.0f);
    return (float)random_below(r, STEPS + 1) / STEPS;
}

void fill_depths(random_source *r, gn_format format, void *texels, size_t count)
{
    uint16_t *const halves = texels;
    uint32_t *const words = texels;
    float *const floats = texels;

    for (size_t i = 0; i < count; ++i) {
        if (format == GN_FORMAT_D16) {
            halves[i] = (uint16_t)random_depth(r, format);
        } else if (format == GN_FORMAT_D24) {
            words[i] = random_depth(r, format);
        } else if (format == GN_FORMAT_D24S8) {
            words[i] = random_depth(r, format);
            words[i] |= random_below(r, 256) << 24;
        } else if (format == GN_FORMAT_D32F) {
            floats[i] = random_float_depth(r);
        } else {
            floats[2 * i] = random_float_depth(r);
            words[2 * i + 1] = random_below(r, 256);
        }
    }
}

float random_reference(random_source *r, gn_format format, bool is_wild)
{
    static const float special[] = {-0.0f, -0.5f, 1.5f, 1e30f, INFINITY, -INFINITY, NAN};

    if (random_chance(r, 10))
        return special[random_below(r, is_wild ? 7 : 4)];
    if (!is_fixed_point(format))
        return random_float_depth(r);
    return (float)random_depth(r, format) * (1.0f / (float)largest_of(format));
}

bool can_compare(lookup_kind kind, gn_texture_target target)
{
    switch (kind) {
    case LOOKUP_IMPLICIT:
    case LOOKUP_GRADIENTS:
        return target != GN_TEXTURE_3D;
    case LOOKUP_BIAS:
        return target != GN_TEXTURE_3D && target != GN_TEXTURE_2D_ARRAY;
    case LOOKUP_LOD:
        return target == GN_TEXTURE_1D || target == GN_TEXTURE_2D;
    case LOOKUP_GATHER:
        return target != GN_TEXTURE_3D && target != GN_TEXTURE_1D;
    default:
        return false;
    }
}
