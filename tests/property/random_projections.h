/* Random projections of every kind and convention. They shrink. */
#ifndef RANDOM_PROJECTIONS_H
#define RANDOM_PROJECTIONS_H

#include <stdbool.h>

#include <gnomon.h>

#include <theft.h>

enum volume { BOX, PYRAMID, SYMMETRIC, VOLUMES };

/* What a function's name says. */
struct convention {
    bool left_handed, zero_to_one, reversed, infinite;
};

/* The volume a camera sees, what was asked for, and what was made of it. The
 * numbers are left, right, bottom, top, near, far or fov_y, aspect, near, far. */
struct projection {
    enum volume volume;
    struct convention convention;
    float numbers[6];
    gn_transform transform;
};

/* The projection of the same volume in another convention. */
gn_status project_in(const struct projection *projection, struct convention convention,
                     gn_transform *result);

/* Its planes: left, right, bottom, top at the distance near, then near and far,
 * INFINITY where it has none. */
void planes_of(const struct projection *projection, double planes[6]);

/* How random ones are chosen. */
struct projection_choice {
    int first, last; /* volumes first to last - 1 */
    int exponents;   /* of the numbers */
    bool ordinary;   /* planes in order and apart, near and far positive */
};

/* Instances are struct projection, of numbers the constructor accepts. The choice
 * must outlive the runs. */
struct theft_type_info random_projections(struct projection_choice *choice);

#endif
