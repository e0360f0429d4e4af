/* Differences within quads of 2x2 fragments. Lane l of a block is the pixel (l % 4, l / 4). One
 * lane has no differences. */
#ifndef GN_SHADERS_DERIVATIVE_H
#define GN_SHADERS_DERIVATIVE_H

#include <gnomon/sampling.h>

/* Distance in lanes to the next column and to the next row. */
#define COLUMN 1
#define ROW 4

static inline void derivative_x(const float value[GN_LANES], float out[GN_LANES])
{
#if GN_LANES == 1
    (void)value;
    out[0] = 0.0f;
#else
    for (int l = 0; l < GN_LANES; l += 2 * COLUMN)
        out[l] = out[l + COLUMN] = value[l + COLUMN] - value[l];
#endif
}

static inline void derivative_y(const float value[GN_LANES], float out[GN_LANES])
{
#if GN_LANES == 1
    (void)value;
    out[0] = 0.0f;
#else
    for (int l = 0; l < GN_LANES; l += l % ROW == ROW - 1 ? ROW + 1 : 1)
        out[l] = out[l + ROW] = value[l + ROW] - value[l];
#endif
}

#endif
