/* Long draws: a draw of thousands of triangles keeps few of its vertices at a time, and draws what
 * its parts draw one after the other. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "backwards.h"
#include "noise.h"
#include "unit.h"

/* Pixels a side: fewer where the sanitizer makes each one slow. The number of vertices is the
 * same. */
#if defined(__SANITIZE_ADDRESS__)
#define SIZE 48
#else
#define SIZE 96
#endif

enum {
    ACROSS = 30,
    ROWS = 100,
    VERTICES = ACROSS * ROWS,
    QUADS = (ACROSS - 1) * (ROWS - 1),
    VARYINGS = 4,
    PART = 510 /* elements, of whole quads */
};

typedef struct frame {
    uint32_t color[SIZE * SIZE], depth[SIZE * SIZE];
} frame;

static float position[VERTICES][3], color[VERTICES][4];
static uint32_t indices[6 * QUADS];
static uint32_t count;

/* A band wound up and down over the whole target, with its rows one over the other. */
static void make_vertices(void)
{
    uint32_t seed = 1;

    for (int i = 0; i < VERTICES; ++i) {
        const float across = (float)(i % ACROSS) / (ACROSS - 1), along = (float)(i / ACROSS) / ROWS;

        position[i][0] = 2.2f * across - 1.1f;
        position[i][1] = 2.0f * noise(&seed) - 1.0f;
        position[i][2] = along + 0.5f * noise(&seed) - 1.0f;
        for (int c = 0; c < 4; ++c)
            color[i][c] = noise(&seed);
    }
}

static void add_quad(uint32_t row, uint32_t column)
{
    const uint32_t v = row * ACROSS + column;
    const uint32_t corner[6] = {v, v + 1, v + ACROSS, v + ACROSS, v + 1, v + ACROSS + 1};

    memcpy(indices + count, corner, sizeof corner);
    count += 6;
}

/* Quads row by row, the rows in the order of `row_of`. */
static void make_indices(uint32_t (*row_of)(uint32_t n))
{
    count = 0;
    for (uint32_t n = 0; n < ROWS - 1; ++n)
        for (uint32_t x = 0; x < ACROSS - 1; ++x)
            add_quad(row_of(n), x);
}

static uint32_t in_order(uint32_t n)
{
    return n;
}

static uint32_t backwards(uint32_t n)
{
    return ROWS - 2 - n;
}

/* Every fiftieth quad goes far back. */
static uint32_t stepping_back(uint32_t n)
{
    return n % 50 == 49 ? n - 40 : n;
}

static uint32_t scattered(uint32_t n)
{
    return n * 7 % (ROWS - 1);
}

/* The last row needs the first row's vertices. */
static uint32_t closing(uint32_t n)
{
    return n == ROWS - 2 ? 0 : n;
}

/* Draws the elements in parts of `part` elements, in a workspace of that size. */
static void draw_in_parts(frame *f, gn_topology topology, uint32_t part, gn_workspace *workspace)
{
    static gn_color_uniforms uniforms;
    gn_target target = {{gn_surface_bottom_up(f->color, GN_FORMAT_RGBA8, SIZE, SIZE)},
                        gn_surface_bottom_up(f->depth, GN_FORMAT_D24, SIZE, SIZE)};
    gn_pipeline pipeline = {.depth.test = true, .raster.topology = topology};
    gn_mesh mesh = {.vertex_count = VERTICES, .indices = indices, .index_format = GN_INDEX_UINT32};
    const uint32_t overlap = topology == GN_TRIANGLE_STRIP ? 2 : 0;

    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position[0], .components = 3};
    mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){.data = color[0], .components = 4};
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &uniforms), GN_OK);
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_clear_depth(&target.depth, 1), GN_OK);
    for (mesh.first = 0; mesh.first + overlap < count; mesh.first += part) {
        const uint32_t rest = count - mesh.first;

        mesh.count = rest < part + overlap ? rest : part + overlap;
        assert_int_equal(gn_draw(&target, &pipeline, &mesh, workspace), GN_OK);
    }
}

/* Makes little visible: some quads in every sixty-fourth row. */
static void hide_most(void)
{
    for (int i = 0; i < VERTICES; ++i)
        if (i / ACROSS % 64 > 1 || i % ACROSS > 4)
            position[i][2] = 3.0f;
}

/* One draw, on one thread and in tasks, with much and little memory, draws what its parts draw. */
static void draw_both_ways(gn_topology topology)
{
    static frame parts, whole;
    const size_t sizes[] = {gn_workspace_size_parallel(VERTICES, 2 * QUADS, VARYINGS),
                            gn_workspace_size(VERTICES, VARYINGS),
                            gn_workspace_size(1024, VARYINGS), gn_workspace_size(0, VARYINGS)};
    gn_workspace workspace = {.size = sizes[0], .memory = malloc(sizes[0])};

    assert_non_null(workspace.memory);
    for (int best = 0; best < 2; ++best) {
        workspace.backend = best ? gn_backend_best() : GN_BACKEND_PORTABLE;
        workspace.size = sizes[0];
        workspace.parallel = NULL;
        draw_in_parts(&parts, topology, PART, &workspace);
        for (uint32_t n = 0; n < 2 * sizeof sizes / sizeof *sizes; ++n) {
            workspace.size = sizes[n / 2];
            workspace.parallel = n % 2 ? run_backwards : NULL;
            workspace.threads = n / 2;
            draw_in_parts(&whole, topology, count, &workspace);
            assert_memory_equal(&whole, &parts, sizeof whole);
        }
    }
    free(workspace.memory);
}

static void rows_in_any_order(void **state)
{
    static uint32_t (*const orders[])(uint32_t) = {in_order, backwards, stepping_back, scattered,
                                                   closing};

    (void)state;
    make_vertices();
    for (size_t n = 0; n < sizeof orders / sizeof *orders; ++n) {
        make_indices(orders[n]);
        draw_both_ways(GN_TRIANGLES);
    }
}

/* Visible triangles wait for more, while later vertices are shaded. */
static void few_triangles_are_seen(void **state)
{
    (void)state;
    make_vertices();
    hide_most();
    make_indices(in_order);
    draw_both_ways(GN_TRIANGLES);
}

/* Few vertices, each of them many times. The last ones are no whole row of lanes, and the draw
 * keeps nearly as many as its ring holds: the lanes behind the last one must overwrite none. */
static void few_vertices_many_times(void **state)
{
    uint32_t seed = 1;

    (void)state;
    make_vertices();
    count = 3072;
    for (uint32_t i = 0; i < count; ++i)
        indices[i] = i < 1024 ? i % 7 : i < 2048 ? 5 + i % 8 : 11 + i % 7;
    draw_both_ways(GN_TRIANGLES);
    for (uint32_t vertices = 17; vertices <= 200; vertices += 1 + vertices / 8)
        for (uint32_t near = 7; near < vertices; near = 2 * near + 1) {
            for (uint32_t i = 0; i < count; ++i)
                indices[i] = i * (vertices - near) / count + (uint32_t)(noise(&seed) * (float)near);
            draw_both_ways(vertices % 2 ? GN_TRIANGLES : GN_TRIANGLE_STRIP);
        }
}

static void strips(void **state)
{
    (void)state;
    make_vertices();
    make_indices(in_order);
    draw_both_ways(GN_TRIANGLE_STRIP);
}

/* Slivers through centres of pixels. Snapping changes the winding of many. Which of them are culled
 * depends on whether their part of the draw has vertices outside. */
static void make_slivers(void)
{
    uint32_t seed = 7;

    for (int i = 0; i < VERTICES; i += 3) {
        const float x = (float)(int)(noise(&seed) * (SIZE - 16) + 8.0f) + 0.5f;
        const float y = (float)(int)(noise(&seed) * (SIZE - 16) + 8.0f) + 0.5f;
        const float along_x = 8.0f * noise(&seed) - 4.0f, along_y = 8.0f * noise(&seed) - 4.0f;

        for (int v = 0; v < 3; ++v) {
            const float t = 2.0f * noise(&seed) - 1.0f;
            const float off_x = 0.006f * noise(&seed) - 0.003f;
            const float off_y = 0.006f * noise(&seed) - 0.003f;

            position[i + v][0] = (x + t * along_x + off_x) * (2.0f / SIZE) - 1.0f;
            position[i + v][1] = (y + t * along_y + off_y) * (2.0f / SIZE) - 1.0f;
            position[i + v][2] = 0.0f;
        }
    }
    position[VERTICES - 1][0] = 5.0f;
}

/* Every instance of a draw draws the same pixels if only the last part has a vertex outside. */
static void instances_are_alike(void **state)
{
    static frame f;
    static gn_color_uniforms uniforms;
    uint64_t passed = 0;
    const size_t size = gn_workspace_size(VERTICES, VARYINGS);
    gn_workspace workspace = {.size = size, .memory = malloc(size), .samples_passed = &passed};
    gn_target target = {{gn_surface_bottom_up(f.color, GN_FORMAT_RGBA8, SIZE, SIZE)}, {0}};
    gn_pipeline pipeline = {.raster.cull = GN_CULL_FRONT};
    gn_mesh mesh = {.vertex_count = VERTICES, .indices = indices, .index_format = GN_INDEX_UINT32};

    (void)state;
    assert_non_null(workspace.memory);
    make_slivers();
    for (count = 0; count < VERTICES; ++count)
        indices[count] = count;
    mesh.count = count;
    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position[0], .components = 3};
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &uniforms), GN_OK);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    const uint64_t once = passed;

    assert_true(once > 0);
    mesh.instance_count = 3;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    assert_int_equal(passed, 4 * once);
    free(workspace.memory);
}

/* Little memory is enough to shade each vertex once if indices follow the vertices' order. */
static uint64_t shaded;

static void count_vertices(const void *uniforms, const gn_vertex_input *input,
                           gn_vertex_output *output)
{
    (void)uniforms;
    shaded += input->count;
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            output->position[c][l] = c < 3 ? input->attribute[0][c][l] : 1.0f;
}

static void few_vertices_are_kept(void **state)
{
    static frame f;
    static unsigned char memory[GN_WORKSPACE_SIZE(1024, 0)];
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_target target = {.depth = gn_surface_bottom_up(f.depth, GN_FORMAT_D24, SIZE, SIZE)};
    gn_pipeline pipeline = {.depth.test = true, .program.vertex_shader = count_vertices};
    gn_mesh mesh = {.vertex_count = VERTICES, .indices = indices, .index_format = GN_INDEX_UINT32};

    (void)state;
    make_vertices();
    make_indices(in_order);
    mesh.count = count;
    mesh.attribute[0] = (gn_attribute){.data = position[0], .components = 3};
    shaded = 0;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    assert_int_equal(shaded, VERTICES);
}

/* Blocks of as many indices as the library finds ranges of. Each block has vertices of its own in
 * no order. The triangles of a step, some of which begin in the block before, need the vertices of
 * two blocks: more than 512, but not above the 1024 that memory is there for. The vertices of three
 * blocks would not fit. */
enum { BLOCKS = 6, BLOCK_INDICES = 1024, BLOCK_VERTICES = 480 };

static void two_blocks_are_kept(void **state)
{
    static frame whole, parts;
    static unsigned char memory[GN_WORKSPACE_SIZE(1024, 0)];
    uint64_t passed = 0;
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .samples_passed = &passed};
    gn_target target = {.depth = gn_surface_bottom_up(whole.depth, GN_FORMAT_D24, SIZE, SIZE)};
    gn_pipeline pipeline = {
        .depth.test = true, .depth.function = GN_ALWAYS, .program.vertex_shader = count_vertices};
    gn_mesh mesh = {.vertex_count = VERTICES, .indices = indices, .index_format = GN_INDEX_UINT32};

    (void)state;
    make_vertices();
    for (count = 0; count < BLOCKS * BLOCK_INDICES; ++count)
        indices[count] =
            count / BLOCK_INDICES * BLOCK_VERTICES + count % BLOCK_INDICES * 7919 % BLOCK_VERTICES;
    mesh.count = count;
    mesh.attribute[0] = (gn_attribute){.data = position[0], .components = 3};
    shaded = 0;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    assert_int_equal(shaded, BLOCKS * BLOCK_VERTICES);
    const uint64_t in_one = passed;

    passed = 0;
    target.depth = gn_surface_bottom_up(parts.depth, GN_FORMAT_D24, SIZE, SIZE);
    for (mesh.count = PART; mesh.first < count; mesh.first += PART) {
        mesh.count = count - mesh.first < PART ? count - mesh.first : PART;
        assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    }
    assert_true(in_one > 0);
    assert_int_equal(passed, in_one);
    assert_memory_equal(&whole, &parts, sizeof whole);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_in_any_order),       cmocka_unit_test(few_triangles_are_seen),
        cmocka_unit_test(few_vertices_many_times), cmocka_unit_test(strips),
        cmocka_unit_test(instances_are_alike),     cmocka_unit_test(few_vertices_are_kept),
        cmocka_unit_test(two_blocks_are_kept),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
