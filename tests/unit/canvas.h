/* A small canvas and a draw to it. A test may change any part of the draw. */
#ifndef CANVAS_H
#define CANVAS_H

#include "drawing.h"

enum { SIZE = 8 };

typedef struct canvas {
    uint32_t color[SIZE * SIZE];
    uint32_t depth[SIZE * SIZE];
    gn_target target;
    gn_pipeline pipeline;
    gn_mesh mesh;
    unsigned char memory[GN_WORKSPACE_SIZE(64, GN_SHADER_VARYINGS)];
    gn_workspace workspace;
} canvas;

static canvas c;

/* Clears a canvas of 8x8 pixels, on which NDC x, y in -1..1 is 0..8 pixels. */
static inline void reset(const float *positions, uint32_t vertex_count, gn_topology topology)
{
    memset(&c, 0, sizeof c);
    c.target.color[0] = gn_surface_bottom_up(c.color, GN_FORMAT_RGBA8, SIZE, SIZE);
    c.target.depth = gn_surface_bottom_up(c.depth, GN_FORMAT_D24, SIZE, SIZE);
    assert_int_equal(gn_clear_depth(&c.target.depth, 1.0f), GN_OK);
    c.pipeline = colored_pipeline(topology);
    c.mesh = mesh_of(positions, 4, vertex_count);
    c.workspace.memory = c.memory;
    c.workspace.size = sizeof c.memory;
}

static inline gn_status draw(void)
{
    return gn_draw(&c.target, &c.pipeline, &c.mesh, &c.workspace);
}

static inline bool pixel(int x, int y)
{
    return c.color[y * SIZE + x] != 0;
}

static inline int covered(void)
{
    int n = 0;

    for (int i = 0; i < SIZE * SIZE; ++i)
        n += c.color[i] != 0;
    return n;
}

static float colors[GN_MAX_COLORS][SIZE * SIZE][4];

/* Makes the first attachments floats, whose channels are all 7. */
static inline void set_float_colors(int count)
{
    for (int a = 0; a < count; ++a) {
        for (int i = 0; i < SIZE * SIZE * 4; ++i)
            colors[a][i / 4][i % 4] = 7.0f;
        c.target.color[a] = gn_surface_bottom_up(colors[a], GN_FORMAT_RGBA32F, SIZE, SIZE);
    }
}

/* Draws on a cleared canvas and returns the number of pixels that are covered. */
static inline int drawn(void)
{
    memset(c.color, 0, sizeof c.color);
    assert_int_equal(draw(), GN_OK);
    return covered();
}

#endif
