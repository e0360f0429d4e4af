/* What projections of every convention share. */
#ifndef GNOMON_MATH_PROJECTION_H
#define GNOMON_MATH_PROJECTION_H

#include <gnomon/projection.h>

#include <stdbool.h>

/* The sign of z before the camera. */
#define GN_RIGHT_HANDED (-1.0f)
#define GN_LEFT_HANDED 1.0f

/* The suffixes of a name after the hand: a sum of these, 0 for _no. */
enum projection_depth { GN_DEPTH_ZO = 1, GN_DEPTH_REVERSED = 2, GN_DEPTH_INFINITE = 4 };

bool gn_all_finite(const float *numbers, int count);

/* The perspective matrix with x_scale and y_scale on the diagonal and the skews of
 * an asymmetric frustum. z_near and z_far are positive and differ; z_far is not
 * read where depth is infinite. GN_OUT_OF_RANGE, and nothing written, where an
 * entry of the matrix or the inverse cannot be held. */
gn_status gn_write_perspective(float hand, unsigned depth, float x_scale, float y_scale,
                               float skew_x, float skew_y, float z_near, float z_far,
                               gn_transform *result);

#endif
