/* Lines from pixel to pixel, drawn as gnomon/draw.h describes: every joint and every start is
 * drawn, each pixel of a line once; which pixels they are; and the effect of the width. */
#include <math.h>
#include <stdlib.h>

#include "drawing.h"
#include "noise.h"

enum { LARGEST = 1000 };

/* The number of random strips: smaller where the sanitizer would make them take half a minute. */
#if defined(__SANITIZE_ADDRESS__)
#define STRIPS 10000
#else
#define STRIPS 100000
#endif

/* The vertices' distance below a pixel's centre, in x and y. */
#define SHORT 0x1p-10f

static uint32_t pixels[LARGEST * LARGEST];
static gn_target target;
static gn_pipeline pipeline;
static gn_color_uniforms uniforms;
static gn_backend backend; /* computed once, because that takes longer than a line */
static uint64_t drawn;     /* pixels, or samples, of one draw */
static int width, height;

static void clear(void)
{
    memset(pixels, 0, (size_t)(width * height) * sizeof *pixels);
}

static void set_canvas(int columns, int rows, gn_topology topology)
{
    gn_transform projection;

    backend = gn_backend_best();
    width = columns;
    height = rows;
    clear();
    target = (gn_target){
        {gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, (uint32_t)columns, (uint32_t)rows)}, {0}};
    assert_int_equal(gn_orthographic_rh_no(0, (float)columns, 0, (float)rows, -1, 1, &projection),
                     GN_OK);
    uniforms.clip_from_model = projection.matrix;
    pipeline = colored_pipeline(topology);
    pipeline.program.uniforms = &uniforms;
}

static void draw_at(const float *positions, uint32_t count)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3, GN_SHADER_VARYINGS)];
    const gn_mesh mesh = mesh_of(positions, 2, count);
    gn_workspace workspace = {
        .memory = memory, .size = sizeof memory, .backend = backend, .samples_passed = &drawn};

    drawn = 0;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
}

typedef struct place {
    int x, y;
} place;

/* Draws lines whose ends are up to three pixels. */
static void draw_between(const place *p, uint32_t count)
{
    float positions[6];

    for (uint32_t i = 0; i < count; ++i) {
        positions[2 * i] = (float)p[i].x + 0.5f - SHORT;
        positions[2 * i + 1] = (float)p[i].y + 0.5f - SHORT;
    }
    draw_at(positions, count);
}

static uint32_t *pixel(place p)
{
    return &pixels[p.y * width + p.x];
}

static bool is_x_major(place a, place b)
{
    return abs(a.x - b.x) >= abs(a.y - b.y);
}

/* The number of the line's pixels: columns if it is long along x, rows if it is long along y. */
static int steps_between(place a, place b)
{
    return is_x_major(a, b) ? abs(a.x - b.x) : abs(a.y - b.y);
}

/* The pixel nearest to the line after `step` steps. Of two that are equally near, a line that is
 * longer along y has the left one; any other line has the upper one if it rises and the lower one
 * if it falls. */
static place nearest_pixel(place a, place b, int step)
{
    const int n = steps_between(a, b), dx = b.x - a.x, dy = b.y - a.y;
    const bool x_major = is_x_major(a, b);
    const int upwards = x_major && (dx > 0) == (dy > 0) ? 1 : -1;
    const double across = (double)step * (x_major ? dy : dx) / n;
    const int nearest = (int)(upwards > 0 ? floor(across + 0.5) : ceil(across - 0.5));
    const place p = {a.x + (x_major ? (dx > 0 ? step : -step) : nearest),
                     a.y + (x_major ? nearest : (dy > 0 ? step : -step))};

    return p;
}

/* Draws the line, clears its pixels, and asserts that it has one pixel for every step except the
 * last, from its first end on, each within `bound` of the exact line. Returns true if all are
 * nearest_pixel's. */
static bool is_line(place a, place b, double bound)
{
    const place ends[2] = {a, b};
    const int n = steps_between(a, b);
    bool all_nearest = true;
    uint64_t found = 0;

    draw_between(ends, 2);
    assert_int_equal(drawn, n);
    assert_true(n == 0 || *pixel(a));
    for (int step = 0; step < n; ++step) {
        const place p = nearest_pixel(a, b, step);
        const double exact = (double)step * (is_x_major(a, b) ? b.y - a.y : b.x - a.x) / n;

        all_nearest = all_nearest && *pixel(p);
        for (int side = -1; side <= 1; ++side) {
            const place q = is_x_major(a, b) ? (place){p.x, p.y + side} : (place){p.x + side, p.y};
            const int across = is_x_major(a, b) ? q.y - a.y : q.x - a.x;

            if (q.x >= 0 && q.x < width && q.y >= 0 && q.y < height && *pixel(q)) {
                assert_true(fabs(across - exact) <= bound);
                *pixel(q) = 0;
                ++found;
            }
        }
    }
    assert_int_equal(found, n);
    return all_nearest;
}

/* Whether the line leads to the right, or up if it is longer along y. */
static bool is_ascending(place a, place b)
{
    return is_x_major(a, b) ? a.x < b.x : a.y < b.y;
}

static place random_place(uint32_t *seed)
{
    place p;

    p.x = (int)(noise(seed) * (float)width);
    p.y = (int)(noise(seed) * (float)height);
    return p;
}

static void all_lines_of_a_grid(void **state)
{
    enum { SIDE = 16 };

    set_canvas(SIDE, SIDE, GN_LINES);
    for (int i = 0; i < SIDE * SIDE * SIDE * SIDE; ++i) {
        const place a = {i % SIDE, i / SIDE % SIDE};
        const place b = {i / (SIDE * SIDE) % SIDE, i / (SIDE * SIDE * SIDE)};
        const bool is_nearest = is_line(a, b, 0.5);

        assert_true(is_nearest || !is_ascending(a, b));
    }
}

/* A target whose sides are not powers of two, so that transforms round. */
static void long_lines(void **state)
{
    uint32_t seed = 1;

    set_canvas(LARGEST, LARGEST - 1, GN_LINES);
    for (int i = 0; i < 2000; ++i) {
        const place a = random_place(&seed), b = random_place(&seed);

        if (is_ascending(a, b))
            assert_true(is_line(a, b, 0.5));
        else
            is_line(a, b, 0.5 + 0x1p-8);
    }
}

static void strips_have_starts_and_joints(void **state)
{
    uint32_t seed = 1;

    set_canvas(100, 75, GN_LINE_STRIP);
    for (int i = 0; i < STRIPS; ++i) {
        place p[3];

        for (int end = 0; end < 3; ++end)
            p[end] = random_place(&seed);
        const int first = steps_between(p[0], p[1]), second = steps_between(p[1], p[2]);

        draw_between(p, 3);
        assert_int_equal(drawn, first + second);
        assert_true(first == 0 || *pixel(p[0]));
        assert_true(second == 0 || *pixel(p[1]));
        clear();
    }
}

/* Larger points are drawn with the largest size. */
static void the_largest_point(void **state)
{
    static const float middle[2] = {150, 150};
    static const float sizes[] = {GN_MAX_POINT_SIZE, 257, 1e30f};

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        set_canvas(300, 300, GN_POINTS);
        pipeline.raster.point_size = sizes[i];
        draw_at(middle, 1);
        assert_int_equal(drawn, 256 * 256);
    }
}

/* Bit i: the line has pixels in column i, or in row i if it is longer along y. */
static uint32_t places_along(const float ends[4], bool x_major)
{
    uint32_t along = 0;

    draw_at(ends, 2);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            along |= pixels[y * width + x] ? 1u << (x_major ? x : y) : 0;
    clear();
    return along;
}

/* Every line between quarter pixels of three pixels each way. The width changes nothing along the
 * line, since its diamonds are those of the line itself. OpenGL would first shift lines of even
 * width by half a pixel. */
static void widths_do_not_move_ends(void **state)
{
    enum { QUARTERS = 12 };

    set_canvas(8, 8, GN_LINES);
    for (int i = 0; i < QUARTERS * QUARTERS * QUARTERS * QUARTERS; ++i) {
        float ends[4];
        uint32_t thin = 0;

        for (int n = 0, rest = i; n < 4; ++n, rest /= QUARTERS)
            ends[n] = 2.0f + (float)(rest % QUARTERS) * 0.25f;
        const bool x_major = fabsf(ends[0] - ends[2]) >= fabsf(ends[1] - ends[3]);

        for (int line_width = 1; line_width <= 3; ++line_width) {
            pipeline.raster.line_width = (float)line_width;
            const uint32_t along = places_along(ends, x_major);

            if (line_width == 1)
                thin = along;
            assert_int_equal(along, thin);
        }
    }
}

/* A level line along the side between two rows, eight pixels long. Samples lie 1, 3, 5 and 7
 * eighths above a pixel's lower side. The line owns samples on its lower side. */
static void widths_are_rounded_without_samples(void **state)
{
    static const float ends[4] = {0.0f, 4.0f, 8.0f, 4.0f};
    static const struct {
        float width;
        uint64_t pixels, samples;
    } cases[] = {{0.25f, 1, 4}, {1.25f, 1, 5}, {1.5f, 2, 6}, {2.5f, 2, 10}, {3.5f, 4, 14}};

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        set_canvas(8, 8, GN_LINES);
        pipeline.raster.line_width = cases[i].width;
        draw_at(ends, 2);
        assert_int_equal(drawn, 8 * cases[i].pixels);
        make_multisampled(&target);
        draw_at(ends, 2);
        assert_int_equal(drawn, 8 * cases[i].samples);
    }
}

/* The squares of these lengths are 0, or are no normal floats. */
static void the_shortest_lines_draw_nothing(void **state)
{
    static const float ends[][4] = {{0, 0, 0x1p-80f, 0},        {0, 0, 0, -0x1p-80f},
                                    {0, 0, 0x1p-149f, 0},       {0, 0, -0x1p-90f, 0x1p-78f},
                                    {0, 0, 0x1p-68f, 0x1p-69f}, {0x1p-75f, 0, 0, 0}};

    set_canvas(8, 8, GN_LINES);
    pipeline.raster.viewport =
        (gn_viewport){.enabled = true, .x = -4, .y = -4, .width = 8, .height = 8};
    pipeline.raster.line_width = 3.0f;
    gn_mat4_identity(&uniforms.clip_from_model); /* but NDC 0 is window 0 */
    for (int sampled = 0; sampled < 2; ++sampled) {
        for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i) {
            draw_at(ends[i], 2);
            assert_int_equal(drawn, 0);
        }
        make_multisampled(&target);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_lines_of_a_grid),
        cmocka_unit_test(long_lines),
        cmocka_unit_test(strips_have_starts_and_joints),
        cmocka_unit_test(the_largest_point),
        cmocka_unit_test(widths_do_not_move_ends),
        cmocka_unit_test(widths_are_rounded_without_samples),
        cmocka_unit_test(the_shortest_lines_draw_nothing),
    };
    return cmocka_run_group_tests_name("lines", tests, NULL, NULL);
}
