/* Counts of what became of primitives and fragments: each count by hand. Nothing is drawn of what
 * is not finite, and in viewports as far away as may be. */
#include <math.h>

#include "counted_draw.h"

static void place_triangle(float x0, float y0, float x1, float y1, float x2, float y2)
{
    place(0, x0, y0);
    place(1, x1, y1);
    place(2, x2, y2);
}

static void set_scissor(int32_t x, uint32_t width)
{
    pipeline.raster.scissor =
        (gn_scissor){.enabled = true, .x = x, .y = 0, .width = width, .height = 20};
}

/* Expects one primitive, and that the named counts are 1 and the other five are 0. */
#define EXPECT_ONE(counts, ...)                                                                    \
    do {                                                                                           \
        const gn_draw_statistics got = (counts);                                                   \
        gn_draw_statistics expected = {.primitives = 1, __VA_ARGS__};                              \
        expected.samples_covered = got.samples_covered;                                            \
        expected.samples_passed = got.samples_passed;                                              \
        expect_equal(&got, &expected, __LINE__, #__VA_ARGS__);                                     \
    } while (0)

static void triangles_by_hand(void **state)
{
    reset(GN_TRIANGLES, 3, 1);
    place_triangle(2, 2, 10, 2, 2, 10);
    EXPECT_ONE(count_draw(), .drawn = 1);
    pipeline.raster.cull = GN_CULL_FRONT;
    EXPECT_ONE(count_draw(), .culled = 1);
    pipeline.raster.front_face = GN_FRONT_CLOCKWISE;
    EXPECT_ONE(count_draw(), .drawn = 1);
    pipeline.raster.cull = GN_CULL_FRONT_AND_BACK;
    EXPECT_ONE(count_draw(), .culled = 1);
    pipeline.raster.cull = GN_CULL_NONE;

    set_scissor(12, 5);
    EXPECT_ONE(count_draw(), .missed = 1);
    pipeline.raster.scissor.enabled = false;
    place_triangle(2.6f, 2.6f, 3.4f, 2.6f, 2.6f, 3.4f);
    EXPECT_ONE(count_draw(), .missed = 1);
    place_triangle(2, 2, 4, 4, 8, 8);
    EXPECT_ONE(count_draw(), .without_area = 1);
    place_triangle(2, 2, 2, 2, 9, 3);
    EXPECT_ONE(count_draw(), .without_area = 1);

    place_triangle(-20, 2, -10, 2, -10, 10);
    EXPECT_ONE(count_draw(), .outside = 1);
    place_triangle(-20, 10, 10, -20, -20, -20); /* passes by the target's corner */
    EXPECT_ONE(count_draw(), .outside = 1);
    place_triangle(-20, 2, 10, 2, 2, 10);
    EXPECT_ONE(count_draw(), .drawn = 1, .clipped = 1);
    pipeline.raster.cull = GN_CULL_BACK; /* the front is clockwise */
    EXPECT_ONE(count_draw(), .culled = 1);
    pipeline.raster.cull = GN_CULL_NONE;
    set_scissor(20, 4);
    EXPECT_ONE(count_draw(), .missed = 1);
    pipeline.raster.scissor.enabled = false;

    place_triangle(2, 2, 10, 2, 2, 10);
    for (uint32_t v = 0; v < 3; ++v)
        multiply(v, -1.0f);
    EXPECT_ONE(count_draw(), .outside = 1, .behind = 1);
    multiply(0, -1.0f);
    EXPECT_ONE(count_draw(), .drawn = 1, .clipped = 1);
}

static void vertices_that_are_not_finite(void **state)
{
    const float odd[] = {INFINITY, -INFINITY, NAN};

    reset(GN_TRIANGLES, 3, 1);
    for (int n = 0; n < 3; ++n) {
        for (int i = 0; i < (n == 2 ? 4 : 3); ++i) {
            pipeline.depth.clamp_enabled = false;
            place_triangle(2, 2, 10, 2, 2, 10);
            position[1][i] = odd[n];
            EXPECT_ONE(count_draw(), .not_finite = 1);
            pipeline.depth.clamp_enabled = true;
            EXPECT_ONE(count_draw(), .drawn = i == 2, .not_finite = i != 2);
        }
        pipeline.program.clip_distance_count = 1;
        place_triangle(2, 2, 10, 2, 2, 10);
        extra[2][0] = odd[n];
        EXPECT_ONE(count_draw(), .not_finite = 1);
        extra[2][0] = 0.0f;
        pipeline.program.clip_distance_count = 0;
    }
    pipeline.depth.clamp_enabled = false;
    memset(position[1], 0, sizeof position[1]);
    EXPECT_ONE(count_draw(), .not_finite = 1);
    pipeline.program.clip_distance_count = 1;
    for (int i = 0; i < 3; ++i)
        extra[i][0] = -1.0f;
    place_triangle(2, 2, 10, 2, 2, 10);
    EXPECT_ONE(count_draw(), .outside = 1);
    extra[2][0] = 1.0f;
    EXPECT_ONE(count_draw(), .drawn = 1, .clipped = 1);
}

static void lines_points_and_outlines_by_hand(void **state)
{
    memset(extra, 0, sizeof extra);
    reset(GN_LINES, 2, 1);
    place_triangle(2, 2, 10, 5, 3, 3);
    EXPECT_ONE(count_draw(), .drawn = 1);
    memset(position[1], 0, sizeof position[1]);
    EXPECT_ONE(count_draw(), .not_finite = 1);
    place(1, 2, 2);
    EXPECT_ONE(count_draw(), .without_area = 1);
    place(1, -200, 5);
    EXPECT_ONE(count_draw(), .drawn = 1, .clipped = 1);
    place_triangle(-5, 4, 4, -8, 0, 0);
    EXPECT_ONE(count_draw(), .outside = 1);
    place_triangle(-5, 10, -8, 10, 0, 0);
    EXPECT_ONE(count_draw(), .outside = 1);
    multiply(0, -1.0f);
    multiply(1, -1.0f);
    EXPECT_ONE(count_draw(), .outside = 1, .behind = 1);
    place_triangle(2, 2, 10, 5, 3, 3);
    set_scissor(12, 5);
    EXPECT_ONE(count_draw(), .missed = 1);

    reset(GN_POINTS, 1, 1);
    EXPECT_ONE(count_draw(), .drawn = 1);
    set_scissor(12, 5);
    EXPECT_ONE(count_draw(), .missed = 1);
    place(0, -1, 5);
    EXPECT_ONE(count_draw(), .outside = 1);
    memset(position[0], 0, sizeof position[0]);
    EXPECT_ONE(count_draw(), .not_finite = 1);

    /* A triangle that is drawn as lines or points is one primitive. */
    for (int mode = GN_POLYGON_FILL + 1; mode < GN_POLYGON_FILL + 3; ++mode) {
        reset(GN_TRIANGLES, 3, 1);
        pipeline.raster.polygon_mode_front = (gn_polygon_mode)mode;
        pipeline.raster.polygon_mode_back = (gn_polygon_mode)mode;
        place_triangle(2, 2, 10, 2, 2, 10);
        EXPECT_ONE(count_draw(), .drawn = 1);
        place_triangle(2, 2, 4, 4, 8, 8); /* seen from the side */
        EXPECT_ONE(count_draw(), .drawn = 1);
        place_triangle(-20, 2, 10, 2, 2, 10);
        EXPECT_ONE(count_draw(), .drawn = 1, .clipped = 1);
        pipeline.raster.cull = GN_CULL_FRONT;
        EXPECT_ONE(count_draw(), .culled = 1);
        place_triangle(-20, 2, -10, 2, -10, 10);
        EXPECT_ONE(count_draw(), .outside = 1);
        place_triangle(2, 2, 10, 2, NAN, 10);
        EXPECT_ONE(count_draw(), .not_finite = 1);
        pipeline.raster.cull = GN_CULL_BACK;
        place_triangle(2, 2, 10, 2, 2, 10);
        set_scissor(12, 5);
        EXPECT_ONE(count_draw(), .missed = 1);
        place_triangle(2, 2, 4, 4, 8, 8); /* seen from the side, and off the scissor */
        pipeline.raster.cull = GN_CULL_NONE;
        EXPECT_ONE(count_draw(), .missed = 1);

        /* One vertex has no place in the window; the edge between the others is drawn. */
        reset(GN_TRIANGLES, 3, GN_SAMPLES);
        pipeline.raster.polygon_mode_front = (gn_polygon_mode)mode;
        pipeline.raster.polygon_mode_back = (gn_polygon_mode)mode;
        place_triangle(2, 2, 10, 2, 2, 10);
        memset(position[0], 0, sizeof position[0]);
        EXPECT_ONE(count_draw(), .drawn = 1);
        pipeline.raster.cull = GN_CULL_FRONT_AND_BACK;
        EXPECT_ONE(count_draw(), .not_finite = 1);
    }
    /* A filled triangle of the same draw is without area before it is culled. */
    reset(GN_TRIANGLES, 3, 1);
    pipeline.raster.polygon_mode_front = GN_POLYGON_LINE;
    pipeline.raster.cull = GN_CULL_FRONT_AND_BACK;
    pipeline.raster.front_face = GN_FRONT_CLOCKWISE;
    place_triangle(3, 5, 6, 10, 12, 20); /* exact: the area is 0 before snapping too */
    EXPECT_ONE(count_draw(), .without_area = 1);

    /* Three times one vertex has no edges, but three points. */
    reset(GN_TRIANGLES, 3, 1);
    pipeline.raster.polygon_mode_front = GN_POLYGON_LINE;
    pipeline.raster.polygon_mode_back = GN_POLYGON_LINE;
    place_triangle(4, 4, 4, 4, 4, 4);
    EXPECT_ONE(count_draw(), .missed = 1);
}

static void faults_count_nothing(void **state)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 0)];
    gn_draw_statistics counts = {.drawn = 1};
    const gn_draw_statistics before = counts;
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .statistics = &counts};

    reset(GN_TRIANGLES, 3, 1);
    place_triangle(2, 2, 10, 2, 2, 10);
    indices[0] = indices[1] = 0;
    indices[2] = 3;
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT16;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_INDEX_OUT_OF_RANGE);
    expect_equal(&counts, &before, __LINE__, "index out of range");
    mesh.index_format = GN_INDEX_NONE;
    mesh.count = 2;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    expect_equal(&counts, &before, __LINE__, "two vertices of a triangle");
}

static void lines_and_points_that_are_not_finite(void **state)
{
    for (int i = 0; i < 12; ++i) {
        const bool is_line = i < 6;
        float *const number =
            i % 6 < 4 ? &position[is_line][i % 6] : &extra[is_line][0]; /* a distance */

        reset(is_line ? GN_LINES : GN_POINTS, is_line ? 2 : 1, 1);
        place_triangle(2, 2, 10, 5, 3, 3);
        memset(extra, 0, sizeof extra);
        pipeline.program.clip_distance_count = 1;
        *number = i % 6 == 5 ? INFINITY : NAN;
        EXPECT_ONE(count_draw(), .not_finite = 1);
    }
    memset(extra, 0, sizeof extra);
}

static void nothing_is_drawn_far_away(void **state)
{
    static const gn_topology topologies[] = {GN_POINTS, GN_LINES, GN_TRIANGLES};

    for (int i = 0; i < 24; ++i) {
        const float far = (float)(i % 2 ? GN_MAX_SIZE : -GN_MAX_SIZE);
        const bool is_beside = i / 2 % 2;
        const uint32_t corners = 1 + (uint32_t)i / 4 % 3, samples = i / 12 ? GN_SAMPLES : 1;

        reset(topologies[corners - 1], corners, samples);
        place_triangle(2, 2, 10, 2, 2, 10);
        pipeline.raster.viewport =
            (gn_viewport){true, is_beside ? far : 0, is_beside ? 0 : far, WIDTH, HEIGHT};
        pipeline.raster.line_width = pipeline.raster.point_size = 3.0f;
        EXPECT_ONE(count_draw(), .missed = 1);
        for (uint32_t p = 0; p < samples * WIDTH * HEIGHT; ++p)
            assert_int_equal(color[p], 0);
    }
}

/* Fragments that tests, the shader or masks reject are covered but do not pass. */
static void rejected_samples_are_covered(void **state)
{
    memset(extra, 0, sizeof extra);
    reset(GN_TRIANGLES, 3, GN_SAMPLES);
    place_triangle(2, 2, 6, 2, 2, 6);
    const gn_draw_statistics all = count_draw();
    pipeline.samples.write_disabled = 3;
    const gn_draw_statistics half = count_draw();
    pipeline.samples.write_disabled = 0;
    pipeline.depth.test_enabled = true;
    pipeline.depth.function = GN_NEVER;
    const gn_draw_statistics none = count_draw();

    assert_true(all.samples_covered > 20);
    assert_int_equal(all.samples_passed, all.samples_covered);
    assert_int_equal(half.samples_covered, all.samples_covered);
    assert_true(half.samples_passed > 0 && half.samples_passed < all.samples_passed);
    assert_int_equal(none.samples_covered, all.samples_covered);
    assert_int_equal(none.samples_passed, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_by_hand),
        cmocka_unit_test(vertices_that_are_not_finite),
        cmocka_unit_test(lines_points_and_outlines_by_hand),
        cmocka_unit_test(lines_and_points_that_are_not_finite),
        cmocka_unit_test(nothing_is_drawn_far_away),
        cmocka_unit_test(faults_count_nothing),
        cmocka_unit_test(rejected_samples_are_covered),
    };

    return cmocka_run_group_tests_name("statistics", tests, NULL, NULL);
}
