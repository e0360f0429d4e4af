/* Random transforms and floats for the properties of the mathematics, seeds for those of drawing,
 * and floats as vectors. Instances shrink: zero bits make the simplest. */
#ifndef RANDOM_INPUTS_H
#define RANDOM_INPUTS_H

#include <gnomon.h>

#include "properties.h"

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

/* Types of arguments. Transforms are struct made: one of the chosen kinds, of numbers that its
 * constructor accepts. Floats are FLOATS floats, of any bit pattern or with the chosen exponents.
 * Seeds are of type uint64_t; they do not shrink. */
#define TRANSFORMS(from, end, most)                                                                \
    INSTANCES(make_transform, print_transform, (&(struct choice){from, end, most}))
#define FLOATS_WITHIN(most) INSTANCES(make_floats, print_floats, (&(struct choice){0, 0, most}))
#define ANY_FLOATS INSTANCES(make_floats, print_floats, NULL)
#define SEEDS                                                                                      \
    (&(const struct theft_type_info){                                                              \
        .alloc = make_seed, .free = theft_generic_free_cb, .print = print_seed})

theft_alloc_cb make_transform, make_floats, make_seed;
theft_print_cb print_transform, print_floats, print_seed;

/* Zeroed memory; ends the program if there is none. */
void *allocated(size_t size);

/* A number with a magnitude of 2^-exponents to 2^exponents. */
float random_number(struct theft *t, int exponents);

/* Whether the bits are equal, or both numbers are NaN. */
bool same_floats(const float *a, const float *b, size_t count);

/* Whether all numbers are equal. */
static inline bool same_numbers(const float *a, const float *b, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (a[i] != b[i])
            return false;
    return true;
}

bool all_finite(const float *a, size_t count);

static inline gn_vec2 vec2_of(const float *f)
{
    return (gn_vec2){f[0], f[1]};
}

static inline gn_vec3 vec3_of(const float *f)
{
    return (gn_vec3){f[0], f[1], f[2]};
}

static inline gn_vec4 vec4_of(const float *f)
{
    return (gn_vec4){f[0], f[1], f[2], f[3]};
}

static inline gn_quat quat_of(const float *f)
{
    return (gn_quat){f[0], f[1], f[2], f[3]};
}

#endif
