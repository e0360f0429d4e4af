/* The pixel formats as tests and the reference know them: names, sizes and where channels are come
 * from the library's rows (src/formats/rows.h), which are data; what is computed with them is
 * written on this side again. */
#ifndef SCENE_FORMAT_H
#define SCENE_FORMAT_H

#include <stdbool.h>
#include <stddef.h>

#include <gnomon.h>

#include "../../src/formats/rows.h"

typedef enum scene_encoding { SCENE_UNORM, SCENE_SRGB, SCENE_FLOAT } scene_encoding;

typedef struct scene_format {
    const char *name;     /* RGBA8; null: no format */
    size_t size, element; /* in bytes */
    bool is_color;        /* otherwise depth, stencil or both */
    bool high_first;      /* two bytes that are one number, the higher in the first */
    scene_encoding encoding;
    int channels;           /* how many of a colour; 1 of depth or stencil, 2 of both */
    int shift[4], width[4]; /* of colours red first; of the others depth, stencil */
} scene_format;

/* How many rows there are of colours, and of depth, stencil and both. */
#define SCENE_COUNT(name, bytes, element, kind, ...) +SCENE_COUNT_##kind
#define SCENE_COUNT_COLOR 1
#define SCENE_COUNT_DEPTH 0x10000
enum {
    SCENE_COLOR_FORMATS = (GN_FORMATS(SCENE_COUNT)) & 0xFFFF,
    SCENE_DEPTH_FORMATS = (GN_FORMATS(SCENE_COUNT)) >> 16,
    SCENE_FORMATS = 1 + SCENE_COLOR_FORMATS + SCENE_DEPTH_FORMATS /* with GN_FORMAT_NONE */
};

/* The row of a format; that of GN_FORMAT_NONE and of no format is empty. */
const scene_format *scene_format_of(gn_format format);

/* All formats of colours, and all others, in the order of the rows. */
extern const gn_format scene_color_formats[SCENE_COLOR_FORMATS];
extern const gn_format scene_depth_formats[SCENE_DEPTH_FORMATS];

bool scene_is_color_format(gn_format format);
bool scene_is_float_format(gn_format format);
bool scene_has_depth(gn_format format);
bool scene_has_stencil(gn_format format);

/* Bits of a channel of integers or floats. */
int scene_channel_width(gn_format format, int channel);

/* Bytes of an element of a format's pixels; 0 of GN_FORMAT_NONE. */
size_t scene_element_size(gn_format format);

#endif
