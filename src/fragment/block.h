/* Fragments, 16 at a time: depth, varyings, shader, colour. One function, made into one
 * for each common state by constant arguments, so that nothing that is constant over
 * a draw is asked in its blocks. */
#ifndef GN_FRAGMENT_BLOCK_H
#define GN_FRAGMENT_BLOCK_H

#include "../shaders/ready_made.h"
#include "../texture/sample.h"

#include "color.h"
#include "depth.h"
#include "formats.h"
#include "planes.h"

/* What computes a fragment's colour. */
typedef enum fragment_source {
    SOURCE_SHADER, /* the pipeline's fragment shader */
    SOURCE_COLOR,  /* varyings 0 to 3, smooth: gn_shade_color without the call */
    SOURCE_TEXTURE /* and 4 and 5: gn_shade_textured without the call */
} fragment_source;

/* What is constant over a draw. */
typedef struct fragment_kind {
    gn_format depth_format; /* GN_FORMAT_NONE: no test */
    gn_format color_format; /* GN_FORMAT_NONE: no colour */
    fragment_source source;
} fragment_kind;

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

static inline lanes_f interpolate_varying(const gn_pipeline *pipeline, raster_triangle triangle,
                                          uint32_t n, float x, float y, lanes_f w)
{
    const attribute_plane plane = triangle_plane(triangle, VARYING_PLANES + n);

    switch (pipeline->interpolation[n]) {
    case GN_FLAT:
        return lanes_splat(plane.origin);
    case GN_NOPERSPECTIVE:
        return plane_in_block(plane, x, y);
    default:
        return lanes_mul(plane_in_block(plane, x, y), w);
    }
}

GN_STEP void run_shader(const gn_pipeline *pipeline, raster_triangle triangle, int32_t x, int32_t y,
                        uint32_t coverage, lanes_f w, lanes_f out[4])
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
    input.sample_2d = GN_SPECIALISED ? sample_2d : gn_sample_2d;
    output.color = color;
    pipeline->fragment_shader(pipeline->uniforms, &input, &output);
    for (int c = 0; c < 4; ++c)
        out[c] = lanes_load(color[c]);
}

GN_INLINE void sample_texture(const gn_textured_uniforms *uniforms, const fragment_place *at,
                              raster_triangle triangle, lanes_f w, lanes_f texel[4])
{
    const lanes_f s = lanes_mul(interpolate(at, triangle, VARYING_PLANES + VARYING_S), w);
    const lanes_f t = lanes_mul(interpolate(at, triangle, VARYING_PLANES + VARYING_T), w);

    sample(&uniforms->texture, &uniforms->sampler, &s, &t, texel);
}

GN_INLINE void shade(const fragment_state *state, fragment_kind kind, const fragment_place *at,
                     raster_triangle triangle, uint32_t coverage)
{
    lanes_f color[4], texel[4];

    if (kind.depth_format != GN_FORMAT_NONE) {
        coverage = test_depth(&state->test, &state->depth, kind.depth_format, at, coverage,
                              interpolate(at, triangle, DEPTH_PLANE));
        if (!coverage)
            return;
    }
    if (kind.color_format == GN_FORMAT_NONE)
        return;

    const lanes_f w = lanes_div(lanes_splat(1.0f), interpolate(at, triangle, ONE_OVER_W_PLANE));
    if (kind.source == SOURCE_SHADER) {
        run_shader(state->pipeline, triangle, at->x, at->y, coverage, w, color);
    } else {
        if (kind.source == SOURCE_TEXTURE)
            sample_texture(state->pipeline->uniforms, at, triangle, w, texel);
        for (uint32_t c = 0; c < 4; ++c) {
            color[c] = lanes_mul(interpolate(at, triangle, VARYING_PLANES + c), w);
            if (kind.source == SOURCE_TEXTURE)
                color[c] = lanes_mul(color[c], texel[c]);
        }
    }
    if (kind.color_format == GN_FORMAT_RGBA8 || kind.color_format == GN_FORMAT_RGBA32F)
        write_color(&state->color, kind.color_format, at, coverage, color);
    else
        write_encoded(&state->color, kind.color_format, at->x, at->y, coverage, color);
}

/* Neighbouring blocks in a row. */
GN_INLINE void shade_blocks(const fragment_state *state, fragment_kind kind,
                            raster_triangle triangle, int32_t x, int32_t y, uint32_t count,
                            uint32_t coverage)
{
    fragment_place at;

    at.shape = SHAPE_BLOCK;
    at.y = y;
    at.columns = 0;
    at.row = 0;
    for (uint32_t i = 0; i < count; ++i) {
        at.x = x + (int32_t)i * BLOCK_SIZE;
        at.color = pixel_memory(&state->color, kind.color_format, at.x, y);
        at.depth = pixel_memory(&state->depth, kind.depth_format, at.x, y);
        shade(state, kind, &at, triangle, coverage);
    }
}

/* The attributes that the library interpolates for a kind of fragments: from the first on,
 * up to the end. */
GN_INLINE uint32_t first_attribute(fragment_kind kind)
{
    return kind.depth_format != GN_FORMAT_NONE ? DEPTH_PLANE : ONE_OVER_W_PLANE;
}

GN_INLINE uint32_t end_attribute(fragment_kind kind)
{
    if (kind.color_format == GN_FORMAT_NONE)
        return ONE_OVER_W_PLANE;
    return VARYING_PLANES + (kind.source == SOURCE_TEXTURE ? VARYING_END : VARYING_S);
}

/* Covered blocks, as many as make whole rows of 16 pixels. */
GN_INLINE void shade_rows(const fragment_state *state, fragment_kind kind, raster_triangle triangle,
                          int32_t x, int32_t y, uint32_t count)
{
    const int32_t end = x + (int32_t)count * BLOCK_SIZE;
    column_terms columns;
    row_terms rows;
    fragment_place at;

    for (uint32_t n = first_attribute(kind); n < end_attribute(kind); ++n)
        set_row_terms(&rows, n, triangle_plane(triangle, n), y);
    at.shape = SHAPE_ROW;
    at.columns = &columns;
    for (at.x = x; at.x < end; at.x += GN_LANES) {
        for (uint32_t n = first_attribute(kind); n < end_attribute(kind); ++n)
            columns.value[n] = columns_from(triangle_plane(triangle, n), at.x);
        at.color = pixel_memory(&state->color, kind.color_format, at.x, y);
        at.depth = pixel_memory(&state->depth, kind.depth_format, at.x, y);
        for (int32_t row = 0; row < BLOCK_SIZE; ++row) {
            at.y = y + row;
            at.row = rows.value[row];
            shade(state, kind, &at, triangle, GN_ALL_LANES);
            if (kind.color_format != GN_FORMAT_NONE)
                at.color += state->color.row_stride;
            if (kind.depth_format != GN_FORMAT_NONE)
                at.depth += state->depth.row_stride;
        }
    }
}

/* Blocks that make a row of 16 pixels. */
#define BLOCKS_IN_ROW (GN_LANES / BLOCK_SIZE)

/* Covered blocks, in rows as far as they go. */
GN_INLINE void shade_run(const fragment_state *state, fragment_kind kind, raster_triangle triangle,
                         int32_t x, int32_t y, uint32_t count)
{
    const gn_textured_uniforms *textured = state->pipeline->uniforms;
    const bool in_rows = kind.source != SOURCE_TEXTURE || has_one_filter(&textured->sampler);
    const uint32_t whole = in_rows ? count - count % BLOCKS_IN_ROW : 0;

    shade_rows(state, kind, triangle, x, y, whole);
    shade_blocks(state, kind, triangle, x + (int32_t)whole * BLOCK_SIZE, y, count - whole,
                 GN_ALL_LANES);
}

/* A run_function for one state; the context is a fragment_state. */
#define GN_RUN_FUNCTION(name, depth_format, color_format, source)                                  \
    static void name(const void *context, raster_triangle triangle, int32_t x, int32_t y,          \
                     uint32_t count, uint32_t coverage)                                            \
    {                                                                                              \
        const fragment_state *state = (const fragment_state *)context;                             \
        const fragment_kind kind = {depth_format, color_format, source};                           \
                                                                                                   \
        shade_blocks(state, kind, triangle, x, y, count, coverage);                                \
    }

/* The same for what is drawn in rows where it can be. Kept apart from the rows, single
 * blocks, of which small triangles have most, begin with little ado. */
#define GN_RUN_ROWS_FUNCTION(name, depth_format, color_format, source)                             \
    GN_OUT_OF_LINE void name##_long(const fragment_state *state, raster_triangle triangle,         \
                                    int32_t x, int32_t y, uint32_t count)                          \
    {                                                                                              \
        const fragment_kind kind = {depth_format, color_format, source};                           \
                                                                                                   \
        shade_run(state, kind, triangle, x, y, count);                                             \
    }                                                                                              \
    static void name(const void *context, raster_triangle triangle, int32_t x, int32_t y,          \
                     uint32_t count, uint32_t coverage)                                            \
    {                                                                                              \
        const fragment_state *state = (const fragment_state *)context;                             \
        const fragment_kind kind = {depth_format, color_format, source};                           \
                                                                                                   \
        if (count > 1)                                                                             \
            name##_long(state, triangle, x, y, count);                                             \
        else                                                                                       \
            shade_blocks(state, kind, triangle, x, y, 1, coverage);                                \
    }

GN_RUN_FUNCTION(run_any, state->depth.format, state->color.format, SOURCE_SHADER)
GN_RUN_FUNCTION(run_rgba8, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_SHADER)
GN_RUN_FUNCTION(run_rgba8_d24, GN_FORMAT_D24, GN_FORMAT_RGBA8, SOURCE_SHADER)
GN_RUN_FUNCTION(run_rgba8_d32f, GN_FORMAT_D32F, GN_FORMAT_RGBA8, SOURCE_SHADER)
GN_RUN_ROWS_FUNCTION(run_color_rgba8, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_COLOR)
GN_RUN_ROWS_FUNCTION(run_color_rgba8_d24, GN_FORMAT_D24, GN_FORMAT_RGBA8, SOURCE_COLOR)
GN_RUN_ROWS_FUNCTION(run_color_rgba8_d32f, GN_FORMAT_D32F, GN_FORMAT_RGBA8, SOURCE_COLOR)
GN_RUN_ROWS_FUNCTION(run_texture_rgba8, GN_FORMAT_NONE, GN_FORMAT_RGBA8, SOURCE_TEXTURE)
GN_RUN_ROWS_FUNCTION(run_texture_rgba8_d24, GN_FORMAT_D24, GN_FORMAT_RGBA8, SOURCE_TEXTURE)
GN_RUN_ROWS_FUNCTION(run_texture_rgba8_d32f, GN_FORMAT_D32F, GN_FORMAT_RGBA8, SOURCE_TEXTURE)
GN_RUN_ROWS_FUNCTION(run_depth_d24, GN_FORMAT_D24, GN_FORMAT_NONE, SOURCE_SHADER)
GN_RUN_ROWS_FUNCTION(run_depth_d32f, GN_FORMAT_D32F, GN_FORMAT_NONE, SOURCE_SHADER)

static inline fragment_source source_of(const gn_pipeline *p)
{
    const bool texture = p->fragment_shader == gn_shade_textured;
    const uint32_t varyings = texture ? VARYING_END : VARYING_ALPHA + 1;

    if ((!texture && p->fragment_shader != gn_shade_color) || p->varying_count < varyings)
        return SOURCE_SHADER;
    for (uint32_t n = 0; n < varyings; ++n) {
        if (p->interpolation[n] != GN_SMOOTH)
            return SOURCE_SHADER;
    }
    return texture ? SOURCE_TEXTURE : SOURCE_COLOR;
}

/* The function that draws blocks under a state. */
static inline run_function *run_function_of(const fragment_state *state)
{
    const fragment_source source = source_of(state->pipeline);

    if (!GN_SPECIALISED)
        return run_any;
    if (state->color.format == GN_FORMAT_NONE)
        return state->depth.format == GN_FORMAT_D24    ? run_depth_d24
               : state->depth.format == GN_FORMAT_D32F ? run_depth_d32f
                                                       : run_any;
    if (state->color.format != GN_FORMAT_RGBA8)
        return run_any;
    switch (state->depth.format) {
    case GN_FORMAT_NONE:
        return source == SOURCE_COLOR     ? run_color_rgba8
               : source == SOURCE_TEXTURE ? run_texture_rgba8
                                          : run_rgba8;
    case GN_FORMAT_D24:
        return source == SOURCE_COLOR     ? run_color_rgba8_d24
               : source == SOURCE_TEXTURE ? run_texture_rgba8_d24
                                          : run_rgba8_d24;
    case GN_FORMAT_D32F:
        return source == SOURCE_COLOR     ? run_color_rgba8_d32f
               : source == SOURCE_TEXTURE ? run_texture_rgba8_d32f
                                          : run_rgba8_d32f;
    default:
        return run_any;
    }
}

#endif
