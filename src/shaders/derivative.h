/* Differences within quads of 2x2 fragments; lane l of a block is the pixel (l % 4, l / 4). */
#ifndef GN_SHADERS_DERIVATIVE_H
#define GN_SHADERS_DERIVATIVE_H

#include "gnomon/sampling.h"

/* To the neighbour in a row and in a column. */
#define COLUMN 1
#define ROW 4

static inline void derivative_x(const float value[GN_LANES], float out[GN_LANES])
{
    for (int l = 0; l < GN_LANES; l += 2 * COLUMN)
        out[l] = out[l + COLUMN] = value[l + COLUMN] - value[l];
}

static inline void derivative_y(const float value[GN_LANES], float out[GN_LANES])
{
    for (int l = 0; l < GN_LANES; l += l % ROW == ROW - 1 ? ROW + 1 : 1)
        out[l] = out[l + ROW] = value[l + ROW] - value[l];
}

#endif
