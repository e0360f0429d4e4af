/* Random transforms and floats for the properties of the mathematics. Both shrink: zero bits make
 * the simplest. */
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
    AFFINE_KINDS, /* number of the kinds above */
    ORTHOGRAPHIC = AFFINE_KINDS,
    FRUSTUM,
    PERSPECTIVE,
    VIEWPORT,
    KINDS
};

extern const char *const kind_names[KINDS];

/* Which kinds to generate: first to last - 1, with numbers of 2^-exponents to 2^exponents. */
struct choice {
    int first, last;
    int exponents;
};

/* A constructor, its arguments, and its result. */
struct made {
    enum kind kind;
    float numbers[9];
    gn_transform transform;
};

enum { FLOATS = 32 };

/* A number with a magnitude of 2^-exponents to 2^exponents. */
float random_number(struct theft *t, int exponents);

/* Instances are struct made: one of the chosen kinds, of numbers that its constructor accepts. The
 * choice must outlive the runs. */
struct theft_type_info random_transforms(struct choice *choice);

/* Instances are FLOATS floats: with the chosen exponents, or with a null pointer of any bit
 * pattern. */
struct theft_type_info random_floats(struct choice *choice);

#endif
