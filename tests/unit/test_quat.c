/* Quaternions: products, rotations and paths worked by hand, all rotations of a cube, opposite
 * directions, every size, every status, results left untouched. tests/property tests error bounds,
 * tests/accuracy compares with cglm. */
#include <float.h>

#include "near.h"
#include "untouched.h"

/* Defines a function that calls gn_quat_NAME with arguments taken from an array of numbers. */
#define MAKE(name, ...)                                                                            \
    static gn_status name(const float *f, gn_quat *q)                                              \
    {                                                                                              \
        return gn_quat_##name(__VA_ARGS__, q);                                                     \
    }
#define V(i) ((gn_vec3){f[i], f[(i) + 1], f[(i) + 2]})
#define Q(i) ((gn_quat){f[i], f[(i) + 1], f[(i) + 2], f[(i) + 3]})

MAKE(invert, Q(0))
MAKE(normalize, Q(0))
MAKE(from_axis_angle, V(0), f[3])
MAKE(from_mat3, (const gn_mat3 *)f)
MAKE(from_directions, V(0), V(3))
MAKE(look_rh, V(0), V(3))
MAKE(slerp, Q(0), Q(4), f[8])
MAKE(nlerp, Q(0), Q(4), f[8])

typedef gn_status maker(const float *, gn_quat *);

#define H 0.70710678118654752440f /* the square root of 1/2 */

static const struct made {
    maker *make;
    int count;
    float numbers[9], expected[4], tolerance;
} made[] = {
    {invert, 4, {0, 0, 0, 2}, {0, 0, 0, 0.5f}, 0},
    {invert, 4, {1, -1, 1, 1}, {-0.25f, 0.25f, -0.25f, 0.25f}, 0},
    {invert, 4, {0x1p-120f}, {-0x1p120f, 0, 0, 0}, 0},
    {invert, 4, {0, 0x1p-120f}, {0, -0x1p120f, 0, 0}, 0},
    {invert, 4, {0, 0, 0x1p-120f}, {0, 0, -0x1p120f, 0}, 0},
    {invert, 4, {0, 0, 0, 0x1p-120f}, {0, 0, 0, 0x1p120f}, 0},
    {normalize, 4, {1, -1, 1, 1}, {0.5f, -0.5f, 0.5f, 0.5f}, 0},
    /* A quarter of a turn, and a third of one about the diagonal. */
    {from_axis_angle, 4, {0, 0, 1, 0.5f * GN_PI}, {0, 0, H, H}, 1e-7f},
    {from_axis_angle, 4, {2, 2, 2, 2 * GN_PI / 3}, {0.5f, 0.5f, 0.5f, 0.5f}, 1e-7f},
    {from_mat3, 9, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0, 1}, 0},
    {from_directions, 6, {1, 0, 0, 1, 0, 0}, {0, 0, 0, 1}, 0},
    {from_directions, 6, {3e38f, 0, 0, 0, 1e-44f, 0}, {0, 0, H, H}, 2e-7f},
    /* To look along x is a turn to the right, clockwise about y. */
    {look_rh, 6, {0, 0, -2, 0, 1, 0}, {0, 0, 0, 1}, 0},
    {look_rh, 6, {1, 0, 0, 0, 1, 0}, {0, -H, 0, H}, 1e-7f},
    /* Half way to a quarter turn; -q is the same turn, and lengths do not matter. A quarter of the
     * way along the arc, and along the chord: (0, 0, H/4, 3/4 + H/4), normalized. */
    {slerp, 9, {0, 0, 0, 1, 0, 0, H, H, 0.5f}, {0, 0, 0.38268343f, 0.92387953f}, 2e-7f},
    {slerp, 9, {0, 0, 0, 1, 0, 0, -5 * H, -5 * H, 0.5f}, {0, 0, 0.38268343f, 0.92387953f}, 2e-7f},
    {nlerp, 9, {0, 0, 0, 1, 0, 0, -5 * H, -5 * H, 0.5f}, {0, 0, 0.38268343f, 0.92387953f}, 2e-7f},
    {slerp, 9, {0, 0, 0, 1, 0, 0, H, H, 0.25f}, {0, 0, 0.19509032f, 0.98078528f}, 2e-7f},
    {nlerp, 9, {0, 0, 0, 1, 0, 0, H, H, 0.25f}, {0, 0, 0.18736553f, 0.98229034f}, 2e-7f},
    /* Beyond both ends; half a turn apart; no turn; an angle that is no float. */
    {slerp, 9, {0, 0, 0, 1, 0, 0, H, H, 2}, {0, 0, 1, 0}, 1e-6f},
    {slerp, 9, {0, 0, 0, 1, 0, 0, H, H, -1}, {0, 0, -H, H}, 1e-6f},
    {slerp, 9, {0, 0, 0, 1, 1, 0, 0, 0, 0.5f}, {H, 0, 0, H}, 2e-7f},
    {slerp, 9, {0, 0, 0, 1, 0, 0, 0, 1, 0.3f}, {0, 0, 0, 1}, 0},
    {slerp, 9, {0, 0, 0, 1, 0x1p-149f, 0, 0, 1, 0.5f}, {0, 0, 0, 1}, 1e-40f},
};

/* Every number that is not finite is refused, and so is a result that is null. */
static void quaternions_by_hand(void **state)
{
    static const float bad[3] = {NAN, INFINITY, -INFINITY};

    for (size_t i = 0; i < COUNT(made); ++i) {
        gn_quat q;

        assert_int_equal(made[i].make(made[i].numbers, &q), GN_OK);
        assert_near(&q.x, made[i].expected, 4, made[i].tolerance);
        assert_int_equal(made[i].make(made[i].numbers, NULL), GN_NULL_POINTER);
        mark(q);
        for (int k = 0; k < 3 * made[i].count; ++k) {
            float numbers[9];
            memcpy(numbers, made[i].numbers, sizeof numbers);
            numbers[k / 3] = bad[k % 3];
            assert_int_equal(made[i].make(numbers, &q), GN_NOT_FINITE);
        }
        assert_untouched(q);
    }
}

static void what_cannot_be(void **state)
{
    static const struct {
        maker *make;
        gn_status status;
        float numbers[9];
    } cases[] = {
        {invert, GN_DEGENERATE, {0, -0.0f, 0, 0}},
        {invert, GN_OUT_OF_RANGE, {0x1p-140f}},
        {invert, GN_OUT_OF_RANGE, {0, 0x1p-140f}},
        {invert, GN_OUT_OF_RANGE, {0, 0, 0x1p-129f}},
        {invert, GN_OUT_OF_RANGE, {0, 0, 0, 0x1p-140f}},
        {invert, GN_OUT_OF_RANGE, {FLT_MAX, FLT_MAX}},
        {normalize, GN_DEGENERATE, {0, -0.0f, 0, 0}},
        {from_axis_angle, GN_DEGENERATE, {0, 0, 0, 1}},
        {from_directions, GN_DEGENERATE, {0, 0, 0, 1, 0, 0}},
        {from_directions, GN_DEGENERATE, {1, 0, 0, 0, 0, 0}},
        {from_directions, GN_NOT_FINITE, {0, 0, 0, NAN, 1, 0}},
        {from_directions, GN_NOT_FINITE, {0, 0, INFINITY, 0, 0, 0}},
        {look_rh, GN_DEGENERATE, {0, 0, 0, 0, 1, 0}},
        {look_rh, GN_DEGENERATE, {0, 0, -2, 0, 0, 0}},
        {look_rh, GN_DEGENERATE, {0, 0, -2, 0, 0, 1}},
        {slerp, GN_NOT_FINITE, {NAN, 0, 0, 1}},
        {slerp, GN_NOT_FINITE, {0, 0, 0, 0, 0, INFINITY, 0, 1}},
        {slerp, GN_DEGENERATE, {0, 0, 0, 0, 5, 6, 7, 8, 0.5f}},
        {slerp, GN_DEGENERATE, {1, 2, 3, 4, 0, -0.0f, 0, 0, 0.5f}},
        {slerp, GN_OUT_OF_RANGE, {1, 0, 0, 0, 0, 0, 1, 0, FLT_MAX}},
        {nlerp, GN_DEGENERATE, {0, 0, 0, 0, 5, 6, 7, 8, 0.5f}},
        {nlerp, GN_DEGENERATE, {1, 2, 3, 4, 0, -0.0f, 0, 0, 0.5f}},
        {from_mat3, GN_OUT_OF_RANGE, {0}},
        {from_mat3, GN_OUT_OF_RANGE, {2, 0, 0, 0, 2, 0, 0, 0, 2}},
        {from_mat3, GN_OUT_OF_RANGE, {1, 0, 0, 0.01f, 1, 0, 0, 0, 1}},
        {from_mat3, GN_OUT_OF_RANGE, {FLT_MAX, 0, 0, 0, 1, 0, FLT_MAX, 0, -FLT_MAX}},
    };
    static const gn_quat bad[] = {{0, -0.0f, 0, 0},
                                  {NAN, 0, 0, 1},
                                  {0, INFINITY, 0, 1},
                                  {0, 0, -INFINITY, 1},
                                  {0, 0, 0, NAN}};
    gn_quat q;
    gn_mat3 m3;
    gn_mat4 m4;

    mark(q);
    mark(m3);
    mark(m4);
    for (size_t i = 0; i < COUNT(cases); ++i)
        if (cases[i].make(cases[i].numbers, &q) != cases[i].status)
            fail_msg("case %zu", i);
    assert_int_equal(gn_quat_from_mat3(NULL, &q), GN_NULL_POINTER);
    for (size_t i = 0; i < COUNT(bad); ++i) {
        assert_int_equal(gn_quat_to_mat3(bad[i], &m3), i ? GN_NOT_FINITE : GN_DEGENERATE);
        assert_int_equal(gn_quat_to_mat4(bad[i], &m4), i ? GN_NOT_FINITE : GN_DEGENERATE);
    }
    assert_int_equal(gn_quat_to_mat3((gn_quat){1, 2, 3, 4}, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_quat_to_mat4((gn_quat){1, 2, 3, 4}, NULL), GN_NULL_POINTER);
    assert_untouched(q);
    assert_untouched(m3);
    assert_untouched(m4);
}

/* Hamilton's units, and others. */
static void products(void **state)
{
    static const struct {
        gn_quat a, b;
        float product[4];
    } cases[] = {{{1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, -1}},
                 {{0, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, -1}},
                 {{0, 0, 1, 0}, {0, 0, 1, 0}, {0, 0, 0, -1}},
                 {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}},
                 {{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}},
                 {{0, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 0}},
                 {{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}},
                 {{1, 2, 3, 4}, {0, 0, 0, 1}, {1, 2, 3, 4}},
                 {{0, 0, 0, 1}, {1, 2, 3, 4}, {1, 2, 3, 4}},
                 {{1, 2, 3, 4}, {5, 6, 7, 8}, {24, 48, 48, -6}},
                 {{5, 6, 7, 8}, {1, 2, 3, 4}, {32, 32, 56, -6}}};
    const gn_quat p = {1, 2, 3, 4}, q = {5, 6, 7, 8};
    const gn_quat one = gn_quat_identity(), back = gn_quat_conjugate(p);

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const gn_quat product = gn_quat_multiply(cases[i].a, cases[i].b);
        assert_near(&product.x, cases[i].product, 4, 0);
    }
    assert_near(&one.x, (float[]){0, 0, 0, 1}, 4, 0);
    assert_near(&back.x, (float[]){-1, -2, -3, 4}, 4, 0);
    assert_true(gn_quat_dot(p, q) == 5 + 12 + 21 + 32);
}

/* A quarter of a turn about z, a third of a turn about the diagonal, and the quaternion of length
 * zero, which turns nothing. */
static void rotated_vectors(void **state)
{
    const gn_vec3 v = {1, 2, 3};

    assert_vec3(gn_quat_rotate((gn_quat){0, 0, H, H}, v), -2, 1, 3, 1e-6f);
    assert_vec3(gn_quat_rotate((gn_quat){0.5f, 0.5f, 0.5f, 0.5f}, v), 3, 1, 2, 1e-6f);
    assert_vec3(gn_quat_rotate((gn_quat){0, 0, 0, 0}, v), 1, 2, 3, 0);
}

/* Every pair of exponents: conjugate(q) / |q|^2 within 9 u of each component, or within 2^-146
 * below the normal floats. */
static void inverses_of_unlike_components(void **state)
{
    for (int e = -126; e <= 127; ++e) {
        for (int f = -149; f <= e; ++f) {
            const float large = ldexpf(1.28741455f, e), small = ldexpf(-1.06158471f, f);
            const double square = (double)small * (double)small + (double)large * (double)large;
            const double exact[2] = {-(double)small / square, -(double)large / square};
            gn_quat back;
            const gn_status status = gn_quat_invert((gn_quat){small, large, 0, 0}, &back);

            if (status == GN_OUT_OF_RANGE) {
                assert_true(sqrt(square) > (double)FLT_MAX || fabs(exact[1]) > (double)FLT_MAX);
                continue;
            }
            assert_int_equal(status, GN_OK);
            for (int i = 0; i < 2; ++i)
                assert_true(fabs((double)(&back.x)[i] - exact[i]) <=
                            fmax(9 * 0x1p-24 * fabs(exact[i]), 0x1p-146));
        }
    }
}

/* The 24 rotations of a cube: whole numbers; half turns and negative traces are among them. The
 * length of a quaternion does not change its matrix. */
static void cubes(void **state)
{
    static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                     {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    int turns = 0;

    for (int code = 0; code < 6 * 8; ++code) {
        gn_mat3 m = {{{0}}}, back;
        gn_mat4 m4, expected;
        gn_quat turn;

        for (int i = 0; i < 3; ++i)
            m.m[i][orders[code / 8][i]] = code >> i & 1 ? -1.0f : 1.0f;
        mark(turn);
        if (gn_mat3_determinant(&m) < 0) { /* a reflection */
            assert_int_equal(gn_quat_from_mat3(&m, &turn), GN_OUT_OF_RANGE);
            assert_untouched(turn);
            continue;
        }
        ++turns;
        assert_int_equal(gn_quat_from_mat3(&m, &turn), GN_OK);
        assert_int_equal(gn_quat_to_mat3(turn, &back), GN_OK);
        assert_int_equal(gn_quat_to_mat4(turn, &m4), GN_OK);
        assert_mat3(&back, &m, 5e-7f);
        gn_mat4_from_mat3(&back, &expected);
        assert_mat4(&m4, &expected, 0);
    }
    assert_int_equal(turns, 24);
    for (int e = -147; e <= 126; ++e) {
        static const gn_mat3 third = {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
        const float s = ldexpf(1.0f, e);
        gn_mat3 m;

        assert_int_equal(gn_quat_to_mat3((gn_quat){s, s, s, s}, &m), GN_OK);
        assert_mat3(&m, &third, 5e-7f);
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

/* Exactly opposite, where the axis depends on the rounding of the directions' lengths most; and
 * opposite but for the last bit of one component, and mostly along x: of the cross product of the
 * unit vectors only x is not 0, and it is nothing but rounding; as an axis it would be mostly along
 * the vectors. */
static void opposite_directions(void **state)
{
    static const gn_vec3 pairs[][2] = {
        {{512, 20, 23}, {-512, -0x1.3ffffep+4f, -23}}, {{512, 5, 31}, {-512, -0x1.400002p+2f, -31}},
        {{256, 5, 18}, {-256, -5, -0x1.200002p+4f}},   {{128, 6, 11}, {-128, -0x1.800002p+2f, -11}},
        {{128, 5, 17}, {-128, -5, -0x1.0ffffep+4f}},   {{64, 7, 9}, {-64, -0x1.c00002p+2f, -9}},
    };
    static const gn_vec3 some[] = {{1, 0, 0},
                                   {0, -1, 0},
                                   {0, 0, 2},
                                   {1, 1, 1},
                                   {1, -1, 0},
                                   {0, 3, 4},
                                   {-5, 1e-9f, 2e-4f},
                                   {-0x1.eb97e4p-9f, -0x1.48a484p+0f, -0x1.9a8e98p+0f},
                                   {0x1.947486p-8f, 0x1.4dfe7ep-1f, 0x1.b3ef3cp-1f}};
    gn_quat turn;

    for (size_t i = 0; i < COUNT(pairs); ++i) {
        gn_vec3 a, b;

        assert_int_equal(gn_vec3_normalize(pairs[i][0], &a), GN_OK);
        assert_int_equal(gn_vec3_normalize(pairs[i][1], &b), GN_OK);
        const gn_vec3 cross = gn_vec3_cross(a, b);
        assert_true(cross.x != 0 && cross.y == 0 && cross.z == 0);
        assert_int_equal(gn_quat_from_directions(pairs[i][0], pairs[i][1], &turn), GN_OK);
        assert_true(distance_after(turn, pairs[i][0], pairs[i][1]) <= 12 * 0x1p-24);
    }
    for (size_t i = 0; i < COUNT(some); ++i) {
        gn_vec3 to = gn_vec3_negate(some[i]), axis;

        assert_int_equal(gn_quat_from_directions(some[i], to, &turn), GN_OK);
        assert_float_equal(turn.w, 0, 1e-6f);
        assert_true(distance_after(turn, some[i], to) <= 12 * 0x1p-24);
        /* Almost opposite: the rotation's axis is perpendicular to both. */
        to.x += 0.001f;
        to.z -= 0.002f;
        assert_int_equal(gn_quat_from_directions(some[i], to, &turn), GN_OK);
        assert_true(distance_after(turn, some[i], to) <= 12 * 0x1p-24);
        if (gn_vec3_normalize(gn_vec3_cross(some[i], to), &axis) == GN_OK)
            assert_vec3((gn_vec3){turn.x, turn.y, turn.z}, axis.x, axis.y, axis.z, 2e-3f);
    }
}

/* Nearly equal and nearly opposite: the small angle is divided correctly. An angle whose sines are
 * denormal floats, also with a t that is large. */
static void paths_between_near_rotations(void **state)
{
    const gn_quat one = {0, 0, 0, 1}, tilted = {0, 0.6f, 0, 0.8f},
                  beside = {0, 0.6f, 0x1p-148f, 0.8f};
    gn_quat q;

    for (int exponent = -1; exponent >= -60; --exponent) {
        const float small = ldexpf(1.0f, exponent), angle = 0.25f * atanf(small);

        for (float sign = -1; sign <= 1; sign += 2) {
            assert_int_equal(gn_quat_slerp(one, (gn_quat){sign * small, 0, 0, sign}, 0.25f, &q),
                             GN_OK);
            assert_near(&q.x, (float[]){sinf(angle), 0, 0, cosf(angle)}, 4, 2e-7f);
            assert_float_equal(q.x, sinf(angle), 4e-6f * angle);
        }
    }
    for (float t = -1; t <= 2; t += 0.25f) {
        for (int large = 0; large < 2; ++large) {
            assert_int_equal(gn_quat_slerp(tilted, beside, ldexpf(t, 100 * large), &q), GN_OK);
            assert_near(&q.x, (float[]){0, 0.6f, 0, 0.8f}, 4, 2e-7f);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quaternions_by_hand),
        cmocka_unit_test(what_cannot_be),
        cmocka_unit_test(products),
        cmocka_unit_test(rotated_vectors),
        cmocka_unit_test(inverses_of_unlike_components),
        cmocka_unit_test(cubes),
        cmocka_unit_test(opposite_directions),
        cmocka_unit_test(paths_between_near_rotations),
    };
    return cmocka_run_group_tests_name("quat", tests, NULL, NULL);
}
