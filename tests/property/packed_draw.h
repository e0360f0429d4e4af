/* How many bytes of a draw are members' and not padding. */
#ifndef PACKED_DRAW_H
#define PACKED_DRAW_H

#include <stddef.h>

/* The textures of a draw, which are not counted. */
#define PACKED_DRAW_TEXTURES (1 + SCENE_MAP_COUNT)

extern const size_t packed_draw_size;

#endif
