/* Picture files of all formats, written row by row. */
#ifndef PICTURE_WRITE_H
#define PICTURE_WRITE_H

#include "picture_format.h"
#include "png_write.h"

/* Writes a complete picture into an open output, which stays open. PNG_GREY16 is for PNG alone; PPM
 * drops alpha. Returns 0, or EXIT_FAULT with the reason printed. */
int picture_write(output *o, picture_format format, png_kind kind, uint32_t width, uint32_t height,
                  png_row *row, const void *context);

/* Opens, writes and finishes a file. Returns 0, or EXIT_FAULT with the
 * reason printed and nothing half-written. */
int picture_write_file(const char *path, picture_format format, png_kind kind, uint32_t width,
                       uint32_t height, png_row *row, const void *context);

#endif
