/* Numbers, vectors and matrices beside what a test expects of them. */
#ifndef UNIT_NEAR_H
#define UNIT_NEAR_H

#include <math.h>

#include "unit.h"

/* Equal numbers, or numbers not farther apart than the tolerance, or NaN and NaN. */
static inline void assert_near(const float *got, const float *expected, int count, float tolerance)
{
    for (int i = 0; i < count; ++i)
        if (!(got[i] == expected[i] || fabsf(got[i] - expected[i]) <= tolerance ||
              (isnan(got[i]) && isnan(expected[i]))))
            fail_msg("number %d of %d: %a, should be %a", i, count, (double)got[i],
                     (double)expected[i]);
}

static inline void assert_vec3(gn_vec3 got, float x, float y, float z, float tolerance)
{
    assert_near(&got.x, (const float[]){x, y, z}, 3, tolerance);
}

static inline void assert_mat3(const gn_mat3 *got, const gn_mat3 *expected, float tolerance)
{
    assert_near(got->m[0], expected->m[0], 9, tolerance);
}

static inline void assert_mat4(const gn_mat4 *got, const gn_mat4 *expected, float tolerance)
{
    assert_near(got->m[0], expected->m[0], 16, tolerance);
}

/* The point goes to another, and back. */
static inline void assert_moves(const gn_transform *transform, gn_vec3 from, gn_vec3 to,
                                float tolerance)
{
    const gn_vec3 moved = gn_mat4_transform_point(&transform->matrix, from);

    assert_vec3(moved, to.x, to.y, to.z, tolerance);
    assert_vec3(gn_mat4_transform_point(&transform->inverse, moved), from.x, from.y, from.z,
                tolerance);
}

/* The matrix of the transform and its inverse are each other's inverses. */
static inline void assert_inverses(const gn_transform *transform, float tolerance)
{
    gn_mat4 one, product;

    gn_mat4_identity(&one);
    gn_mat4_multiply(&transform->matrix, &transform->inverse, &product);
    assert_mat4(&product, &one, tolerance);
    gn_mat4_multiply(&transform->inverse, &transform->matrix, &product);
    assert_mat4(&product, &one, tolerance);
}

#endif
