/* The origin of a model whose coordinates are far from zero. */
#include "origin.h"

#include <math.h>

origin_bounds origin_empty(void)
{
    return (origin_bounds){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

void origin_add(origin_bounds *b, const double position[3])
{
    for (int c = 0; c < 3; ++c) {
        if (!isfinite(position[c]))
            continue;
        if (position[c] < b->low[c])
            b->low[c] = position[c];
        if (position[c] > b->high[c])
            b->high[c] = position[c];
    }
}

void origin_choose(const origin_bounds *b, double origin[3])
{
    double middle[3], distance = 0.0, half = 0.0;
    for (int c = 0; c < 3; ++c) {
        middle[c] = b->low[c] <= b->high[c] ? b->low[c] / 2.0 + b->high[c] / 2.0 : 0.0;
        distance = fmax(distance, fabs(middle[c]));
        if (b->low[c] <= b->high[c])
            half = fmax(half, b->high[c] / 2.0 - b->low[c] / 2.0);
    }
    for (int c = 0; c < 3; ++c)
        origin[c] = distance > 16.0 * half ? middle[c] : 0.0;
}
