/* Quaternions: products and rotations worked by hand, all rotations of a cube, half turns, opposite
 * directions, every status. cglm is a second source for matrices, products and slerp.
 * tests/property tests error bounds. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "unit.h"

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#define HALF_ROOT 0.70710678118654752440f

static const gn_quat p = {1, 2, 3, 4}, q = {5, 6, 7, 8}, zero = {0, -0.0f, 0, 0};
static const gn_quat bad[4] = {
    {NAN, 0, 0, 1}, {0, INFINITY, 0, 1}, {0, 0, -INFINITY, 1}, {0, 0, 0, NAN}};
static const gn_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};

static void assert_quat(gn_quat got, float qx, float qy, float qz, float qw, float tolerance)
{
    assert_float_equal(got.x, qx, tolerance);
    assert_float_equal(got.y, qy, tolerance);
    assert_float_equal(got.z, qz, tolerance);
    assert_float_equal(got.w, qw, tolerance);
}

static void assert_vec3(gn_vec3 got, float vx, float vy, float vz)
{
    assert_float_equal(got.x, vx, 1e-6f);
    assert_float_equal(got.y, vy, 1e-6f);
    assert_float_equal(got.z, vz, 1e-6f);
}

static gn_quat marked(void)
{
    const gn_quat mark = {11, 12, 13, 14};
    return mark;
}

static void assert_untouched(gn_quat got)
{
    assert_quat(got, 11, 12, 13, 14, 0.0f);
}

static void units_multiply_as_hamilton_says(void **state)
{
    (void)state;
    const gn_quat i = {1, 0, 0, 0}, j = {0, 1, 0, 0}, k = {0, 0, 1, 0};
    const gn_quat one = gn_quat_identity();
    assert_quat(one, 0, 0, 0, 1, 0.0f);
    assert_quat(gn_quat_multiply(i, i), 0, 0, 0, -1, 0.0f);
    assert_quat(gn_quat_multiply(j, j), 0, 0, 0, -1, 0.0f);
    assert_quat(gn_quat_multiply(k, k), 0, 0, 0, -1, 0.0f);
    assert_quat(gn_quat_multiply(i, j), 0, 0, 1, 0, 0.0f);
    assert_quat(gn_quat_multiply(j, i), 0, 0, -1, 0, 0.0f);
    assert_quat(gn_quat_multiply(j, k), 1, 0, 0, 0, 0.0f);
    assert_quat(gn_quat_multiply(k, i), 0, 1, 0, 0, 0.0f);
    assert_quat(gn_quat_multiply(p, one), 1, 2, 3, 4, 0.0f);
    assert_quat(gn_quat_multiply(one, p), 1, 2, 3, 4, 0.0f);
    assert_quat(gn_quat_multiply(p, q), 24, 48, 48, -6, 0.0f);
    assert_quat(gn_quat_multiply(q, p), 32, 32, 56, -6, 0.0f);
    assert_true(gn_quat_dot(p, q) == 5 + 12 + 21 + 32);
    assert_quat(gn_quat_conjugate(p), -1, -2, -3, 4, 0.0f);

    versor a = {1, 2, 3, 4}, b = {5, 6, 7, 8}, theirs;
    glm_quat_mul(a, b, theirs);
    assert_quat(gn_quat_multiply(p, q), theirs[0], theirs[1], theirs[2], theirs[3], 0.0f);
}

/* Every pair of exponents: conjugate(q) / |q|^2 within 9 u of each component, or within 2^-146
 * below the normal floats. */
static void inverses_of_unlike_components(void **state)
{
    (void)state;
    for (int e = -126; e <= 127; ++e) {
        for (int f = -149; f <= e; ++f) {
            const float large = ldexpf(1.28741455f, e), small = ldexpf(-1.06158471f, f);
            const double square = (double)small * (double)small + (double)large * (double)large;
            const double exact[2] = {-(double)small / square, -(double)large / square};
            gn_quat back;
            const gn_status status = gn_quat_invert((gn_quat){small, large, 0.0f, 0.0f}, &back);
            if (status == GN_OUT_OF_RANGE) {
                assert_true(sqrt(square) > (double)FLT_MAX || fabs(exact[1]) > (double)FLT_MAX);
                continue;
            }
            assert_int_equal(status, GN_OK);
            const double got[2] = {(double)back.x, (double)back.y};
            for (int i = 0; i < 2; ++i)
                assert_true(fabs(got[i] - exact[i]) <=
                            fmax(9 * 0x1p-24 * fabs(exact[i]), 0x1p-146));
        }
    }
}

static void inverses(void **state)
{
    (void)state;
    const gn_quat two = {0, 0, 0, 2}, four = {1, -1, 1, 1}, tiny = {0, 0, 0x1p-129f, 0};
    const gn_quat huge = {FLT_MAX, FLT_MAX, 0, 0}, small = {0x1p-100f, 0, 0, 0};
    gn_quat result = marked();
    for (int i = 0; i < 4; ++i)
        assert_int_equal(gn_quat_invert(bad[i], &result), GN_NOT_FINITE);
    assert_int_equal(gn_quat_invert(zero, &result), GN_DEGENERATE);
    assert_int_equal(gn_quat_invert(tiny, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_quat_invert(huge, &result), GN_OUT_OF_RANGE);
    assert_untouched(result);
    assert_int_equal(gn_quat_invert(two, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_quat_invert(two, &result), GN_OK);
    assert_quat(result, 0, 0, 0, 0.5f, 0.0f);
    assert_int_equal(gn_quat_invert(four, &result), GN_OK);
    assert_quat(result, -0.25f, 0.25f, -0.25f, 0.25f, 0.0f);
    assert_int_equal(gn_quat_invert(small, &result), GN_OK);
    assert_quat(result, -0x1p100f, 0, 0, 0, 0.0f);

    for (int i = 0; i < 4; ++i)
        assert_int_equal(gn_quat_normalize(bad[i], &result), GN_NOT_FINITE);
    assert_int_equal(gn_quat_normalize(zero, &result), GN_DEGENERATE);
    assert_quat(result, -0x1p100f, 0, 0, 0, 0.0f);
    assert_int_equal(gn_quat_normalize(two, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_quat_normalize(four, &result), GN_OK);
    assert_quat(result, 0.5f, -0.5f, 0.5f, 0.5f, 0.0f);
}

static void axes_and_angles(void **state)
{
    (void)state;
    const gn_vec3 nothing = {0, 0, 0}, wrong = {0, NAN, 0}, diagonal = {2, 2, 2};
    gn_quat turn = marked();
    assert_int_equal(gn_quat_from_axis_angle(nothing, 1.0f, &turn), GN_DEGENERATE);
    assert_int_equal(gn_quat_from_axis_angle(wrong, 1.0f, &turn), GN_NOT_FINITE);
    assert_int_equal(gn_quat_from_axis_angle(x, INFINITY, &turn), GN_NOT_FINITE);
    assert_untouched(turn);
    assert_int_equal(gn_quat_from_axis_angle(x, 1.0f, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_quat_from_axis_angle(z, 0.5f * GN_PI, &turn), GN_OK);
    assert_quat(turn, 0, 0, HALF_ROOT, HALF_ROOT, 1e-7f);
    assert_vec3(gn_quat_rotate(turn, x), 0, 1, 0);
    assert_vec3(gn_quat_rotate(turn, y), -1, 0, 0);
    assert_vec3(gn_quat_rotate(turn, z), 0, 0, 1);
    /* A third of a turn about the diagonal takes x to y to z to x. */
    assert_int_equal(gn_quat_from_axis_angle(diagonal, 2.0f * GN_PI / 3.0f, &turn), GN_OK);
    assert_quat(turn, 0.5f, 0.5f, 0.5f, 0.5f, 1e-7f);
    assert_vec3(gn_quat_rotate(turn, x), 0, 1, 0);
    assert_vec3(gn_quat_rotate(turn, y), 0, 0, 1);
    assert_vec3(gn_quat_rotate(turn, z), 1, 0, 0);
}

/* The 24 rotations of a cube: whole numbers; half turns and negative traces are among them. */
static void cubes(void **state)
{
    (void)state;
    int turns = 0;
    for (int code = 0; code < 6 * 8; ++code) {
        static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                         {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
        gn_mat3 m = {{{0}}}, back;
        gn_mat4 m4;
        gn_quat turn = marked();
        for (int i = 0; i < 3; ++i)
            m.m[i][orders[code / 8][i]] = (code >> i & 1) != 0 ? -1.0f : 1.0f;
        const int negatives = (code & 1) + (code >> 1 & 1) + (code >> 2 & 1);
        if ((negatives + code / 24) % 2 != 0) { /* a reflection */
            assert_int_equal(gn_quat_from_mat3(&m, &turn), GN_OUT_OF_RANGE);
            assert_untouched(turn);
            continue;
        }
        ++turns;
        assert_int_equal(gn_quat_from_mat3(&m, &turn), GN_OK);
        assert_int_equal(gn_quat_to_mat3(turn, &back), GN_OK);
        assert_int_equal(gn_quat_to_mat4(turn, &m4), GN_OK);
        assert_true(m4.m[3][3] == 1.0f && m4.m[3][0] == 0.0f && m4.m[0][3] == 0.0f);
        for (int i = 0; i < 9; ++i) {
            assert_float_equal(back.m[i / 3][i % 3], m.m[i / 3][i % 3], 5e-7f);
            assert_true(m4.m[i / 3][i % 3] == back.m[i / 3][i % 3]);
        }
    }
    assert_int_equal(turns, 24);
}

static void matrices_that_are_no_rotations(void **state)
{
    (void)state;
    const gn_mat3 nothing = {{{0}}}, twice = {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
    const gn_mat3 shear = {{{1, 0, 0}, {0.01f, 1, 0}, {0, 0, 1}}};
    const gn_mat3 huge = {{{FLT_MAX, 0, 0}, {0, 1, 0}, {FLT_MAX, 0, -FLT_MAX}}};
    gn_mat3 one, result3;
    gn_mat4 result4;
    gn_quat result = marked();
    assert_int_equal(gn_quat_from_mat3(&nothing, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_quat_from_mat3(&twice, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_quat_from_mat3(&shear, &result), GN_OUT_OF_RANGE);
    assert_int_equal(gn_quat_from_mat3(&huge, &result), GN_OUT_OF_RANGE);
    for (int i = 0; i < 9; ++i) {
        gn_mat3_identity(&one);
        one.m[i / 3][i % 3] = i % 2 ? NAN : INFINITY;
        assert_int_equal(gn_quat_from_mat3(&one, &result), GN_NOT_FINITE);
    }
    gn_mat3_identity(&one);
    assert_int_equal(gn_quat_from_mat3(NULL, &result), GN_NULL_POINTER);
    assert_int_equal(gn_quat_from_mat3(&one, NULL), GN_NULL_POINTER);
    assert_untouched(result);
    assert_int_equal(gn_quat_from_mat3(&one, &result), GN_OK);
    assert_quat(result, 0, 0, 0, 1, 0.0f);

    result3 = twice;
    memset(&result4, 0, sizeof result4);
    assert_int_equal(gn_quat_to_mat3(zero, &result3), GN_DEGENERATE);
    assert_int_equal(gn_quat_to_mat4(zero, &result4), GN_DEGENERATE);
    for (int i = 0; i < 4; ++i) {
        assert_int_equal(gn_quat_to_mat3(bad[i], &result3), GN_NOT_FINITE);
        assert_int_equal(gn_quat_to_mat4(bad[i], &result4), GN_NOT_FINITE);
    }
    assert_memory_equal(&result3, &twice, sizeof twice);
    assert_true(result4.m[0][0] == 0.0f && result4.m[3][3] == 0.0f);
    assert_int_equal(gn_quat_to_mat3(p, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_quat_to_mat4(p, NULL), GN_NULL_POINTER);
}

/* The length of q does not change its matrix. */
static void matrices_match_cglm(void **state)
{
    (void)state;
    for (float angle = -7.0f; angle < 7.0f; angle += 0.37f) {
        const gn_vec3 axis = {1.0f, -2.0f, 0.5f};
        versor theirs;
        mat3 m;
        gn_mat3 ours;
        gn_quat turn, long_turn;
        vec3 about = {1.0f, -2.0f, 0.5f}, v = {3.0f, 0.25f, -1.0f}, moved;
        glm_quatv(theirs, angle, about);
        glm_quat_mat3(theirs, m);
        glm_quat_rotatev(theirs, v, moved);
        assert_int_equal(gn_quat_from_axis_angle(axis, angle, &turn), GN_OK);
        assert_quat(turn, theirs[0], theirs[1], theirs[2], theirs[3], 5e-7f);
        for (int exponent = -140; exponent <= 120; exponent += 20) {
            const float factor = ldexpf(1.0f, exponent);
            long_turn.x = turn.x * factor;
            long_turn.y = turn.y * factor;
            long_turn.z = turn.z * factor;
            long_turn.w = turn.w * factor;
            assert_int_equal(gn_quat_to_mat3(long_turn, &ours), GN_OK);
            /* At 2^-140 ten bits remain. */
            for (int i = 0; i < 9; ++i)
                assert_float_equal(ours.m[i / 3][i % 3], m[i / 3][i % 3],
                                   exponent < -120 ? 1e-2f : 2e-6f);
        }
        const gn_vec3 from = {3.0f, 0.25f, -1.0f};
        assert_vec3(gn_vec3_scale(gn_quat_rotate(turn, from), 0.25f), 0.25f * moved[0],
                    0.25f * moved[1], 0.25f * moved[2]);
    }
}

static void directions(void **state)
{
    (void)state;
    const gn_vec3 nothing = {0, 0, 0}, wrong = {NAN, 1, 0}, infinite = {0, 0, INFINITY};
    const gn_vec3 far_x = {3e38f, 0, 0}, near_y = {0, 1e-44f, 0};
    gn_quat turn = marked();
    assert_int_equal(gn_quat_from_directions(nothing, x, &turn), GN_DEGENERATE);
    assert_int_equal(gn_quat_from_directions(x, nothing, &turn), GN_DEGENERATE);
    assert_int_equal(gn_quat_from_directions(nothing, wrong, &turn), GN_NOT_FINITE);
    assert_int_equal(gn_quat_from_directions(infinite, nothing, &turn), GN_NOT_FINITE);
    assert_untouched(turn);
    assert_int_equal(gn_quat_from_directions(x, y, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_quat_from_directions(x, x, &turn), GN_OK);
    assert_quat(turn, 0, 0, 0, 1, 0.0f);
    assert_int_equal(gn_quat_from_directions(far_x, near_y, &turn), GN_OK);
    assert_quat(turn, 0, 0, HALF_ROOT, HALF_ROOT, 2e-7f);

    const gn_vec3 some[] = {{1, 0, 0},  {0, -1, 0}, {0, 0, 2},         {1, 1, 1},
                            {1, -1, 0}, {0, 3, 4},  {-5, 1e-9f, 2e-4f}};
    for (size_t i = 0; i < sizeof some / sizeof some[0]; ++i) {
        gn_vec3 unit;
        assert_int_equal(gn_vec3_normalize(some[i], &unit), GN_OK);
        assert_int_equal(gn_quat_from_directions(some[i], gn_vec3_negate(some[i]), &turn), GN_OK);
        assert_float_equal(turn.w, 0.0f, 1e-6f);
        assert_vec3(gn_quat_rotate(turn, unit), -unit.x, -unit.y, -unit.z);
        /* Almost opposite directions in the plane of some[i] and another axis: the rotation's axis
         * is perpendicular to both. */
        gn_vec3 other = gn_vec3_negate(some[i]);
        other.x += 0.001f;
        other.z -= 0.002f;
        gn_vec3 axis = gn_vec3_cross(some[i], other), to, turned = {0};
        assert_int_equal(gn_vec3_normalize(other, &to), GN_OK);
        assert_int_equal(gn_quat_from_directions(some[i], other, &turn), GN_OK);
        turned = gn_quat_rotate(turn, unit);
        assert_vec3(turned, to.x, to.y, to.z);
        if (gn_vec3_normalize(axis, &axis) == GN_OK) {
            assert_float_equal(turn.x, axis.x, 2e-3f);
            assert_float_equal(turn.y, axis.y, 2e-3f);
            assert_float_equal(turn.z, axis.z, 2e-3f);
        }
    }
}

/* Returns the distance of the direction of `from`, turned, from the direction of `to`. */
static double distance_after(gn_quat turn, gn_vec3 from, gn_vec3 to)
{
    const double v[3] = {(double)from.x, (double)from.y, (double)from.z};
    const double goal[3] = {(double)to.x, (double)to.y, (double)to.z};
    const double i[3] = {(double)turn.x, (double)turn.y, (double)turn.z}, w = (double)turn.w;
    double of_v = 0, of_goal = 0, of_i = 0, along = 0, distance = 0;
    for (int k = 0; k < 3; ++k) {
        of_v += v[k] * v[k];
        of_goal += goal[k] * goal[k];
        of_i += i[k] * i[k];
        along += i[k] * v[k];
    }
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        const double turned =
            ((w * w - of_i) * v[k] + 2 * along * i[k] + 2 * w * (i[l] * v[m] - i[m] * v[l])) /
            (w * w + of_i);
        const double difference = turned / sqrt(of_v) - goal[k] / sqrt(of_goal);
        distance += difference * difference;
    }
    return sqrt(distance);
}

/* Opposite but for the last bit of one component, and mostly along x. Of the cross product of the
 * unit vectors only x is not 0, and it is nothing but rounding: as an axis it would be mostly along
 * the vectors. */
static void opposite_but_for_the_last_bit(void **state)
{
    (void)state;
    static const gn_vec3 pairs[][2] = {
        {{512, 20, 23}, {-512, -0x1.3ffffep+4f, -23}}, {{512, 5, 31}, {-512, -0x1.400002p+2f, -31}},
        {{256, 5, 18}, {-256, -5, -0x1.200002p+4f}},   {{128, 6, 11}, {-128, -0x1.800002p+2f, -11}},
        {{128, 5, 17}, {-128, -5, -0x1.0ffffep+4f}},   {{64, 7, 9}, {-64, -0x1.c00002p+2f, -9}},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; ++i) {
        const gn_vec3 from = pairs[i][0], to = pairs[i][1];
        gn_vec3 a, b, cross;
        gn_quat turn;
        assert_int_equal(gn_vec3_normalize(from, &a), GN_OK);
        assert_int_equal(gn_vec3_normalize(to, &b), GN_OK);
        cross = gn_vec3_cross(a, b);
        assert_true(cross.x != 0 && cross.y == 0 && cross.z == 0);
        assert_int_equal(gn_quat_from_directions(from, to, &turn), GN_OK);
        assert_true(distance_after(turn, from, to) <= 12 * 0x1p-24);
    }
}

static void views(void **state)
{
    (void)state;
    const gn_vec3 ahead = {0, 0, -2}, nothing = {0, 0, 0}, wrong = {0, 0, NAN};
    const gn_vec3 forward = {-4, 6, -4.5f}, up = {0.1f, 2, -0.3f}, eye = {3, -2, 5};
    gn_quat turn = marked();
    gn_transform view;
    gn_mat3 m;
    assert_int_equal(gn_quat_look_rh(nothing, y, &turn), GN_DEGENERATE);
    assert_int_equal(gn_quat_look_rh(ahead, nothing, &turn), GN_DEGENERATE);
    assert_int_equal(gn_quat_look_rh(ahead, z, &turn), GN_DEGENERATE);
    assert_int_equal(gn_quat_look_rh(wrong, y, &turn), GN_NOT_FINITE);
    assert_untouched(turn);
    assert_int_equal(gn_quat_look_rh(ahead, y, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_quat_look_rh(ahead, y, &turn), GN_OK);
    assert_quat(turn, 0, 0, 0, 1, 0.0f);
    /* To look along x is a turn to the right, clockwise about y. */
    assert_int_equal(gn_quat_look_rh(x, y, &turn), GN_OK);
    assert_quat(turn, 0, -HALF_ROOT, 0, HALF_ROOT, 1e-7f);
    /* The view of look-at is the inverse rotation. */
    assert_int_equal(gn_quat_look_rh(forward, up, &turn), GN_OK);
    assert_int_equal(gn_look_at_rh(eye, gn_vec3_add(eye, forward), up, &view), GN_OK);
    assert_int_equal(gn_quat_to_mat3(gn_quat_conjugate(turn), &m), GN_OK);
    for (int i = 0; i < 9; ++i)
        assert_float_equal(m.m[i / 3][i % 3], view.matrix.m[i / 3][i % 3], 1e-6f);
}

/* Exactly opposite, where the axis depends on the rounding of the directions' lengths most. */
static void exactly_opposite(void **state)
{
    (void)state;
    static const gn_vec3 some[] = {{-0x1.eb97e4p-9f, -0x1.48a484p+0f, -0x1.9a8e98p+0f},
                                   {0x1.947486p-8f, 0x1.4dfe7ep-1f, 0x1.b3ef3cp-1f}};
    for (size_t i = 0; i < sizeof some / sizeof *some; ++i) {
        const gn_vec3 to = gn_vec3_negate(some[i]);
        gn_quat turn;
        assert_int_equal(gn_quat_from_directions(some[i], to, &turn), GN_OK);
        assert_true(distance_after(turn, some[i], to) <= 12 * 0x1p-24);
    }
}

static void between_rotations(void **state)
{
    (void)state;
    const gn_quat one = {0, 0, 0, 1}, quarter = {0, 0, HALF_ROOT, HALF_ROOT};
    const gn_quat minus = {0, 0, -5 * HALF_ROOT, -5 * HALF_ROOT}, half = {1, 0, 0, 0};
    const float eighth = GN_PI / 8.0f;
    gn_quat result;
    /* Half way to a quarter turn, and as far again. -q is the same turn, and lengths do not
     * matter. */
    assert_int_equal(gn_quat_slerp(one, quarter, 0.5f, &result), GN_OK);
    assert_quat(result, 0, 0, sinf(eighth), cosf(eighth), 2e-7f);
    assert_int_equal(gn_quat_slerp(one, minus, 0.5f, &result), GN_OK);
    assert_quat(result, 0, 0, sinf(eighth), cosf(eighth), 2e-7f);
    assert_int_equal(gn_quat_nlerp(one, minus, 0.5f, &result), GN_OK);
    assert_quat(result, 0, 0, sinf(eighth), cosf(eighth), 2e-7f);
    assert_int_equal(gn_quat_slerp(one, quarter, 0.25f, &result), GN_OK);
    assert_quat(result, 0, 0, sinf(0.5f * eighth), cosf(0.5f * eighth), 2e-7f);
    /* A quarter along the chord is (0, 0, 1/4 h, 3/4 + 1/4 h), h = sqrt(1/2). */
    const float chord = sqrtf(0.25f * 0.25f * 0.5f + powf(0.75f + 0.25f * HALF_ROOT, 2.0f));
    assert_int_equal(gn_quat_nlerp(one, quarter, 0.25f, &result), GN_OK);
    assert_quat(result, 0, 0, 0.25f * HALF_ROOT / chord, (0.75f + 0.25f * HALF_ROOT) / chord,
                2e-7f);
    assert_int_equal(gn_quat_slerp(one, quarter, 2.0f, &result), GN_OK);
    assert_quat(result, 0, 0, 1, 0, 1e-6f);
    assert_int_equal(gn_quat_slerp(one, quarter, -1.0f, &result), GN_OK);
    assert_quat(result, 0, 0, -HALF_ROOT, HALF_ROOT, 1e-6f);
    /* Half a turn apart. */
    assert_int_equal(gn_quat_slerp(one, half, 0.5f, &result), GN_OK);
    assert_quat(result, HALF_ROOT, 0, 0, HALF_ROOT, 2e-7f);
    assert_int_equal(gn_quat_slerp(one, one, 0.3f, &result), GN_OK);
    assert_quat(result, 0, 0, 0, 1, 0.0f);
    /* So near that the angle between them is no float. */
    const gn_quat nearest = {0x1p-149f, 0, 0, 1};
    assert_int_equal(gn_quat_slerp(one, nearest, 0.5f, &result), GN_OK);
    assert_quat(result, 0, 0, 0, 1, 1e-40f);

    /* An angle whose sines are denormal floats, also with a t that is large. */
    const gn_quat tilted = {0, 0.6f, 0, 0.8f}, beside = {0, 0.6f, 0x1p-148f, 0.8f};
    for (float t = -1.0f; t <= 2.0f; t += 0.25f) {
        assert_int_equal(gn_quat_slerp(tilted, beside, t, &result), GN_OK);
        assert_quat(result, 0, 0.6f, 0, 0.8f, 2e-7f);
        assert_int_equal(gn_quat_slerp(tilted, beside, ldexpf(t, 100), &result), GN_OK);
        assert_quat(result, 0, 0.6f, 0, 0.8f, 2e-7f);
    }

    /* Nearly equal and nearly opposite: the small angle is divided correctly. */
    for (int exponent = -1; exponent >= -60; --exponent) {
        const float small = ldexpf(1.0f, exponent), angle = atanf(small);
        const gn_quat close = {small, 0, 0, 1}, opposite = {-small, 0, 0, -1};
        assert_int_equal(gn_quat_slerp(one, close, 0.25f, &result), GN_OK);
        assert_quat(result, sinf(0.25f * angle), 0, 0, cosf(0.25f * angle), 2e-7f);
        assert_float_equal(result.x, sinf(0.25f * angle), 1e-6f * angle);
        assert_int_equal(gn_quat_slerp(one, opposite, 0.25f, &result), GN_OK);
        assert_float_equal(result.x, sinf(0.25f * angle), 1e-6f * angle);
    }

    versor a = {0.1f, 0.2f, 0.3f, 0.9f}, b = {-0.5f, 0.4f, 0.1f, 0.3f}, theirs;
    glm_quat_normalize(a);
    glm_quat_normalize(b);
    const gn_quat from = {0.1f, 0.2f, 0.3f, 0.9f}, to = {-0.5f, 0.4f, 0.1f, 0.3f};
    for (float t = 0.0f; t <= 1.0f; t += 0.125f) {
        glm_quat_slerp(a, b, t, theirs);
        assert_int_equal(gn_quat_slerp(from, to, t, &result), GN_OK);
        assert_quat(result, theirs[0], theirs[1], theirs[2], theirs[3], 5e-7f);
        glm_quat_nlerp(a, b, t, theirs);
        assert_int_equal(gn_quat_nlerp(from, to, t, &result), GN_OK);
        assert_quat(result, theirs[0], theirs[1], theirs[2], theirs[3], 5e-7f);
    }
}

static void paths_that_cannot_be(void **state)
{
    (void)state;
    gn_quat result = marked();
    for (int i = 0; i < 4; ++i) {
        assert_int_equal(gn_quat_slerp(bad[i], zero, 0.5f, &result), GN_NOT_FINITE);
        assert_int_equal(gn_quat_slerp(zero, bad[i], 0.5f, &result), GN_NOT_FINITE);
        assert_int_equal(gn_quat_nlerp(bad[i], p, 0.5f, &result), GN_NOT_FINITE);
        assert_int_equal(gn_quat_nlerp(p, bad[i], 0.5f, &result), GN_NOT_FINITE);
    }
    assert_int_equal(gn_quat_slerp(p, q, NAN, &result), GN_NOT_FINITE);
    assert_int_equal(gn_quat_nlerp(p, q, INFINITY, &result), GN_NOT_FINITE);
    assert_int_equal(gn_quat_slerp(zero, q, 0.5f, &result), GN_DEGENERATE);
    assert_int_equal(gn_quat_slerp(p, zero, 0.5f, &result), GN_DEGENERATE);
    assert_int_equal(gn_quat_nlerp(zero, q, 0.5f, &result), GN_DEGENERATE);
    assert_int_equal(gn_quat_nlerp(p, zero, 0.5f, &result), GN_DEGENERATE);
    const gn_quat i = {1, 0, 0, 0}, k = {0, 0, 1, 0};
    assert_int_equal(gn_quat_slerp(i, k, FLT_MAX, &result), GN_OUT_OF_RANGE);
    assert_untouched(result);
    assert_int_equal(gn_quat_slerp(p, q, 0.5f, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_quat_nlerp(p, q, 0.5f, NULL), GN_NULL_POINTER);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units_multiply_as_hamilton_says),
        cmocka_unit_test(inverses),
        cmocka_unit_test(inverses_of_unlike_components),
        cmocka_unit_test(axes_and_angles),
        cmocka_unit_test(cubes),
        cmocka_unit_test(matrices_that_are_no_rotations),
        cmocka_unit_test(matrices_match_cglm),
        cmocka_unit_test(directions),
        cmocka_unit_test(opposite_but_for_the_last_bit),
        cmocka_unit_test(exactly_opposite),
        cmocka_unit_test(views),
        cmocka_unit_test(between_rotations),
        cmocka_unit_test(paths_that_cannot_be),
    };
    return cmocka_run_group_tests_name("quat", tests, NULL, NULL);
}
