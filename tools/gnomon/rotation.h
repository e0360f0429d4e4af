/* Rotations given in degrees. */
#ifndef ROTATION_H
#define ROTATION_H

#include <gnomon.h>

/* Radians, rounded once. */
float rotation_radians(float degrees);

/* The rotation about an axis of any length but zero, through the origin. Multiples of 90 degrees
 * about x, y and z are exact. Returns the status of gn_rotate_axis. */
gn_status rotation_about(gn_vec3 axis, float degrees, gn_transform *result);

#endif
