/* The table of decode_table.h, made from the rows of formats. */
#include "decode_table.h"

#include "properties.h"

#define KIND(encoding, c, width)                                                                   \
    ((encoding) == ENCODING_FLOAT ? (width) == 32 ? CHANNEL_FLOAT32 : CHANNEL_SMALL_FLOAT          \
     : (encoding) == ENCODING_SRGB && (c) < 3 ? CHANNEL_SRGB                                       \
                                              : CHANNEL_FRACTION)

/* The bits of a fraction in place; 1 for channels that are none. */
#define IS_HIGH(offset, width) ((width) < 32 && (offset) % 32 + (width) == 32)
#define FRACTION(offset, width)                                                                    \
    ((width) > 0 && (width) < 32                                                                   \
         ? ((1u << (width) % 32) - 1) << ((offset) % 32 - (IS_HIGH(offset, width) ? 16 : 0))       \
         : 1u)

/* The bits of a small float where a half has them. */
#define FLOAT(width) ((width) == 16 ? 0xFFFFu : (width) == 11 ? 0x7FF0u : 0x7FE0u)

#define MASK(encoding, offset, width)                                                              \
    ((encoding) == ENCODING_FLOAT ? FLOAT(width) : FRACTION(offset, width))

#define CHANNEL(encoding, c, offset, width)                                                        \
    {                                                                                              \
        (int32_t) MASK(encoding, offset, width), 1.0f / (float)FRACTION(offset, width),            \
            KIND(encoding, c, width), (offset) / 32, (offset) % 32, (width),                       \
            IS_HIGH(offset, width)                                                                 \
    }

#define COLOR_CHANNELS(w0, w1, w2, w3) (((w0) > 0) + ((w1) > 0) + ((w2) > 0) + ((w3) > 0))

#define ROW(name, layout, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)                          \
    {FORMAT_##kind == FORMAT_COLOR ? COLOR_CHANNELS(w0, w1, w2, w3) : 1,                           \
     FORMAT_##kind == FORMAT_DEPTH && (w0) > 0,                                                    \
     {CHANNEL(ENCODING_##encoding, 0, o0, w0), CHANNEL(ENCODING_##encoding, 1, o1, w1),            \
      CHANNEL(ENCODING_##encoding, 2, o2, w2), CHANNEL(ENCODING_##encoding, 3, o3, w3)}},

/* Without designated elements, which C++ lacks: the rows are in the order of gn_format. */
#define NUMBER(name, layout, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3) NUMBER_##name,
#define IS_IN_ORDER(name, layout, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)                  \
    &&(int)NUMBER_##name == (int)GN_FORMAT_##name
enum { NUMBER_NONE, GN_FORMATS(NUMBER) };
typedef char rows_are_in_order[1 GN_FORMATS(IS_IN_ORDER) ? 1 : -1];

const format_decoding gni_decodings[] = {{0}, GN_FORMATS(ROW)};
