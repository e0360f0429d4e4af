/* The pixel formats: one row of plain data each. Sizes, masks, classes, predicates, conversions and
 * faults of the library, and the tables of the tests, are derived from these rows. This file
 * includes only data, so that programs outside the library may use it too.
 *
 * CONTRIBUTING.md says how to add a format.
 *
 *   name      as in GN_FORMAT_name
 *   layout    of a pixel in memory, as in pixel_layout.h
 *   kind      COLOR, or DEPTH: depth, stencil or both
 *   encoding  UNORM: fractions of the largest value; SRGB: fractions too, with red, green and blue
 *             encoded along sRGB's curve; FLOAT: floats of as many bits as the channel has
 *   channels  red, green, blue and alpha of a colour, otherwise depth and stencil: for each the
 *             lowest bit and the number of bits, or 0, 0 if the format lacks the channel
 *
 * Bits are counted in the pixel taken as one number (pixel_layout.h). No channel crosses a multiple
 * of 32. */
#ifndef GN_FORMATS_FORMAT_TABLE_H
#define GN_FORMATS_FORMAT_TABLE_H

#include "pixel_layout.h"

/* clang-format off */
#define GN_FORMATS(ROW) \
    /*  name           layout       kind   encoding     channels */ \
    ROW(RGBA8,         WORD,        COLOR, UNORM,  0, 8,   8, 8,  16, 8,  24, 8) \
    ROW(RGBA32F,       FOUR_WORDS,  COLOR, FLOAT,  0, 32,  32, 32,  64, 32,  96, 32) \
    ROW(D16,           SHORT,       DEPTH, UNORM,  0, 16,   0, 0,   0, 0,   0, 0) \
    ROW(D24,           WORD,        DEPTH, UNORM,  0, 24,   0, 0,   0, 0,   0, 0) \
    ROW(D32F,          WORD,        DEPTH, FLOAT,  0, 32,   0, 0,   0, 0,   0, 0) \
    ROW(D24S8,         WORD,        DEPTH, UNORM,  0, 24,  24, 8,   0, 0,   0, 0) \
    ROW(D32FS8,        TWO_WORDS,   DEPTH, FLOAT,  0, 32,  32, 8,   0, 0,   0, 0) \
    ROW(S8,            BYTE,        DEPTH, UNORM,  0, 0,   0, 8,   0, 0,   0, 0) \
    ROW(BGRA8,         WORD,        COLOR, UNORM, 16, 8,   8, 8,   0, 8,  24, 8) \
    ROW(R8,            BYTE,        COLOR, UNORM,  0, 8,   0, 0,   0, 0,   0, 0) \
    ROW(RG8,           SHORT,       COLOR, UNORM,  0, 8,   8, 8,   0, 0,   0, 0) \
    ROW(RGB8,          THREE_BYTES, COLOR, UNORM,  0, 8,   8, 8,  16, 8,   0, 0) \
    ROW(RGB565,        SHORT,       COLOR, UNORM, 11, 5,   5, 6,   0, 5,   0, 0) \
    ROW(RGB5_A1,       SHORT,       COLOR, UNORM, 11, 5,   6, 5,   1, 5,   0, 1) \
    ROW(RGBA4,         SHORT,       COLOR, UNORM, 12, 4,   8, 4,   4, 4,   0, 4) \
    ROW(R16,           SHORT,       COLOR, UNORM,  0, 16,   0, 0,   0, 0,   0, 0) \
    ROW(RGBA16,        FOUR_SHORTS, COLOR, UNORM,  0, 16,  16, 16,  32, 16,  48, 16) \
    ROW(R32F,          WORD,        COLOR, FLOAT,  0, 32,   0, 0,   0, 0,   0, 0) \
    ROW(RGBA16F,       FOUR_SHORTS, COLOR, FLOAT,  0, 16,  16, 16,  32, 16,  48, 16) \
    ROW(SRGB8_A8,      WORD,        COLOR, SRGB,   0, 8,   8, 8,  16, 8,  24, 8) \
    ROW(RG16F,         WORD,        COLOR, FLOAT,  0, 16,  16, 16,   0, 0,   0, 0) \
    ROW(RGB565_SWAPPED, SHORT_HIGH_FIRST, COLOR, UNORM, 11, 5,   5, 6,   0, 5,   0, 0) \
    ROW(RGB10_A2,      WORD,        COLOR, UNORM,  0, 10,  10, 10,  20, 10,  30, 2) \
    ROW(R11F_G11F_B10F, WORD, COLOR, FLOAT,  0, 11,  11, 11,  22, 10,   0, 0) \
    ROW(RGB32F,        THREE_WORDS, COLOR, FLOAT,  0, 32,  32, 32,  64, 32,   0, 0)
/* clang-format on */

#endif
