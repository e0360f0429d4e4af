/* Sizes, channels and predicates of a format, from the rows of formats (format_table.h). Each
 * function is a choice among constants. Compilers fold it if the format is constant; otherwise it
 * becomes a comparison or a small table. */
#ifndef GN_FORMATS_PROPERTIES_H
#define GN_FORMATS_PROPERTIES_H

#include <stdbool.h>

#include <gnomon/surface.h>

#include "../lanes/lanes.h"
#include "format_table.h"

typedef enum format_kind { FORMAT_COLOR, FORMAT_DEPTH } format_kind;

typedef enum format_encoding { ENCODING_UNORM, ENCODING_SRGB, ENCODING_FLOAT } format_encoding;

/* Returns the bytes of one pixel of a format; 0 for GN_FORMAT_NONE and for a value that is no
 * gn_format. */
GN_INLINE uint32_t format_size(gn_format format)
{
#define SIZE(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)                 \
    case GN_FORMAT_##name:                                                                         \
        return bytes;
    switch (format) {
        GN_FORMATS(SIZE)
    default:
        return 0;
    }
#undef SIZE
}

/* Returns the bytes to which pixels and strides of a format are aligned; 1 for a value that is no
 * format. */
static inline uint32_t format_element(gn_format format)
{
#define ELEMENT(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)              \
    case GN_FORMAT_##name:                                                                         \
        return element;
    switch (format) {
        GN_FORMATS(ELEMENT)
    default:
        return 1;
    }
#undef ELEMENT
}

/* How the pixels of a format lie in memory: their bytes and their element as one number. The number
 * is the number of bytes, except for two layouts that have small numbers of their own, so that a
 * choice among layouts is among small numbers. */
typedef uint32_t pixel_layout;

#define GN_LAYOUT(bytes, element)                                                                  \
    ((pixel_layout)((bytes) == 2 && (element) == 1   ? 5                                           \
                    : (bytes) == 8 && (element) == 4 ? 6                                           \
                                                     : (bytes)))

static inline pixel_layout format_layout(gn_format format)
{
#define LAYOUT(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)               \
    case GN_FORMAT_##name:                                                                         \
        return GN_LAYOUT(bytes, element);
    switch (format) {
        GN_FORMATS(LAYOUT)
    default:
        return 0;
    }
#undef LAYOUT
}

static inline bool format_is_color(gn_format format)
{
#define IS_COLOR(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)             \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_COLOR;
    switch (format) {
        GN_FORMATS(IS_COLOR)
    default:
        return false;
    }
#undef IS_COLOR
}

static inline bool format_has_depth(gn_format format)
{
#define HAS_DEPTH(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)            \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_DEPTH && w0 > 0;
    switch (format) {
        GN_FORMATS(HAS_DEPTH)
    default:
        return false;
    }
#undef HAS_DEPTH
}

static inline bool format_has_stencil(gn_format format)
{
#define HAS_STENCIL(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)          \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_DEPTH && w1 > 0;
    switch (format) {
        GN_FORMATS(HAS_STENCIL)
    default:
        return false;
    }
#undef HAS_STENCIL
}

/* Whether the format is a colour that a GN_BASIC library lacks. */
static inline bool format_is_encoded(gn_format format)
{
    return format_is_color(format) && format != GN_FORMAT_RGBA8 && format != GN_FORMAT_RGBA32F;
}

/* Whether fragments of the format can be drawn: a GN_BASIC library has few formats. */
static inline bool format_is_compiled(gn_format format)
{
    return format_is_color(format) ? GN_HAVE_FORMATS || !format_is_encoded(format)
                                   : GN_HAVE_STENCIL || !format_has_stencil(format);
}

static inline format_encoding format_encoding_of(gn_format format)
{
#define ENCODING(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)             \
    case GN_FORMAT_##name:                                                                         \
        return ENCODING_##encoding;
    switch (format) {
        GN_FORMATS(ENCODING)
    default:
        return ENCODING_UNORM;
    }
#undef ENCODING
}

static inline bool format_is_float(gn_format format)
{
    return format_encoding_of(format) == ENCODING_FLOAT;
}

/* Returns how many of red, green, blue and alpha, in this order, a colour format has; 4 for
 * anything else. */
static inline int format_channels(gn_format format)
{
#define CHANNELS(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)             \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_COLOR ? (w0 > 0) + (w1 > 0) + (w2 > 0) + (w3 > 0) : 4;
    switch (format) {
        GN_FORMATS(CHANNELS)
    default:
        return 4;
    }
#undef CHANNELS
}

/* The channels of a row, 16 bits for each, the first channel lowest: the lowest bit, and above it
 * the number of bits. */
typedef uint64_t format_fields;

#define GN_FIELD(offset, width) ((uint64_t)((offset) | (width) << 8))
#define GN_FIELDS(o0, w0, o1, w1, o2, w2, o3, w3)                                                  \
    (GN_FIELD(o0, w0) | GN_FIELD(o1, w1) << 16 | GN_FIELD(o2, w2) << 32 | GN_FIELD(o3, w3) << 48)

static inline format_fields format_fields_of(gn_format format)
{
#define FIELDS(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)               \
    case GN_FORMAT_##name:                                                                         \
        return GN_FIELDS(o0, w0, o1, w1, o2, w2, o3, w3);
    switch (format) {
        GN_FORMATS(FIELDS)
    default:
        return 0;
    }
#undef FIELDS
}

/* Returns the lowest bit of a channel in its word. field_word returns which word it is. */
static inline int field_shift(format_fields fields, int channel)
{
    return (int)(fields >> 16 * channel & 31);
}

static inline int field_word(format_fields fields, int channel)
{
    return (int)(fields >> 16 * channel >> 5 & 3);
}

/* Returns the bits of a channel; 0 if the format lacks it. */
static inline int field_width(format_fields fields, int channel)
{
    return (int)(fields >> 16 * channel >> 8 & 255);
}

/* The numbers in which the reference blends colours of a format. */
typedef enum color_arithmetic {
    ARITHMETIC_BYTES, /* pixels of GN_FORMAT_RGBA8 */
    ARITHMETIC_SHORTS,
    ARITHMETIC_FLOATS
} color_arithmetic;

/* The arithmetic of a format: floats if channels are not linear fractions, otherwise the smallest
 * integers that hold every channel. */
#define GN_ARITHMETIC(encoding, w0, w1, w2, w3)                                                    \
    ((encoding) != ENCODING_UNORM                       ? ARITHMETIC_FLOATS                        \
     : (w0) <= 8 && (w1) <= 8 && (w2) <= 8 && (w3) <= 8 ? ARITHMETIC_BYTES                         \
                                                        : ARITHMETIC_SHORTS)

static inline color_arithmetic arithmetic_of(gn_format format)
{
#define ARITHMETIC(name, bytes, element, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)           \
    case GN_FORMAT_##name:                                                                         \
        return GN_ARITHMETIC(ENCODING_##encoding, w0, w1, w2, w3);
    switch (format) {
        GN_FORMATS(ARITHMETIC)
    default:
        return ARITHMETIC_BYTES;
    }
#undef ARITHMETIC
}

#endif
