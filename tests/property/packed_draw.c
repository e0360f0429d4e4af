/* Computes the sizes of structs without padding, by including their headers again, packed. No other
 * file may use the structs packed. */
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
