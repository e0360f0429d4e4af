/* The user's clip distances: triangles and lines end where a distance becomes negative, points are
 * drawn whole or not at all. */
#include <math.h>
#include <string.h>

#include "unit.h"

enum { SIZE = 8 };

/* Distance i of a vertex at (x, y) is a * x + b * y + c of plane i. The distances of vertex number
 * `broken`, counted from 0, are NaN. */
typedef struct planes {
    float plane[GN_MAX_CLIP_DISTANCES][3];
    uint32_t count;
    uint32_t broken;
} planes;

typedef struct canvas {
    uint32_t color[SIZE * SIZE];
    planes planes;
    gn_target target;
    gn_pipeline pipeline;
    gn_mesh mesh;
    unsigned char memory[GN_WORKSPACE_SIZE(16, 4 + GN_MAX_CLIP_DISTANCES)];
    gn_workspace workspace;
} canvas;

static canvas c;

static void shade_vertices(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    const planes *p = uniforms;

    for (int l = 0; l < GN_LANES; ++l) {
        const float x = in->attribute[0][0][l];
        const float y = in->attribute[0][1][l];

        for (int i = 0; i < 4; ++i)
            out->position[i][l] = in->attribute[0][i][l];
        out->varying[0][l] = x;
        out->varying[1][l] = y;
        for (uint32_t i = 0; i < p->count; ++i)
            out->clip_distance[i][l] =
                in->vertex_id[l] == p->broken
                    ? NAN
                    : p->plane[i][0] * x + p->plane[i][1] * y + p->plane[i][2];
    }
}

static void shade_fragments(const void *uniforms, const gn_fragment_input *in,
                            gn_fragment_output *out)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l) {
        out->color[0][l] = in->varying[0][l];
        out->color[1][l] = in->varying[1][l];
        out->color[2][l] = 1.0f;
        out->color[3][l] = 1.0f;
    }
}

static void reset(const float *positions, uint32_t vertex_count, gn_topology topology)
{
    memset(&c, 0, sizeof c);
    c.target.color[0] = gn_surface_bottom_up(c.color, GN_FORMAT_RGBA8, SIZE, SIZE);
    c.pipeline.program.vertex_shader = shade_vertices;
    c.pipeline.program.fragment_shader = shade_fragments;
    c.pipeline.program.uniforms = &c.planes;
    c.pipeline.program.varying_count = 2;
    c.pipeline.raster.topology = topology;
    c.planes.broken = UINT32_MAX;
    c.mesh.attribute[0].data = positions;
    c.mesh.attribute[0].components = 2;
    c.mesh.vertex_count = vertex_count;
    c.mesh.count = vertex_count;
    c.workspace.memory = c.memory;
    c.workspace.size = sizeof c.memory;
}

static void add_plane(float x, float y, float constant)
{
    float *const p = c.planes.plane[c.planes.count++];

    p[0] = x;
    p[1] = y;
    p[2] = constant;
    c.pipeline.program.clip_distance_count = c.planes.count;
}

/* Returns the number of pixels drawn. */
static int draw(void)
{
    int n = 0;

    memset(c.color, 0, sizeof c.color);
    assert_int_equal(gn_draw(&c.target, &c.pipeline, &c.mesh, &c.workspace), GN_OK);
    for (int i = 0; i < SIZE * SIZE; ++i)
        n += c.color[i] != 0;
    return n;
}

static bool pixel(int x, int y)
{
    return c.color[y * SIZE + x] != 0;
}

static const float square[8] = {-1, -1, 1, -1, -1, 1, 1, 1};

/* All eight distances make an octagon of the pixels whose centres are less than 3 pixels away from
 * the middle along x and y, and less than 4.25 along both together. */
static void assert_octagon(const float *positions, uint32_t vertex_count)
{
    int expected = 0;

    reset(positions, vertex_count, GN_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        const float sx = i & 1 ? 1.0f : -1.0f;
        const float sy = i & 2 ? 1.0f : -1.0f;

        add_plane(i & 1 ? sy : 0, i & 1 ? 0 : sy, 0.75f);
        add_plane(sx, sy, 1.0625f);
    }
    const int drawn = draw();
    for (int y = 0; y < SIZE; ++y) {
        for (int x = 0; x < SIZE; ++x) {
            const double dx = fabs(x + 0.5 - 4), dy = fabs(y + 0.5 - 4);
            const bool inside = dx < 3 && dy < 3 && dx + dy < 4.25;

            assert_int_equal(pixel(x, y), inside);
            expected += inside;
        }
    }
    assert_int_equal(drawn, expected);
}

/* All eight distances cut two triangles, or one that three sides of the view volume cut too: that
 * makes 22 new vertices, more than there are lanes. */
static void eight_planes_make_an_octagon(void **state)
{
    (void)state;
    static const float beyond[6] = {-3, -4, 5, -4, -3, 6};

    assert_octagon(square, 4);
    assert_octagon(beyond, 3);
}

static void triangles_end_at_planes(void **state)
{
    (void)state;
    reset(square, 4, GN_TRIANGLE_STRIP);
    assert_int_equal(draw(), 64);
    add_plane(1, 0, 0);
    assert_int_equal(draw(), 32);
    assert_true(pixel(4, 0) && !pixel(3, 0));
    add_plane(-1, 0, 0.5f);
    assert_int_equal(draw(), 16);
    add_plane(0, 1, 0.25f);
    add_plane(0, -1, 0.25f);
    assert_int_equal(draw(), 4);
    assert_true(pixel(4, 3) && pixel(5, 4));

    /* Clipping leaves the values of varyings as they are. */
    reset(square, 4, GN_TRIANGLE_STRIP);
    draw();
    const uint32_t whole = c.color[5 * SIZE + 6];
    add_plane(0.75f, 0.25f, 0);
    draw();
    assert_int_equal(c.color[5 * SIZE + 6], whole);
}

static void lines_end_at_planes(void **state)
{
    (void)state;
    static const float across[4] = {-0.984375f, 0.140625f, 0.984375f, 0.140625f};

    reset(across, 2, GN_LINES);
    assert_int_equal(draw(), 8);
    add_plane(1, 0, 0.5f);
    assert_int_equal(draw(), 6);
    assert_true(pixel(2, 4) && !pixel(1, 4));
    add_plane(-1, 0, 0.25f);
    assert_int_equal(draw(), 3);
    add_plane(0, -1, 0);
    assert_int_equal(draw(), 0);
}

static void points_are_whole_or_not_there(void **state)
{
    (void)state;
    static const float two[4] = {0.015625f, 0, -0.015625f, 0};

    reset(two, 2, GN_POINTS);
    c.pipeline.raster.point_size = 4.0f;
    c.mesh.count = 1;
    const int one = draw();
    assert_true(one == 16 && pixel(2, 4));
    c.mesh.count = 2;
    add_plane(1, 0, 0);
    assert_int_equal(draw(), one);
    add_plane(-1, 0, 0);
    assert_int_equal(draw(), 0);
}

static void what_is_not_finite_is_not_drawn(void **state)
{
    (void)state;
    reset(square, 3, GN_TRIANGLES);
    add_plane(0, 0, 1);
    assert_int_equal(draw(), 28);
    c.planes.broken = 1;
    assert_int_equal(draw(), 0);
    c.planes.broken = UINT32_MAX;
    c.planes.plane[0][2] = INFINITY;
    assert_int_equal(draw(), 0);
    c.pipeline.raster.topology = GN_LINES;
    c.planes.plane[0][2] = 1;
    c.planes.broken = 0;
    assert_int_equal(draw(), 0);

    static const float two[4] = {0.125f, 0.125f, 0.375f, 0.375f};
    reset(two, 2, GN_POINTS);
    add_plane(0, 0, 1);
    assert_int_equal(draw(), 2);
    c.planes.broken = 0;
    assert_int_equal(draw(), 1);
    assert_true(pixel(5, 5));
}

static void distances_take_workspace(void **state)
{
    (void)state;
    reset(square, 4, GN_TRIANGLE_STRIP);
    for (int i = 0; i < GN_MAX_CLIP_DISTANCES; ++i)
        add_plane(0, 0, 1);
    c.workspace.size = gn_workspace_size(0, 2 + GN_MAX_CLIP_DISTANCES);
    assert_int_equal(draw(), 64);
    c.workspace.size -= 1;
    assert_int_equal(gn_draw(&c.target, &c.pipeline, &c.mesh, &c.workspace),
                     GN_WORKSPACE_TOO_SMALL);
    assert_int_equal(c.workspace.needed, c.workspace.size + 1);
    c.pipeline.program.clip_distance_count = GN_MAX_CLIP_DISTANCES + 1;
    assert_int_equal(gn_draw(&c.target, &c.pipeline, &c.mesh, &c.workspace), GN_OUT_OF_RANGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_end_at_planes),
        cmocka_unit_test(eight_planes_make_an_octagon),
        cmocka_unit_test(lines_end_at_planes),
        cmocka_unit_test(points_are_whole_or_not_there),
        cmocka_unit_test(what_is_not_finite_is_not_drawn),
        cmocka_unit_test(distances_take_workspace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
