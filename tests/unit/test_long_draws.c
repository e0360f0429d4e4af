/* Long draws: a draw of thousands of triangles keeps few of its vertices at a time, and draws what
 * its parts draw one after the other. Where its segments end: a sliver that only culling after
 * snapping keeps is drawn if no vertex of its segment is outside the view volume. The boundaries
 * are those measured of the reference (reference/RULES.md, 'From clip space to triangles'). */
#include <stdlib.h>

#include "backwards.h"
#include "drawing.h"
#include "noise.h"

/* Pixels a side: fewer where the sanitizer makes each one slow. The number of vertices is the
 * same. */
#if defined(__SANITIZE_ADDRESS__)
#define SIZE 48
#else
#define SIZE 96
#endif

enum {
    MOST = 9000,
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

static float position[MOST][4], color[VERTICES][4];
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
        position[i][3] = 1.0f;
        for (int c = 0; c < 4; ++c)
            color[i][c] = noise(&seed);
    }
}

/* Row n of an order of rows. */
static uint32_t row_of(int order, uint32_t n)
{
    switch (order) {
    case 1: /* backwards */
        return ROWS - 2 - n;
    case 2: /* every fiftieth row goes far back */
        return n % 50 == 49 ? n - 40 : n;
    case 3: /* scattered */
        return n * 7 % (ROWS - 1);
    case 4: /* the last row needs the first row's vertices */
        return n == ROWS - 2 ? 0 : n;
    default:
        return n;
    }
}

/* Quads row by row. */
static void make_indices(int order)
{
    count = 0;
    for (uint32_t n = 0; n < QUADS; ++n) {
        const uint32_t v = row_of(order, n / (ACROSS - 1)) * ACROSS + n % (ACROSS - 1);
        const uint32_t corner[6] = {v, v + 1, v + ACROSS, v + ACROSS, v + 1, v + ACROSS + 1};

        memcpy(indices + count, corner, sizeof corner);
        count += 6;
    }
}

static gn_mesh indexed_mesh(void)
{
    gn_mesh mesh = mesh_of(position[0], 4, VERTICES);

    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT32;
    mesh.count = count;
    return mesh;
}

/* Draws the elements in parts of `part` elements. */
static void draw_in_parts(const gn_target *target, const gn_pipeline *pipeline, gn_mesh mesh,
                          uint32_t part, gn_workspace *workspace)
{
    const uint32_t overlap = pipeline->raster.topology == GN_TRIANGLE_STRIP ? 2 : 0;

    for (mesh.first = 0; mesh.first + overlap < count; mesh.first += part) {
        const uint32_t rest = count - mesh.first;

        mesh.count = rest < part + overlap ? rest : part + overlap;
        assert_int_equal(gn_draw(target, pipeline, &mesh, workspace), GN_OK);
    }
}

static void draw_frame(frame *f, gn_topology topology, uint32_t part, gn_workspace *workspace)
{
    const gn_target target = {{gn_surface_bottom_up(f->color, GN_FORMAT_RGBA8, SIZE, SIZE)},
                              gn_surface_bottom_up(f->depth, GN_FORMAT_D24, SIZE, SIZE)};
    gn_pipeline pipeline = colored_pipeline(topology);
    gn_mesh mesh = indexed_mesh();

    pipeline.depth.test_enabled = true;
    mesh.attribute[GN_ATTRIBUTE_COLOR] = floats(color[0], 4);
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_clear_depth(&target.depth, 1), GN_OK);
    draw_in_parts(&target, &pipeline, mesh, part, workspace);
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
        draw_frame(&parts, topology, PART, &workspace);
        for (uint32_t n = 0; n < 2 * sizeof sizes / sizeof *sizes; ++n) {
            workspace.size = sizes[n / 2];
            workspace.parallel = n % 2 ? run_backwards : NULL;
            workspace.threads = n / 2;
            draw_frame(&whole, topology, count, &workspace);
            assert_memory_equal(&whole, &parts, sizeof whole);
        }
    }
    free(workspace.memory);
}

static void rows_in_any_order(void **state)
{
    make_vertices();
    for (int order = 4; order >= 0; --order) {
        make_indices(order);
        draw_both_ways(GN_TRIANGLES);
    }
    draw_both_ways(GN_TRIANGLE_STRIP);
}

/* Little is visible: some quads in every sixty-fourth row. Visible triangles wait for more, while
 * later vertices are shaded. */
static void few_triangles_are_seen(void **state)
{
    make_vertices();
    for (int i = 0; i < VERTICES; ++i)
        if (i / ACROSS % 64 > 1 || i % ACROSS > 4)
            position[i][2] = 3.0f;
    make_indices(0);
    draw_both_ways(GN_TRIANGLES);
}

/* Few vertices, each of them many times. The last ones are no whole row of lanes, and the draw
 * keeps nearly as many as its ring holds: the lanes behind the last one must overwrite none. */
static void few_vertices_many_times(void **state)
{
    uint32_t seed = 1;

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
            position[i + v][3] = 1.0f;
        }
    }
    position[VERTICES - 1][0] = 5.0f;
}

/* Every instance of a draw draws the same pixels if only the last part has a vertex outside. */
static void instances_are_alike(void **state)
{
    static frame f;
    static unsigned char memory[GN_WORKSPACE_SIZE(VERTICES, VARYINGS)];
    uint64_t passed = 0;
    gn_workspace workspace = {.size = sizeof memory, .memory = memory, .samples_passed = &passed};
    const gn_target target = {{gn_surface_bottom_up(f.color, GN_FORMAT_RGBA8, SIZE, SIZE)}, {0}};
    gn_pipeline pipeline = colored_pipeline(GN_TRIANGLES);
    gn_mesh mesh;

    make_slivers();
    for (count = 0; count < VERTICES; ++count)
        indices[count] = count;
    mesh = indexed_mesh();
    pipeline.raster.cull = GN_CULL_FRONT;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    const uint64_t once = passed;

    assert_true(once > 0);
    mesh.instance_count = 3;
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    assert_int_equal(passed, 4 * once);
}

static uint64_t shaded;

static void count_vertices(const void *uniforms, const gn_vertex_input *input,
                           gn_vertex_output *output)
{
    shaded += input->count;
    pass_positions(uniforms, input, output);
}

/* Draws depth alone in a workspace for 1024 vertices. Returns the samples that passed if all do;
 * others are not counted. */
static uint64_t draw_depth(frame *f, gn_compare function, uint32_t part)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(1024, 0)];
    uint64_t passed = 0;
    gn_workspace workspace = {.memory = memory,
                              .size = sizeof memory,
                              .samples_passed = function == GN_ALWAYS ? &passed : NULL};
    const gn_target target = {.depth = gn_surface_bottom_up(f->depth, GN_FORMAT_D24, SIZE, SIZE)};
    const gn_pipeline pipeline = {.depth = {.test_enabled = true, .function = function},
                                  .program.vertex_shader = count_vertices};

    shaded = 0;
    draw_in_parts(&target, &pipeline, indexed_mesh(), part, &workspace);
    return passed;
}

/* Little memory is enough to shade each vertex once if indices follow the vertices' order. */
static void few_vertices_are_kept(void **state)
{
    static frame f;

    make_vertices();
    make_indices(0);
    draw_depth(&f, GN_LESS, count);
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

    make_vertices();
    for (count = 0; count < BLOCKS * BLOCK_INDICES; ++count)
        indices[count] =
            count / BLOCK_INDICES * BLOCK_VERTICES + count % BLOCK_INDICES * 7919 % BLOCK_VERTICES;
    const uint64_t in_one = draw_depth(&whole, GN_ALWAYS, count);

    assert_int_equal(shaded, BLOCKS * BLOCK_VERTICES);
    assert_true(in_one > 0);
    assert_int_equal(draw_depth(&parts, GN_ALWAYS, PART), in_one);
    assert_memory_equal(&whole, &parts, sizeof whole);
}

/* How a draw is divided: one segment of all triangles up to `whole` elements, above that segments
 * of `step` triangles. */
typedef struct division {
    gn_topology topology;
    bool indexed;
    uint32_t whole, step;
} division;

static const division divisions[] = {
    {GN_TRIANGLES, false, 4096, 1365},      {GN_TRIANGLES, true, 1024, 341},
    {GN_TRIANGLE_STRIP, false, 4096, 4094}, {GN_TRIANGLE_STRIP, true, 1024, 1022},
    {GN_TRIANGLE_FAN, false, 4096, 1022},   {GN_TRIANGLE_FAN, true, 1024, 1022},
};

enum { SIDE = 16, GOAL = 5 * SIDE + 7 };

/* Places an element at a corner of the sliver. The corners are in steps of 1/256 pixel from the
 * centre of pixel (4, 4), on the way to the centre of pixel (7, 5). Snapped, the sliver is
 * counter-clockwise and contains the centre of pixel (7, 5); unsnapped, it is clockwise. */
static void place(uint32_t element, int corner)
{
    static const float sliver[3][2] = {{0.0f, 0.0f},
                                       {266.0f * 3.0f + 1.0f - 0.133f, 266.0f + 0.398f},
                                       {276.0f * 3.0f - 1.0f + 0.133f, 276.0f - 0.398f}};

    for (int i = 0; i < 2; ++i)
        position[element][i] = (4.5f + sliver[corner][i] / 256.0f) * (2.0f / SIDE) - 1.0f;
}

/* Puts the elements of one triangle at the sliver's corners and all other elements at the sliver's
 * first corner, so that no other triangle has an area. One of the other elements is outside the
 * view volume. In a strip's odd triangles the first two elements are exchanged. */
static void place_all(const division *d, uint32_t triangle, uint32_t outside)
{
    const uint32_t odd = d->topology == GN_TRIANGLE_STRIP ? triangle & 1 : 0;

    for (uint32_t i = 0; i < count; ++i) {
        place(i, 0);
        position[i][2] = i == outside ? 2.0f : 0.0f;
        position[i][3] = 1.0f;
    }
    if (d->topology == GN_TRIANGLES)
        triangle *= 3;
    if (d->topology != GN_TRIANGLE_FAN)
        place(triangle + odd, 0);
    place(triangle + 1 - odd, 1);
    place(triangle + 2, 2);
    if (d->topology == GN_TRIANGLE_STRIP) /* so that the next triangle has no area either */
        place(triangle + 3, 2);
}

/* Whether the sliver is drawn. Every back end and number of tasks must agree. */
static bool is_drawn(const division *d)
{
    static uint32_t pixels[SIDE * SIDE];
    static unsigned char memory[GN_WORKSPACE_SIZE(MOST, VARYINGS)];
    const gn_target target = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, SIDE, SIDE)}, {0}};
    gn_pipeline pipeline = colored_pipeline(d->topology);
    gn_mesh mesh = indexed_mesh();
    gn_workspace workspace = {.memory = memory};
    bool drawn = false;

    pipeline.raster.cull = GN_CULL_BACK;
    mesh.vertex_count = MOST;
    if (!d->indexed)
        mesh.index_format = GN_INDEX_NONE;
    for (int way = 0; way < 4; ++way) {
        workspace.size = way & 1 ? gn_workspace_size(0, VARYINGS) : sizeof memory;
        workspace.backend = way & 2 ? gn_backend_best() : GN_BACKEND_PORTABLE;
        memset(pixels, 0, sizeof pixels);
        assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
        if (way > 0 && drawn != (pixels[GOAL] != 0))
            fail_msg("topology %d, %u elements: way %d differs", (int)d->topology, count, way);
        drawn = pixels[GOAL] != 0;
    }
    return drawn;
}

/* Tests the sliver as a triangle of segment `segment`, with an outside vertex around the ends of
 * this segment, which has the triangles from `first` up to `end`. */
static void check_triangle(const division *d, uint32_t triangle, uint32_t first, uint32_t end)
{
    const uint32_t scale = d->topology == GN_TRIANGLES ? 3 : 1;
    const bool is_fan = d->topology == GN_TRIANGLE_FAN;
    /* The first vertex of a fan belongs to every segment. */
    const uint32_t low = scale * first + (is_fan && first > 0);
    const uint32_t high = scale * (end - 1) + 2;
    const uint32_t own = scale * triangle + is_fan;
    const uint32_t beside[] = {low - 1, low, high, high + 1};

    for (int i = 0; i < 4; ++i) {
        const uint32_t outside = beside[i];

        /* Not in the sliver, which would be clipped, and not the hub, which all slivers share. */
        if (outside >= count || (is_fan && outside == 0) || (outside >= own && outside <= own + 2))
            continue;
        place_all(d, triangle, outside);
        if (is_drawn(d) != (outside < low || outside > high))
            fail_msg("topology %d, indexed %d, %u elements: triangle %u, vertex %u outside",
                     (int)d->topology, (int)d->indexed, count, triangle, outside);
    }
}

static void segments_end_where_measured(void **state)
{
    for (uint32_t i = 0; i < MOST; ++i)
        indices[i] = i;
    for (size_t n = 0; n < sizeof divisions / sizeof *divisions; ++n) {
        const division *d = &divisions[n];
        const uint32_t scale = d->topology == GN_TRIANGLES ? 3 : 1;
        /* These include a known case: a fan in which a wrong division changes a pixel. */
        const uint32_t counts[] = {d->whole - 1, d->whole, d->whole + 1, d->whole + 2,
                                   d->whole + d->step * scale + 3};

        for (size_t k = 0; k < sizeof counts / sizeof *counts; ++k) {
            const uint32_t total = (counts[k] - 3) / scale + 1;
            const uint32_t step = counts[k] > d->whole ? d->step : total;

            count = counts[k];
            for (uint32_t first = 0; first < total; first += step) {
                const uint32_t end = first + step < total ? first + step : total;

                check_triangle(d, first, first, end);
                check_triangle(d, end - 1, first, end);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_in_any_order),           cmocka_unit_test(few_triangles_are_seen),
        cmocka_unit_test(few_vertices_many_times),     cmocka_unit_test(instances_are_alike),
        cmocka_unit_test(few_vertices_are_kept),       cmocka_unit_test(two_blocks_are_kept),
        cmocka_unit_test(segments_end_where_measured),
    };

    return cmocka_run_group_tests_name("long draws", tests, NULL, NULL);
}
