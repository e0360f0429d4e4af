/* Levels in memory that follow each other tightly packed. */
#ifndef GN_TEXTURE_PACKED_H
#define GN_TEXTURE_PACKED_H

#include "gnomon/texture.h"

/* Bytes of the levels first to end - 1 of a texture without a fault of its shape; 0 where they do
 * not fit memory. */
size_t gn_packed_bytes(const gn_texture *texture, uint32_t first, uint32_t end);

/* Lists those levels, from `memory` on. */
void gn_place_levels(gn_texture *texture, uint32_t first, uint32_t end, const void *memory);

#endif
