/* Blocks of fragments: depth, varyings, shader, colour. One function, made into one
 * for each common state by constant arguments, so that nothing that is constant over
 * a draw is asked in its blocks. */
#ifndef GN_FRAGMENT_BLOCK_H
#define GN_FRAGMENT_BLOCK_H

#include "../shaders/ready_made.h"

#include "color.h"
#include "depth.h"

/* What computes a fragment's colour. */
typedef enum fragment_source {
    SOURCE_SHADER, /* the pipeline's fragment shader */
    SOURCE_COLOR   /* varyings 0 to 3, smooth: gn_shade_color without the call */
} fragment_source;

static inline fragment_state fragment_state_of(const gn_target *target, const gn_pipeline *pipeline)
{
    fragment_state s;

    s.pipeline = pipeline;
    s.color = target->color;
    s.depth = target->depth;
    if (!pipeline->depth_test)
        s.depth.format = GN_FORMAT_NONE;
    s.test = depth_state_of(pipeline);
    return s;
}

/* Plane n's value in every lane of the block at (x, y): per_y * y + (per_x * x + origin),
 * in this order. */
GN_INLINE lanes_f interpolate(raster_triangle triangle, uint32_t n, float x, float y)
{
    const attribute_plane plane = triangle_plane(triangle, n);

    return lanes_add(lanes_rows(plane.per_y, y), lanes_columns(plane.per_x, x, plane.origin));
}

GN_INLINE lanes_f interpolate_varying(const gn_pipeline *pipeline, raster_triangle triangle,
                                      uint32_t n, float x, float y, lanes_f w)
{
    const uint32_t plane = VARYING_PLANES + n;

    switch (pipeline->interpolation[n]) {
    case GN_FLAT:
        return lanes_splat(triangle_plane(triangle, plane).origin);
    case GN_NOPERSPECTIVE:
        return interpolate(triangle, plane, x, y);
    default:
        return lanes_mul(interpolate(triangle, plane, x, y), w);
    }
}

static inline void run_shader(const gn_pipeline *pipeline, raster_triangle triangle, int32_t x,
                              int32_t y, uint32_t coverage, lanes_f w, lanes_f out[4])
{
    float varying[GN_MAX_VARYINGS][GN_LANES];
    float color[4][GN_LANES];
    gn_fragment_input input;
    gn_fragment_output output;

    for (uint32_t n = 0; n < pipeline->varying_count; ++n)
        lanes_store(varying[n], interpolate_varying(pipeline, triangle, n, (float)x, (float)y, w));
    input.varying = (const float(*)[GN_LANES])varying;
    input.coverage = coverage;
    input.x = x;
    input.y = y;
    output.color = color;
    if (pipeline->fragment_shader == gn_shade_textured)
        shade_textured(pipeline->uniforms, &input, &output);
    else
        pipeline->fragment_shader(pipeline->uniforms, &input, &output);
    for (int c = 0; c < 4; ++c)
        out[c] = lanes_load(color[c]);
}

GN_INLINE void shade_block(const fragment_state *state, raster_triangle triangle, int32_t x,
                           int32_t y, uint32_t coverage, gn_format depth_format,
                           gn_format color_format, fragment_source source)
{
    const float px = (float)x;
    const float py = (float)y;
    lanes_f color[4];

    if (depth_format != GN_FORMAT_NONE) {
        coverage = test_depth(&state->test, &state->depth, depth_format, x, y, coverage,
                              interpolate(triangle, DEPTH_PLANE, px, py));
        if (!coverage)
            return;
    }
    if (color_format == GN_FORMAT_NONE)
        return;

    const lanes_f w = lanes_div(lanes_splat(1.0f), interpolate(triangle, ONE_OVER_W_PLANE, px, py));
    if (source == SOURCE_COLOR) {
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_mul(interpolate(triangle, VARYING_PLANES + (uint32_t)c, px, py), w);
    } else {
        run_shader(state->pipeline, triangle, x, y, coverage, w, color);
    }
    write_color(&state->color, color_format, x, y, coverage, color);
}

/* A run_function for one state; the context is a fragment_state. */
#define GN_RUN_FUNCTION(name, depth_format, color_format, source)                                  \
    static void name(const void *context, raster_triangle triangle, int32_t x, int32_t y,          \
                     uint32_t count, uint32_t coverage)                                            \
    {                                                                                              \
        const fragment_state *state = (const fragment_state *)context;                             \
                                                                                                   \
        for (uint32_t i = 0; i < count; ++i)                                                       \
            shade_block(state, triangle, x + (int32_t)i * BLOCK_SIZE, y, coverage, depth_format,   \
                        color_format, source);                                                     \
    }

GN_RUN_FUNCTION(run_any, state->depth.format, state->color.format, SOURCE_SHADER)
GN_RUN_FUNCTION(run_rgba8, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_SHADER)
GN_RUN_FUNCTION(run_rgba8_d24, GN_FORMAT_D24, GN_FORMAT_RGBA8, SOURCE_SHADER)
GN_RUN_FUNCTION(run_rgba8_d32f, GN_FORMAT_D32F, GN_FORMAT_RGBA8, SOURCE_SHADER)
GN_RUN_FUNCTION(run_color_rgba8, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_COLOR)
GN_RUN_FUNCTION(run_color_rgba8_d24, GN_FORMAT_D24, GN_FORMAT_RGBA8, SOURCE_COLOR)
GN_RUN_FUNCTION(run_color_rgba8_d32f, GN_FORMAT_D32F, GN_FORMAT_RGBA8, SOURCE_COLOR)

/* The function that draws blocks under a state. */
static inline run_function *run_function_of(const fragment_state *state)
{
    const gn_pipeline *p = state->pipeline;
    bool color = p->fragment_shader == gn_shade_color;

    for (uint32_t n = 0; n < 4; ++n)
        color = color && n < p->varying_count && p->interpolation[n] == GN_SMOOTH;
    if (state->color.format != GN_FORMAT_RGBA8)
        return run_any;
    switch (state->depth.format) {
    case GN_FORMAT_NONE:
        return color ? run_color_rgba8 : run_rgba8;
    case GN_FORMAT_D24:
        return color ? run_color_rgba8_d24 : run_rgba8_d24;
    case GN_FORMAT_D32F:
        return color ? run_color_rgba8_d32f : run_rgba8_d32f;
    default:
        return run_any;
    }
}

#endif
