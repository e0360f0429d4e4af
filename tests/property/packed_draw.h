/* packed_draw_size: how many bytes of a draw belong to members and are not padding. */
#ifndef PACKED_DRAW_H
#define PACKED_DRAW_H

#include <stddef.h>

/* The number of textures in a draw, which packed_draw_size leaves out. */
#define PACKED_DRAW_TEXTURES (1 + SCENE_MAP_COUNT)

extern const size_t packed_draw_size;

#endif
