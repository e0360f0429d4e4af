/* Segments of long draws: a sliver that only culling after snapping keeps is drawn if no vertex of
 * its segment is outside the view volume. The boundaries are those measured of the reference
 * (reference/RULES.md, 'From clip space to triangles'). */
#include <stdlib.h>

#include "unit.h"

enum { SIZE = 16, MOST = 9000, GOAL = 5 * SIZE + 7 };

/* Corners of the sliver in steps of 1/256 pixel from the centre of pixel (4, 4), on the way to the
 * centre of pixel (7, 5). Snapped, it is counter-clockwise and contains the centre of pixel (7, 5);
 * unsnapped, it is clockwise. */
static const float sliver[3][2] = {
    {0.0f, 0.0f},
    {266.0f * 3.0f + 1.0f - 0.133f, 266.0f + 0.398f},
    {276.0f * 3.0f - 1.0f + 0.133f, 276.0f - 0.398f},
};

static float position[MOST][4];
static uint16_t indices[MOST];

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

static void place(uint32_t element, int corner)
{
    for (int i = 0; i < 2; ++i)
        position[element][i] = (4.5f + sliver[corner][i] / 256.0f) * (2.0f / SIZE) - 1.0f;
}

/* Puts the elements of one triangle at the sliver's corners and all other elements at the sliver's
 * first corner, so that no other triangle has an area. One of the other elements is outside the
 * view volume. In a strip's odd triangles the first two elements are exchanged. */
static void place_all(const division *d, uint32_t count, uint32_t triangle, uint32_t outside)
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
static bool is_drawn(const division *d, uint32_t count)
{
    static uint32_t color[SIZE * SIZE];
    static gn_color_uniforms uniforms;
    static unsigned char memory[GN_WORKSPACE_SIZE(MOST, GN_SHADER_VARYINGS)];
    gn_target target = {{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, SIZE, SIZE)}, {0}};
    gn_pipeline pipeline = {.raster.topology = d->topology, .raster.cull = GN_CULL_BACK};
    gn_mesh mesh = {.vertex_count = MOST, .count = count};
    gn_workspace workspace = {.memory = memory, .backend = GN_BACKEND_PORTABLE};
    bool drawn = false;

    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position[0], .components = 4};
    if (d->indexed) {
        mesh.indices = indices;
        mesh.index_format = GN_INDEX_UINT16;
    }
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&pipeline, &uniforms), GN_OK);
    for (int way = 0; way < 4; ++way) {
        workspace.size = way & 1 ? gn_workspace_size(0, GN_SHADER_VARYINGS) : sizeof memory;
        workspace.backend = way & 2 ? gn_backend_best() : GN_BACKEND_PORTABLE;
        assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
        assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
        if (way > 0 && drawn != (color[GOAL] != 0))
            fail_msg("topology %d, %u elements: way %d differs", (int)d->topology, count, way);
        drawn = color[GOAL] != 0;
    }
    return drawn;
}

/* Tests the sliver as a triangle of segment `segment`, with an outside vertex around the ends of
 * this segment. */
static void check_triangle(const division *d, uint32_t count, uint32_t step, uint32_t triangle,
                           uint32_t segment)
{
    const uint32_t scale = d->topology == GN_TRIANGLES ? 3 : 1;
    const uint32_t total = (count - 3) / scale + 1;
    const uint32_t end = (segment + 1) * step < total ? (segment + 1) * step : total;
    const bool is_fan = d->topology == GN_TRIANGLE_FAN;
    /* The first vertex of a fan belongs to every segment. */
    const uint32_t low = scale * segment * step + (is_fan && segment > 0);
    const uint32_t high = scale * (end - 1) + 2;
    const uint32_t own = scale * triangle + is_fan;
    const uint32_t beside[] = {low - 1, low, high, high + 1};

    for (int i = 0; i < 4; ++i) {
        const uint32_t outside = beside[i];

        /* Not in the sliver, which would be clipped, and not the hub, which all slivers share. */
        if (outside >= count || (is_fan && outside == 0) || (outside >= own && outside <= own + 2))
            continue;
        place_all(d, count, triangle, outside);
        if (is_drawn(d, count) != (outside < low || outside > high))
            fail_msg("topology %d, indexed %d, %u elements: triangle %u, vertex %u outside",
                     (int)d->topology, (int)d->indexed, count, triangle, outside);
    }
}

static void segments_end_where_measured(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < MOST; ++i)
        indices[i] = (uint16_t)i;
    for (size_t n = 0; n < sizeof divisions / sizeof *divisions; ++n) {
        const division *d = &divisions[n];
        const uint32_t scale = d->topology == GN_TRIANGLES ? 3 : 1;
        /* These include a known case: a fan in which a wrong division changes a pixel. */
        const uint32_t counts[] = {d->whole - 1, d->whole, d->whole + 1, d->whole + 2,
                                   d->whole + d->step * scale + 3};

        for (size_t k = 0; k < sizeof counts / sizeof *counts; ++k) {
            const uint32_t total = (counts[k] - 3) / scale + 1;
            const uint32_t step = counts[k] > d->whole ? d->step : total;

            for (uint32_t s = 0; s * step < total; ++s) {
                const uint32_t end = (s + 1) * step < total ? (s + 1) * step : total;

                check_triangle(d, counts[k], step, s * step, s);
                check_triangle(d, counts[k], step, end - 1, s);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segments_end_where_measured),
    };

    return cmocka_run_group_tests_name("segments", tests, NULL, NULL);
}
