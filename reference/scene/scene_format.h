/* The pixel formats as tests and the reference know them. Names, sizes and the places of channels
 * come from the library's rows (src/formats/format_table.h), which are plain data. What is computed
 * from them is written here a second time, independently of the library. */
#ifndef SCENE_FORMAT_H
#define SCENE_FORMAT_H

#include <stdbool.h>
#include <stddef.h>

#include <gnomon.h>

#include "../../src/formats/format_table.h"

typedef enum scene_encoding { SCENE_UNORM, SCENE_SRGB, SCENE_FLOAT } scene_encoding;

typedef struct scene_format {
    const char *name;     /* such as RGBA8; null: no format */
    size_t size, element; /* in bytes */
    bool is_color;        /* otherwise depth, stencil or both */
    bool high_first;      /* two bytes that are one number, the first byte the high one */
    scene_encoding encoding;
    int channels;           /* of a colour; 1 for depth or stencil, 2 for both */
    int shift[4], width[4]; /* colours: red first; others: depth, stencil */
} scene_format;

/* The number of rows of colours, and of rows of depth, stencil and both. */
#define SCENE_COUNT(name, layout, kind, ...) +SCENE_COUNT_##kind
#define SCENE_COUNT_COLOR 1
#define SCENE_COUNT_DEPTH 0x10000
enum {
    SCENE_COLOR_FORMATS = (GN_FORMATS(SCENE_COUNT)) & 0xFFFF,
    SCENE_DEPTH_FORMATS = (GN_FORMATS(SCENE_COUNT)) >> 16,
    SCENE_FORMATS = 1 + SCENE_COLOR_FORMATS + SCENE_DEPTH_FORMATS /* with GN_FORMAT_NONE */
};

/* Returns the row of a format; an empty row for GN_FORMAT_NONE and for a value that is no
 * format. */
const scene_format *scene_format_of(gn_format format);

/* All colour formats, and all other formats, in the order of the rows. */
extern const gn_format scene_color_formats[SCENE_COLOR_FORMATS];
extern const gn_format scene_depth_formats[SCENE_DEPTH_FORMATS];

bool scene_is_color_format(gn_format format);
bool scene_is_float_format(gn_format format);
bool scene_has_depth(gn_format format);
bool scene_has_stencil(gn_format format);

/* Returns the number of bits of a channel. */
int scene_channel_width(gn_format format, int channel);

/* Returns the bytes of an element of a format's pixels; 0 for GN_FORMAT_NONE. */
size_t scene_element_size(gn_format format);

#endif
