/* Draws a scene with the library and with OSMesa, and reports the differences. */
#ifndef COMPARISON_H
#define COMPARISON_H

#include <stdio.h>

#include "scene.h"

#include "shadow.h"

typedef struct comparison {
    scene_frame ours;
    scene_frame reference;
    scene_difference difference; /* difference of the pictures; samples are resolved */
    scene_difference samples;    /* difference of all samples, if a pixel has several */
    uint64_t shadow_texels;      /* difference of the shadow maps, if there is one */
} comparison;

/* Draws both, the library's with the given back end. Prints into `words` the version of Mesa, how
 * many pixels differ in colour and in depth, and by how much; if a pixel has several samples, how
 * many samples differ. Returns 0, or EXIT_FAULT with the reason printed; free with comparison_free
 * either way. */
int comparison_make(const scene *s, const shadow_pass *shadow, gn_backend backend, FILE *words,
                    comparison *result);

/* Writes the library's picture, OSMesa's and the difference side by side. The difference is black
 * where both are equal, otherwise the amplified differences of the channels, and magenta if only
 * alpha or depth differ. */
int comparison_write_triptych(const comparison *c, const char *path);

/* Prints "out.png: Gnomon, OSMesa, difference". */
void comparison_name_triptych(FILE *words, const char *path);

/* Writes the library's picture alone. */
int comparison_write_picture(const comparison *c, const char *path);

void comparison_free(comparison *c);

#endif
