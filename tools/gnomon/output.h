/* Output files that appear completely or not at all: they are written beside their final place
 * under another name, and renamed when everything has succeeded. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

typedef struct output {
    const char *path; /* as the user wrote it, for messages */
    char *final;      /* the file that is made or replaced: the path with symbolic links followed */
    char *temporary;  /* null if the path is not a regular file (a pipe, /dev/null) */
    FILE *file;
} output;

/* Returns null, or why a file cannot be made or replaced at this path, or standard output cannot be
 * written; the text is valid until the next call. Follows symbolic links, looks at the directory,
 * and at the file if it exists; writes nothing. */
const char *output_fault(const char *path);

/* Whether the path means standard output: "-", one of its names in /dev, or the file or pipe that
 * standard output leads to. */
bool output_is_standard(const char *path);

/* The stream for the command's messages when these outputs, each of which may be null, are written:
 * standard output, or standard error if a picture goes to standard output. */
FILE *output_words(const char *first, const char *second);

/* Starts an output file. Returns 0, or EXIT_FAULT with the reason printed and nothing left to clean
 * up. Between open and rename or abandon, a signal that ends the program removes the temporary
 * file. At most OUTPUT_LIMIT files are open at a time. */
#define OUTPUT_LIMIT 4
int output_open(output *o, const char *path);

/* Flushes and closes: then all bytes are in the temporary file. Returns 0, or EXIT_FAULT with the
 * reason printed and the temporary file removed. */
int output_finish(output *o);

/* Gives a finished file its final name. Returns 0, or EXIT_FAULT with the reason printed. The
 * temporary file is gone either way. */
int output_rename(output *o);

/* Closes and removes the temporary file. Harmless after rename and on a zeroed output. */
void output_abandon(output *o);

/* Whether both names lead to one file, through symbolic links too. A file that does not exist yet
 * is compared by its directory and its name there. */
bool output_same_file(const char *a, const char *b);

#endif
