/* Points, lines, and triangles drawn as points or lines: small pictures worked by hand. */
#include "canvas.h"

static uint32_t pixel(int x, int y)
{
    return c.color[y * SIZE + x] != 0;
}

/* A point of 3 pixels about the centre of pixel (4, 2), and a point whose shader sets the size 2
 * about a corner of four pixels. */
static void points_are_squares(void **state)
{
    (void)state;
    static const float centre[4] = {0.125f, -0.375f, 0, 1};
    static const float outside[4] = {1.01f, 0, 0, 1};

    reset(centre, 1, GN_POINTS);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 1);
    assert_true(pixel(4, 2));
    c.pipeline.raster.point_size = 3.0f;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 9);
    assert_true(pixel(3, 1) && pixel(5, 3));

    /* A point whose centre is outside is not drawn, even if part of it is inside. */
    reset(outside, 1, GN_POINTS);
    c.pipeline.raster.point_size = 4.0f;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 0);
}

static void two_pixels_large(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l) {
        for (int i = 0; i < 4; ++i) {
            out->position[i][l] = in->attribute[GN_ATTRIBUTE_POSITION][i][l];
            out->varying[i][l] = 1.0f;
        }
        if (out->point_size)
            out->point_size[l] = 2.0f;
    }
}

static void shaders_give_point_sizes(void **state)
{
    (void)state;
    static const float corner[4] = {0, 0, 0, 1};

    reset(corner, 1, GN_POINTS);
    c.pipeline.program.vertex_shader = two_pixels_large;
    c.pipeline.raster.point_size = 5.0f;
    c.pipeline.program.vertex_writes_point_size = true;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 4);
    assert_true(pixel(3, 3) && pixel(4, 4));
    c.pipeline.program.vertex_writes_point_size = false;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 25);
}

/* A square near pixel centres (on them the reference loses one pixel, reference/RULES.md). A loop
 * draws every pixel of it, a strip ends before its last pixel, separate lines draw two sides. */
static void lines_leave_out_their_last_pixel(void **state)
{
    (void)state;
    static const float ends[16] = {-0.609375f, -0.609375f, 0, 1, 0.640625f,  -0.609375f, 0, 1,
                                   0.640625f,  0.640625f,  0, 1, -0.609375f, 0.640625f,  0, 1};

    reset(ends, 4, GN_LINE_LOOP);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 20);
    assert_true(pixel(1, 1) && pixel(6, 1) && pixel(6, 6) && pixel(1, 6) && !pixel(2, 2));
    reset(ends, 4, GN_LINE_STRIP);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 15);
    assert_false(pixel(1, 6));
    reset(ends, 4, GN_LINES);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 10);
    assert_true(!pixel(6, 1) && pixel(6, 6) && !pixel(6, 3));

    /* Three wide, the bottom side: rows 0 to 2. */
    reset(ends, 2, GN_LINES);
    c.pipeline.raster.line_width = 3.0f;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 15);
    assert_true(pixel(1, 0) && pixel(5, 2) && !pixel(6, 1) && !pixel(3, 3));
}

/* A triangle near pixel centres, from (1, 1) to (6, 1) and (1, 6): the front face as lines, the
 * back face as points, and clipped at the right, where the side of the view volume is no edge. */
static void triangles_have_outlines(void **state)
{
    (void)state;
    static const float front[12] = {-0.609375f, -0.609375f, 0,         1, 0.640625f, -0.609375f, 0,
                                    1,          -0.609375f, 0.640625f, 0, 1};
    static const float back[12] = {-0.609375f, -0.609375f, 0,          1, -0.609375f, 0.640625f, 0,
                                   1,          0.640625f,  -0.609375f, 0, 1};
    static const float across[12] = {-0.609375f, -0.609375f, 0,         1, 2.640625f, -0.609375f, 0,
                                     1,          -0.609375f, 0.640625f, 0, 1};

    reset(front, 3, GN_TRIANGLES);
    c.pipeline.raster.polygon_mode_front = GN_POLYGON_LINE;
    c.pipeline.raster.polygon_mode_back = GN_POLYGON_POINT;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 15);
    assert_true(pixel(1, 1) && pixel(6, 1) && pixel(1, 6) && !pixel(2, 2));

    reset(back, 3, GN_TRIANGLES);
    c.pipeline.raster.polygon_mode_front = GN_POLYGON_LINE;
    c.pipeline.raster.polygon_mode_back = GN_POLYGON_POINT;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 3);
    assert_true(pixel(1, 1) && pixel(6, 1) && pixel(1, 6));
    c.pipeline.raster.cull = GN_CULL_BACK;
    assert_int_equal(gn_clear_color(&c.target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(covered(), 0);

    reset(across, 3, GN_TRIANGLES);
    c.pipeline.raster.polygon_mode_front = GN_POLYGON_LINE;
    assert_int_equal(draw(), GN_OK);
    assert_true(pixel(7, 1) && !pixel(7, 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_squares),
        cmocka_unit_test(shaders_give_point_sizes),
        cmocka_unit_test(lines_leave_out_their_last_pixel),
        cmocka_unit_test(triangles_have_outlines),
    };
    return cmocka_run_group_tests_name("outlines", tests, NULL, NULL);
}
