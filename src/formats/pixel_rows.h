/* Rows of GN_LANES pixels in memory, and a choice among their layouts. */
#ifndef GN_FORMATS_PIXEL_ROWS_H
#define GN_FORMATS_PIXEL_ROWS_H

#include "pixel_memory.h"

/* A row of pixels of any format in memory of a function's own. */
typedef union pixel_row {
    int32_t word[4 * GN_LANES];
    unsigned char byte[16 * GN_LANES];
} pixel_row;

/* The rows of four pixels of `bytes` bytes that a row of sixteen is made of, as lanes/rows.h takes
 * them. Loads do not write to them. */
#if GN_LANES == 16
GN_INLINE void quarter_row(const unsigned char *pixels, int bytes, unsigned char *row[4])
{
    for (int r = 0; r < 4; ++r)
        row[r] = (unsigned char *)(uintptr_t)pixels + 4 * bytes * r;
}
#endif

/* Exchanges the bytes of shorts. */
GN_INLINE lanes_i exchanged_bytes(lanes_i a)
{
    const lanes_i low = lanes_i_splat(0xFF);

    return lanes_i_or(lanes_i_and(lanes_i_shift_right(a, 8), low),
                      lanes_i_shift_left(lanes_i_and(a, low), 8));
}

/* Calls FUNCTION(layout) with a constant for each layout of colours. */
#define GN_EACH_COLOR_LAYOUT(layout, FUNCTION)                                                     \
    switch (layout) {                                                                              \
    case GN_LAYOUT(1, 1):                                                                          \
        FUNCTION(GN_LAYOUT(1, 1));                                                                 \
        break;                                                                                     \
    case GN_LAYOUT(2, 2):                                                                          \
        FUNCTION(GN_LAYOUT(2, 2));                                                                 \
        break;                                                                                     \
    case GN_LAYOUT(2, 1):                                                                          \
        FUNCTION(GN_LAYOUT(2, 1));                                                                 \
        break;                                                                                     \
    case GN_LAYOUT(3, 1):                                                                          \
        FUNCTION(GN_LAYOUT(3, 1));                                                                 \
        break;                                                                                     \
    case GN_LAYOUT(4, 4):                                                                          \
        FUNCTION(GN_LAYOUT(4, 4));                                                                 \
        break;                                                                                     \
    case GN_LAYOUT(8, 2):                                                                          \
        FUNCTION(GN_LAYOUT(8, 2));                                                                 \
        break;                                                                                     \
    default: /* GN_LAYOUT(16, 4) */                                                                \
        FUNCTION(GN_LAYOUT(16, 4));                                                                \
        break;                                                                                     \
    }

/* Returns the words of a pixel of a layout. */
GN_INLINE int layout_words(pixel_layout layout)
{
    return layout == GN_LAYOUT(16, 4)                               ? 4
           : layout == GN_LAYOUT(8, 2) || layout == GN_LAYOUT(8, 4) ? 2
                                                                    : 1;
}

#endif
