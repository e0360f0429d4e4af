/* Workspaces of every size: a draw in tasks gives the same pixels in each, and writes nothing
 * behind it. A line loop has one element more than vertices: its first vertex again, which needs
 * room too. A GN_BASIC library draws the triangles, over any number of lanes. */
#include <stdlib.h>

#include "backwards.h"
#include "drawing.h"
#include "noise.h"

enum {
    SIZE = 4,
    FAN_SIZE = 32,
    VARYINGS = 4,
    /* More vertices than a segment has. They can fill the memory to the last: it holds a multiple
     * of 16. */
    COUNT = 4096 + 128,
    BEHIND = 2048 /* bytes */
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

static gn_mesh many_vertices(void)
{
    gn_mesh mesh = mesh_of(position[0], 3, COUNT);

    make_vertices();
    mesh.attribute[GN_ATTRIBUTE_COLOR] = floats(color[0], 4);
    return mesh;
}

/* Draws in a workspace of `size` bytes. */
static void draw(uint32_t *pixels, gn_topology topology, const gn_mesh *mesh, size_t size)
{
    static const unsigned char behind[BEHIND];
    const gn_target target = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, SIZE, SIZE)}, {0}};
    const gn_pipeline pipeline = colored_pipeline(topology);
    gn_workspace workspace = {
        .memory = memory, .size = size, .parallel = run_backwards, .threads = 2};

    if (mesh->count == 4)
        workspace.backend = GN_BACKEND_PORTABLE;
    memset(pixels, 0, SIZE * SIZE * sizeof *pixels);
    memset(memory + size, 0, BEHIND);
    assert_int_equal(gn_draw(&target, &pipeline, mesh, &workspace), GN_OK);
    if (memcmp(memory + size, behind, BEHIND) != 0)
        fail_msg("topology %d: written behind %zu bytes", (int)topology, size);
}

/* Draws in workspaces from the smallest to one that holds all vertices and tasks, each `step` bytes
 * larger than the one before. */
static void draw_in_all(gn_topology topology, const gn_mesh *mesh, size_t step)
{
    const size_t most = gn_workspace_size_parallel(mesh->count, mesh->count, VARYINGS);
    static const uint32_t cleared[SIZE * SIZE];
    uint32_t expected[SIZE * SIZE], pixels[SIZE * SIZE];

    memory = malloc(most + BEHIND);
    assert_non_null(memory);
    draw(expected, topology, mesh, most);
    assert_memory_not_equal(expected, cleared, sizeof expected);
    for (size_t size = gn_workspace_size(0, VARYINGS); size < most; size += step) {
        draw(pixels, topology, mesh, size);
        if (memcmp(pixels, expected, sizeof pixels) != 0)
            fail_msg("topology %d: other pixels in %zu bytes", (int)topology, size);
    }
    free(memory);
}

/* Bytes for this many vertices more. */
static size_t step_of(uint32_t vertices)
{
    return gn_workspace_size(COUNT + vertices, VARYINGS) - gn_workspace_size(COUNT, VARYINGS);
}

/* Steps between sizes of workspaces, in bytes: every whole number of floats, or one in five where
 * the sanitizer would make that half a minute. The steps leave every remainder of a row of
 * lanes. */
#if defined(__SANITIZE_ADDRESS__)
#define SIZE_STEP 20
#else
#define SIZE_STEP 4
#endif

/* Some sizes leave hardly a byte besides the parts that are allotted first. */
static void few_vertices_in_steps_of_floats(void **state)
{
    static const uint8_t indices[4] = {0, 1, 2, 3};
    gn_mesh mesh = mesh_of(square, 4, 4);

    draw_in_all(GN_TRIANGLE_STRIP, &mesh, SIZE_STEP);
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT8;
    draw_in_all(GN_TRIANGLE_STRIP, &mesh, SIZE_STEP);
}

#if defined(GN_BASIC)
static const gn_topology last = GN_TRIANGLE_FAN;
#else
static const gn_topology last = GN_LINE_STRIP;

static void line_loops(void **state)
{
    const gn_mesh mesh = many_vertices();

    draw_in_all(GN_LINE_LOOP, &mesh, step_of(16));
}
#endif

static void other_topologies(void **state)
{
    const gn_mesh mesh = many_vertices();

    for (int topology = GN_TRIANGLES; topology <= (int)last; ++topology)
        draw_in_all((gn_topology)topology, &mesh, step_of(16 * 20));
}

/* Draws a fan of four vertices in a workspace of `size` bytes; the first one provokes. */
static void draw_fan(float pixels[FAN_SIZE * FAN_SIZE * 4], const float fan[4][4], size_t size)
{
    gn_target target = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA32F, FAN_SIZE, FAN_SIZE)}, {0}};
    gn_pipeline pipeline = colored_pipeline(GN_TRIANGLE_FAN);
    gn_mesh mesh = mesh_of(fan[0], 4, 4);
    gn_workspace workspace = {.memory = memory, .size = size};

    pipeline.raster.provoking_vertex = GN_PROVOKING_FIRST;
    mesh.attribute[GN_ATTRIBUTE_COLOR] = floats(color[0], 4);
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

static void sizes(void **state)
{
    static const uint32_t counts[] = {0, 1, 15, 16, 17, 1000, 100000};
    const uint32_t most = GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES;

    for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i)
        for (uint32_t v = 0; v <= most; v += 8) {
            assert_int_equal(gn_workspace_size(counts[i], v), GN_WORKSPACE_SIZE(counts[i], v));
            assert_true(gn_workspace_size(counts[i], v) >= gn_workspace_size(0, v));
        }
    assert_true(gn_workspace_size(3, most + 1) == SIZE_MAX);
    assert_true(gn_workspace_size_parallel(3, 1, most + 1) == SIZE_MAX);
    /* Rounds do not grow without end. */
    assert_true(gn_workspace_size_parallel(3, 100000, 4) ==
                gn_workspace_size_parallel(3, UINT32_MAX, 4));
    assert_true(gn_workspace_size_parallel(3, 1000, 4) < gn_workspace_size_parallel(3, 50000, 4));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
#if !defined(GN_BASIC)
        cmocka_unit_test(line_loops),
#endif
        cmocka_unit_test(other_topologies),
        cmocka_unit_test(few_vertices_in_steps_of_floats),
        cmocka_unit_test(fans_of_four),
        cmocka_unit_test(sizes),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
