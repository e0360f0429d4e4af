/* The images that the dropped model needs, and the maps of its parts that are made of them. */
#ifndef PAGE_MAPS_H
#define PAGE_MAPS_H

#include "page_parts.h"
#include "page_text.h"
#include "reader.h"

#define PAGE_MAX_MAP_SIZE 8192

/* Finds the images of a model among the dropped files: those that materials name, those inside the
 * model, and those whose file names are the model's with _diffuse, _nm_tangent, _spec or _glow, for
 * maps that no material names. Warns of those that were not dropped. Returns false if there is not
 * enough memory; free with page_maps_forget either way. */
bool page_maps_find(const model *m, model_reader *warnings);

/* Adds the images whose texels are wanted to page_model_describe's text. */
void page_maps_describe(text *to);

/* As page_model_image. Returns null, with the message set, if it does not want this image. */
uint32_t *page_maps_image(uint32_t number, uint32_t width, uint32_t height);

/* Makes the maps of all parts, and frees the images. Warns of what is drawn otherwise than the
 * files say. Returns false if there is not enough memory; the maps so far are then to be freed. */
bool page_maps_complete(const model *m, part_maps *maps, model_reader *warnings);

void page_maps_forget(void);

#endif
