/* A small draw that tests change and count: in every back end, in tasks and in workspaces of
 * several sizes. */
#ifndef COUNTED_DRAW_H
#define COUNTED_DRAW_H

#include <stdlib.h>

#include "backwards.h"
#include "drawing.h"

enum { WIDTH = 24, HEIGHT = 20, MOST = 9000 };

static uint32_t color[GN_SAMPLES * WIDTH * HEIGHT], depth[GN_SAMPLES * WIDTH * HEIGHT];
static float position[MOST][4];
static float extra[MOST][2]; /* a clip distance, a point's size */
static uint16_t indices[MOST];

static gn_target target;
static gn_pipeline pipeline;
static gn_mesh mesh;

static inline void copy_vertices(const void *uniforms, const gn_vertex_input *input,
                                 gn_vertex_output *output)
{
    const float(*const texcoord)[GN_LANES] = input->attribute[GN_ATTRIBUTE_TEXCOORD];

    pass_positions(uniforms, input, output);
    if (pipeline.program.clip_distance_count > 0)
        memcpy(output->clip_distance[0], texcoord[0], sizeof texcoord[0]);
    if (output->point_size)
        memcpy(output->point_size, texcoord[1], sizeof texcoord[1]);
}

/* A pipeline in its initial state, and a mesh of `count` vertices of `position`. */
static inline void reset(gn_topology topology, uint32_t count, uint32_t samples)
{
    memset(&pipeline, 0, sizeof pipeline);
    target = (gn_target){{gn_surface_bottom_up(color, GN_FORMAT_RGBA8, WIDTH, HEIGHT)},
                         gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    if (samples > 1)
        make_multisampled(&target);
    pipeline.program.vertex_shader = copy_vertices;
    pipeline.program.fragment_shader = shade_white;
    pipeline.raster.topology = topology;
    mesh = mesh_of(position[0], 4, count);
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD] = floats(extra[0], 2);
}

static inline void clear(void)
{
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_clear_depth(&target.depth, 1.0f), GN_OK);
}

static inline void expect_equal(const gn_draw_statistics *a, const gn_draw_statistics *b, int line,
                                const char *what)
{
    const uint64_t *const x = (const uint64_t *)(const void *)a;
    const uint64_t *const y = (const uint64_t *)(const void *)b;

    for (size_t i = 0; i < sizeof *a / sizeof *x; ++i)
        if (x[i] != y[i])
            fail_msg("line %d, %s: count %d is %llu, not %llu", line, what, (int)i,
                     (unsigned long long)x[i], (unsigned long long)y[i]);
}

static inline void expect_sound(const gn_draw_statistics *n)
{
    assert_int_equal(n->primitives, n->not_finite + n->outside + n->without_area + n->culled +
                                        n->missed + n->drawn);
    assert_true(n->behind <= n->outside);
    assert_true(n->clipped <= n->drawn);
    assert_true(n->samples_passed <= n->samples_covered);
}

/* Draws with every back end, on the calling thread and in tasks, in the least workspace and in a
 * large one. Expects equal counts, which are added to those that are there, and as many samples if
 * nothing else is counted. */
static inline gn_draw_statistics count_draw(void)
{
    const uint32_t varyings = pipeline.program.clip_distance_count;
    const size_t sizes[] = {gn_workspace_size(0, varyings), gn_workspace_size(MOST, varyings),
                            gn_workspace_size_parallel(MOST, MOST, varyings)};
    void *const memory = malloc(sizes[2]);
    gn_draw_statistics first = {0};
    bool is_first = true;

    assert_non_null(memory);
    for (gn_backend b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; b = backend_after(b)) {
        for (int way = 0; way < 7; ++way) {
            gn_draw_statistics counts = {.primitives = 5, .culled = 7, .samples_passed = 11};
            const gn_draw_statistics before = counts;
            uint64_t passed = 3;
            gn_workspace workspace = {.memory = memory,
                                      .size = sizes[way % 3],
                                      .backend = b,
                                      .parallel = way < 3 ? NULL : run_backwards,
                                      .samples_passed = way % 2 || way == 6 ? &passed : NULL,
                                      .statistics = way < 6 ? &counts : NULL};
            clear();
            assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
            if (way == 6) {
                assert_int_equal(passed, 3 + first.samples_passed);
                continue;
            }
            counts.primitives -= before.primitives;
            counts.culled -= before.culled;
            counts.samples_passed -= before.samples_passed;
            expect_sound(&counts);
            assert_int_equal(passed, way % 2 ? 3 + counts.samples_passed : 3);
            if (is_first)
                first = counts;
            expect_equal(&counts, &first, __LINE__, gn_backend_name(b));
            is_first = false;
        }
    }
    free(memory);
    return first;
}

/* Sets a vertex at a place in the target, in pixels, in front of the eye. */
static inline void place(uint32_t vertex, float x, float y)
{
    const float at[4] = {x * 2.0f / WIDTH - 1.0f, y * 2.0f / HEIGHT - 1.0f, 0.0f, 1.0f};

    memcpy(position[vertex], at, sizeof at);
}

static inline void multiply(uint32_t vertex, float factor)
{
    for (int i = 0; i < 4; ++i)
        position[vertex][i] *= factor;
}

#endif
