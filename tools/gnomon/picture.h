/* Pictures: the options and the model's contents, as a scene. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdio.h>

#include "scene.h"

#include "maps.h"
#include "options.h"
#include "picture_format.h"
#include "shadow.h"

typedef struct picture {
    scene *scene; /* into GN_FORMAT_RGBA8 and GN_FORMAT_D32F */
    shading shading;
    maps_told maps;
    shadow_pass shadow; /* zeroed: no shadow */
} picture;

/* Reads the model and its maps, places the camera and builds the scene to draw. Returns 0; free
 * with picture_free. Otherwise returns EXIT_FAULT with the reason printed and nothing to free. */
int picture_describe(const options *o, picture *result);

void picture_free(picture *p);

/* Prints "out.png: 1024x1024, 2492 triangles, Phong", and the maps on a second line. */
void picture_print_summary(FILE *file, const char *name, const picture *p);

/* Checks that an output overwrites no input and can be written in one of these formats. Returns
 * EXIT_FAULT with the reason printed, otherwise 0. Null names no file. */
int picture_check_output(const options *o, const char *output_path, unsigned int formats);

#endif
