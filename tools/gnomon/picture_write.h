/* Picture files of all formats, written row by row. */
#ifndef PICTURE_WRITE_H
#define PICTURE_WRITE_H

#include "picture_format.h"
#include "png_write.h"

/* Writes a complete picture into an open output, which stays open. PNG_GREY16 is for PNG alone; PPM
 * drops alpha. Returns 0, or EXIT_FAULT with the reason printed. */
int picture_write(output *o, picture_format format, png_kind kind, uint32_t width, uint32_t height,
                  png_row *row, const void *context);

/* The parts of a TGA, PPM or raw file, for those who write rows in an order of their own. Head and
 * tail may be empty; their sizes are returned. picture_plain_row turns a row of this kind into the
 * format's, in place, and returns its size, which is that of every row. */
#define PICTURE_EDGE_SIZE 64
size_t picture_plain_head(picture_format format, png_kind kind, uint32_t width, uint32_t height,
                          uint8_t head[PICTURE_EDGE_SIZE]);
size_t picture_plain_row(picture_format format, png_kind kind, uint32_t width, uint8_t *row);
size_t picture_plain_tail(picture_format format, uint8_t tail[PICTURE_EDGE_SIZE]);

/* Opens, writes and finishes a file. Returns 0, or EXIT_FAULT with the reason printed and nothing
 * half-written. */
int picture_write_file(const char *path, picture_format format, png_kind kind, uint32_t width,
                       uint32_t height, png_row *row, const void *context);

#endif
