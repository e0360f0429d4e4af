/* The pixel formats: one row of plain data each. Sizes, masks, classes, predicates, conversions and
 * faults of the library, and the tables of the tests, are derived from these rows. This file
 * includes nothing, so that programs outside the library may use the list and the layouts too.
 *
 * To add a format, add its name to gn_format (gnomon/surface.h) and a row here. If its channels
 * are stored in a way that no other format has, add the conversion to unorm.h or floats.h, or to
 * pixel_memory.h. CONTRIBUTING.md has the whole recipe.
 *
 *   name      as in GN_FORMAT_name
 *   bytes     of a pixel
 *   element   bytes of the elements that a pixel is made of; pixels and strides are aligned to them
 *   kind      COLOR, or DEPTH: depth, stencil or both
 *   encoding  UNORM: fractions of the largest value; SRGB: fractions too, with red, green and blue
 *             encoded along sRGB's curve; FLOAT: floats of as many bits as the channel has
 *   channels  red, green, blue and alpha of a colour, otherwise depth and stencil: for each the
 *             lowest bit and the number of bits, or 0, 0 if the format lacks the channel
 *
 * Bits are counted in the pixel taken as one number. The number's low bits are the first element in
 * memory, except in a pixel of two bytes, whose first byte is the high one. No channel crosses a
 * multiple of 32. */
#ifndef GN_FORMATS_FORMAT_TABLE_H
#define GN_FORMATS_FORMAT_TABLE_H

/* clang-format off */
#define GN_FORMATS(ROW) \
    /*  name     bytes element  kind  encoding     channels */ \
    ROW(RGBA8,     4, 4, COLOR, UNORM,  0, 8,   8, 8,  16, 8,  24, 8) \
    ROW(RGBA32F,  16, 4, COLOR, FLOAT,  0, 32, 32, 32, 64, 32, 96, 32) \
    ROW(D16,       2, 2, DEPTH, UNORM,  0, 16,  0, 0,   0, 0,   0, 0) \
    ROW(D24,       4, 4, DEPTH, UNORM,  0, 24,  0, 0,   0, 0,   0, 0) \
    ROW(D32F,      4, 4, DEPTH, FLOAT,  0, 32,  0, 0,   0, 0,   0, 0) \
    ROW(D24S8,     4, 4, DEPTH, UNORM,  0, 24, 24, 8,   0, 0,   0, 0) \
    ROW(D32FS8,    8, 4, DEPTH, FLOAT,  0, 32, 32, 8,   0, 0,   0, 0) \
    ROW(S8,        1, 1, DEPTH, UNORM,  0, 0,   0, 8,   0, 0,   0, 0) \
    ROW(BGRA8,     4, 4, COLOR, UNORM, 16, 8,   8, 8,   0, 8,  24, 8) \
    ROW(R8,        1, 1, COLOR, UNORM,  0, 8,   0, 0,   0, 0,   0, 0) \
    ROW(RG8,       2, 2, COLOR, UNORM,  0, 8,   8, 8,   0, 0,   0, 0) \
    ROW(RGB8,      3, 1, COLOR, UNORM,  0, 8,   8, 8,  16, 8,   0, 0) \
    ROW(RGB565,    2, 2, COLOR, UNORM, 11, 5,   5, 6,   0, 5,   0, 0) \
    ROW(RGB5_A1,   2, 2, COLOR, UNORM, 11, 5,   6, 5,   1, 5,   0, 1) \
    ROW(RGBA4,     2, 2, COLOR, UNORM, 12, 4,   8, 4,   4, 4,   0, 4) \
    ROW(R16,       2, 2, COLOR, UNORM,  0, 16,  0, 0,   0, 0,   0, 0) \
    ROW(RGBA16,    8, 2, COLOR, UNORM,  0, 16, 16, 16, 32, 16, 48, 16) \
    ROW(R32F,      4, 4, COLOR, FLOAT,  0, 32,  0, 0,   0, 0,   0, 0) \
    ROW(RGBA16F,   8, 2, COLOR, FLOAT,  0, 16, 16, 16, 32, 16, 48, 16) \
    ROW(SRGB8_A8,  4, 4, COLOR, SRGB,   0, 8,   8, 8,  16, 8,  24, 8) \
    ROW(RG16F,     4, 4, COLOR, FLOAT,  0, 16, 16, 16,  0, 0,   0, 0) \
    ROW(RGB565_SWAPPED, \
                   2, 1, COLOR, UNORM, 11, 5,   5, 6,   0, 5,   0, 0) \
    ROW(RGB10_A2,  4, 4, COLOR, UNORM,  0, 10, 10, 10, 20, 10, 30, 2) \
    ROW(R11F_G11F_B10F, \
                   4, 4, COLOR, FLOAT,  0, 11, 11, 11, 22, 10,  0, 0)
/* clang-format on */

#endif
