/* Inputs of fragment shaders besides varyings, worked by hand; derivatives. */
#include <math.h>
#include <string.h>

#include "unit.h"

enum { SIZE = 16 };

typedef struct canvas {
    float color[SIZE * SIZE][4];
    gn_target target;
    gn_color_uniforms uniforms;
    gn_pipeline pipeline;
    gn_mesh mesh;
    unsigned char memory[GN_WORKSPACE_SIZE(16, GN_SHADER_VARYINGS)];
    gn_workspace workspace;
} canvas;

static canvas c;

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

/* Clears a canvas of 16x16 pixels, on which NDC x, y in -1..1 is 0..16 pixels. */
static void reset(const float *positions, uint32_t vertex_count, gn_topology topology)
{
    memset(&c, 0, sizeof c);
    c.target.color[0] = gn_surface_bottom_up(c.color, GN_FORMAT_RGBA32F, SIZE, SIZE);
    for (int i = 0; i < 4; ++i)
        c.uniforms.clip_from_model.m[i][i] = 1.0f;
    assert_int_equal(gn_use_vertex_color(&c.pipeline, &c.uniforms), GN_OK);
    c.pipeline.program.fragment_shader = show_point_coordinate;
    c.pipeline.raster.topology = topology;
    c.mesh.attribute[GN_ATTRIBUTE_POSITION].data = positions;
    c.mesh.attribute[GN_ATTRIBUTE_POSITION].components = 4;
    c.mesh.vertex_count = vertex_count;
    c.mesh.count = vertex_count;
    c.workspace.memory = c.memory;
    c.workspace.size = sizeof c.memory;
}

static gn_status draw(void)
{
    return gn_draw(&c.target, &c.pipeline, &c.mesh, &c.workspace);
}

/* OpenGL 4.5 section 14.4.1: s = 1/2 + (x_f + 1/2 - x_w) / size, whatever the samples are. */
static void point_coordinates_follow_their_formula(void **state)
{
    (void)state;
    static gn_vec4 samples[GN_SAMPLES * SIZE * SIZE];
    /* At (9, 6), w = 2 and (4, 4), w = 1. */
    static const float places[2][4] = {{0.25f, -0.5f, 0, 2}, {-0.5f, -0.5f, 0, 1}};
    static const float centre[2][2] = {{9, 6}, {4, 4}};

    for (int origin = 0; origin < 2; ++origin) {
        for (int n = 0; n < 4; ++n) {
            const int p = n / 2;
            const bool is_sampled = n % 2 > 0;
            int drawn = 0;

            reset(places[p], 1, GN_POINTS);
            const gn_surface resolved = c.target.color[0];
            if (is_sampled) {
                const gn_surface first =
                    gn_surface_bottom_up(samples, GN_FORMAT_RGBA32F, SIZE, SIZE);

                memset(samples, 0, sizeof samples);
                c.target.color[0] = gn_surface_multisampled(&first);
            }
            c.pipeline.raster.point_size = 4.0f;
            c.pipeline.raster.point_origin = (gn_point_origin)origin;
            c.pipeline.program.fragment_reads_point_coordinate = true;
            assert_int_equal(draw(), GN_OK);
            if (is_sampled)
                assert_int_equal(gn_resolve(&resolved, &c.target.color[0]), GN_OK);
            for (int i = 0; i < SIZE * SIZE; ++i) {
                const float s = 0.5f + ((float)(i % SIZE) + 0.5f - centre[p][0]) / 4.0f;
                const float up = 0.5f + ((float)(i / SIZE) + 0.5f - centre[p][1]) / 4.0f;

                if (c.color[i][3] == 0.0f)
                    continue;
                ++drawn;
                assert_float_equal(c.color[i][0], s, 1e-6f);
                assert_float_equal(c.color[i][1], origin == GN_POINT_LOWER_LEFT ? up : 1.0f - up,
                                   1e-6f);
            }
            assert_int_equal(drawn, 16);
        }
    }
}

static void point_coordinates_are_given_where_asked(void **state)
{
    (void)state;
    static const float square[16] = {-0.5f, -0.5f, 0, 1, 0.5f, -0.5f, 0, 1,
                                     -0.5f, 0.5f,  0, 1, 0.5f, 0.5f,  0, 1};
    static const gn_topology topologies[] = {GN_POINTS, GN_TRIANGLE_STRIP, GN_LINE_STRIP};

    for (int i = 0; i < 3; ++i) {
        int drawn = 0;

        reset(square, 4, topologies[i]);
        c.pipeline.program.fragment_reads_point_coordinate = i > 0;
        assert_int_equal(draw(), GN_OK);
        for (int p = 0; p < SIZE * SIZE; ++p) {
            if (c.color[p][3] == 0.0f)
                continue;
            ++drawn;
            assert_float_equal(c.color[p][0], i > 0 ? 0.0f : 7.0f, 0.0f);
            assert_float_equal(c.color[p][1], i > 0 ? 0.0f : 7.0f, 0.0f);
        }
        assert_true(drawn >= 4);
    }
}

static void an_origin_is_checked(void **state)
{
    (void)state;
    reset(NULL, 0, GN_POINTS);
    c.pipeline.raster.point_origin = (gn_point_origin)2;
    assert_int_equal(gn_pipeline_check(&c.pipeline, NULL), GN_INVALID_ENUM);
}

/* Quads have their lower left corners at lanes 0, 2, 8 and 10. */
static void derivatives_are_differences_in_quads(void **state)
{
    (void)state;
    float value[GN_LANES], x[GN_LANES], y[GN_LANES], width[GN_LANES];

    for (int l = 0; l < GN_LANES; ++l)
        value[l] = (float)(l * l * (l % 3 - 1));
    gn_derivative_x(value, x);
    gn_derivative_y(value, y);
    gn_derivative_width(value, width);
    for (int l = 0; l < GN_LANES; ++l) {
        const int column = l % 4, row = l / 4;
        const int left = row * 4 + column / 2 * 2;
        const int low = row / 2 * 8 + column;

        assert_float_equal(x[l], value[left + 1] - value[left], 0.0f);
        assert_float_equal(y[l], value[low + 4] - value[low], 0.0f);
        assert_float_equal(width[l], fabsf(x[l]) + fabsf(y[l]), 0.0f);
    }
    /* In place. */
    memcpy(width, value, sizeof value);
    gn_derivative_x(width, width);
    assert_memory_equal(width, x, sizeof x);
    memcpy(width, value, sizeof value);
    gn_derivative_y(width, width);
    assert_memory_equal(width, y, sizeof y);
    gn_derivative_width(value, x);
    gn_derivative_width(value, value);
    assert_memory_equal(value, x, sizeof x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(point_coordinates_follow_their_formula),
        cmocka_unit_test(point_coordinates_are_given_where_asked),
        cmocka_unit_test(an_origin_is_checked),
        cmocka_unit_test(derivatives_are_differences_in_quads),
    };
    return cmocka_run_group_tests_name("fragment inputs", tests, NULL, NULL);
}
