/* Imports models and their maps, in a child process under limits (confined.h). */
#ifndef IMPORT_H
#define IMPORT_H

#include "files.h"
#include "maps.h"
#include "options.h"

typedef struct imported {
    model model;     /* the maps of its parts have no names */
    part_maps *maps; /* one of each part */
    maps_told told;
    files_list opened; /* the models and all that they name */
} imported;

/* Reads the model and those of its maps that are in `wanted`, a set of 1 << map_kind. Returns 0;
 * free with import_free. Otherwise returns EXIT_FAULT with the reason printed, which names the file
 * and, if a limit was reached, the option that raises it. Call it before threads are started. */
int import_model(const options *o, unsigned int wanted, imported *result);

/* Reads all models of the options, one after another, as the parts of one model, each placed where
 * the options say. As import_model otherwise; the limits are those of each model. */
int import_models(const options *o, unsigned int wanted, imported *result);

void import_free(imported *i);

#endif
