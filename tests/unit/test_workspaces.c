/* Workspaces of every size: a draw in tasks gives the same pixels in each, and writes nothing
 * behind it. A line loop has one element more than vertices: its first vertex again, which needs
 * room too. A GN_BASIC library draws the triangles, over any number of lanes. */
#include <stdlib.h>
#include <string.h>

#include "backwards.h"
#include "noise.h"
#include "unit.h"

enum {
    SIZE = 4,
    FAN_SIZE = 32,
    VARYINGS = 4,
    /* More vertices than a segment has. They can fill the memory to the last: it holds a multiple
     * of 16. */
    COUNT = 4096 + 128,
    BEHIND = 1024 /* bytes */
};

static float position[COUNT][3], color[COUNT][4];
static unsigned char *memory;

/* Most vertices lie beyond the far plane, which is quick. The first and the last ones do not. */
static void make_vertices(void)
{
    uint32_t seed = 1;

    for (int i = 0; i < COUNT; ++i) {
        for (int c = 0; c < 3; ++c)
            position[i][c] = 2.25f * noise(&seed) - 1.125f;
        if ((i + 2) % 32 >= 4)
            position[i][2] = 2.0f;
        for (int c = 0; c < 4; ++c)
            color[i][c] = noise(&seed);
    }
}

/* Draws in a workspace of `size` bytes. */
static void draw(uint32_t *pixels, gn_topology topology, size_t size)
{
    static gn_color_uniforms uniforms;
    gn_target target = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, SIZE, SIZE)}, {0}};
    gn_pipeline pipeline = {.raster.topology = topology};
    gn_mesh mesh = {.vertex_count = COUNT, .count = COUNT};
    gn_workspace workspace = {
        .memory = memory, .size = size, .parallel = run_backwards, .threads = 2};

    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position[0], .components = 3};
    mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){.data = color[0], .components = 4};
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &uniforms), GN_OK);
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    memset(memory + size, 0xA5, BEHIND);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    for (int i = 0; i < BEHIND; ++i)
        if (memory[size + i] != 0xA5)
            fail_msg("topology %d, %zu bytes: byte %d behind the workspace is written",
                     (int)topology, size, i);
}

/* Draws in workspaces from the smallest to one that holds all vertices and tasks. Each holds
 * `vertices` vertices more than the one before. */
static void draw_in_all(gn_topology topology, uint32_t vertices)
{
    const size_t most = gn_workspace_size_parallel(COUNT, COUNT, VARYINGS);
    const size_t step =
        gn_workspace_size(COUNT + vertices, VARYINGS) - gn_workspace_size(COUNT, VARYINGS);
    static const uint32_t cleared[SIZE * SIZE];
    uint32_t expected[SIZE * SIZE], pixels[SIZE * SIZE];

    make_vertices();
    memory = malloc(most + BEHIND);
    assert_non_null(memory);
    draw(expected, topology, most);
    assert_memory_not_equal(expected, cleared, sizeof expected);
    for (size_t size = gn_workspace_size(0, VARYINGS); size < most; size += step) {
        draw(pixels, topology, size);
        if (memcmp(pixels, expected, sizeof pixels) != 0)
            fail_msg("topology %d: other pixels in %zu bytes", (int)topology, size);
    }
    free(memory);
}

#if defined(GN_BASIC)
static const gn_topology last = GN_TRIANGLE_FAN;
#else
static const gn_topology last = GN_LINE_STRIP;

static void line_loops(void **state)
{
    (void)state;
    draw_in_all(GN_LINE_LOOP, 16);
}
#endif

static void other_topologies(void **state)
{
    (void)state;
    for (int topology = GN_TRIANGLES; topology <= (int)last; ++topology)
        draw_in_all((gn_topology)topology, 16 * 20);
}

/* Draws a fan of four vertices in a workspace of `size` bytes; the first one provokes. */
static void draw_fan(float pixels[FAN_SIZE * FAN_SIZE * 4], const float fan[4][4], size_t size)
{
    static gn_color_uniforms uniforms;
    gn_target target = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA32F, FAN_SIZE, FAN_SIZE)}, {0}};
    gn_pipeline pipeline = {.raster.topology = GN_TRIANGLE_FAN};
    gn_mesh mesh = {.vertex_count = 4, .count = 4};
    gn_workspace workspace = {.memory = memory, .size = size};

    pipeline.raster.provoking_vertex = GN_PROVOKING_FIRST;
    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = fan[0], .components = 4};
    mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){.data = color[0], .components = 4};
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &uniforms), GN_OK);
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
}

/* How a fan of four is made of triangles depends on all of its vertices. The least workspace of one
 * lane holds three of them. The fourth one is outside, or inside. */
static void fans_of_four(void **state)
{
    static const float corner[4][2] = {{-0.7f, -0.7f}, {0.7f, -0.7f}, {0.7f, 0.7f}, {-0.5f, 0.5f}};
    static float least[FAN_SIZE * FAN_SIZE * 4], larger[FAN_SIZE * FAN_SIZE * 4];
    const size_t most = gn_workspace_size(4, VARYINGS);
    uint32_t seed = 1;

    (void)state;
    make_vertices();
    memory = malloc(most);
    assert_non_null(memory);
    for (int n = 0; n < 20; ++n) {
        float fan[4][4];

        for (int v = 0; v < 4; ++v) {
            const float w = 0.5f + noise(&seed);

            for (int c = 0; c < 2; ++c)
                fan[v][c] = (corner[v][c] + (v == 3 && n % 2 ? (float)c : 0.0f)) * w;
            fan[v][2] = 0.0f;
            fan[v][3] = w;
        }
        draw_fan(larger, (const float(*)[4])fan, most);
        draw_fan(least, (const float(*)[4])fan, gn_workspace_size(0, VARYINGS));
        assert_memory_equal(least, larger, sizeof larger);
    }
    free(memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
#if !defined(GN_BASIC)
        cmocka_unit_test(line_loops),
#endif
        cmocka_unit_test(other_topologies),
        cmocka_unit_test(fans_of_four),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
