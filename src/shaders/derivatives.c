/* Derivatives in quads of 2x2 fragments; lane l of a block is the pixel (l % 4, l / 4). */
#include "gnomon/derivatives.h"

#include "../math/bits.h"

/* To the neighbour in a row and in a column. */
#define COLUMN 1
#define ROW 4

void gn_derivative_x(const float value[GN_LANES], float out[GN_LANES])
{
    for (int l = 0; l < GN_LANES; l += 2 * COLUMN)
        out[l] = out[l + COLUMN] = value[l + COLUMN] - value[l];
}

void gn_derivative_y(const float value[GN_LANES], float out[GN_LANES])
{
    for (int l = 0; l < GN_LANES; l += l % ROW == ROW - 1 ? ROW + 1 : 1)
        out[l] = out[l + ROW] = value[l + ROW] - value[l];
}

void gn_derivative_width(const float value[GN_LANES], float out[GN_LANES])
{
    float x[GN_LANES], y[GN_LANES];

    gn_derivative_x(value, x);
    gn_derivative_y(value, y);
    for (int l = 0; l < GN_LANES; ++l)
        out[l] = gn_magnitude(x[l]) + gn_magnitude(y[l]);
}
