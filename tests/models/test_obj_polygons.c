/* Polygons of OBJ files: their triangles cover them once. */
#include "model_test.h"

#include <math.h>
#include <stdlib.h>

#include "obj_test.h"

/* Corners of a polygon in the plane, anticlockwise. */
typedef struct shape {
    size_t count;
    double corner[16][2];
} shape;

static const shape shapes[] = {
    {4, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}},
    /* An arrow, whose third corner is reflex: from wherever it begins, one cut is right. */
    {4, {{0, 0}, {4, 1}, {1, 1}, {1, 4}}},
    /* A U. */
    {8, {{0, 0}, {6, 0}, {6, 5}, {4, 5}, {4, 2}, {2, 2}, {2, 5}, {0, 5}}},
    /* A square with corners in the middle of its sides. */
    {8, {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}}},
    /* A star. */
    {8, {{0, -4}, {1, -1}, {4, 0}, {1, 1}, {0, 4}, {-1, 1}, {-4, 0}, {-1, -1}}},
    /* A square with a hole, which a cut joins with the border. */
    {10, {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}},
    /* A spike that leads out and back, and a corner that is there twice. */
    {7, {{0, 0}, {4, 0}, {4, 2}, {7, 2}, {4, 2}, {4, 4}, {0, 4}}},
};

static double area_of(const shape *s)
{
    double sum = 0.0;
    for (size_t i = 0; i < s->count; ++i) {
        const double *const a = s->corner[i], *const b = s->corner[(i + 1) % s->count];
        sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return sum;
}

/* Reads a polygon that begins at some corner; z = slope x + lift. */
static void read_shape(const shape *s, size_t first, double slope, double lift)
{
    char text[2048];
    int length = 0;
    for (size_t i = 0; i < s->count; ++i)
        length += snprintf(text + length, sizeof text - (size_t)length, "v %g %g %g\n",
                           s->corner[i][0], s->corner[i][1], slope * s->corner[i][0] + lift);
    length += snprintf(text + length, sizeof text - (size_t)length, "f");
    for (size_t i = 0; i < s->count; ++i)
        length += snprintf(text + length, sizeof text - (size_t)length, " %zu",
                           (first + i) % s->count + 1);
    assert_true(read_obj_text(text, NULL));
    assert_int_equal(read_messages.warning_count, 0);
    assert_int_equal(read_model.part_count, 1);
}

static void test_shapes(void **state)
{
    static const double slopes[] = {0.0, 1.0, 0.3, -5.0};
    double smallest;
    (void)state;
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; ++i)
        for (size_t first = 0; first < shapes[i].count; ++first)
            for (size_t k = 0; k < sizeof slopes / sizeof slopes[0]; ++k) {
                read_shape(shapes + i, first, slopes[k], 3.0);
                const double area = signed_area(read_model.parts, &smallest);
                assert_true(fabs(area - area_of(shapes + i)) < 1e-9);
                assert_true(smallest > 0.0);
            }
}

/* Polygons in every plane of the axes, in both orders of their corners. */
static void test_planes(void **state)
{
    /* The arrow: its normal is the axis, or against it. */
    static const int arrow[4][2] = {{0, 0}, {4, 1}, {1, 1}, {1, 4}};
    (void)state;
    for (int axis = 0; axis < 3; ++axis)
        for (int turns = 0; turns < 2; ++turns) {
            char text[512];
            int length = 0;
            double sum = 0.0;
            for (int i = 0; i < 4; ++i) {
                int p[3] = {7, 7, 7};
                p[(axis + 1) % 3] = arrow[i][turns];
                p[(axis + 2) % 3] = arrow[i][1 - turns];
                length += snprintf(text + length, sizeof text - (size_t)length, "v %d %d %d\n",
                                   p[0], p[1], p[2]);
            }
            snprintf(text + length, sizeof text - (size_t)length, "s off\nf 1 2 3 4\n");
            assert_true(read_obj_text(text, NULL));
            const model_part *const part = read_model.parts;
            for (uint32_t i = 0; i < part->index_count; i += 3) {
                const float *const a = part->positions + 3 * part->indices[i];
                const float *const b = part->positions + 3 * part->indices[i + 1];
                const float *const c = part->positions + 3 * part->indices[i + 2];
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                const double area =
                    (double)((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])) / 2.0;
                assert_true(turns == 0 ? area > 0.0 : area < 0.0);
                sum += area;
            }
            /* Two triangles with the base 0 0 to 1 1, and 3 across it. */
            assert_true(fabs(fabs(sum) - 3.0) < 1e-9);
            for (uint32_t v = 0; v < part->vertex_count; ++v)
                assert_float_equal(part->normals[3 * v + (uint32_t)axis], turns == 0 ? 1.0f : -1.0f,
                                   1e-6f);
        }
}

/* Four corners that lie in no plane, concave if seen from above: the cut does not leave them. */
static void test_not_planar(void **state)
{
    double smallest;
    (void)state;
    assert_true(read_obj_text("v 0 0 0\nv 4 1 0.5\nv 1 1 0\nv 1 4 0.5\nf 2 3 4 1\n", NULL));
    assert_float_equal(signed_area(read_model.parts, &smallest), 3.0, 1e-6);
    assert_true(smallest > 0.0);
}

static void test_without_area(void **state)
{
    (void)state;
    assert_true(read_obj_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n", NULL));
    assert_int_equal(read_model.parts[0].index_count, 6);
    assert_true(has_warning("x.obj: 2 triangles have no area and cannot be seen (1)"));
    assert_true(read_obj_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", NULL));
    assert_true(has_warning("x.obj: 1 triangle has no area and cannot be seen (1)"));
}

static void test_crossing(void **state)
{
    (void)state;
    /* A bow tie whose halves differ. */
    assert_true(read_obj_text("v 0 0 0\nv 4 0 0\nv 1 2 0\nv 3 2 0\nf 1 2 3 4\n", NULL));
    assert_true(has_warning("x.obj: line 5: a face crosses itself, or has very many corners; its "
                            "triangles may overlap (1)"));
    assert_int_equal(read_model.parts[0].index_count, 6);
}

/* Reads one polygon of many corners, radius(i) from the middle, and compares areas. */
static void expect_large(size_t count, double (*radius)(size_t))
{
    char *const text = malloc(count * 96);
    size_t length = 0;
    double area = 0.0, smallest, before[2] = {0.0, 0.0}, first[2] = {0.0, 0.0};
    assert_non_null(text);
    for (size_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * (double)i / (double)count;
        char line[64];
        float p[2];
        snprintf(line, sizeof line, "v %.9g %.9g 0\n", radius(i) * cos(angle),
                 radius(i) * sin(angle));
        sscanf(line, "v %f %f", p, p + 1);
        const double at[2] = {(double)p[0], (double)p[1]};
        if (i == 0)
            memcpy(first, at, sizeof at);
        else
            area += 0.5 * (before[0] * at[1] - before[1] * at[0]);
        memcpy(before, at, sizeof at);
        length += (size_t)sprintf(text + length, "%s", line);
    }
    area += 0.5 * (before[0] * first[1] - before[1] * first[0]);
    text[length++] = 'f';
    for (size_t i = 0; i < count; ++i)
        length += (size_t)sprintf(text + length, " %zu", i + 1);
    assert_true(read_obj_text(text, NULL));
    free(text);
    assert_int_equal(read_messages.warning_count, 0);
    assert_int_equal(read_model.parts[0].index_count, 3 * (count - 2));
    assert_true(fabs(signed_area(read_model.parts, &smallest) - area) < 1e-3);
    assert_true(smallest >= 0.0);
}

static double circle(size_t i)
{
    (void)i;
    return 100.0;
}

static double comb(size_t i)
{
    return i % 2 == 0 ? 100.0 : 20.0;
}

static double waves(size_t i)
{
    return 100.0 + 60.0 * sin((double)i * 0.05);
}

static void test_many_corners(void **state)
{
    (void)state;
    expect_large(10000, circle);
    expect_large(10000, comb);
    expect_large(10000, waves);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shapes),     cmocka_unit_test(test_planes),
        cmocka_unit_test(test_not_planar), cmocka_unit_test(test_without_area),
        cmocka_unit_test(test_crossing),   cmocka_unit_test(test_many_corners),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
