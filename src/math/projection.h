/* What projections of every convention share. */
#ifndef GNOMON_MATH_PROJECTION_H
#define GNOMON_MATH_PROJECTION_H

#include <gnomon/projection.h>

#include <stdbool.h>

/* The sign of z in front of the camera. */
#define GN_RIGHT_HANDED (-1.0f)
#define GN_LEFT_HANDED 1.0f

/* The suffixes of a name after the handedness: a sum of these, 0 for _no. */
enum projection_depth { GN_DEPTH_ZO = 1, GN_DEPTH_REVERSED = 2, GN_DEPTH_INFINITE = 4 };

bool gn_all_finite(const float *numbers, int count);

/* Writes the perspective matrix with x_scale and y_scale on the diagonal and the skews of an
 * asymmetric frustum. Preconditions: z_near and z_far are positive and differ; z_far is not read if
 * depth is infinite. Returns GN_OUT_OF_RANGE, and writes nothing, if gn_mat4_invert_perspective
 * refuses the matrix: a number would overflow or a reciprocal would not be a normal float. */
gn_status gn_write_perspective(float hand, unsigned depth, float x_scale, float y_scale,
                               float skew_x, float skew_y, float z_near, float z_far,
                               gn_transform *result);

#endif
