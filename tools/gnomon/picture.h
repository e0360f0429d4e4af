/* Pictures: the options and the model's contents, as a scene. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdio.h>

#include "scene.h"

#include "grid.h"
#include "import.h"
#include "look.h"
#include "options.h"
#include "picture_format.h"
#include "shadow.h"

/* What is drawn. */
typedef struct contents {
    imported from;
    bounding_sphere bounds;

    /* If it is not null, picture_build calls it when the shadow map is drawn, or could not be for
     * this fault, and before the map is used. Returns the fault that then holds. */
    int (*complete_shadows)(shadow_pass *pass, int fault);
} contents;

/* What a draw of a picture shows. */
typedef enum draw_kind {
    DRAW_PART = 0,
    DRAW_EDGES, /* of a part */
    DRAW_GRID,
    DRAW_BACKGROUND
} draw_kind;

typedef struct picture {
    scene *scene; /* into GN_FORMAT_RGBA8, or SRGB8_A8 of the same bytes, and GN_FORMAT_D32F. In
                     this order: the background if it has two colours; the grid as seen from above;
                     a draw for each opaque part; edges; a draw for each blended part, the farthest
                     first; the grid as seen from below */
    size_t *part_of_draw;    /* of draws of parts and edges */
    draw_kind *kind_of_draw; /* null: all are parts */
    size_t blended_first, blended_count;
    grid ground;
    look look;
    shading shading;
    char *maps;         /* those that the options' shader takes, in words; null: none */
    shadow_pass shadow; /* zeroed: no shadow */
} picture;

/* Reads the model and its maps, places the camera and builds the scene to draw. Returns 0; free
 * with picture_free. Otherwise returns EXIT_FAULT with the reason printed and nothing to free. */
int picture_describe(const options *o, picture *result);

/* The two halves of picture_describe. picture_import also checks that the options' outputs
 * overwrite none of the files that were read; names with a number are checked by
 * picture_check_opened. picture_build takes the maps out of the contents unless it is to `keep`
 * them. Both return 0, or EXIT_FAULT with the reason printed and nothing to free. */
int picture_import(const options *o, contents *result);
int picture_build(const options *o, contents *c, bool keep, picture *result);

/* The shader of the contents' picture: that of the options, or the one that fits the maps. */
shading picture_shading(const options *o, const contents *c);

/* Draws the same contents, turned, from where the options' camera is. The picture must have been
 * built from them, with options that differ in the camera alone. Returns 0, or EXIT_FAULT with the
 * reason printed. */
int picture_place(picture *p, const options *o, const contents *c, const gn_transform *turn);

void picture_free(picture *p);

/* The number of triangles, lines and points of the models. */
uint64_t picture_primitive_count(const picture *p);

/* Whether a draw shows a part of a model. */
bool picture_is_part(const picture *p, size_t draw);

/* Prints "out.png: 1024x1024, 2492 triangles, Phong", and on further lines the maps and the
 * distance of the grid's lines. The second function prints another number of primitives. */
void picture_print_summary(FILE *file, const char *name, const picture *p);
void picture_print_summary_of(FILE *file, const char *name, const picture *p, uint64_t primitives);

/* Checks that an output overwrites no file that the options name and can be written in one of these
 * formats. Returns EXIT_FAULT with the reason printed, otherwise 0. Null names no file. */
int picture_check_output(const options *o, const char *output_path, unsigned int formats);

/* Checks that an output overwrites none of the files that were read. Returns as
 * picture_check_output. */
int picture_check_opened(const contents *c, const char *output_path);

#endif
