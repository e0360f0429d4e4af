/* Sizes, channels and predicates of a format, from the rows of formats (format_table.h). What reads
 * the rows is a choice among constants. Compilers fold it if the format is constant; otherwise it
 * becomes a comparison or a small table. */
#ifndef GN_FORMATS_PROPERTIES_H
#define GN_FORMATS_PROPERTIES_H

#include <stdbool.h>

#include <gnomon/surface.h>

#include "../lanes/lanes.h"
#include "format_table.h"

typedef enum format_kind { FORMAT_COLOR, FORMAT_DEPTH } format_kind;

typedef enum format_encoding { ENCODING_UNORM, ENCODING_SRGB, ENCODING_FLOAT } format_encoding;

/* Returns the bytes of one pixel of a layout; 0 for LAYOUT_NONE. */
GN_INLINE uint32_t layout_bytes(pixel_layout layout)
{
#define BYTES(argument, name, bytes, element)                                                      \
    case LAYOUT_##name:                                                                            \
        return bytes;
    switch (layout) {
        PIXEL_LAYOUTS(BYTES, )
    default:
        return 0;
    }
#undef BYTES
}

/* Returns the bytes of an element of a layout's pixels; 1 for LAYOUT_NONE. */
GN_INLINE uint32_t layout_element(pixel_layout layout)
{
#define ELEMENT(argument, name, bytes, element)                                                    \
    case LAYOUT_##name:                                                                            \
        return element;
    switch (layout) {
        PIXEL_LAYOUTS(ELEMENT, )
    default:
        return 1;
    }
#undef ELEMENT
}

/* Returns how many words of 32 bits hold a pixel. */
GN_INLINE int layout_words(pixel_layout layout)
{
    return (int)(layout_bytes(layout) + 3) / 4;
}

/* Ends a function with the value that ROW, which is one `case`, returns of a format's row; with
 * `none` if the format has no row. */
#define RETURN_BY_FORMAT(format, ROW, none)                                                        \
    switch (format) {                                                                              \
        GN_FORMATS(ROW)                                                                            \
    default:                                                                                       \
        return none;                                                                               \
    }

/* Returns LAYOUT_NONE for GN_FORMAT_NONE and for a value that is no gn_format. */
GN_INLINE pixel_layout format_layout(gn_format format)
{
#define LAYOUT(name, layout, ...)                                                                  \
    case GN_FORMAT_##name:                                                                         \
        return LAYOUT_##layout;
    RETURN_BY_FORMAT(format, LAYOUT, LAYOUT_NONE);
#undef LAYOUT
}

/* Returns the bytes of one pixel of a format; 0 for GN_FORMAT_NONE and for a value that is no
 * gn_format. */
GN_INLINE uint32_t format_size(gn_format format)
{
#define SIZE(name, layout, ...)                                                                    \
    case GN_FORMAT_##name:                                                                         \
        return LAYOUT_##layout##_BYTES;
    RETURN_BY_FORMAT(format, SIZE, 0);
#undef SIZE
}

/* Returns the bytes to which pixels and strides of a format are aligned; 1 for a value that is no
 * format. */
static inline uint32_t format_element(gn_format format)
{
    return layout_element(format_layout(format));
}

static inline bool format_is_color(gn_format format)
{
#define IS_COLOR(name, layout, kind, ...)                                                          \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_COLOR;
    RETURN_BY_FORMAT(format, IS_COLOR, false);
#undef IS_COLOR
}

static inline format_encoding format_encoding_of(gn_format format)
{
#define ENCODING(name, layout, kind, encoding, ...)                                                \
    case GN_FORMAT_##name:                                                                         \
        return ENCODING_##encoding;
    RETURN_BY_FORMAT(format, ENCODING, ENCODING_UNORM);
#undef ENCODING
}

static inline bool format_is_float(gn_format format)
{
    return format_encoding_of(format) == ENCODING_FLOAT;
}

/* The channels of a row, 16 bits for each, the first channel lowest: the lowest bit, and above it
 * the number of bits. */
typedef uint64_t format_fields;

#define GN_FIELD(offset, width) ((uint64_t)((offset) | (width) << 8))
#define GN_FIELDS(o0, w0, o1, w1, o2, w2, o3, w3)                                                  \
    (GN_FIELD(o0, w0) | GN_FIELD(o1, w1) << 16 | GN_FIELD(o2, w2) << 32 | GN_FIELD(o3, w3) << 48)

static inline format_fields format_fields_of(gn_format format)
{
#define FIELDS(name, layout, kind, encoding, ...)                                                  \
    case GN_FORMAT_##name:                                                                         \
        return GN_FIELDS(__VA_ARGS__);
    RETURN_BY_FORMAT(format, FIELDS, 0);
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

/* Returns how many of red, green, blue and alpha, in this order, a colour format has. */
static inline int format_channels(gn_format format)
{
    const format_fields fields = format_fields_of(format);

    return (field_width(fields, 0) > 0) + (field_width(fields, 1) > 0) +
           (field_width(fields, 2) > 0) + (field_width(fields, 3) > 0);
}

static inline bool format_has_depth(gn_format format)
{
#define HAS_DEPTH(name, layout, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)                    \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_DEPTH && w0 > 0;
    RETURN_BY_FORMAT(format, HAS_DEPTH, false);
#undef HAS_DEPTH
}

static inline bool format_has_stencil(gn_format format)
{
#define HAS_STENCIL(name, layout, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)                  \
    case GN_FORMAT_##name:                                                                         \
        return FORMAT_##kind == FORMAT_DEPTH && w1 > 0;
    RETURN_BY_FORMAT(format, HAS_STENCIL, false);
#undef HAS_STENCIL
}

/* Whether the format has two bytes, with 5 bits of red, 6 of green and 5 of blue. */
GN_INLINE bool format_is_565(gn_format format)
{
    return format == GN_FORMAT_RGB565 || format == GN_FORMAT_RGB565_SWAPPED;
}

/* Whether the format is a colour that a GN_BASIC library has, for targets and textures. */
GN_INLINE bool format_is_basic(gn_format format)
{
    return format == GN_FORMAT_RGBA8 || format == GN_FORMAT_RGBA32F || format_is_565(format);
}

/* Whether fragments of the format can be drawn: a GN_BASIC library has few formats. Inline, so that
 * the code of the others is left out of little code too. */
GN_INLINE bool format_is_compiled(gn_format format)
{
    return format_is_color(format) ? GN_HAVE_FORMATS || format_is_basic(format)
                                   : GN_HAVE_STENCIL || !format_has_stencil(format);
}

/* The numbers in which the reference blends colours of a format. */
typedef enum color_arithmetic {
    ARITHMETIC_BYTES, /* pixels of GN_FORMAT_RGBA8 */
    ARITHMETIC_SHORTS,
    ARITHMETIC_FLOATS
} color_arithmetic;

/* The arithmetic of a format: floats if channels are not linear fractions, otherwise the smallest
 * integers that hold every channel. */
static inline color_arithmetic arithmetic_of(gn_format format)
{
#define ARITHMETIC(name, layout, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)                   \
    case GN_FORMAT_##name:                                                                         \
        return ENCODING_##encoding != ENCODING_UNORM      ? ARITHMETIC_FLOATS                      \
               : w0 <= 8 && w1 <= 8 && w2 <= 8 && w3 <= 8 ? ARITHMETIC_BYTES                       \
                                                          : ARITHMETIC_SHORTS;
    RETURN_BY_FORMAT(format, ARITHMETIC, ARITHMETIC_BYTES);
#undef ARITHMETIC
}

/* What other files take for granted: pixels of whole elements and at most four words; channels that
 * lie in the pixel and in one word. */
#define IS_LAYOUT(argument, name, bytes, element)                                                  \
    &&(bytes) % (element) == 0 && (bytes) <= LAYOUT_MOST_BYTES && ((element) & ((element)-1)) == 0
typedef char layouts_are_whole[1 PIXEL_LAYOUTS(IS_LAYOUT, ) ? 1 : -1];
#undef IS_LAYOUT

#define LIES_IN(layout, offset, width)                                                             \
    ((offset) + (width) <= 8 * LAYOUT_##layout##_BYTES &&                                          \
     ((width) == 0 || (offset) / 32 == ((offset) + (width)-1) / 32))
#define ARE_IN_LAYOUT(name, layout, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)                \
    &&LIES_IN(layout, o0, w0) && LIES_IN(layout, o1, w1) && LIES_IN(layout, o2, w2) &&             \
        LIES_IN(layout, o3, w3)
typedef char channels_lie_in_layouts[1 GN_FORMATS(ARE_IN_LAYOUT) ? 1 : -1];
#undef LIES_IN
#undef ARE_IN_LAYOUT

#endif
