/* Random transforms and floats for the properties of the mathematics. Both
 * shrink: all-zero bits give the simplest. */
#ifndef RANDOM_INPUTS_H
#define RANDOM_INPUTS_H

#include <gnomon.h>

#include <theft.h>

enum kind {
    TRANSLATE,
    SCALE,
    ROTATE_X,
    ROTATE_Y,
    ROTATE_Z,
    ROTATE_AXIS,
    LOOK_AT,
    AFFINE_KINDS, /* those above */
    ORTHOGRAPHIC = AFFINE_KINDS,
    FRUSTUM,
    PERSPECTIVE,
    VIEWPORT,
    KINDS
};

extern const char *const kind_names[KINDS];

/* What to make: kinds first to last - 1, numbers of 2^-exponents to 2^exponents. */
struct choice {
    int first, last;
    int exponents;
};

/* A constructor, the numbers it was given, and what it made of them. */
struct made {
    enum kind kind;
    float numbers[9];
    gn_transform transform;
};

enum { FLOATS = 32 };

/* A number of 2^-exponents to 2^exponents in magnitude. */
float random_number(struct theft *t, int exponents);

/* Instances are struct made: one of the kinds chosen, of numbers its constructor
 * accepts. The choice must outlive the runs. */
struct theft_type_info random_transforms(struct choice *choice);

/* Instances are FLOATS floats: of the exponents chosen, or with a null pointer of
 * any bit pattern. */
struct theft_type_info random_floats(struct choice *choice);

#endif
