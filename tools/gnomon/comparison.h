/* Drawing a scene twice, with the library and with OSMesa, and reporting what differs. */
#ifndef COMPARISON_H
#define COMPARISON_H

#include <stdio.h>

#include <scene.h>

#include "shadow.h"

typedef struct comparison {
    scene_frame ours;
    scene_frame reference;
    scene_difference difference; /* of the pictures; samples are resolved */
    scene_difference samples;    /* of every sample, where there are several */
    uint64_t shadow_texels;      /* of the shadow map, where there is one */
} comparison;

/* Draws both, ours with the given back end, and prints, into `words`, the Mesa version and how many
 * pixels differ in colour and depth, and by how much, and of samples, where a pixel has several,
 * how many. 0, or EXIT_FAULT with the reason printed; free with comparison_free either way. */
int comparison_make(const scene *s, const shadow_pass *shadow, gn_backend backend, FILE *words,
                    comparison *result);

/* Writes ours, OSMesa's and the difference side by side: black where all is equal, otherwise
 * the channels' differences amplified, magenta where only alpha or depth differ. */
int comparison_write_triptych(const comparison *c, const char *path);

/* Prints "out.png: Gnomon, OSMesa, difference". */
void comparison_name_triptych(FILE *words, const char *path);

/* Writes ours alone. */
int comparison_write_picture(const comparison *c, const char *path);

void comparison_free(comparison *c);

#endif
