/* Transforms: the effect of every constructor on a point, there and back; every status, results
 * left untouched; compositions, inverses, normal matrices, boxes; models and their decomposition.
 * test_projections.c has projections, tests/property bounds of the inverses. */
#include <float.h>

#include "near.h"
#include "untouched.h"

/* Defines the constructor of that name with its arguments taken from an array of numbers. */
#define MAKE(name, ...)                                                                            \
    static gn_status make_##name(const float *f, gn_transform *t)                                  \
    {                                                                                              \
        return gn_##name(__VA_ARGS__, t);                                                          \
    }
#define V(i) ((gn_vec3){f[i], f[(i) + 1], f[(i) + 2]})

MAKE(translate, V(0))
MAKE(scale, V(0))
MAKE(rotate_x, f[0])
MAKE(rotate_y, f[0])
MAKE(rotate_z, f[0])
MAKE(rotate_axis, V(0), f[3])
MAKE(look_at_rh, V(0), V(3), V(6))
MAKE(look_at_lh, V(0), V(3), V(6))
MAKE(look_to_rh, V(0), V(3), V(6))
MAKE(look_to_lh, V(0), V(3), V(6))
MAKE(frame_orthonormal, V(0), V(3), V(6), V(9))
MAKE(frame_general, V(0), V(3), V(6), V(9))
MAKE(affine, (const gn_mat3 *)f, V(9))
MAKE(trs, V(12), (const gn_mat3 *)f, V(9)) /* the rotation, the scale, the translation */

typedef gn_status maker(const float *, gn_transform *);

#define HALF_ROOT 0.70710678118654752440f

static const struct made {
    maker *make;
    int count;
    float numbers[15];
    gn_vec3 from, to;
    float tolerance;
} made[] = {
    {make_translate, 3, {1, -2, 3.5f}, {4, 5, 6}, {5, 3, 9.5f}, 0},
    {make_scale, 3, {2, -4, 0.5f}, {4, 5, 6}, {8, -20, 3}, 0},
    {make_scale, 3, {0x1p-126f, -0x1p126f, 1}, {1, 1, 6}, {0x1p-126f, -0x1p126f, 6}, 0},
    /* Right-handed quarter turns; a third of a turn about the diagonal; half turns about axes that
     * are very short and very long. */
    {make_rotate_x, 1, {0.5f * GN_PI}, {1, 2, 0}, {1, 0, 2}, 1e-6f},
    {make_rotate_y, 1, {0.5f * GN_PI}, {0, 1, 2}, {2, 1, 0}, 1e-6f},
    {make_rotate_z, 1, {0.5f * GN_PI}, {2, 0, 1}, {0, 2, 1}, 1e-6f},
    {make_rotate_axis, 4, {1, 1, 1, 2 * GN_PI / 3}, {1, 2, 3}, {3, 1, 2}, 1e-6f},
    {make_rotate_axis, 4, {0, 0, 1e-30f, 0.5f * GN_PI}, {2, 0, 1}, {0, 2, 1}, 1e-6f},
    {make_rotate_axis, 4, {1e-45f, 0, 1e-45f, GN_PI}, {1, 2, 3}, {3, -2, 1}, 1e-6f},
    {make_rotate_axis, 4, {3e38f, -3e38f, 0, GN_PI}, {1, 2, 3}, {-2, -1, -3}, 1e-6f},
    /* The direction ahead of a camera becomes -z or +z, the direction to its right +x. For a camera
     * that looks along x with y up, the right is +z in a right-handed world and -z in a left-handed
     * one. A camera that already is at the origin gives the identity. */
    {make_look_at_rh, 9, {1, 2, 3, 5, 2, 3, 0, 3, 0}, {8, 4, 2}, {-1, 2, -7}, 0},
    {make_look_to_rh, 9, {1, 2, 3, 2, 0, 0, 0, 3, 0}, {8, 4, 2}, {-1, 2, -7}, 0},
    {make_look_at_lh, 9, {1, 2, 3, 5, 2, 3, 0, 3, 0}, {8, 4, 2}, {1, 2, 7}, 0},
    {make_look_to_lh, 9, {1, 2, 3, 2, 0, 0, 0, 3, 0}, {8, 4, 2}, {1, 2, 7}, 0},
    {make_look_at_rh, 9, {0, 0, 0, 0, 0, -1, 0, 1, 0}, {1, 2, 3}, {1, 2, 3}, 0},
    {make_look_to_lh, 9, {0, 0, 0, 0, 0, 1, 0, 1, 0}, {1, 2, 3}, {1, 2, 3}, 0},
    /* A frame at (1, 2, 3) whose x axis is the world's y axis, and so on; the last left-handed. */
    {make_frame_orthonormal, 12, {0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 2, 3}, {5, 6, 7}, {8, 7, 9}, 0},
    {make_frame_orthonormal, 12, {0, 1, 0, -1, 0, 0, 0, 0, 1, 1, 2, 3}, {5, 6, 7}, {-5, 7, 10}, 0},
    {make_frame_orthonormal, 12, {0, 1, 0, 1, 0, 0, 0, 0, 1, 1, 2, 3}, {5, 6, 7}, {7, 7, 10}, 0},
    {make_frame_orthonormal,
     12,
     {1.000005f, 1e-5f, 0, 0, 1, 0, 0, 0, 1, 1, 2, 3},
     {5, 6, 7},
     {6, 8, 10},
     2e-4f},
    {make_frame_general, 12, {1, 0, 0, 2, 1, 0, 3, 4, 2, 1, 2, 3}, {5, 6, 7}, {39, 36, 17}, 0},
    {make_affine, 12, {1, 0, 0, 2, 1, 0, 3, 4, 2, 1, 2, 3}, {5, 6, 7}, {39, 36, 17}, 0},
    /* Scaled, then turned by a quarter about z, then moved: (2, 3, 4), (-3, 2, 4), (-2, 4, 7). */
    {make_trs, 15, {0, 1, 0, -1, 0, 0, 0, 0, 1, 2, 3, 4, 1, 2, 3}, {1, 1, 1}, {-2, 4, 7}, 1e-6f},
    {make_trs, 15, {0, 1, 0, -1, 0, 0, 0, 0, 1, 2, -3, 4, 1, 2, 3}, {1, 1, 1}, {4, 4, 7}, 1e-6f},
};

/* Every number that is not finite is refused, and so is a result that is null. */
static void constructors(void **state)
{
    static const float bad[3] = {NAN, INFINITY, -INFINITY};
    gn_transform t;

    for (size_t i = 0; i < COUNT(made); ++i) {
        assert_int_equal(made[i].make(made[i].numbers, &t), GN_OK);
        assert_moves(&t, made[i].from, made[i].to, made[i].tolerance);
        for (int k = 0; k < 3; ++k) { /* no negative zero in translations */
            assert_false(t.matrix.m[3][k] == 0 && signbit(t.matrix.m[3][k]));
            assert_false(t.inverse.m[3][k] == 0 && signbit(t.inverse.m[3][k]));
        }
        assert_int_equal(made[i].make(made[i].numbers, NULL), GN_NULL_POINTER);
        mark(t);
        for (int k = 0; k < 3 * made[i].count; ++k) {
            float numbers[15];
            memcpy(numbers, made[i].numbers, sizeof numbers);
            numbers[k / 3] = bad[k % 3];
            assert_int_equal(made[i].make(numbers, &t), GN_NOT_FINITE);
        }
        assert_untouched(t);
    }
    assert_int_equal(gn_affine(NULL, (gn_vec3){0, 0, 0}, &t), GN_NULL_POINTER);
    assert_int_equal(gn_trs((gn_vec3){0, 0, 0}, NULL, (gn_vec3){1, 1, 1}, &t), GN_NULL_POINTER);
    assert_untouched(t);
    assert_int_equal(gn_transform_identity(NULL), GN_NULL_POINTER);
    assert_int_equal(gn_transform_identity(&t), GN_OK);
    assert_moves(&t, (gn_vec3){1, 2, 3}, (gn_vec3){1, 2, 3}, 0);
    assert_inverses(&t, 0);
}

#define BIG FLT_MAX

static void what_cannot_be(void **state)
{
    static const struct {
        maker *make;
        gn_status status;
        float numbers[15];
    } cases[] = {
        {make_scale, GN_SINGULAR, {0, 1, 1}},
        {make_scale, GN_SINGULAR, {1, -0.0f, 1}},
        {make_scale, GN_SINGULAR, {1, 1, 0}},
        {make_scale, GN_OUT_OF_RANGE, {1, 0x1p-127f, 1}},
        {make_scale, GN_OUT_OF_RANGE, {-0x1.000002p126f, 1, 1}},
        {make_rotate_axis, GN_DEGENERATE, {0, -0.0f, 0, 1}},
        /* No direction; up is zero, along it, against it, or nearly; numbers too far apart. */
        {make_look_at_rh, GN_DEGENERATE, {1, 2, 3, 1, 2, 3, 0, 1, 0}},
        {make_look_at_rh, GN_DEGENERATE, {1, 2, 3, 2, 4, 6, 0, 0, 0}},
        {make_look_at_rh, GN_DEGENERATE, {1, 2, 3, 2, 4, 6, 1, 2, 3}},
        {make_look_at_rh, GN_DEGENERATE, {1, 2, 3, 2, 4, 6, -0.5f, -1, -1.5f}},
        {make_look_at_rh, GN_DEGENERATE, {1, 2, 3, 2, 4, 6, 1, 2, 3.000001f}},
        {make_look_at_rh, GN_OUT_OF_RANGE, {-BIG, 0, 0, BIG, 0, 0, 0, 1, 0}},
        {make_look_at_rh, GN_OUT_OF_RANGE, {BIG, BIG, BIG, 3e38f, 3e38f, 3e38f, 0, 1, 0}},
        {make_look_at_lh, GN_DEGENERATE, {1, 2, 3, 1, 2, 3, 0, 1, 0}},
        {make_look_at_lh, GN_DEGENERATE, {1, 2, 3, 2, 4, 6, -0.5f, -1, -1.5f}},
        {make_look_at_lh, GN_OUT_OF_RANGE, {-BIG, 0, 0, BIG, 0, 0, 0, 1, 0}},
        {make_look_to_rh, GN_DEGENERATE, {1, 2, 3, 0, 0, 0, 0, 1, 0}},
        {make_look_to_rh, GN_DEGENERATE, {1, 2, 3, 0, 1, 0, 0, 0, 0}},
        {make_look_to_rh, GN_OUT_OF_RANGE, {BIG, BIG, BIG, -1, -1, -1, 0, 1, 0}},
        {make_look_to_lh, GN_DEGENERATE, {1, 2, 3, 0, 0, 0, 0, 1, 0}},
        {make_look_to_lh, GN_DEGENERATE, {0, 0, 0, 1, 2, 3, -0.5f, -1, -1.5f}},
        {make_look_to_lh, GN_OUT_OF_RANGE, {BIG, BIG, BIG, -1, -1, -1, 0, 1, 0}},
        /* Each axis too long, and not perpendicular to each other one. */
        {make_frame_orthonormal, GN_OUT_OF_RANGE, {1.00001f, 0, 0, 0, 1, 0, 0, 0, 1}},
        {make_frame_orthonormal, GN_OUT_OF_RANGE, {0, 1, 0, 1.00001f, 0, 0, 0, 0, 1}},
        {make_frame_orthonormal, GN_OUT_OF_RANGE, {0, 1, 0, 0, 0, 1, 1.00001f, 0, 0}},
        {make_frame_orthonormal, GN_OUT_OF_RANGE, {1, 2e-5f, 0, 0, 1, 0, 0, 0, 1}},
        {make_frame_orthonormal, GN_OUT_OF_RANGE, {0, 0, 1, 0, 1, 0, 1, 2e-5f, 0}},
        {make_frame_orthonormal, GN_OUT_OF_RANGE, {0, 1, 0, 0, 0, 1, 1, 2e-5f, 0}},
        {make_frame_orthonormal, GN_OUT_OF_RANGE, {1, 0, 0, 1, 0, 0, 0, 0, 1}},
        {make_frame_orthonormal, GN_OUT_OF_RANGE, {BIG, BIG, BIG, 0, 1, 0, 0, 0, 1}},
        {make_frame_orthonormal,
         GN_OUT_OF_RANGE,
         {HALF_ROOT, HALF_ROOT, 0, -HALF_ROOT, HALF_ROOT, 0, 0, 0, 1, BIG, BIG, BIG}},
        {make_frame_general, GN_SINGULAR, {1, 0, 0, 2, 1, 0, 3, 1, 0, 1, 2, 3}},
        {make_frame_general, GN_SINGULAR, {1, 0, 0, 0, 0, 0, 3, 4, 2, 1, 2, 3}},
        {make_affine, GN_SINGULAR, {1, 0, 0, 2, 1, 0, 0, 0, 0, 1, 2, 3}},
        {make_trs, GN_OUT_OF_RANGE, {0, 1.0001f, 0, -1, 0, 0, 0, 0, 1, 2, 3, 4, 1, 2, 3}},
        {make_trs,
         GN_OUT_OF_RANGE,
         {0, 1, 0, -1, 0, 0, 0, 0, 1, 0.1f, 0.1f, 0.1f, 3e38f, 3e38f, 3e38f}},
    };
    gn_transform t;

    mark(t);
    for (size_t i = 0; i < COUNT(cases); ++i)
        if (cases[i].make(cases[i].numbers, &t) != cases[i].status)
            fail_msg("case %zu", i);
    /* Each number of a model's scale and rotation decides alone. */
    for (int n = 0; n < 12; ++n) {
        float numbers[15] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 3, 4, 1, 2, 3};
        numbers[n] = n < 9 ? 0.5f : 0x1p-140f;
        assert_int_equal(make_trs(numbers, &t), GN_OUT_OF_RANGE);
        numbers[n] = -0.0f;
        assert_int_equal(n < 9 ? GN_SINGULAR : make_trs(numbers, &t), GN_SINGULAR);
    }
    assert_untouched(t);
}

/* Just beyond the threshold, a camera that looks almost straight down still has a rotation. */
static void camera_almost_along_up(void **state)
{
    for (float slope = 0x1p-19f; slope < 1.0f; slope *= 2.0f) {
        const float numbers[9] = {0.3f, 7, -0.2f, 0.3f, -5, -0.2f, slope, 1, -0.7f * slope};
        gn_transform t;
        assert_int_equal(make_look_at_rh(numbers, &t), GN_OK);
        assert_inverses(&t, 4e-6f);
    }
}

/* The right operand comes first; the result may be an operand. */
static void composition(void **state)
{
    const gn_vec3 point = {1, 1, 1};
    gn_transform move, grow, both, left, right;

    assert_int_equal(gn_translate((gn_vec3){1, 2, 3}, &move), GN_OK);
    assert_int_equal(gn_scale((gn_vec3){2, 2, 2}, &grow), GN_OK);
    assert_int_equal(gn_transform_compose(&move, &grow, &both), GN_OK);
    assert_moves(&both, point, (gn_vec3){3, 4, 5}, 0);
    assert_int_equal(gn_transform_compose(&grow, &move, &both), GN_OK);
    assert_moves(&both, point, (gn_vec3){4, 6, 8}, 0);
    left = grow;
    right = move;
    assert_int_equal(gn_transform_compose(&left, &move, &left), GN_OK);
    assert_int_equal(gn_transform_compose(&grow, &right, &right), GN_OK);
    assert_memory_equal(&left, &both, sizeof both);
    assert_memory_equal(&right, &both, sizeof both);
}

/* Each entry of the four matrices decides alone. Overflow of the matrix, and of the inverse. */
static void compositions_that_cannot_be(void **state)
{
    gn_transform good, large, tiny, result;

    assert_int_equal(gn_transform_identity(&good), GN_OK);
    assert_int_equal(gn_scale((gn_vec3){0x1p70f, 1, 1}, &large), GN_OK);
    assert_int_equal(gn_scale((gn_vec3){1, 0x1p-70f, 1}, &tiny), GN_OK);
    mark(result);
    for (int n = 0; n < 64; ++n) {
        gn_transform bad[2] = {good, good};
        gn_mat4 *const m = n % 2 ? &bad[n % 4 / 2].inverse : &bad[n % 4 / 2].matrix;
        m->m[n / 16][n / 4 % 4] = n % 8 < 4 ? NAN : INFINITY;
        assert_int_equal(gn_transform_compose(&bad[0], &bad[1], &result), GN_NOT_FINITE);
    }
    assert_int_equal(gn_transform_compose(&large, &large, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_transform_compose(&tiny, &tiny, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_transform_compose(NULL, &good, &result), GN_NULL_POINTER);
    assert_int_equal(gn_transform_compose(&good, NULL, &result), GN_NULL_POINTER);
    assert_int_equal(gn_transform_compose(&good, &good, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_transform_invert(NULL, &result), GN_NULL_POINTER);
    assert_int_equal(gn_transform_invert(&good, NULL), GN_NULL_POINTER);
    assert_untouched(result);
}

/* Of an inverse, and of normals: perpendicular to a slope that is scaled with them; a rotation
 * turns them as it turns other vectors. */
static void inverses_and_normals(void **state)
{
    const gn_vec3 slope = {1, 1, 0}, normal = {1, -1, 0};
    gn_transform grow, turn, inverted;
    gn_mat3 normals, part;

    assert_int_equal(gn_rotate_axis((gn_vec3){1, 2, 3}, 0.7f, &turn), GN_OK);
    assert_int_equal(gn_transform_invert(&turn, &inverted), GN_OK);
    assert_memory_equal(&inverted.matrix, &turn.inverse, sizeof(gn_mat4));
    assert_memory_equal(&inverted.inverse, &turn.matrix, sizeof(gn_mat4));
    assert_int_equal(gn_transform_invert(&inverted, &inverted), GN_OK);
    assert_memory_equal(&inverted, &turn, sizeof turn);

    assert_int_equal(gn_scale((gn_vec3){1, 4, 1}, &grow), GN_OK);
    assert_int_equal(gn_transform_normal_matrix(&grow, &normals), GN_OK);
    const gn_vec3 moved = gn_mat3_multiply_vec3(&normals, normal);
    assert_vec3(moved, 1, -0.25f, 0, 0);
    assert_true(gn_vec3_dot(moved, gn_mat4_transform_direction(&grow.matrix, slope)) == 0);
    assert_int_equal(gn_transform_normal_matrix(&turn, &normals), GN_OK);
    gn_mat4_upper_left(&turn.matrix, &part);
    assert_memory_equal(&normals, &part, sizeof part);
    mark(normals);
    assert_int_equal(gn_transform_normal_matrix(NULL, &normals), GN_NULL_POINTER);
    assert_int_equal(gn_transform_normal_matrix(&turn, NULL), GN_NULL_POINTER);
    assert_untouched(normals);
}

/* The lower or the upper bound overflows in each coordinate, or only the margin for rounding; or
 * the box is empty. */
static void boxes_that_cannot_be(void **state)
{
    const gn_box box = {{-1, -2, -3}, {1, 2, 3}};
    gn_box result;
    gn_mat4 m;

    mark(result);
    for (int i = 0; i < 12; ++i) {
        const int row = i % 3;

        gn_mat4_identity(&m);
        m.m[3][row] = i < 6 ? FLT_MAX : -FLT_MAX;
        m.m[row][row] = i % 6 < 3 ? 0x1p125f : 0;
        assert_int_equal(gn_mat4_transform_box(&m, &box, &result), GN_OUT_OF_RANGE);
        gn_box empty = box;
        (&empty.min.x)[row] = 4;
        gn_mat4_identity(&m);
        assert_int_not_equal(gn_mat4_transform_box(&m, &empty, &result), GN_OK);
    }
    assert_untouched(result);
}

/* Whatever axis was mirrored, and if the rotation has the determinant -1 (the last case), scale.x
 * and the first column have the reflection. */
static void decomposition(void **state)
{
    static const struct {
        float scale[3];
        gn_mat3 rotation;
        float scale_x;
        gn_mat3 expected;
    } cases[] = {
        {{2, 3, 4}, {{{0, 1}, {-1}, {0, 0, 1}}}, 2, {{{0, 1}, {-1}, {0, 0, 1}}}},
        {{-2, 3, 4}, {{{0, 1}, {-1}, {0, 0, 1}}}, -2, {{{0, 1}, {-1}, {0, 0, 1}}}},
        {{2, -3, 4}, {{{0, 1}, {-1}, {0, 0, 1}}}, -2, {{{0, -1}, {1}, {0, 0, 1}}}},
        {{-2, -3, -4}, {{{0, 1}, {-1}, {0, 0, 1}}}, -2, {{{0, 1}, {1}, {0, 0, -1}}}},
        {{2, 3, 4}, {{{0, 1}, {1}, {0, 0, 1}}}, -2, {{{0, -1}, {1}, {0, 0, 1}}}},
    };
    const gn_vec3 offset = {1, 2, 3};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const float *const s = cases[i].scale;
        gn_transform t, again;
        gn_vec3 translation, scale;
        gn_mat3 rotation;
        assert_int_equal(gn_trs(offset, &cases[i].rotation, (gn_vec3){s[0], s[1], s[2]}, &t),
                         GN_OK);
        assert_int_equal(gn_mat4_decompose_trs(&t.matrix, &translation, &rotation, &scale), GN_OK);
        assert_vec3(translation, 1, 2, 3, 0);
        assert_vec3(scale, cases[i].scale_x, 3, 4, 0);
        assert_mat3(&rotation, &cases[i].expected, 0);
        assert_int_equal(gn_trs(translation, &rotation, scale, &again), GN_OK);
        assert_mat4(&again.matrix, &t.matrix, 0);
    }
}

static const gn_mat4 model = {{{0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 4, 0}, {1, 2, 3, 1}}};

/* The model with one number changed. */
static void decompose(int column, int row, float number, gn_status status)
{
    gn_vec3 translation, scale;
    gn_mat3 rotation;
    gn_mat4 m = model;

    m.m[column][row] = number;
    mark(translation);
    mark(scale);
    mark(rotation);
    assert_int_equal(gn_mat4_decompose_trs(&m, &translation, &rotation, &scale), status);
    if (status != GN_OK) {
        assert_untouched(translation);
        assert_untouched(scale);
        assert_untouched(rotation);
    }
}

/* Sheared by more than 2^-16 and by less. */
static void what_is_no_model(void **state)
{
    static const int places[3][2] = {{0, 1}, {1, 0}, {2, 2}};
    static const float lengths[3] = {2, -3, 4};
    gn_vec3 v;
    gn_mat3 m;

    for (int i = 0; i < 16; ++i)
        decompose(i / 4, i % 4, i % 3 ? NAN : INFINITY, GN_NOT_FINITE);
    for (int i = 0; i < 4; ++i)
        decompose(i, 3, 0.5f, GN_OUT_OF_RANGE);
    for (int i = 0; i < 3; ++i) {
        const int *const own = places[i], *const next = places[(i + 1) % 3];
        decompose(own[0], own[1], 0, GN_SINGULAR);
        decompose(own[0], own[1], 1e-39f, GN_OUT_OF_RANGE);
        decompose(own[0], next[1], 1.6e-5f * lengths[i], GN_OUT_OF_RANGE);
        decompose(own[0], next[1], 1.4e-5f * lengths[i], GN_OK);
    }
    assert_int_equal(gn_mat4_decompose_trs(NULL, &v, &m, &v), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_decompose_trs(&model, NULL, &m, &v), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_decompose_trs(&model, &v, NULL, &v), GN_NULL_POINTER);
    assert_int_equal(gn_mat4_decompose_trs(&model, &v, &m, NULL), GN_NULL_POINTER);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constructors),
        cmocka_unit_test(what_cannot_be),
        cmocka_unit_test(camera_almost_along_up),
        cmocka_unit_test(composition),
        cmocka_unit_test(compositions_that_cannot_be),
        cmocka_unit_test(inverses_and_normals),
        cmocka_unit_test(boxes_that_cannot_be),
        cmocka_unit_test(decomposition),
        cmocka_unit_test(what_is_no_model),
    };
    return cmocka_run_group_tests_name("transforms", tests, NULL, NULL);
}
