/* Polygons divided into triangles: the triangles have the polygon's winding, lie inside it, and
 * have its area together, so that they cover it exactly once. Faces of OBJ files are cut so, with a
 * warning where they cannot be. And the origins that readers choose for their coordinates. */
#include "model_test.h"

#include "../../tools/models/origin.h"
#include "../../tools/models/polygon.h"

#define MANY 4096

static double corners[3 * MANY];
static polygon cut;
static bool is_simple;

static bool triangulate(size_t count)
{
    model_reader r = {"x", NULL, 0, NULL, BUDGET, &read_model, &read_messages, ""};
    forget_model();
    bool good = polygon_begin(&r, &cut, count);
    for (size_t i = 0; i < count && good; ++i)
        memcpy(cut.corners[i].position, corners + 3 * i, sizeof cut.corners[i].position);
    return good && polygon_cut(&r, &cut, &is_simple);
}

/* How a flat polygon is placed in space: a point of it is origin + x * along + y * across. */
typedef struct placement {
    double origin[3], along[3], across[3];
} placement;

static const placement placements[] = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
    {{1, 2, 3}, {0, 1, 0}, {0, 0, 1}},  {{1, 2, 3}, {0, 0, 1}, {0, 1, 0}},
    {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}},  {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
    {{9, 9, 9}, {2, 1, -1}, {1, 3, 2}}, {{500000, 4500000, 100}, {1, 0, 0}, {0, 1, 0}}};

static double area(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static double polygon_area(const double *xy, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        const double *const p = xy + 2 * i, *const q = xy + 2 * ((i + 1) % count);
        sum += p[0] * q[1] - p[1] * q[0];
    }
    return sum;
}

/* Whether a ray to the right crosses the outline an odd number of times. */
static bool is_inside(const double *xy, size_t count, double x, double y)
{
    bool inside = false;
    for (size_t i = 0; i < count; ++i) {
        const double *const p = xy + 2 * i, *const q = xy + 2 * ((i + 1) % count);
        if ((p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) * (q[0] - p[0]) / (q[1] - p[1]))
            inside = !inside;
    }
    return inside;
}

/* Requires a cover of the polygon in a placement, beginning at a corner. */
static void require_cover_at(const double *xy, size_t count, const placement *at, size_t turn)
{
    const double expected = polygon_area(xy, count);
    double sum = 0.0;
    cut.work_left = POLYGON_MOST_WORK;
    for (size_t i = 0; i < count; ++i)
        for (size_t c = 0; c < 3; ++c)
            corners[3 * i + c] = at->origin[c] + xy[2 * ((i + turn) % count)] * at->along[c] +
                                 xy[2 * ((i + turn) % count) + 1] * at->across[c];
    assert_true(triangulate(count));
    assert_true(is_simple);
    for (size_t t = 0; t < cut.index_count / 3; ++t) {
        const double *v[3];
        for (size_t k = 0; k < 3; ++k) {
            assert_true(cut.triangles[3 * t + k] < count);
            v[k] = xy + 2 * ((cut.triangles[3 * t + k] + turn) % count);
        }
        assert_true(area(v[0], v[1], v[2]) > 0.0);
        assert_true(is_inside(xy, count, (v[0][0] + v[1][0] + v[2][0]) / 3.0,
                              (v[0][1] + v[1][1] + v[2][1]) / 3.0));
        sum += area(v[0], v[1], v[2]);
    }
    assert_true(fabs(sum - expected) <= 1e-9 * expected);
}

static void require_cover(const double *xy, size_t count)
{
    assert_true(polygon_area(xy, count) > 0.0);
    for (size_t p = 0; p < sizeof placements / sizeof placements[0]; ++p)
        for (size_t turn = 0; turn < count; turn += 1 + count / 16)
            require_cover_at(xy, count, placements + p, turn);
}

#define COVER(...)                                                                                 \
    do {                                                                                           \
        static const double xy[] = {__VA_ARGS__};                                                  \
        require_cover(xy, sizeof xy / sizeof xy[0] / 2);                                           \
    } while (0)

static void test_small_shapes(void **state)
{
    COVER(0, 0, 1, 0, 0, 1);
    COVER(0, 0, 1, 0, 1, 1, 0, 1);
    COVER(1, 0, 3, 1, 3, 3, 1, 4, 0, 2);
    COVER(0, 0, 2, 1, 4, 0, 2, 4);                         /* an arrow head */
    COVER(0, 0, 3, 0, 3, 1, 1, 1, 1, 3, 0, 3);             /* an L */
    COVER(0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3); /* a U */
    COVER(0, 0, 1, 0, 2, 0, 0, 2);                         /* a corner on an edge */
    COVER(0, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1);
    COVER(0, -4, 1, -1, 4, 0, 1, 1, 0, 4, -1, 1, -4, 0, -1, -1); /* a star */
    /* A spiral. */
    COVER(0, 0, 9, 0, 9, 9, 2, 9, 2, 4, 5, 4, 5, 5, 3, 5, 3, 8, 8, 8, 8, 1, 0, 1);
    /* A square with a square hole, joined by a bridge that is passed twice. */
    COVER(0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 1, 1, 1, 3, 3, 3, 3, 1, 1, 1);
    /* A spike that leads out and back, and a corner that is there twice. */
    COVER(0, 0, 4, 0, 4, 2, 7, 2, 4, 2, 4, 4, 0, 4);
}

static void make_comb(double *xy, size_t teeth)
{
    for (size_t i = 0; i < teeth; ++i) {
        xy[4 * i] = (double)(2 * (teeth - i));
        xy[4 * i + 1] = 10.0;
        xy[4 * i + 2] = (double)(2 * (teeth - i) - 1);
        xy[4 * i + 3] = 1.0;
    }
    xy[4 * teeth] = xy[4 * teeth + 1] = xy[4 * teeth + 3] = 0.0;
    xy[4 * teeth + 2] = (double)(2 * teeth);
}

/* Combs, a circle, a circle of spikes, and waves around a circle. Without work left it is a fan. */
static void test_many_corners(void **state)
{
    static double xy[2 * MANY];
    make_comb(xy, 100);
    require_cover(xy, 202);
    for (int shape = 0; shape < 4; ++shape) {
        make_comb(xy, (MANY - 2) / 2);
        for (int i = 0; i < MANY && shape < 3; ++i) {
            const double angle = 6.283185307179586 * i / MANY;
            const double radius = shape == 1 && i % 2 ? 20.0
                                  : shape == 2        ? 100.0 + 60.0 * sin(i * 0.05)
                                                      : 100.0;
            xy[2 * i] = radius * cos(angle);
            xy[2 * i + 1] = radius * sin(angle);
        }
        require_cover_at(xy, MANY, placements, 0);
    }
    cut.work_left = 100;
    assert_true(triangulate(MANY));
    assert_false(is_simple);
    assert_true(cut.index_count > 0 && cut.index_count <= 3 * (MANY - 2));
}

/* Polygons without a cover: triangles of existing corners all the same. */
static void test_no_cover(void **state)
{
    static const double shapes[][15] = {
        {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},     /* a point */
        {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4},     /* a line */
        {0, 0, 0, 2, 2, 0, 2, 0, 0, 0, 2, 0, 1, 3, 0},     /* crosses itself */
        {3, 0, 0, -2, 2, 0, 1, -3, 0, 1, 3, 0, -2, -2, 0}, /* a pentagram */
        {0, 0, 0, NAN, 1, 1, 2, 2, INFINITY, 3, 0, 3, 0, 4, 4},
        {0, 0, 0, 1e308, 0, 0, 1e308, 1e308, 0, -1e308, 1e308, 0, 0, 1e308, 9}};
    for (size_t s = 0; s < sizeof shapes / sizeof shapes[0]; ++s) {
        memcpy(corners, shapes[s], sizeof shapes[s]);
        cut.work_left = POLYGON_MOST_WORK;
        assert_true(triangulate(5));
        assert_true(cut.index_count <= 9);
        for (size_t i = 0; i < cut.index_count; i += 3) {
            const uint32_t *const t = cut.triangles + i;
            assert_true(t[0] < 5 && t[1] < 5 && t[2] < 5);
            assert_true(t[0] != t[1] && t[0] != t[2] && t[1] != t[2]);
        }
    }
}

static void test_no_memory(void **state)
{
    model_reader r = {"x", NULL, 0, NULL, 16, &read_model, &read_messages, ""};
    polygon p;
    forget_model();
    memset(&p, 0, sizeof p);
    expect_fault(polygon_begin(&r, &p, 4), "not enough memory");
    polygon_release(&r, &p);
}

static void test_faces(void **state)
{
    /* An arrow; and four corners that lie in no plane, concave if seen from above: the cut does not
     * leave them. */
    expect_read(read_obj_text("v 0 0 3\nv 4 1 7\nv 1 1 4\nv 1 4 4\nf 3 4 1 2\n", NULL), NULL);
    expect_area(read_model.parts, 2, 3.0);
    expect_read(read_obj_text("v 0 0 0\nv 4 1 0.5\nv 1 1 0\nv 1 4 0.5\nf 2 3 4 1\n", NULL), NULL);
    expect_area(read_model.parts, 2, 3.0);
    expect_read(read_obj_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n", NULL),
                "x.obj: 2 triangles have no area and cannot be seen (1)");
    expect_read(read_obj_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", NULL),
                "x.obj: 1 triangle has no area and cannot be seen (1)");
    /* A bow tie whose halves differ. */
    assert_true(read_obj_text("v 0 0 0\nv 4 0 0\nv 1 2 0\nv 3 2 0\nf 1 2 3 4\n", NULL));
    assert_true(has_warning("x.obj: line 5: a face crosses itself, or has very many corners; its "
                            "triangles may overlap (1)"));
    assert_int_equal(read_model.parts[0].index_count, 6);
}

static void test_origin(void **state)
{
    /* The middle is 16 half sides away from zero, then 17. What is not finite does not count. */
    static const struct {
        double points[3][3], origin[3];
    } cases[] = {{{{15, 0, 0}, {17, 2, 1}, {NAN, 0, 0}}, {0, 0, 0}},
                 {{{16, 0, 0}, {18, 2, 1}, {NAN, INFINITY, -INFINITY}}, {17, 1, 0.5}}};
    origin_bounds b = origin_empty();
    double origin[3];
    origin_choose(&b, origin);
    assert_true(origin[0] == 0.0 && origin[1] == 0.0 && origin[2] == 0.0);
    for (int i = 0; i < 2; ++i) {
        b = origin_empty();
        for (int k = 0; k < 3; ++k)
            origin_add(&b, cases[i].points[k]);
        origin_choose(&b, origin);
        for (int k = 0; k < 3; ++k)
            assert_true(origin[k] == cases[i].origin[k]);
    }
    b = origin_empty();
    origin_add(&b, (const double[3]){1e308, -1.5e308, 0.0});
    origin_add(&b, (const double[3]){1.5e308, -1e308, 0.0});
    origin_choose(&b, origin);
    assert_true(isfinite(origin[0]) && isfinite(origin[1]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_small_shapes), cmocka_unit_test(test_many_corners),
        cmocka_unit_test(test_no_cover),     cmocka_unit_test(test_no_memory),
        cmocka_unit_test(test_faces),        cmocka_unit_test(test_origin),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, forget_last_model);
    free(cut.corners);
    free(cut.triangles);
    return failed;
}
