#include "smooth_coverage.h"

#include <math.h>

static float clamped(float x)
{
    return x > 0.0f ? x < 1.0f ? x : 1.0f : 0.0f;
}

void cover_smooth_line(const float (*coverage)[GN_LANES], gn_fragment_output *output)
{
    for (int l = 0; l < GN_LANES; ++l) {
        const float most = coverage[3][l] * 2.0f - 1.0f;
        const float across = clamped(coverage[1][l] - fabsf(coverage[0][l]));
        const float along = clamped(coverage[3][l] - fabsf(coverage[2][l]));

        output->color[3][l] *= across * (along < most ? along : most);
    }
}

/* As in the reference, what is nearer than the threshold has more than its alpha, and what is
 * farther has its own. */
void cover_smooth_point(const float (*coverage)[GN_LANES], gn_fragment_output *output)
{
    for (int l = 0; l < GN_LANES; ++l) {
        const float x = coverage[0][l], y = coverage[1][l];
        const float threshold = coverage[2][l], one = coverage[3][l];
        const float distance = x * x + y * y;

        if (one < distance)
            output->kept &= ~(1u << l);
        output->color[3][l] *=
            threshold >= distance ? 1.0f / (one - threshold) * (one - distance) : one;
    }
}
