/* Random projections of every kind and convention, which shrink. */
#ifndef RANDOM_PROJECTIONS_H
#define RANDOM_PROJECTIONS_H

#include <gnomon.h>

#include "properties.h"

enum volume { BOX, PYRAMID, SYMMETRIC, VOLUMES };

/* The choices that a function's name states. */
struct convention {
    bool left_handed, zero_to_one, reversed, infinite;
};

/* The volume that a camera sees, the arguments, and the result. The numbers are left, right,
 * bottom, top, near, far or fov_y, aspect, near, far. */
struct projection {
    enum volume volume;
    struct convention convention;
    float numbers[6];
    gn_transform transform;
};

/* The projection of the volume in another convention. */
gn_status project_in(const struct projection *projection, struct convention convention,
                     gn_transform *result);

/* The planes of the volume: left, right, bottom, top at the distance near, then near and far;
 * INFINITY for a missing plane. */
void planes_of(const struct projection *projection, double planes[6]);

/* How random projections are chosen. */
struct projection_choice {
    int exponents; /* of the numbers */
    bool ordinary; /* planes in order and apart, near and far positive */
};

/* The type of arguments struct projection, of numbers that the constructor must accept. */
#define PROJECTIONS(most, is_ordinary)                                                             \
    INSTANCES(make_projection, print_projection, (&(struct projection_choice){most, is_ordinary}))

theft_alloc_cb make_projection;
theft_print_cb print_projection;

#endif
