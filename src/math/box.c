/* The box of a transformed box: each bound is the sum of the least, or greatest, contributions of
 * the coordinates.
 *
 * The sums are in the order of gn_mat4_transform_point. Rounding keeps the order of products and of
 * sums, so even before the bounds are moved they contain what that function returns for any point
 * of the box. Against exact arithmetic, three products and three sums are off by 4 u of the
 * magnitudes' sum, with u = 2^-24. Moving the bound adds one u, and the sum of magnitudes is itself
 * rounded. Each of four products may lose 2^-150 to underflow. */
#include "bounding_box.h"
#include "transform.h"

#define TOLERANCE 0x1.8p-22f /* 6 u */
#define UNDERFLOW 0x1p-147f

gn_status gn_mat4_transform_box(const gn_mat4 *m, const gn_box *box, gn_box *result)
{
    if (!m || !box || !result)
        return GN_NULL_POINTER;
    if (!gn_mat4_is_finite(m) || !gn_vec3_is_finite(box->min) || !gn_vec3_is_finite(box->max))
        return GN_NOT_FINITE;
    if (!gn_box_is_ordered(box))
        return GN_OUT_OF_RANGE;
    const float from[2][3] = {{box->min.x, box->min.y, box->min.z},
                              {box->max.x, box->max.y, box->max.z}};
    float low[3], high[3];
    for (int row = 0; row < 3; ++row) {
        float least[3], most[3], magnitude = gn_magnitude(m->m[3][row]);
        for (int i = 0; i < 3; ++i) {
            float a = m->m[i][row] * from[0][i], b = m->m[i][row] * from[1][i];
            least[i] = gn_smaller(a, b);
            most[i] = gn_larger(a, b);
            magnitude += gn_larger(gn_magnitude(a), gn_magnitude(b));
        }
        float margin = TOLERANCE * magnitude + UNDERFLOW;
        low[row] = (((least[0] + least[1]) + least[2]) + m->m[3][row]) - margin;
        high[row] = (((most[0] + most[1]) + most[2]) + m->m[3][row]) + margin;
        if (!gn_is_finite(low[row]) || !gn_is_finite(high[row]))
            return GN_OUT_OF_RANGE;
    }
    const gn_vec3 min = {low[0], low[1], low[2]}, max = {high[0], high[1], high[2]};
    result->min = min;
    result->max = max;
    return GN_OK;
}
