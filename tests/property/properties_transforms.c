/* Properties of transforms: a matrix and its inverse, as constructors make them and as composition
 * keeps them. Bounds are those of transform.h; products of the stored floats are computed in
 * double. */
#include <math.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "random_inputs.h"

/* The bound on |E| in the constructor's contract. `inverse_first` selects E = inverse * matrix -
 * identity. */
static matrix stated_bound(const struct made *made, bool inverse_first)
{
    matrix bound = {{{0}}}, m = magnitudes(widened(&made->transform.matrix));
    matrix inverse = magnitudes(widened(&made->transform.inverse));
    const float *n = made->numbers;
    double eye = fabs((double)n[0]) + fabs((double)n[1]) + fabs((double)n[2]);
    switch (made->kind) {
    case TRANSLATE:
        return bound;
    case ROTATE_X:
    case ROTATE_Y:
    case ROTATE_Z:
        return scaled(2.0 * U, identity());
    case ROTATE_AXIS:
    case LOOK_AT:
        for (int i = 0; i < 9; ++i)
            bound.m[i / 3][i % 3] = (made->kind == LOOK_AT ? 17.0 : i % 4 == 0 ? 46.0 : 31.0) * U;
        for (int row = 0; row < 3 && made->kind == LOOK_AT; ++row)
            bound.m[3][row] = 23.0 * U * eye;
        return bound;
    default:
        return scaled(U, inverse_first ? product(inverse, m) : product(m, inverse));
    }
}

static matrix error_of(const gn_transform *transform, bool inverse_first)
{
    matrix m = widened(&transform->matrix), inverse = widened(&transform->inverse);
    return lack(inverse_first ? inverse : m, inverse_first ? m : inverse);
}

/* Both products are the identity within the bound. For rotations the inverse is the transpose; so
 * turned vectors keep their lengths. */
static enum theft_trial_res inverse_is_inverse(struct theft *t, void *arg)
{
    const struct made *made = arg;
    gn_mat4 turned_back;
    (void)t;
    gn_mat4_transpose(&made->transform.matrix, &turned_back);
    if (made->kind >= ROTATE_X && made->kind <= ROTATE_AXIS &&
        !same_numbers(turned_back.m[0], made->transform.inverse.m[0], 16))
        return THEFT_TRIAL_FAIL;
    for (int order = 0; order < 2; ++order)
        if (!within(error_of(&made->transform, order == 1), stated_bound(made, order == 1)))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

/* Both matrices are multiplied, to the bit. So composition is as associative as products are, and
 * its error is within the bound that follows from theirs. Inversion exchanges them. */
static enum theft_trial_res composition_multiplies(struct theft *t, void *arg1, void *arg2)
{
    const gn_transform *a = &((struct made *)arg1)->transform;
    const gn_transform *b = &((struct made *)arg2)->transform;
    gn_transform both, expected, inverted;
    (void)t;
    gn_mat4_multiply(&a->matrix, &b->matrix, &expected.matrix);
    gn_mat4_multiply(&b->inverse, &a->inverse, &expected.inverse);
    return verdict(gn_transform_compose(a, b, &both) == GN_OK &&
                   memcmp(&both, &expected, sizeof both) == 0 &&
                   gn_transform_invert(&both, &inverted) == GN_OK &&
                   memcmp(&inverted.matrix, &both.inverse, sizeof inverted.matrix) == 0 &&
                   memcmp(&inverted.inverse, &both.matrix, sizeof inverted.matrix) == 0);
}

/* R^T and 0 - R^T t, to the bit, so that the bounds are those of a product with a vector; for a
 * rotation that gets the numbers of another transform as its translation. */
static enum theft_trial_res rigid_inverse_is_transposed(struct theft *t, void *arg1, void *arg2)
{
    gn_mat4 m = ((struct made *)arg1)->transform.matrix, expected, inverse;
    const float *offset = ((struct made *)arg2)->numbers;
    gn_mat3 turned;
    (void)t;
    gn_mat4_transpose(&m, &expected);
    gn_mat4_upper_left(&expected, &turned);
    const gn_vec3 back = gn_mat3_multiply_vec3(&turned, vec3_of(offset));
    for (int i = 0; i < 3; ++i) {
        m.m[3][i] = offset[i];
        expected.m[3][i] = 0.0f - (&back.x)[i];
    }
    gn_mat4_invert_rigid(&m, &inverse);
    return verdict(same_floats(inverse.m[0], expected.m[0], 16));
}

/* The transposed inverse to the bit; so moved normals are perpendicular to moved tangents. */
static enum theft_trial_res normals_take_the_inverse(struct theft *t, void *arg)
{
    const gn_transform *transform = &((struct made *)arg)->transform;
    gn_mat3 normals, inverse;
    (void)t;
    if (gn_transform_normal_matrix(transform, &normals) != GN_OK)
        return THEFT_TRIAL_FAIL;
    gn_mat3_transpose(&normals, &normals);
    gn_mat4_upper_left(&transform->inverse, &inverse);
    return verdict(memcmp(&normals, &inverse, sizeof normals) == 0);
}

#define ANY_TRANSFORMS TRANSFORMS(0, KINDS, 8)
#define ONE_KIND(kind, exponents) TRANSFORMS(kind, kind + 1, exponents)

static const property transforms[] = {
    PROPERTY1("translate: inverse", inverse_is_inverse, ONE_KIND(TRANSLATE, 60)),
    PROPERTY1("scale: inverse", inverse_is_inverse, ONE_KIND(SCALE, 60)),
    PROPERTY1("rotate x: inverse", inverse_is_inverse, ONE_KIND(ROTATE_X, 100)),
    PROPERTY1("rotate y: inverse", inverse_is_inverse, ONE_KIND(ROTATE_Y, 100)),
    PROPERTY1("rotate z: inverse", inverse_is_inverse, ONE_KIND(ROTATE_Z, 100)),
    PROPERTY1("rotate axis: inverse", inverse_is_inverse, ONE_KIND(ROTATE_AXIS, 60)),
    PROPERTY1("look at: inverse", inverse_is_inverse, ONE_KIND(LOOK_AT, 60)),
    PROPERTY2("compose: products", composition_multiplies, ANY_TRANSFORMS, ANY_TRANSFORMS),
    PROPERTY2("rigid inverse: transposed", rigid_inverse_is_transposed,
              TRANSFORMS(ROTATE_X, ROTATE_AXIS + 1, 30), ANY_TRANSFORMS),
    PROPERTY1("normal matrix: transposed inverse", normals_take_the_inverse, ANY_TRANSFORMS),
};

SUITE(properties_transforms, transforms);
