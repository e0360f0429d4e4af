/* The layouts of pixels: the shapes that a pixel may have in memory, one row of plain data each.
 * Formats of one layout are loaded and stored by the same functions. This file includes nothing, so
 * that programs outside the library may use it too.
 *
 * To add a layout, add a row here. Its pixels are then loaded and stored one by one
 * (pixel_memory.h); where that is too slow, pixel_rows.h chooses functions of ../lanes/. Texels of
 * whole words are loaded by index at once, others one by one (../texture/texel_layout.c).
 *
 *   name     as in LAYOUT_name
 *   bytes    of a pixel
 *   element  bytes of the elements that a pixel is made of; pixels and strides are aligned to them
 *
 * Lanes hold a pixel as one number in up to four words of 32 bits, least significant first. The
 * low bits of the number are the first element in memory, except in SHORT_HIGH_FIRST. */
#ifndef GN_FORMATS_PIXEL_LAYOUT_H
#define GN_FORMATS_PIXEL_LAYOUT_H

/* ROW(argument, name, bytes, element) */
/* clang-format off */
#define PIXEL_LAYOUTS(ROW, argument) \
    ROW(argument, BYTE,              1, 1) \
    ROW(argument, SHORT,             2, 2) \
    ROW(argument, SHORT_HIGH_FIRST,  2, 1) /* two bytes that are one number, the high one first */ \
    ROW(argument, THREE_BYTES,       3, 1) \
    ROW(argument, WORD,              4, 4) \
    ROW(argument, FOUR_SHORTS,       8, 2) \
    ROW(argument, TWO_WORDS,         8, 4) \
    ROW(argument, THREE_WORDS,      12, 4) \
    ROW(argument, FOUR_WORDS,       16, 4)
/* clang-format on */

#define LAYOUT_NAME(argument, name, bytes, element) LAYOUT_##name,
typedef enum pixel_layout {
    LAYOUT_NONE,
    PIXEL_LAYOUTS(LAYOUT_NAME, ) PIXEL_LAYOUT_COUNT
} pixel_layout;
#undef LAYOUT_NAME

/* LAYOUT_name_BYTES and LAYOUT_name_ELEMENT. */
#define LAYOUT_SIZES(argument, name, bytes, element)                                               \
    LAYOUT_##name##_BYTES = (bytes), LAYOUT_##name##_ELEMENT = (element),
enum { PIXEL_LAYOUTS(LAYOUT_SIZES, ) LAYOUT_MOST_BYTES = 16 };
#undef LAYOUT_SIZES

#endif
