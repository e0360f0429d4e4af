/* Runs the gnomon command as a user does: in a directory of its own, through a shell. Tests look at
 * its output, exit status and files from outside. */
#ifndef RUNNER_H
#define RUNNER_H

#include "suite.h"

/* The results of the last run. */
typedef struct run {
    int status;       /* exit status; 128 + n for signal n */
    char out[16384];  /* standard output */
    char error[8192]; /* standard error */
} run;

/* A decoded PNG, top row first: 16-bit grey or 8-bit RGBA, whatever the file's own kind. */
typedef struct picture {
    uint32_t width, height;
    uint8_t *rgba;  /* from picture_read */
    uint16_t *grey; /* from picture_read_grey16 */
} picture;

/* Every test program makes its directory first, and finds the command: the environment variable
 * GNOMON or the program's first argument. */

/* Runs "gnomon " + arguments with the directory as the current one. The arguments are words of a
 * shell. A run that takes longer than a minute has status 124. */
run gnomon(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Does what gnomon does, for a whole shell line, in which $GNOMON is the command. */
run shell(const char *line);

int lines(const char *text);

/* Returns whether there is such a program. Says that `what` is not looked at if there is none. */
bool has_program(const char *name, const char *what);

/* Returns whether the command can be tested with little memory. Says so if it cannot, because it
 * was built with AddressSanitizer; the plain build is tested then. */
bool little_memory_works(void);

/* Runs gnomon and fails unless all of this holds: it ends with this status; it prints one line on
 * standard error that begins with gnomon and holds both texts; it prints nothing on standard
 * output; it leaves no new file. */
void expect(int status, const char *arguments, const char *first, const char *second);

/* Fails unless the run ended with status 0 and printed nothing on standard error. */
void expect_good(const run *r);

/* Files in the directory, by their plain names. */
void write_text(const char *name, const char *text);
void write_bytes(const char *name, const void *bytes, size_t size);
bool exists(const char *name);
void remove_file(const char *name);
const char *path_of(const char *name); /* valid until the next call */

/* Counts the names in the directory that did not exist at runner_mark; expect requires 0. */
void runner_mark(void);
int new_files(void);

picture picture_read(const char *name);
picture picture_read_grey16(const char *name);
void picture_free(picture *p);

/* 0xrrggbbaa */
uint32_t pixel(const picture *p, uint32_t x, uint32_t y);

/* An OBJ file of the square -1..1 in x and y at z = 0, facing +z, with texture coordinates 0..1. */
extern const char square_obj[];

/* Options for a camera that maps this square to the whole picture. */
#define FRONT "--eye 0,0,5 --target 0,0,0 --orthographic 2"

#endif
