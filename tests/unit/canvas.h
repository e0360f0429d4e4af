/* A small canvas and a draw to it. A test may change any part of the draw. */
#ifndef CANVAS_H
#define CANVAS_H

#include <string.h>

#include "unit.h"

enum { SIZE = 8 };

typedef struct canvas {
    uint32_t color[SIZE * SIZE];
    uint32_t depth[SIZE * SIZE];
    gn_target target;
    gn_color_uniforms uniforms;
    gn_pipeline pipeline;
    gn_mesh mesh;
    unsigned char memory[GN_WORKSPACE_SIZE(64, GN_SHADER_VARYINGS)];
    gn_workspace workspace;
} canvas;

static canvas c;

static const float white[16] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

/* Clears a canvas of 8x8 pixels, on which NDC x, y in -1..1 is 0..8 pixels. */
static inline void reset(const float *positions, uint32_t vertex_count, gn_topology topology)
{
    memset(&c, 0, sizeof c);
    c.target.color[0] = gn_surface_bottom_up(c.color, GN_FORMAT_RGBA8, SIZE, SIZE);
    c.target.depth = gn_surface_bottom_up(c.depth, GN_FORMAT_D24, SIZE, SIZE);
    for (int i = 0; i < 4; ++i)
        c.uniforms.clip_from_model.m[i][i] = 1.0f;
    assert_int_equal(gn_clear_color(&c.target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_clear_depth(&c.target.depth, 1.0f), GN_OK);
    assert_int_equal(gn_use_vertex_color(&c.pipeline, &c.uniforms), GN_OK);
    c.pipeline.raster.topology = topology;
    c.mesh.attribute[GN_ATTRIBUTE_POSITION].data = positions;
    c.mesh.attribute[GN_ATTRIBUTE_POSITION].components = 4;
    c.mesh.attribute[GN_ATTRIBUTE_COLOR].data = white;
    c.mesh.attribute[GN_ATTRIBUTE_COLOR].components = 4;
    c.mesh.vertex_count = vertex_count;
    c.mesh.count = vertex_count;
    c.workspace.memory = c.memory;
    c.workspace.size = sizeof c.memory;
}

static inline gn_status draw(void)
{
    return gn_draw(&c.target, &c.pipeline, &c.mesh, &c.workspace);
}

static inline int covered(void)
{
    int n = 0;

    for (int i = 0; i < SIZE * SIZE; ++i)
        n += c.color[i] != 0;
    return n;
}

static const float square[16] = {-1, -1, 0, 1, 1, -1, 0, 1, -1, 1, 0, 1, 1, 1, 0, 1};

#endif
