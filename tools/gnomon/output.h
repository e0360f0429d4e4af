/* Output files that are there whole or not at all: written beside their final place under
 * another name, and renamed when everything has succeeded. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

typedef struct output {
    const char *path; /* as the user wrote it, for messages */
    char *final;      /* what is replaced: the path with symbolic links followed */
    char *temporary;  /* null where the path is no regular file (a pipe, /dev/null) */
    FILE *file;
} output;

/* Whether a picture can be written there, before anything is drawn: the name ends on .png or has no
 * extension, and the directory and what is there already may be written to. 0, or EXIT_FAULT with
 * the reason printed. */
int output_check(const char *path);

/* Whether the path means standard output: "-", its names below /dev, or the file or pipe that
 * standard output leads to. */
bool output_is_standard(const char *path);

/* Where the command's words go when these outputs are written, either of which may be null:
 * standard output, or standard error where a picture goes there. */
FILE *output_words(const char *first, const char *second);

/* Starts an output file. 0, or EXIT_FAULT with the reason printed and nothing left to clean
 * up. Between open and rename or abandon, a signal that ends the program removes the
 * temporary file. At most OUTPUT_LIMIT files are open at a time. */
#define OUTPUT_LIMIT 4
int output_open(output *o, const char *path);

/* Flushes and closes: all bytes are then in the temporary file. 0, or EXIT_FAULT with the
 * reason printed and the temporary file gone. */
int output_finish(output *o);

/* Gives a finished file its final name. 0, or EXIT_FAULT with the reason printed; the
 * temporary file is gone either way. */
int output_rename(output *o);

/* Closes and removes. Harmless after rename and on a zeroed output. */
void output_abandon(output *o);

/* Whether both names lead to one file, that exists or would be made: then by its directory and
 * its name in it. */
bool output_same_file(const char *a, const char *b);

#endif
