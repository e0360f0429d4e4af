/* The maps of a part of a model: finds them, reads them, and lists them in words. */
#ifndef MAPS_H
#define MAPS_H

#include "files.h"
#include "image.h"
#include "model.h"
#include "options.h"

typedef struct part_maps {
    image images[MAP_COUNT]; /* without texels: none */
    bool replaces_color; /* the diffuse map is none of the material's, and takes the place of its
                            colour; otherwise they are multiplied */
    bool normals_in_tangent_space; /* otherwise in the model's space, which is the world's */
} part_maps;

/* What is said of the maps read so far. Zeroed, it is empty. */
typedef struct maps_told {
    char *text;          /* for each map a character, 1 + map_kind, and words; null: nothing */
    files_list oriented; /* files that the user was warned of, since they name an orientation */
} maps_told;

/* Reads the maps of `wanted`, a set of 1 << map_kind, if they exist: by the options; otherwise the
 * map that the material names, a file beside the model or an image inside it; otherwise
 * MODEL_diffuse, _nm_tangent, _nm, _spec or _glow with .tga, .png or .jpg beside MODEL.obj. A part
 * without texture coordinates has no maps. Maps that are read are added to `told`, and their size
 * is subtracted from the budget. Alpha in the diffuse map is opacity, or 255 if the part is opaque.
 * Warns once of a
 * file with an orientation that is not applied. Returns 0; free with maps_free. Otherwise returns
 * EXIT_FAULT with the reason printed and nothing to free. */
int maps_read(const options *o, const model *m, size_t part, unsigned int wanted,
              image_budget *budget, part_maps *result, maps_told *told);

void maps_free(part_maps *maps);
/* Adds the words of a list to the end of another. Returns false if there is not enough memory. */
bool maps_told_append(maps_told *to, const maps_told *from);

/* The maps of `wanted`, a set of 1 << map_kind, in words, allocated; *result is null if there are
 * none. Returns false if there is not enough memory. */
bool maps_told_words(const maps_told *told, unsigned int wanted, char **result);

void maps_told_free(maps_told *told);

/* The length of a model's path without its extension. */
size_t maps_stem_length(const char *model_path);

#endif
