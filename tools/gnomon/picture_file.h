/* Picture files that the command reads to look at them, in a child process under limits
 * (confined.h). */
#ifndef PICTURE_FILE_H
#define PICTURE_FILE_H

#include "image.h"
#include "options.h"

/* Reads a picture of one of the formats of image.h. Returns 0; free with picture_file_free.
 * Otherwise returns EXIT_FAULT with the reason printed and nothing to free. */
int picture_file_read(const char *path, const import_limits *limits, image_values *result);

void picture_file_free(image_values *picture);

/* Channel c, 0 to 3, of pixel i, counted from the upper left, on the scale of 16 bits. A value of
 * 8 bits is multiplied by 257. */
uint32_t picture_file_value(const image_values *picture, size_t i, int c);

#endif
