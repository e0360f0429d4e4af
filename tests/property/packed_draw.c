/* The sizes of structs without padding: the headers again, packed. Nothing else may use them so. */
#include <float.h>
#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#pragma pack(push, 1)
#include "scene.h"
#pragma pack(pop)

#include "packed_draw.h"

const size_t packed_draw_size = sizeof(scene_draw) - PACKED_DRAW_TEXTURES * sizeof(gn_texture);
