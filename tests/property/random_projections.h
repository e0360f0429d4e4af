/* Random projections of every kind and convention, which shrink. */
#ifndef RANDOM_PROJECTIONS_H
#define RANDOM_PROJECTIONS_H

#include <stdbool.h>

#include <theft.h>

#include <gnomon.h>

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
    int first, last; /* volumes first to last - 1 */
    int exponents;   /* of the numbers */
    bool ordinary;   /* planes in order and apart, near and far positive */
};

/* Instances are struct projection, of numbers that the constructor accepts. The choice must outlive
 * the runs. */
struct theft_type_info random_projections(struct projection_choice *choice);

#endif
