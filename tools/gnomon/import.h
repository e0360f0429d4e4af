/* Importing a model and its maps. Files come from anywhere, and those who read them, Assimp and
 * stb_image, may crash, hang or take all memory over one. So a child process reads them, within
 * limits, and hands over what they hold. */
#ifndef IMPORT_H
#define IMPORT_H

#include "maps.h"
#include "options.h"

typedef struct imported {
    model model;     /* its parts' maps have no names */
    part_maps *maps; /* one of each part */
    maps_told told;
} imported;

/* Reads the model and those maps of `wanted`, a set of 1 << map_kind, that there are. 0, to be
 * freed with import_free; otherwise EXIT_FAULT with the reason printed, which names the file and,
 * where a limit ended it, the option that raises it. Call it before threads are started. */
int import_model(const options *o, unsigned int wanted, imported *result);

void import_free(imported *i);

#endif
