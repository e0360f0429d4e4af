/* The maps a part of a model is drawn with: found, read, and told of. */
#ifndef MAPS_H
#define MAPS_H

#include "image.h"
#include "model.h"
#include "options.h"

typedef struct part_maps {
    image images[MAP_COUNT];       /* without texels: none */
    bool normals_in_tangent_space; /* otherwise in that of the model, which is the world's */
} part_maps;

/* What has been read so far, as a list in words; zeroed it is empty. */
typedef struct maps_told {
    char *text; /* null: nothing */
} maps_told;

/* Reads those maps of `wanted`, a set of 1 << map_kind, that there are: by the options; otherwise
 * the one that the material names, a file beside the model or an image inside it; otherwise
 * MODEL_diffuse, _nm_tangent, _nm, _spec or _glow with .tga, .png or .jpg beside MODEL.obj. A part
 * without texture coordinates has none. What is read is added to `told` and taken from the budget.
 * 0, to be freed with maps_free; otherwise EXIT_FAULT with the reason printed and nothing to free.
 */
int maps_read(const options *o, const model_part *part, unsigned int wanted, image_budget *budget,
              part_maps *result, maps_told *told);

void maps_free(part_maps *maps);
void maps_told_free(maps_told *told);

/* Length of a model's path without its extension. */
size_t maps_stem_length(const char *model_path);

#endif
