/* Loads pixels from memory into words and stores them from words, by their layout. */
#ifndef GN_FORMATS_PIXEL_MEMORY_H
#define GN_FORMATS_PIXEL_MEMORY_H

#include "properties.h"

/* A pixel is up to two words. Pixels of up to 32 bits lie in the low bits of the first word. Of
 * four channels of 16 bits, red and green lie in the first word, blue and alpha in the second. */

/* Loads pixel x of a row. */
static inline void load_pixel(const unsigned char *row, int32_t x, pixel_layout layout,
                              int32_t word[2])
{
    const stored_half *const halves = (const stored_half *)(const void *)row;

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
        word[0] = ((const stored_word *)(const void *)row)[x];
        break;
    default: /* GN_LAYOUT(8, 2) */
        word[0] = (int32_t)(halves[4 * x] | (uint32_t)halves[4 * x + 1] << 16);
        word[1] = (int32_t)(halves[4 * x + 2] | (uint32_t)halves[4 * x + 3] << 16);
        break;
    }
}

static inline void store_pixel(unsigned char *row, int32_t x, pixel_layout layout, int32_t first,
                               int32_t second)
{
    stored_half *const halves = (stored_half *)(void *)row;

    switch (layout) {
    case GN_LAYOUT(1, 1):
        row[x] = (unsigned char)first;
        break;
    case GN_LAYOUT(2, 2):
        halves[x] = (uint16_t)first;
        break;
    case GN_LAYOUT(2, 1):
        row[2 * x] = (unsigned char)((uint32_t)first >> 8);
        row[2 * x + 1] = (unsigned char)first;
        break;
    case GN_LAYOUT(3, 1):
        row[3 * x] = (unsigned char)first;
        row[3 * x + 1] = (unsigned char)((uint32_t)first >> 8);
        row[3 * x + 2] = (unsigned char)((uint32_t)first >> 16);
        break;
    case GN_LAYOUT(4, 4):
        ((stored_word *)(void *)row)[x] = first;
        break;
    default: /* GN_LAYOUT(8, 2) */
        halves[4 * x] = (uint16_t)first;
        halves[4 * x + 1] = (uint16_t)((uint32_t)first >> 16);
        halves[4 * x + 2] = (uint16_t)second;
        halves[4 * x + 3] = (uint16_t)((uint32_t)second >> 16);
        break;
    }
}

#endif
