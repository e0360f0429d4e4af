/* The files of a picture: its colours, and perhaps its depth. */
#ifndef PICTURE_FILES_H
#define PICTURE_FILES_H

#include "options.h"
#include "png_write.h"

/* Rows of a picture, and what they are made from. */
typedef struct picture_rows {
    png_row *color, *depth; /* PNG_RGBA8 and PNG_GREY16 */
    const void *context;
} picture_rows;

/* Writes both files or neither, in the size of the options. A null name of the depth: no such file.
 * Neither gets its name before both are complete on disk. An output that is not a regular file has
 * no such moment and cannot be undone. Returns 0, or EXIT_FAULT with the reason printed. */
int picture_files_write(const options *o, const char *color_name, const char *depth_name,
                        const picture_rows *rows);

#endif
