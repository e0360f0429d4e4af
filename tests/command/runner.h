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

/* Does what gnomon does, for a whole shell line, in which gnomon is the command, and $GNOMON its
 * path. */
run shell(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* As gnomon and shell, and fail unless the run ends with status 0. */
run good(const char *format, ...) __attribute__((format(printf, 1, 2)));
run good_shell(const char *format, ...) __attribute__((format(printf, 1, 2)));

int lines(const char *text);

/* Returns whether there is such a program. Says that `what` is not looked at if there is none. */
bool has_program(const char *name, const char *what);

/* Returns whether the command can be tested with little memory. Says so if it cannot, because it
 * was built with AddressSanitizer; the plain build is tested then. */
bool little_memory_works(void);

/* Runs gnomon and fails unless all of this holds: it ends with this status; it prints one line on
 * standard error that begins with gnomon and holds the message, whose parts " ... " may divide; it
 * prints nothing on standard output; it leaves no new file. */
void expect(int status, const char *arguments, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

typedef struct refusal {
    const char *arguments, *message;
} refusal;

/* expect for each row, whose arguments stand behind `before`. */
void expect_each(int status, const char *before, const refusal *rows, size_t count);
#define EXPECT_EACH(status, before, rows) expect_each(status, before, rows, COUNT(rows))

/* Runs a line of shell, and fails unless it ends with this status and standard error holds the
 * message, as for expect. */
void expect_shell(int status, const char *line, const char *message);

/* Fails with the last line that was run, and what it printed. */
void fail_run(const run *r);

/* Fails unless the run ended with status 0 and printed nothing on standard error. */
void expect_good(const run *r);

/* Fails unless the output holds the words. */
void expect_printed(const run *r, const char *words);

/* Fails unless two files are equal. */
void expect_same_files(const char *first, const char *second);

/* Files in the directory, by their plain names. */
void write_text(const char *name, const char *text);
void write_bytes(const char *name, const void *bytes, size_t size);
size_t read_file(const char *name, void *bytes, size_t size);
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

/* An OBJ file of the square -1..1 in x and y at z = 0, facing +z, with texture coordinates 0..1.
 * The directory has it as square.obj. */
extern const char square_obj[];

/* This square behind other lines, such as those that name a material. */
void write_square(const char *name, const char *before);

/* An OBJ file of size x size vertices. */
void write_grid(const char *name, int size);

/* A PPM file of one pixel. */
void write_color(const char *name, int red, int green, int blue);

/* Options for a camera that maps this square to the whole picture. */
#define FRONT "--eye 0,0,5 --target 0,0,0 --orthographic 2"

/* Fails if a channel of two colours, 0xrrggbbaa, differs by more than the tolerance. */
void expect_near(uint32_t got, uint32_t expected, int tolerance);

/* Renders to a.png without a warning, and reads it. */
picture drawn(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The background of render. */
#define BACKGROUND 0xedeeefffu

/* Pixels from left and top to before right and bottom. */
typedef struct rectangle {
    uint32_t left, top, right, bottom;
} rectangle;
#define RECTANGLE(...) ((rectangle){__VA_ARGS__})

/* Fails unless the pixels of the rectangle have this colour, or any but that of the outside if it
 * is 0, and the others that of the outside. The second renders the picture first. */
void expect_inside(const picture *p, rectangle inside, uint32_t color, uint32_t outside);
void expect_rectangle(const char *arguments, rectangle inside, uint32_t color, uint32_t outside);

/* Renders with FRONT; every pixel must have about this colour. */
void expect_color(const char *arguments, uint32_t color);

#endif
