/* Loads pixels from memory into words and stores them from words, by their layout. */
#ifndef GN_FORMATS_PIXEL_MEMORY_H
#define GN_FORMATS_PIXEL_MEMORY_H

#include "properties.h"

/* A pixel is up to four words, least significant first. Pixels of less than 32 bits lie in the low
 * bits of a word. */

/* Loads pixel x of a row. */
static inline void load_pixel(const unsigned char *row, int32_t x, pixel_layout layout,
                              int32_t word[4])
{
    const stored_half *const halves = (const stored_half *)(const void *)row;
    const stored_word *const words = (const stored_word *)(const void *)row;

    switch (layout) {
    case GN_LAYOUT(1, 1):
        word[0] = row[x];
        break;
    case GN_LAYOUT(2, 2):
        word[0] = halves[x];
        break;
    case GN_LAYOUT(2, 1):
        word[0] = row[2 * x] << 8 | row[2 * x + 1];
        break;
    case GN_LAYOUT(3, 1):
        word[0] = row[3 * x] | row[3 * x + 1] << 8 | row[3 * x + 2] << 16;
        break;
    case GN_LAYOUT(4, 4):
        word[0] = words[x];
        break;
    case GN_LAYOUT(8, 2):
        word[0] = (int32_t)(halves[4 * x] | (uint32_t)halves[4 * x + 1] << 16);
        word[1] = (int32_t)(halves[4 * x + 2] | (uint32_t)halves[4 * x + 3] << 16);
        break;
    case GN_LAYOUT(8, 4):
        word[0] = words[2 * x];
        word[1] = words[2 * x + 1];
        break;
    default: /* GN_LAYOUT(16, 4) */
        for (int i = 0; i < 4; ++i)
            word[i] = words[4 * x + i];
        break;
    }
}

static inline void store_pixel(unsigned char *row, int32_t x, pixel_layout layout,
                               const int32_t word[4])
{
    stored_half *const halves = (stored_half *)(void *)row;
    stored_word *const words = (stored_word *)(void *)row;
    const uint32_t first = (uint32_t)word[0];

    switch (layout) {
    case GN_LAYOUT(1, 1):
        row[x] = (unsigned char)first;
        break;
    case GN_LAYOUT(2, 2):
        halves[x] = (uint16_t)first;
        break;
    case GN_LAYOUT(2, 1):
        row[2 * x] = (unsigned char)(first >> 8);
        row[2 * x + 1] = (unsigned char)first;
        break;
    case GN_LAYOUT(3, 1):
        row[3 * x] = (unsigned char)first;
        row[3 * x + 1] = (unsigned char)(first >> 8);
        row[3 * x + 2] = (unsigned char)(first >> 16);
        break;
    case GN_LAYOUT(4, 4):
        words[x] = word[0];
        break;
    case GN_LAYOUT(8, 2):
        halves[4 * x] = (uint16_t)first;
        halves[4 * x + 1] = (uint16_t)(first >> 16);
        halves[4 * x + 2] = (uint16_t)word[1];
        halves[4 * x + 3] = (uint16_t)((uint32_t)word[1] >> 16);
        break;
    case GN_LAYOUT(8, 4):
        words[2 * x] = word[0];
        words[2 * x + 1] = word[1];
        break;
    default: /* GN_LAYOUT(16, 4) */
        for (int i = 0; i < 4; ++i)
            words[4 * x + i] = word[i];
        break;
    }
}

#endif
