/* Loads one pixel from memory into words, and stores it, by its layout. */
#ifndef GN_FORMATS_PIXEL_MEMORY_H
#define GN_FORMATS_PIXEL_MEMORY_H

#include "properties.h"

/* Returns by how many bits byte i of a pixel of bytes is moved up in its word. */
GN_INLINE int byte_shift(pixel_layout layout, int i)
{
    return 8 * (layout == LAYOUT_SHORT_HIGH_FIRST ? 1 - i : i);
}

/* Loads pixel x of a row. Pixels of less than 32 bits lie in the low bits of a word. The loops end
 * at a constant, so that compilers make no call of memcpy of them. */
static inline void load_pixel(const unsigned char *row, int32_t x, pixel_layout layout,
                              int32_t word[4])
{
    const int element = (int)layout_element(layout);
    const int count = (int)layout_bytes(layout) / element;
    const stored_short *const shorts = (const stored_short *)(const void *)row + count * x;
    const stored_word *const words = (const stored_word *)(const void *)row + count * x;

    word[0] = 0;
    for (int i = 0; i < 4; ++i) {
        if (i >= count)
            continue;
        if (element == 4)
            word[i] = words[i];
        else if (element == 1)
            word[0] |= row[count * x + i] << byte_shift(layout, i);
        else if (i % 2 == 0)
            word[i / 2] = shorts[i];
        else
            word[i / 2] |= (int32_t)((uint32_t)shorts[i] << 16);
    }
}

static inline void store_pixel(unsigned char *row, int32_t x, pixel_layout layout,
                               const int32_t word[4])
{
    const int element = (int)layout_element(layout);
    const int count = (int)layout_bytes(layout) / element;
    stored_short *const shorts = (stored_short *)(void *)row + count * x;
    stored_word *const words = (stored_word *)(void *)row + count * x;

    for (int i = 0; i < 4; ++i) {
        if (i >= count)
            continue;
        if (element == 4)
            words[i] = word[i];
        else if (element == 1)
            row[count * x + i] = (unsigned char)((uint32_t)word[0] >> byte_shift(layout, i));
        else
            shorts[i] = (uint16_t)((uint32_t)word[i / 2] >> i % 2 * 16);
    }
}

#endif
