/* PNG files, written row by row with libpng. */
#ifndef PNG_WRITE_H
#define PNG_WRITE_H

#include <stdint.h>

#include "output.h"

typedef enum png_kind {
    PNG_RGB8,  /* 3 bytes a pixel */
    PNG_RGBA8, /* 4 bytes a pixel, alpha not premultiplied */
    PNG_GREY16 /* 2 bytes a pixel, the high one first */
} png_kind;

/* Fills `row` with row y of the picture, counted from the top. */
typedef void png_row(const void *context, uint32_t y, uint8_t *row);

/* Writes a complete PNG into an open output, which stays open. Returns 0, or EXIT_FAULT with the
 * reason printed. */
int png_write(output *o, png_kind kind, uint32_t width, uint32_t height, png_row *row,
              const void *context);

#endif
