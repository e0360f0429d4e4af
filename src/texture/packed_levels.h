/* Levels that are tightly packed in memory, one after the other. */
#ifndef GN_TEXTURE_PACKED_LEVELS_H
#define GN_TEXTURE_PACKED_LEVELS_H

#include <gnomon/texture.h>

/* Returns the bytes of levels first to end - 1, or 0 if they do not fit memory. Precondition: the
 * texture's shape has no fault. */
size_t gni_packed_bytes(const gn_texture *texture, uint32_t first, uint32_t end);

/* Places levels first to end - 1 of the texture, tightly packed, from `memory` on. */
void gni_place_levels(gn_texture *texture, uint32_t first, uint32_t end, const void *memory);

#endif
