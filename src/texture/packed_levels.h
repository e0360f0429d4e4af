/* Levels that are tightly packed in memory, one after the other. */
#ifndef GN_TEXTURE_PACKED_LEVELS_H
#define GN_TEXTURE_PACKED_LEVELS_H

#include <gnomon/texture.h>

/* Returns the bytes of levels first to end - 1 of a texture whose shape has no fault; 0 if they do
 * not fit memory. */
size_t gni_packed_bytes(const gn_texture *texture, uint32_t first, uint32_t end);

/* Sets where levels first to end - 1 of the texture lie: tightly packed from `memory` on. */
void gni_place_levels(gn_texture *texture, uint32_t first, uint32_t end, const void *memory);

#endif
