/* One picture file that all ranks write, each its own rows. The file appears completely under its
 * name or not at all (output.h). Ranks write with MPI-IO; to a pipe, which has no places to write
 * to, rank 0 writes what the others send.
 *
 * All functions are collective. They return the same at all ranks: 0, or EXIT_FAULT with the reason
 * printed by the rank that has found it. */
#ifndef ROWS_FILE_H
#define ROWS_FILE_H

#include "bands.h"
#include "output.h"
#include "picture_write.h"
#include "ranks.h"

typedef struct rows_file {
    const char *path; /* for messages */
    output output;    /* of rank 0 */
    ranks_file *file; /* null: rank 0 writes */
    picture_format format;
    png_kind kind;
    uint32_t width, height;
    uint64_t end;   /* of what all ranks have written of a PNG */
    uint32_t adler; /* likewise, the checksum */
} rows_file;

/* Returns null, or why a picture of this size cannot have this format. */
const char *rows_file_refusal(picture_format format, uint32_t width, uint32_t height);

int rows_file_begin(rows_file *f, const char *path, picture_format format, png_kind kind,
                    uint32_t width, uint32_t height);

/* Writes rows of all ranks. Ranks' rows follow each other in the order of ranks, and begin where
 * the rows of the call before have ended. A rank's first row is the first of a unit of
 * PNG_SEGMENT_ROWS (bands.h); a rank may have none. */
int rows_file_write(rows_file *f, row_range rows, png_row *row, const void *context);

/* Completes the file, and gives it its name. Complete all files before you rename
 * the first one. */
int rows_file_finish(rows_file *f);
int rows_file_rename(rows_file *f);

/* Removes a file that was begun and not renamed; harmless on a zeroed one. */
void rows_file_abandon(rows_file *f);

#endif
