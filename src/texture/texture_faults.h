/* The first fault of a texture: first of its shape, then of each level's memory. */
#ifndef GN_TEXTURE_TEXTURE_FAULTS_H
#define GN_TEXTURE_TEXTURE_FAULTS_H

#include <stdbool.h>

#include "../config/faults.h"
#include "../config/features.h"
#include "../formats/properties.h"
#include "../formats/surface_memory.h"
#include "extent.h"

/* Returns the fault of the member `after` of level n, as FAULT_IF_EIGHTH does. */
#if defined(GN_FAULT_TEXTS)
#define FAULT_IF_LEVEL(condition, n, status, after)                                                \
    do {                                                                                           \
        static const char texts[GN_MAX_LEVELS][sizeof("level[10]." after)] = {                     \
            "level[0]." after,  "level[1]." after,  "level[2]." after,  "level[3]." after,         \
            "level[4]." after,  "level[5]." after,  "level[6]." after,  "level[7]." after,         \
            "level[8]." after,  "level[9]." after,  "level[10]." after, "level[11]." after,        \
            "level[12]." after, "level[13]." after, "level[14]." after};                           \
        if (condition)                                                                             \
            return texts[n];                                                                       \
    } while (0)
#else
#define FAULT_IF_LEVEL(condition, n, status, after) FAULT_IF(condition, status, "")
#endif

/* All members of a texture except its levels. */
typedef struct texture_shape {
    gn_texture_target target;
    gn_format format;
    uint32_t width, height, depth, level_count;
} texture_shape;

static inline bool format_has_texels(gn_format format)
{
    return GN_HAVE_TEXTURES ? format_is_color(format) || format_has_depth(format)
                            : format_is_basic(format);
}

/* Returns the bytes of a texel. Precondition: the format has texels. */
static inline size_t texel_size(gn_format format)
{
    if (!GN_HAVE_TEXTURES)
        return format_is_565(format) ? 2 : format == GN_FORMAT_RGBA8 ? 4 : 16;
    return format_size(format);
}

/* Returns the bytes of an element of a format: texels and all strides are multiples of it. */
static inline uint32_t texel_element(gn_format format)
{
    if (!GN_HAVE_TEXTURES)
        return format == GN_FORMAT_RGB565 ? 2 : format == GN_FORMAT_RGB565_SWAPPED ? 1 : 4;
    return format_element(format);
}

/* Returns the number of levels that a texture of this size has, down to one texel. */
static inline uint32_t most_levels(const texture_shape *s)
{
    uint32_t largest = s->width > s->height ? s->width : s->height;
    uint32_t count = 0;

    if (s->target == GN_TEXTURE_3D && s->depth > largest)
        largest = s->depth;
    for (; largest > 0; largest /= 2)
        ++count;
    return count;
}

static inline fault fault_of_targets_size(const texture_shape *s)
{
    const bool has_depth = s->target == GN_TEXTURE_3D || s->target == GN_TEXTURE_2D_ARRAY;

    FAULT_IF(has_depth && (s->depth == 0 || s->depth > GN_MAX_SIZE), GN_INVALID_SIZE,
             "depth is not in 1 to GN_MAX_SIZE");
    FAULT_IF(s->target == GN_TEXTURE_1D && s->height != 1, GN_INVALID_SIZE,
             "height of a 1D texture is not 1");
    FAULT_IF(s->target == GN_TEXTURE_CUBE && s->width != s->height, GN_INVALID_SIZE,
             "height of a cube is not its width");
    FAULT_IF(s->level_count > most_levels(s), GN_INVALID_SIZE,
             "level_count is above the number of levels of that size");
    return NO_FAULT;
}

static inline fault fault_of_shape(const texture_shape *s)
{
    FAULT_IF(GN_HAVE_TEXTURES && (unsigned)s->target > GN_TEXTURE_CUBE, GN_INVALID_ENUM,
             "target is no gn_texture_target");
    FAULT_IF(!GN_HAVE_TEXTURES && (s->target != GN_TEXTURE_2D || s->level_count > 1),
             GN_NOT_COMPILED, "target or level_count is not that of a GN_BASIC library");
    FAULT_IF(!format_has_texels(s->format), GN_INVALID_FORMAT, "format has no texels");
    FAULT_IF(s->width == 0 || s->width > GN_MAX_SIZE, GN_INVALID_SIZE,
             "width is not in 1 to GN_MAX_SIZE");
    FAULT_IF(s->height == 0 || s->height > GN_MAX_SIZE, GN_INVALID_SIZE,
             "height is not in 1 to GN_MAX_SIZE");
    return GN_HAVE_TEXTURES ? fault_of_targets_size(s) : NO_FAULT;
}

static inline fault fault_of_layers(const gn_texture_level *l, uint32_t n, uint32_t layers,
                                    size_t element, size_t row, size_t rows)
{
    const size_t stride = stride_length(l->layer_stride);

    (void)n;
    if (layers == 1)
        return NO_FAULT;
    FAULT_IF_LEVEL(stride % element != 0, n, GN_MISALIGNED,
                   "layer_stride is no multiple of the format's element");
    FAULT_IF_LEVEL(stride < row, n, GN_INVALID_STRIDE, "layer_stride is shorter than a row");
    FAULT_IF_LEVEL(stride > ((size_t)PTRDIFF_MAX - rows) / (layers - 1), n, GN_INVALID_STRIDE,
                   "layer_stride is too long");
    return NO_FAULT;
}

/* Returns the first fault of level n. Precondition: the texture's shape has no fault. */
static inline fault fault_of_level(const gn_texture *t, uint32_t n)
{
    const gn_texture_level *const l = &t->level[n];
    const texel_extent extent = extent_of_level(t, n);
    const size_t element = texel_element(t->format);
    const size_t row = extent.width * texel_size(t->format);
    const size_t stride = stride_length(l->row_stride);

    FAULT_IF_LEVEL(!l->texels, n, GN_NULL_POINTER, "texels is null");
    FAULT_IF_LEVEL((uintptr_t)l->texels % element != 0, n, GN_MISALIGNED,
                   "texels is not aligned to the format's element");
    FAULT_IF_LEVEL(stride % element != 0, n, GN_MISALIGNED,
                   "row_stride is no multiple of the format's element");
    if (extent.height > 1) {
        FAULT_IF_LEVEL(stride < row, n, GN_INVALID_STRIDE, "row_stride is shorter than a row");
        FAULT_IF_LEVEL(stride > ((size_t)PTRDIFF_MAX - row) / (extent.height - 1), n,
                       GN_INVALID_STRIDE, "row_stride is too long");
    }
    if (!GN_HAVE_TEXTURES)
        return NO_FAULT;
    return fault_of_layers(l, n, extent.layers, element, row,
                           row + (extent.height > 1 ? stride * (extent.height - 1) : 0));
}

static inline texture_shape shape_of(const gn_texture *t)
{
    texture_shape s;

    s.target = t->target;
    s.format = t->format;
    s.width = t->width;
    s.height = t->height;
    s.depth = t->depth;
    s.level_count = t->level_count;
    return s;
}

static inline fault fault_of_texture(const gn_texture *t)
{
    FAULT_IF(!t, GN_NULL_POINTER, "the texture is null");

    const texture_shape shape = shape_of(t);
    FAULT_FROM(fault_of_shape(&shape));
    for (uint32_t n = 0; n < (GN_HAVE_TEXTURES ? levels_of(t) : 1); ++n)
        FAULT_FROM(fault_of_level(t, n));
    return NO_FAULT;
}

#endif
