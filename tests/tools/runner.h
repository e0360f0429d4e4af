/* Running the gnomon command as a user does: in a directory of its own, through a shell, its
 * output, exit status and files looked at from outside. */
#ifndef RUNNER_H
#define RUNNER_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <setjmp.h>
#include <cmocka.h>

/* What the last run left. */
typedef struct run {
    int status;       /* exit status; 128 + n for signal n */
    char out[16384];  /* standard output */
    char error[8192]; /* standard error */
} run;

/* A decoded PNG, top row first. 16-bit grey or 8-bit RGBA, whatever the file's own kind. */
typedef struct picture {
    uint32_t width, height;
    uint8_t *rgba;  /* from picture_read */
    uint16_t *grey; /* from picture_read_grey16 */
} picture;

/* Makes the directory and finds the command: the environment variable GNOMON or the program's
 * first argument. Every test program calls this first. */
void runner_start(int argc, char **argv);

/* Removes the directory. */
void runner_end(void);

/* Runs "gnomon " + arguments with the directory as the current one. The arguments are a
 * shell's words. What does not end within a minute has status 124. */
run gnomon(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The same for a whole shell line, in which $GNOMON is the command. */
run shell(const char *line);

int lines(const char *text);

/* Runs gnomon and fails unless it ends with that status, prints one line on standard error that
 * begins with gnomon and holds both texts, prints nothing on standard output and leaves no new
 * file. */
void expect(int status, const char *arguments, const char *first, const char *second);

/* Files in the directory, by their plain names. */
void write_text(const char *name, const char *text);
void write_bytes(const char *name, const void *bytes, size_t size);
bool exists(const char *name);
void remove_file(const char *name);
const char *path_of(const char *name); /* good until the next call */

/* The names in the directory that were not there at runner_mark; 0 to expect. */
void runner_mark(void);
int new_files(void);

picture picture_read(const char *name);
picture picture_read_grey16(const char *name);
void picture_free(picture *p);

/* 0xrrggbbaa */
uint32_t pixel(const picture *p, uint32_t x, uint32_t y);

/* The square -1..1 in x and y at z = 0, facing +z, texture coordinates 0..1, as an OBJ. */
extern const char square_obj[];

/* A camera that maps this square to the whole picture. */
#define FRONT "--eye 0,0,5 --target 0,0,0 --orthographic 2"

#endif
