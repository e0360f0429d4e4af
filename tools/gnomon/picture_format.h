/* The formats of pictures that the command writes, chosen by the file's name. */
#ifndef PICTURE_FORMAT_H
#define PICTURE_FORMAT_H

#include <stdbool.h>

typedef enum picture_format {
    PICTURE_PNG = 1,
    PICTURE_TGA = 2, /* uncompressed */
    PICTURE_PPM = 4, /* binary, without alpha */
    PICTURE_RAW = 8  /* red, green, blue and alpha of 8 bits, top row first, and nothing else */
} picture_format;

/* Sets of formats: those that programs can look at, and all of them. */
#define PICTURE_ANY (PICTURE_PNG | PICTURE_TGA | PICTURE_PPM)
#define PICTURE_ANY_OR_RAW (PICTURE_ANY | PICTURE_RAW)

#define PICTURE_SUFFIXES_IN_WORDS ".png, .tga or .ppm"
#define PICTURE_SUFFIXES_OR_RAW_IN_WORDS ".png, .tga, .ppm or .raw"

/* Whether the name ends in a suffix. A file whose name only begins with a dot has none. */
bool picture_has_suffix(const char *path);

/* Whether the name ends in .gif, which no command writes. */
bool picture_is_gif(const char *path);

/* The format by the name's suffix. A name without one is a PNG's. Returns false for any other
 * suffix. */
bool picture_format_of(const char *path, picture_format *result);

/* The format of this name: "png", "tga", "ppm" or "raw". Returns false for any other. */
bool picture_format_by_name(const char *name, picture_format *result);

/* Checks, before anything is drawn, that a picture of one of these formats can be written to this
 * path. Returns 0, or EXIT_FAULT with the reason printed. */
int picture_format_check(const char *path, unsigned int allowed);

#endif
