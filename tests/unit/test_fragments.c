/* What fragment shaders get and give: every pixel once and at its place, whatever triangle, target
 * and back end; point coordinates; derivatives. */
#include <math.h>
#include <stdlib.h>

#include "canvas.h"
#include "noise.h"

enum { SIDE = 200 };

static uint8_t times_shaded[SIDE][SIDE];

/* Red and green are the lane's pixel. */
static void paint_places(const void *uniforms, const gn_fragment_input *input,
                         gn_fragment_output *output)
{
    (void)uniforms;
    assert_true(input->x[0] % 2 == 0 && input->x[1] % 2 == 0);
    assert_true(input->y[0] % 2 == 0 && input->y[1] % 2 == 0);
    for (int l = 0; l < GN_LANES; ++l) {
        const int32_t x = input->x[l / 8] + l % 4;
        const int32_t y = input->y[l / 8] + l / 4 % 2;

        output->color[0][l] = (float)x / 255.0f;
        output->color[1][l] = (float)y / 255.0f;
        output->color[2][l] = 0.0f;
        output->color[3][l] = 1.0f;
        if (input->coverage >> l & 1u)
            ++times_shaded[y][x];
    }
}

static void set_random_triangle(float positions[12], float size, uint32_t *seed)
{
    const float x = 2.0f * noise(seed) - 1.0f, y = 2.0f * noise(seed) - 1.0f;

    for (int v = 0; v < 12; v += 4) {
        positions[v] = x + size * (2.0f * noise(seed) - 1.0f);
        positions[v + 1] = y + size * (2.0f * noise(seed) - 1.0f);
        positions[v + 2] = 0.0f;
        positions[v + 3] = 1.0f;
    }
}

/* Draws on memory of the target's size, so that the sanitizers see accesses beyond. A called shader
 * gets packed pixels, the ready-made shader squares of pixels: both must draw the same pixels. */
static void compare_shaders(uint32_t width, uint32_t height)
{
    uint32_t *const squares = calloc(width * height, sizeof *squares);
    uint32_t *const packed = calloc(width * height, sizeof *packed);
    uint32_t *const depths = malloc(sizeof *depths * width * height);

    assert_true(squares && packed && depths);
    memset(times_shaded, 0, sizeof times_shaded);
    for (int shader = 0; shader < 2; ++shader) {
        c.target.color[0] =
            gn_surface_bottom_up(shader ? packed : squares, GN_FORMAT_RGBA8, width, height);
        if (c.pipeline.depth.test_enabled) {
            c.target.depth = gn_surface_bottom_up(depths, GN_FORMAT_D24, width, height);
            assert_int_equal(gn_clear_depth(&c.target.depth, 1.0f), GN_OK);
        }
        if (shader)
            c.pipeline.program.fragment_shader = paint_places;
        assert_int_equal(draw(), GN_OK);
    }
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const bool is_drawn = squares[y * width + x] != 0;

            if (packed[y * width + x] != (is_drawn ? 0xFF000000u + (y << 8 | x) : 0) ||
                times_shaded[y][x] != is_drawn)
                fail_msg("%u x %u: pixel (%u, %u) is %x, shaded %d times", width, height, x, y,
                         packed[y * width + x], times_shaded[y][x]);
        }
    free(squares);
    free(packed);
    free(depths);
}

/* Sizes are odd too, and blocks of small triangles reach over the edges. */
static void a_shader_gets_each_pixel_once(void **state)
{
    static const float sizes[] = {0.02f, 0.1f, 0.3f, 0.55f, 0.6f, 0.65f, 1.0f, 3.0f, 40.0f};
    uint32_t seed = 1;
    gn_backend backend = GN_BACKEND_AUTO;

    for (uint32_t i = 0; i < 5000; ++i) {
        const bool is_large = i % 5 == 0;
        float positions[12];

        set_random_triangle(positions, sizes[i % 9], &seed);
        reset(positions, 3, GN_TRIANGLES);
        c.workspace.backend = backend;
        if (i % 9 == 8)
            backend = backend_after(backend) % GN_BACKEND_COUNT;
        c.target.depth.format = GN_FORMAT_NONE;
        c.pipeline.depth.test_enabled = i % 2;
        c.pipeline.raster.scissor =
            (gn_scissor){i % 4 == 1, (int32_t)(seed >> 9) % SIDE, (int32_t)(seed >> 20) % SIDE,
                         1 + i * 7 % 90, 1 + i * 5 % 70};
        compare_shaders(is_large ? SIDE : 1 + i % 37, is_large ? SIDE : 1 + i % 31);
    }
}

/* Blocks hang over a surface of one row, whose stride nothing limits. */
static void the_stride_of_one_row_is_free(void **state)
{
    static const ptrdiff_t strides[] = {PTRDIFF_MAX - 3, PTRDIFF_MIN, PTRDIFF_MIN / 2, 0};

    for (size_t i = 0; i < sizeof strides / sizeof *strides; ++i)
        for (gn_backend b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; b = backend_after(b)) {
            reset(square, 4, GN_TRIANGLE_STRIP);
            c.target.color[0].height = c.target.depth.height = 1;
            c.target.color[0].row_stride = c.target.depth.row_stride = strides[i];
            c.pipeline.depth.test_enabled = true;
            c.workspace.backend = b;
            assert_int_equal(drawn(), SIZE);
        }
}

static gn_vec4 shown[GN_SAMPLES * SIZE * SIZE];

/* Point coordinates as red and green; red is 7 if there are none. */
static void show_point_coordinate(const void *uniforms, const gn_fragment_input *in,
                                  gn_fragment_output *out)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l) {
        out->color[0][l] = in->point_coordinate ? in->point_coordinate[0][l] : 7.0f;
        out->color[1][l] = in->point_coordinate ? in->point_coordinate[1][l] : 7.0f;
        out->color[2][l] = out->color[3][l] = 1.0f;
    }
}

static void reset_shown(const float *positions, uint32_t count, gn_topology topology)
{
    reset(positions, count, topology);
    memset(shown, 0, sizeof shown);
    c.target.color[0] = gn_surface_bottom_up(shown, GN_FORMAT_RGBA32F, SIZE, SIZE);
    c.target.depth.format = GN_FORMAT_NONE;
    c.pipeline.program.fragment_shader = show_point_coordinate;
}

/* OpenGL 4.5 section 14.4.1: s = 1/2 + (x_f + 1/2 - x_w) / size, whatever the samples are. */
static void point_coordinates_follow_their_formula(void **state)
{
    /* At (5, 3), w = 2 and (2, 2), w = 1. */
    static const float places[2][4] = {{0.5f, -0.5f, 0, 2}, {-0.5f, -0.5f, 0, 1}};
    static const float centre[2][2] = {{5, 3}, {2, 2}};

    for (int n = 0; n < 8; ++n) {
        const int p = n % 2, origin = n / 2 % 2;
        gn_vec4 resolved[SIZE * SIZE];
        const gn_surface to = gn_surface_bottom_up(resolved, GN_FORMAT_RGBA32F, SIZE, SIZE);
        int count = 0;

        reset_shown(places[p], 1, GN_POINTS);
        if (n >= 4)
            make_multisampled(&c.target);
        c.pipeline.raster.point_size = 4.0f;
        c.pipeline.raster.point_origin = (gn_point_origin)origin;
        c.pipeline.program.fragment_reads_point_coordinate = true;
        assert_int_equal(draw(), GN_OK);
        memcpy(resolved, shown, sizeof resolved);
        if (n >= 4)
            assert_int_equal(gn_resolve(&to, &c.target.color[0]), GN_OK);
        for (int i = 0; i < SIZE * SIZE; ++i) {
            const float s = 0.5f + ((float)(i % SIZE) + 0.5f - centre[p][0]) / 4.0f;
            const float up = 0.5f + ((float)(i / SIZE) + 0.5f - centre[p][1]) / 4.0f;

            if (resolved[i].w == 0.0f)
                continue;
            ++count;
            assert_float_equal(resolved[i].x, s, 1e-6f);
            assert_float_equal(resolved[i].y, origin == GN_POINT_LOWER_LEFT ? up : 1.0f - up,
                               1e-6f);
        }
        assert_int_equal(count, 16);
    }
}

static void point_coordinates_are_given_where_asked(void **state)
{
    static const gn_topology topologies[] = {GN_POINTS, GN_TRIANGLE_STRIP, GN_LINE_STRIP};
    static const float inner[16] = {-0.5f, -0.5f, 0, 1, 0.5f, -0.5f, 0, 1,
                                    -0.5f, 0.5f,  0, 1, 0.5f, 0.5f,  0, 1};

    for (int i = 0; i < 3; ++i) {
        int count = 0;

        reset_shown(inner, 4, topologies[i]);
        c.pipeline.program.fragment_reads_point_coordinate = i > 0;
        assert_int_equal(draw(), GN_OK);
        for (int p = 0; p < SIZE * SIZE; ++p) {
            const float expected = i > 0 ? 0.0f : 7.0f;

            count += shown[p].w != 0.0f;
            assert_true(shown[p].w == 0.0f || (shown[p].x == expected && shown[p].y == expected));
        }
        assert_true(count >= 4);
    }
}

/* Quads have their lower left corners at lanes 0, 2, 8 and 10. The results may be in place. */
static void derivatives_are_differences_in_quads(void **state)
{
    float value[GN_LANES], x[GN_LANES], y[GN_LANES], width[GN_LANES], own[3][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l)
        value[l] = own[0][l] = own[1][l] = own[2][l] = (float)(l * l * (l % 3 - 1));
    gn_derivative_x(value, x);
    gn_derivative_y(value, y);
    gn_derivative_width(value, width);
    for (int l = 0; l < GN_LANES; ++l) {
        const int column = l % 4, row = l / 4;
        const int left = row * 4 + column / 2 * 2;
        const int low = row / 2 * 8 + column;

        assert_true(x[l] == value[left + 1] - value[left]);
        assert_true(y[l] == value[low + 4] - value[low]);
        assert_true(width[l] == fabsf(x[l]) + fabsf(y[l]));
    }
    gn_derivative_x(own[0], own[0]);
    gn_derivative_y(own[1], own[1]);
    gn_derivative_width(own[2], own[2]);
    assert_memory_equal(own[0], x, sizeof x);
    assert_memory_equal(own[1], y, sizeof y);
    assert_memory_equal(own[2], width, sizeof width);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_shader_gets_each_pixel_once),
        cmocka_unit_test(the_stride_of_one_row_is_free),
        cmocka_unit_test(point_coordinates_follow_their_formula),
        cmocka_unit_test(point_coordinates_are_given_where_asked),
        cmocka_unit_test(derivatives_are_differences_in_quads),
    };
    return cmocka_run_group_tests_name("fragments", tests, NULL, NULL);
}
