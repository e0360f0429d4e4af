/* Pictures: what the options ask for and what the model holds, as a scene. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdio.h>

#include <scene.h>

#include "maps.h"
#include "options.h"
#include "shadow.h"

typedef struct picture {
    scene *scene; /* into GN_FORMAT_RGBA8 and GN_FORMAT_D32F */
    shading shading;
    maps_told maps;
    shadow_pass shadow; /* zeroed: none */
} picture;

/* Reads the model and its maps, places the camera and describes it all as a scene to draw. 0, to
 * be freed with picture_free; otherwise EXIT_FAULT with the reason printed and nothing to free. */
int picture_describe(const options *o, picture *result);

void picture_free(picture *p);

/* Prints "out.png: 1024x1024, 2492 triangles, Phong", and the maps in a second line. */
void picture_print_summary(FILE *file, const char *name, const picture *p);

/* Whether a file that is read would be overwritten by one that is written, or that one cannot be
 * written: EXIT_FAULT with the reason printed, otherwise 0. Null names no file. */
int picture_check_output(const options *o, const char *output_path);

#endif
