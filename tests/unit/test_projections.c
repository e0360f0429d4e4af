/* Projections and viewports of every convention: entries and points worked by hand, every status,
 * results left untouched, faults in words; and the transforms from one convention to another.
 * tests/property tests bounds, tests/accuracy compares with cglm. */
#include <float.h>
#include <stdbool.h>

#include "near.h"
#include "noise.h"
#include "untouched.h"

typedef gn_status six_planes(float, float, float, float, float, float, gn_transform *);

#define ALL_OF(convention, reversed)                                                               \
    gn_orthographic_##convention##reversed, gn_frustum_##convention##reversed,                     \
        gn_frustum_##convention##_infinite##reversed, gn_perspective_##convention##reversed,       \
        gn_perspective_##convention##_infinite##reversed

/* For near 1 and far 3, clip z = a t + b at the distance t. Depths at t = 1 and t = 3 are a + b and
 * (3 a + b) / 3, the two ends of the range. */
static const struct convention {
    six_planes *box, *pyramid;
    gn_status (*endless_pyramid)(float, float, float, float, float, gn_transform *);
    gn_status (*view)(float, float, float, float, gn_transform *);
    gn_status (*endless_view)(float, float, float, gn_transform *);
    float hand;
    float box_scale, box_offset, a, b, endless_a, endless_b;
} conventions[] = {
    {ALL_OF(rh_no, ), -1, 1, -2, 2, -3, 1, -2},
    {ALL_OF(lh_no, ), 1, 1, -2, 2, -3, 1, -2},
    {ALL_OF(rh_zo, ), -1, 0.5f, -0.5f, 1.5f, -1.5f, 1, -1},
    {ALL_OF(lh_zo, ), 1, 0.5f, -0.5f, 1.5f, -1.5f, 1, -1},
    {ALL_OF(rh_no, _reversed), -1, -1, 2, -2, 3, -1, 2},
    {ALL_OF(lh_no, _reversed), 1, -1, 2, -2, 3, -1, 2},
    {ALL_OF(rh_zo, _reversed), -1, -0.5f, 1.5f, -0.5f, 1.5f, 0, 1},
    {ALL_OF(lh_zo, _reversed), 1, -0.5f, 1.5f, -0.5f, 1.5f, 0, 1},
};

static six_planes *const viewports[4] = {gn_viewport_no, gn_viewport_no_y_down, gn_viewport_zo,
                                         gn_viewport_zo_y_down};

enum kind { BOX, PYRAMID, ENDLESS_PYRAMID, VIEW, ENDLESS_VIEW, VIEWPORT, KINDS };

static gn_status make(enum kind kind, size_t convention, const float *f, gn_transform *t)
{
    const struct convention *const c = &conventions[convention];
    six_planes *const six = kind == BOX       ? c->box
                            : kind == PYRAMID ? c->pyramid
                                              : viewports[convention % 4];

    switch (kind) {
    case ENDLESS_PYRAMID:
        return c->endless_pyramid(f[0], f[1], f[2], f[3], f[4], t);
    case VIEW:
        return c->view(f[0], f[1], f[2], f[3], t);
    case ENDLESS_VIEW:
        return c->endless_view(f[0], f[1], f[2], t);
    default:
        return six(f[0], f[1], f[2], f[3], f[4], f[5], t);
    }
}

static void assert_entries(const gn_transform *t, const float matrix[4][4],
                           const float inverse[4][4], float tolerance)
{
    gn_mat4 m;

    gn_mat4_from_rows(matrix[0], &m); /* as they are written on paper */
    assert_mat4(&t->matrix, &m, tolerance);
    gn_mat4_from_rows(inverse[0], &m);
    assert_mat4(&t->inverse, &m, tolerance);
    for (int k = 0; k < 16; ++k) { /* no negative zero */
        const float entries[2] = {t->matrix.m[k / 4][k % 4], t->inverse.m[k / 4][k % 4]};
        assert_false((entries[0] == 0 && signbit(entries[0])) ||
                     (entries[1] == 0 && signbit(entries[1])));
    }
}

/* Planes -1..3 and -1..0 at distance 1: scales 2/4 and 2/1, skews 2/4 and -1/1. A right angle, and
 * a picture twice as wide as high. */
static void entries_by_hand(void **state)
{
    static const float planes[6] = {-1, 3, -1, 0, 1, 3}, angle[4] = {0.5f * GN_PI, 2, 1, 3};
    gn_transform t;

    for (size_t i = 0; i < COUNT(conventions); ++i) {
        const struct convention *const c = &conventions[i];
        const float h = c->hand, s = h * c->box_scale, o = c->box_offset;
        const float box[4][4] = {{0.5f, 0, 0, -0.5f}, {0, 2, 0, 1}, {0, 0, s, o}, {0, 0, 0, 1}};
        const float of_box[4][4] = {
            {2, 0, 0, 1}, {0, 0.5f, 0, -0.5f}, {0, 0, 1 / s, -o / s}, {0, 0, 0, 1}};

        assert_int_equal(make(BOX, i, planes, &t), GN_OK);
        assert_entries(&t, box, of_box, 0);
        for (int endless = 0; endless < 2; ++endless) {
            const float a = endless ? c->endless_a : c->a, b = endless ? c->endless_b : c->b;
            const float pyramid[4][4] = {
                {0.5f, 0, -h * 0.5f, 0}, {0, 2, h, 0}, {0, 0, h * a + 0, b}, {0, 0, h, 0}};
            const float of_pyramid[4][4] = {
                {2, 0, 0, 1}, {0, 0.5f, 0, -0.5f}, {0, 0, 0, h}, {0, 0, 1 / b, 0 - a / b}};
            const float view[4][4] = {
                {0.5f, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, h * a, b}, {0, 0, h, 0}};
            const float of_view[4][4] = {
                {2, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, h}, {0, 0, 1 / b, -a / b}};

            assert_int_equal(make(endless ? ENDLESS_PYRAMID : PYRAMID, i, planes, &t), GN_OK);
            assert_entries(&t, pyramid, of_pyramid, 0);
            assert_int_equal(make(endless ? ENDLESS_VIEW : VIEW, i, angle, &t), GN_OK);
            assert_entries(&t, view, of_view, 2e-7f);
        }
    }
}

/* Where corners go, there and back, also with planes in the other order and planes behind the eye.
 * For 640 x 480 pixels at (10, 20), the point (1/2, 1/2, 1/2) is three quarters to the right and
 * up; its depth is 3/4 or 1/2 of the range 0.25 .. 0.75. */
static void points_by_hand(void **state)
{
    static const struct {
        enum kind kind;
        size_t convention;
        float numbers[6], from[3], to[3];
    } cases[] = {
        {BOX, 0, {-2, 6, -1, 3, 0.5f, 20}, {-2, -1, -0.5f}, {-1, -1, -1}},
        {BOX, 0, {-2, 6, -1, 3, 0.5f, 20}, {6, 3, -20}, {1, 1, 1}},
        {BOX, 0, {6, -2, 3, -1, 20, -3}, {6, 3, -20}, {-1, -1, -1}},
        {BOX, 0, {6, -2, 3, -1, 20, -3}, {-2, -1, 3}, {1, 1, 1}},
        {PYRAMID, 0, {-0.2f, 0.6f, -0.1f, 0.3f, 0.5f, 20}, {-0.2f, -0.1f, -0.5f}, {-1, -1, -1}},
        {PYRAMID, 0, {-0.2f, 0.6f, -0.1f, 0.3f, 0.5f, 20}, {24, 12, -20}, {1, 1, 1}},
        {PYRAMID, 0, {-0.2f, 0.6f, -0.1f, 0.3f, 20, 0.5f}, {-0.2f, -0.1f, -20}, {-1, -1, -1}},
        {PYRAMID, 0, {-0.2f, 0.6f, -0.1f, 0.3f, 20, 0.5f}, {0.015f, 0.0075f, -0.5f}, {1, 1, 1}},
        {VIEW, 0, {0.5f * GN_PI, 2, 1, 10}, {-20, -10, -10}, {-1, -1, 1}},
        {VIEW, 0, {0.5f * GN_PI, 2, 10, 1}, {2, 1, -1}, {1, 1, 1}},
        {VIEWPORT, 0, {10, 20, 640, 480, 0.25f, 0.75f}, {0.5f, 0.5f, 0.5f}, {490, 380, 0.625f}},
        {VIEWPORT, 1, {10, 20, 640, 480, 0.25f, 0.75f}, {0.5f, 0.5f, 0.5f}, {490, 140, 0.625f}},
        {VIEWPORT, 2, {10, 20, 640, 480, 0.25f, 0.75f}, {0.5f, 0.5f, 0.5f}, {490, 380, 0.5f}},
        {VIEWPORT, 3, {10, 20, 640, 480, 0.25f, 0.75f}, {0.5f, 0.5f, 0.5f}, {490, 140, 0.5f}},
        {VIEWPORT, 0, {-3.5f, 0, 1, 1, 0.75f, 0.25f}, {-1, 0, -1}, {-3.5f, 0.5f, 0.75f}},
        {VIEWPORT, 0, {-3.5f, 0, 1, 1, 0.75f, 0.25f}, {1, 0, 1}, {-2.5f, 0.5f, 0.25f}},
    };

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const float *const p = cases[i].from, *const q = cases[i].to;
        gn_transform t;

        assert_int_equal(make(cases[i].kind, cases[i].convention, cases[i].numbers, &t), GN_OK);
        const gn_vec4 clip = gn_mat4_multiply_vec4(&t.matrix, (gn_vec4){p[0], p[1], p[2], 1});
        const gn_vec4 back = gn_mat4_multiply_vec4(&t.inverse, clip);
        assert_near(&clip.x, (float[]){q[0] * clip.w, q[1] * clip.w, q[2] * clip.w}, 3, 4e-5f);
        assert_near(&back.x, (float[]){p[0], p[1], p[2], 1}, 4, 2e-5f);
    }
}

/* The reference computes 0.5 * (f - n) and 0.5 * (n + f) in double. */
static void viewport_depth_is_the_rasterizers(void **state)
{
    uint64_t seed = 1;

    for (int i = 0; i < 10000; ++i) {
        const uint32_t bits = random_bits(&seed);
        const float near = ldexpf((float)(bits >> 8), -24 - (int)(bits & 31));
        const float far = ldexpf((float)(random_bits(&seed) >> 8), -24 - (int)(bits >> 5 & 31));
        gn_transform t;

        if (near == far)
            continue;
        assert_int_equal(gn_viewport_no(0, 0, 5, 3, near, far, &t), GN_OK);
        assert_true(t.matrix.m[2][2] == (float)(0.5 * ((double)far - (double)near)));
        assert_true(t.matrix.m[3][2] == (float)(0.5 * ((double)near + (double)far)));
    }
}

static void numbers_must_be_finite(void **state)
{
    static const float bad[3] = {NAN, INFINITY, -INFINITY};
    static const float good[KINDS][6] = {
        {-1, 1, -1, 1, 1, 10}, {-1, 1, -1, 1, 1, 10}, {-1, 1, -1, 1, 1}, {1, 1, 1, 10}, {1, 1, 1},
        {0, 0, 8, 8, 0, 1}};
    static const int counts[KINDS] = {6, 6, 5, 4, 3, 6};
    gn_transform t;

    mark(t);
    for (int kind = 0; kind < KINDS; ++kind) {
        for (size_t c = 0; c < COUNT(conventions); ++c) {
            for (int i = 0; i < 3 * counts[kind]; ++i) {
                float numbers[6];
                memcpy(numbers, good[kind], sizeof numbers);
                numbers[i / 3] = bad[i % 3];
                assert_int_equal(make((enum kind)kind, c, numbers, &t), GN_NOT_FINITE);
            }
            assert_int_equal(make((enum kind)kind, c, good[kind], NULL), GN_NULL_POINTER);
        }
    }
    assert_untouched(t);
}

#define BIG FLT_MAX

/* Volumes without extent; numbers out of range; overflow on the way, and reciprocals that are not
 * normal floats. */
static void what_cannot_be(void **state)
{
    static const struct {
        enum kind kind;
        gn_status status;
        float numbers[6];
    } cases[] = {
        {BOX, GN_SINGULAR, {2, 2, -1, 1, 1, 10}},
        {BOX, GN_SINGULAR, {-1, 1, 0, -0.0f, 1, 10}},
        {BOX, GN_SINGULAR, {-1, 1, -1, 1, 3, 3}},
        {BOX, GN_OUT_OF_RANGE, {-BIG, BIG, -1, 1, 1, 10}},
        {BOX, GN_OUT_OF_RANGE, {0, 1e-45f, -1, 1, 1, 10}},
        {BOX, GN_OUT_OF_RANGE, {3e38f, 2e38f, -1, 1, 1, 10}},
        {PYRAMID, GN_SINGULAR, {2, 2, -1, 1, 1, 10}},
        {PYRAMID, GN_SINGULAR, {-1, 1, 0, -0.0f, 1, 10}},
        {PYRAMID, GN_SINGULAR, {-1, 1, -1, 1, 3, 3}},
        {PYRAMID, GN_OUT_OF_RANGE, {-1, 1, -1, 1, 0, 10}},
        {PYRAMID, GN_OUT_OF_RANGE, {-1, 1, -1, 1, 1, -10}},
        {PYRAMID, GN_OUT_OF_RANGE, {3e38f, 2e38f, -1, 1, 1, 10}},
        {PYRAMID, GN_OUT_OF_RANGE, {-1, 1, -1, 1, 1e-45f, 1}},
        {ENDLESS_PYRAMID, GN_SINGULAR, {2, 2, -1, 1, 1}},
        {ENDLESS_PYRAMID, GN_SINGULAR, {-1, 1, 3, 3, 1}},
        {ENDLESS_PYRAMID, GN_OUT_OF_RANGE, {-1, 1, -1, 1, 0}},
        {ENDLESS_PYRAMID, GN_OUT_OF_RANGE, {-1, 1, -1, 1, 1e-45f}},
        {VIEW, GN_SINGULAR, {1, 1, 3, 3}},
        {VIEW, GN_OUT_OF_RANGE, {0, 1, 1, 10}},
        {VIEW, GN_OUT_OF_RANGE, {-1, 1, 1, 10}},
        {VIEW, GN_OUT_OF_RANGE, {GN_PI, 1, 1, 10}},
        {VIEW, GN_OUT_OF_RANGE, {1, 0, 1, 10}},
        {VIEW, GN_OUT_OF_RANGE, {1, -2, 1, 10}},
        {VIEW, GN_OUT_OF_RANGE, {1, 1, -1, 10}},
        {VIEW, GN_OUT_OF_RANGE, {1, 1, 0, 10}},
        {VIEW, GN_OUT_OF_RANGE, {1, 1, 1, 0}},
        {VIEW, GN_OUT_OF_RANGE, {1e-44f, 1, 1, 10}},
        {VIEW, GN_OUT_OF_RANGE, {1, 1e-44f, 1, 10}},
        {VIEW, GN_OK, {0x1.921fb4p1f, 1, 1, 10}}, /* the widest angle */
        {ENDLESS_VIEW, GN_OUT_OF_RANGE, {0, 1, 1}},
        {ENDLESS_VIEW, GN_OUT_OF_RANGE, {1, 0, 1}},
        {ENDLESS_VIEW, GN_OUT_OF_RANGE, {1, 1, 0}},
        {VIEWPORT, GN_SINGULAR, {0, 0, 8, 8, 0.5f, 0.5f}},
        {VIEWPORT, GN_INVALID_VIEWPORT, {0, 0, 0, 8, 0, 1}},
        {VIEWPORT, GN_INVALID_VIEWPORT, {0, 0, 8, -1, 0, 1}},
        {VIEWPORT, GN_OUT_OF_RANGE, {0, 0, 1e-44f, 1, 0, 1}},
        {PYRAMID, GN_OUT_OF_RANGE, {-1, 1, -1, 1, 3e38f, 2e38f}},
        {VIEWPORT, GN_OUT_OF_RANGE, {0, 0, 1, 1, 0, BIG}},
    };
    gn_transform t;

    for (size_t i = 0; i < COUNT(cases); ++i) {
        for (size_t c = 0; c < COUNT(conventions); ++c) {
            mark(t);
            if (make(cases[i].kind, c, cases[i].numbers, &t) != cases[i].status)
                fail_msg("case %zu, convention %zu", i, c);
            if (cases[i].status != GN_OK)
                assert_untouched(t);
        }
    }
}

/* Planes so far apart that second / (second - first) is no normal float: the depths of the planes
 * keep their bounds. */
static void planes_far_apart(void **state)
{
    static const struct {
        size_t convention;
        float z_near, z_far, depth, depth_far; /* of both planes */
    } cases[] = {{6, 1e-6f, 1e38f, 1, 0}, {4, 1e-6f, 1e38f, 1, -1}, {6, 1e-5f, 3e38f, 1, 0},
                 {6, 0.1f, 3e38f, 1, 0},  {5, 1e-3f, 3e38f, 1, -1}, {2, 3e38f, 1e-3f, 0, 1}};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const float numbers[4] = {1, 1, cases[i].z_near, cases[i].z_far};
        gn_transform t;

        assert_int_equal(make(VIEW, cases[i].convention, numbers, &t), GN_OK);
        /* depth = (a z + b) / w, and w is the distance */
        const double a = (double)(t.matrix.m[2][3] * t.matrix.m[2][2]);
        const double b = (double)t.matrix.m[3][2];
        assert_true(fabs(a + b / (double)numbers[2] - (double)cases[i].depth) < 12 * 0x1p-24);
        assert_true(fabs(a + b / (double)numbers[3] - (double)cases[i].depth_far) < 12 * 0x1p-24);
    }
}

static const char no_float[] = "an entry of the matrix or of its inverse would be no normal float";

static void assert_words(float fov_y, float aspect, float z_near, float z_far, const char *words)
{
    const char *const got = gn_perspective_fault(fov_y, aspect, z_near, z_far);

    if (words && got)
        assert_string_equal(got, words);
    assert_int_equal(!got, !words);
}

/* The words name the argument that is wrong. */
static void perspective_faults(void **state)
{
    assert_words(NAN, 1, 1, 10, "fov_y is not finite");
    assert_words(1, INFINITY, 1, 10, "aspect is not finite");
    assert_words(1, 1, NAN, 10, "z_near is not finite");
    assert_words(1, 1, 1, NAN, "z_far is not finite");
    assert_words(1, 1, 1, -INFINITY, "z_far is not finite");
    assert_words(0, 1, 1, 10, "fov_y is not above 0");
    assert_words(60, 1, 1, 10, "fov_y is not below pi: it is in radians");
    assert_words(1, 0, 1, 10, "aspect is not above 0");
    assert_words(1, 1, 0, 10, "z_near is not above 0");
    assert_words(1, 1, 1, -10, "z_far is not above 0");
    assert_words(1, 1, 1, 1, "z_near equals z_far");
    assert_words(1, 1e-44f, 1, 10, no_float);
    assert_words(1, 1, 1, 10, NULL);
    assert_words(1, 1, 10, 1,
                 "z_near is above z_far; for reversed depth call a _reversed function");
    assert_words(1, 1e-44f, 10, 1, no_float);
    assert_words(1, 1, 1, INFINITY, NULL);
}

/* One convention that refuses is a fault. The least magnitude of the number b in clip z = a z + b
 * is 2^-126, and exactly b is 2 n f / (f - n) for depths -1 to 1, n f / (f - n) for depths 0 to 1.
 * So it is no normal float for depths 0 to 1 if n is 2^-127, and for all depths if n is 2^-128.
 * Where reversed depths exchange n and f, the intermediate number 2 f overflows if f is 3e38; and
 * the products f / (f - n) * n and n / (f - n) * f may be rounded to either side of 2^-126. */
static void one_convention_is_a_fault(void **state)
{
    static const struct {
        float z_near, z_far;
        bool fits[4]; /* -1 to 1 and 0 to 1, then these reversed */
    } cases[] = {
        {0x1p-126f, 3, {1, 1, 1, 1}},        {0x1p-126f, 23, {1, 1, 1, 1}},
        {0x1p-126f, 0x1p30f, {1, 1, 1, 1}},  {0x1p-127f, 1, {1, 0, 1, 0}},
        {10, 3e38f, {1, 1, 0, 1}},           {0x1.659c88p-127f, 0x1.287cccp-125f, {1, 1, 1, 0}},
        {0x1p-126f, INFINITY, {1, 1, 1, 1}}, {0x1p-127f, INFINITY, {1, 0, 1, 0}},
        {0x1p-128f, INFINITY, {0, 0, 0, 0}},
    };

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const float numbers[4] = {1, 1, cases[i].z_near, cases[i].z_far};
        bool all = true;

        for (size_t k = 0; k < 4; ++k) {
            gn_transform t;
            assert_int_equal(make(isinf(numbers[3]) ? ENDLESS_VIEW : VIEW, 2 * k, numbers, &t),
                             cases[i].fits[k] ? GN_OK : GN_OUT_OF_RANGE);
            all = all && cases[i].fits[k];
        }
        assert_words(1, 1, numbers[2], numbers[3], all ? NULL : no_float);
    }
}

/* Planes of a view volume whose sums overflow. z' >= 0 does not need w' + z', and with the largest
 * entry in that row all other bounds are planes. */
static void planes_that_are_not_finite(void **state)
{
    gn_plane planes[GN_PLANE_COUNT];

    mark(planes);
    for (int i = 0; i < 12; ++i) {
        gn_mat4 m;

        gn_mat4_identity(&m);
        m.m[i / 3][i % 3] = m.m[i / 3][3] = FLT_MAX;
        assert_int_equal(gn_frustum_planes_no(&m, planes), GN_OUT_OF_RANGE);
        if (i < 11)
            assert_int_equal(gn_frustum_planes_zo(&m, planes), GN_OUT_OF_RANGE);
    }
    assert_untouched(planes);
}

/* (2, 3, 1, 2) becomes these; z = -w and z = w become the ends of the range. */
static void conversions(void **state)
{
    static const struct {
        gn_status (*make)(gn_transform *);
        float y, z, ends[2];
    } cases[] = {{gn_clip_no_to_zo, 3, 1.5f, {0, 2}},
                 {gn_clip_zo_to_no, 3, 0, {-6, 2}},
                 {gn_clip_reverse_zo, 3, 1, {4, 0}},
                 {gn_flip_y, -3, 1, {-2, 2}},
                 {gn_flip_z, 3, -1, {2, -2}}};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        gn_transform t;

        assert_int_equal(cases[i].make(NULL), GN_NULL_POINTER);
        assert_int_equal(cases[i].make(&t), GN_OK);
        const gn_vec4 moved = gn_mat4_multiply_vec4(&t.matrix, (gn_vec4){2, 3, 1, 2});
        assert_near(&moved.x, (float[]){2, cases[i].y, cases[i].z, 2}, 4, 0);
        for (int end = 0; end < 2; ++end) {
            const gn_vec4 v = {0, 0, end ? 2 : -2, 2};
            assert_true(gn_mat4_multiply_vec4(&t.matrix, v).z == cases[i].ends[end]);
        }
        assert_inverses(&t, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(entries_by_hand),
        cmocka_unit_test(points_by_hand),
        cmocka_unit_test(viewport_depth_is_the_rasterizers),
        cmocka_unit_test(numbers_must_be_finite),
        cmocka_unit_test(what_cannot_be),
        cmocka_unit_test(planes_far_apart),
        cmocka_unit_test(perspective_faults),
        cmocka_unit_test(one_convention_is_a_fault),
        cmocka_unit_test(planes_that_are_not_finite),
        cmocka_unit_test(conversions),
    };
    return cmocka_run_group_tests_name("projections", tests, NULL, NULL);
}
