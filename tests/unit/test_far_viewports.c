/* Viewports as far away as may be, and vertices that are not finite: nothing is drawn, and the
 * counts say why. */
#include <math.h>
#include <string.h>

#include "unit.h"

enum { SIZE = 8 };

static unsigned char memory[GN_WORKSPACE_SIZE(16, 8)];
static uint32_t pixels[SIZE * SIZE * GN_SAMPLES];
static float position[6][4];

static void shade_with_distances(const void *none, const gn_vertex_input *input,
                                 gn_vertex_output *output)
{
    (void)none;
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 4; ++c)
            output->position[c][l] = input->attribute[0][c][l];
        output->clip_distance[0][l] = 1.0f;
    }
}

static void shade_red(const void *none, const gn_fragment_input *input, gn_fragment_output *output)
{
    (void)none;
    (void)input;
    for (int l = 0; l < GN_LANES; ++l)
        output->color[0][l] = 1.0f;
}

/* Draws and returns the counts. Nothing must be drawn. */
static gn_draw_statistics draw_nothing(gn_pipeline *p, bool sampled)
{
    gn_draw_statistics counts;
    uint64_t passed = 0;
    gn_target target;
    gn_mesh mesh = {.vertex_count = 6, .count = 6};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};

    memset(&counts, 0, sizeof counts);
    memset(&target, 0, sizeof target);
    memset(pixels, 0x5A, sizeof pixels);
    target.color[0] = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, SIZE, SIZE);
    if (sampled)
        target.color[0] = gn_surface_multisampled(&target.color[0]);
    p->program.vertex_shader = shade_with_distances;
    p->program.fragment_shader = shade_red;
    p->program.clip_distance_count = 1;
    mesh.attribute[0] = (gn_attribute){.data = position[0], .components = 4};
    workspace.samples_passed = &passed;
    workspace.statistics = &counts;
    assert_int_equal(gn_draw(&target, p, &mesh, &workspace), GN_OK);
    assert_int_equal(passed, 0);
    for (size_t i = 0; i < sizeof pixels / sizeof *pixels; ++i)
        assert_int_equal(pixels[i], 0x5A5A5A5A);
    workspace.statistics = NULL; /* another way through the library */
    assert_int_equal(gn_draw(&target, p, &mesh, &workspace), GN_OK);
    assert_int_equal(passed, 0);
    return counts;
}

static void set_positions(void)
{
    for (int i = 0; i < 6; ++i) {
        position[i][0] = i % 3 == 1 ? 0.5f : -0.5f;
        position[i][1] = i % 3 == 2 ? 0.5f : -0.5f;
        position[i][2] = 0.0f;
        position[i][3] = 1.0f;
    }
}

static void nothing_is_drawn_far_away(void **state)
{
    static const gn_topology topologies[] = {GN_POINTS, GN_LINES, GN_TRIANGLES};
    static const uint64_t primitives[] = {6, 3, 2};

    (void)state;
    set_positions();
    for (int t = 0; t < 3; ++t)
        for (int side = 0; side < 4; ++side)
            for (int sampled = 0; sampled < 2; ++sampled) {
                const float far = (float)(side % 2 ? GN_MAX_SIZE : -GN_MAX_SIZE);
                gn_draw_statistics counts;
                gn_pipeline p;

                memset(&p, 0, sizeof p);
                p.raster.topology = topologies[t];
                p.raster.viewport.set = true;
                p.raster.viewport.x = side < 2 ? far : 0.0f;
                p.raster.viewport.y = side < 2 ? 0.0f : far;
                p.raster.viewport.width = p.raster.viewport.height = SIZE;
                p.raster.line_width = 3.0f;
                p.raster.point_size = 3.0f;
                counts = draw_nothing(&p, sampled);
                assert_int_equal(counts.drawn, 0);
                assert_int_equal(counts.not_finite, 0);
                assert_int_equal(counts.missed, primitives[t]);
            }
}

static void vertices_that_are_not_finite(void **state)
{
    static const gn_topology topologies[] = {GN_POINTS, GN_LINES, GN_TRIANGLES};
    static const uint64_t primitives[] = {6, 3, 2};

    (void)state;
    for (int t = 0; t < 3; ++t)
        for (int component = 0; component < 4; ++component) {
            gn_draw_statistics counts;
            gn_pipeline p;

            set_positions();
            memset(&p, 0, sizeof p);
            p.raster.topology = topologies[t];
            for (int i = 0; i < 6; ++i)
                position[i][component] = NAN;
            counts = draw_nothing(&p, false);
            assert_int_equal(counts.not_finite, primitives[t]);
            assert_int_equal(counts.drawn, 0);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_drawn_far_away),
        cmocka_unit_test(vertices_that_are_not_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
