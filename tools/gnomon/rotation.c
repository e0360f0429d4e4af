/* Rotations about coordinate axes, exact in quarter turns, and about any axis. */
#include "rotation.h"

#include <math.h>

#define RADIANS_PER_DEGREE 0.017453292519943295

float rotation_radians(float degrees)
{
    return (float)((double)degrees * RADIANS_PER_DEGREE);
}

/* A rotation about the coordinate axis k, whose component has this sign; quarter turns are
 * exact. */
static gn_status rotate_coordinate_axis(int k, float sign, float degrees, gn_transform *result)
{
    static const float quarter_sines[4] = {0.0f, 1.0f, 0.0f, -1.0f};
    const float rest = fmodf(degrees, 360.0f), quarters = rest / 90.0f;
    const gn_vec3 none = {0.0f, 0.0f, 0.0f};
    float m[3][3] = {{0.0f}}, sine, cosine;
    if (fmodf(rest, 90.0f) == 0.0f) {
        const int quarter = ((int)quarters + 4) % 4;
        sine = quarter_sines[quarter];
        cosine = quarter_sines[(quarter + 1) % 4];
    } else {
        gn_sincos(rotation_radians(degrees), &sine, &cosine);
    }
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    m[k][k] = 1.0f;
    m[i][i] = m[j][j] = cosine;
    m[i][j] = sign * sine;
    m[j][i] = -sign * sine;
    const gn_vec3 x = {m[0][0], m[0][1], m[0][2]}, y = {m[1][0], m[1][1], m[1][2]};
    const gn_vec3 z = {m[2][0], m[2][1], m[2][2]};
    return gn_frame_orthonormal(x, y, z, none, result);
}

gn_status rotation_about(gn_vec3 axis, float degrees, gn_transform *result)
{
    const float n[3] = {axis.x, axis.y, axis.z};
    int last = 0, components = 0;
    for (int k = 0; k < 3; ++k) {
        if (n[k] != 0.0f) {
            last = k;
            ++components;
        }
    }
    return components == 1
               ? rotate_coordinate_axis(last, n[last] > 0.0f ? 1.0f : -1.0f, degrees, result)
               : gn_rotate_axis(axis, rotation_radians(degrees), result);
}
