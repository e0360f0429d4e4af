/* Sixteen fragments: depth, varyings, shader, colour. One text serves all states: steps.h compiles
 * it for classes of states by constant arguments, so that groups ask little that is constant over a
 * draw. */
#ifndef GN_FRAGMENT_GROUP_H
#define GN_FRAGMENT_GROUP_H

#include "color.h"
#include "shader.h"
#include "state.h"

/* What is known of a group's state, by constants or from fragment_state. */
typedef struct fragment_kind {
    gn_format depth_format; /* GN_FORMAT_NONE: no test */
    gn_format color_format; /* of the first attachment; GN_FORMAT_NONE: no colour */
    fragment_source source;
    color_use use;
    bool plain; /* is_plain */

    /* Known per triangle; the last two are set only for rows. */
    bool solid;      /* depth and alpha are as setup_solid says */
    bool usual_test; /* there is no depth test, or it is usual_depth_test */
    bool level;      /* 1/w is the same in every column */
} fragment_kind;

/* Lesser depths pass and are written. */
static const depth_state usual_depth_test = {DEPTH_LESS, false, true};

static inline bool is_usual_depth_test(const depth_state *test)
{
    return test->question == DEPTH_LESS && !test->inverted && test->write;
}

/* Whether a state needs nothing but tests of depth without stencil, smooth varyings and one colour,
 * and tests before it shades. */
static inline bool is_plain(const fragment_state *state)
{
    return !state->is_late && !state->moves_depth && !state->clamps_depth &&
           !format_has_stencil(state->depth.format) && state->is_smooth &&
           state->pipeline->program.color_count <= 1;
}

/* Returns a colour format that the library has. */
static inline gn_format known_format(gn_format format)
{
    return GN_HAVE_FORMATS || format == GN_FORMAT_RGBA32F ? format : GN_FORMAT_RGBA8;
}

/* Returns what is known of any state. */
static inline fragment_kind any_kind(const fragment_state *state)
{
    const fragment_kind kind = {
        .depth_format = state->depth.format,
        .color_format = state->color.format,
        .source = state->source,
        .use = GN_HAVE_COMBINING ? state->combine.use : COLOR_REPLACES,
    };

    return kind;
}

/* Tests stencil and depth, if there are tests. Returns the part of coverage that passed. Depths are
 * clamped to the limits; NaN becomes the upper one. */
GN_INLINE uint32_t test_group(const fragment_state *state, fragment_kind kind,
                              const fragment_place *at, raster_triangle triangle,
                              uint32_t coverage, lanes_f depth)
{
    if (kind.depth_format == GN_FORMAT_NONE)
        return coverage;
    if (GN_HAVE_OFFSET && !kind.plain && state->clamps_depth)
        depth = lanes_max(lanes_min(depth, lanes_splat(state->limits.high)),
                          lanes_splat(state->limits.low));
    if (GN_HAVE_STENCIL && format_has_stencil(kind.depth_format))
        return test_stencil(state, kind.depth_format, at, triangle_is(triangle, PRIMITIVE_IS_BACK),
                            coverage, depth);
    return test_depth(kind.usual_test ? &usual_depth_test : &state->test, &state->depth,
                      kind.depth_format, at, coverage, depth, kind.solid);
}

/* Returns the depths of a group, with the polygon offset. */
GN_INLINE lanes_f depth_of_group(const fragment_state *state, fragment_kind kind,
                                 const fragment_place *at, raster_triangle triangle)
{
    const lanes_f depth = interpolate(at, triangle, DEPTH_PLANE);

    if (GN_HAVE_OFFSET && !kind.plain && state->moves_depth)
        return lanes_add(depth, lanes_splat(triangle_offset(triangle)));
    return depth;
}

/* Returns a varying that the library interpolates itself. */
GN_INLINE lanes_f ready_varying(const fragment_state *state, fragment_kind kind,
                                const fragment_place *at, raster_triangle triangle, uint32_t n,
                                lanes_f w)
{
    if (!kind.plain && !state->is_smooth) {
        const gn_interpolation interpolation = state->pipeline->program.interpolation[n];

        if (interpolation == GN_FLAT)
            return lanes_splat(triangle_plane(triangle, VARYING_PLANES + n).origin);
        if (interpolation == GN_NOPERSPECTIVE)
            return interpolate(at, triangle, VARYING_PLANES + n);
    }
    return lanes_mul(interpolate(at, triangle, VARYING_PLANES + n), w);
}

/* Samples the draw's texture. The linear filter is inlined for the most frequent case: rows whose
 * colours replace the surface's. */
GN_INLINE void sample_texture(const fragment_state *state, fragment_kind kind,
                              const fragment_place *at, raster_triangle triangle, lanes_f w,
                              lanes_f texel[4])
{
    const lanes_f s = ready_varying(state, kind, at, triangle, VARYING_S, w);
    const lanes_f t = ready_varying(state, kind, at, triangle, VARYING_T, w);

    if (at->shape == SHAPE_ROW && kind.plain && kind.use == COLOR_REPLACES &&
        state->sampler->magnify == GN_MAGNIFY_LINEAR)
        sample_linear_inline(state->texture, state->sampler, &s, &t, texel);
    else
        sample(state->texture, state->sampler, &s, &t, texel);
}

/* Computes the colours of a ready-made shader: varyings, with or without a texture. */
GN_INLINE void ready_color(const fragment_state *state, fragment_kind kind,
                           const fragment_place *at, raster_triangle triangle, lanes_f w,
                           lanes_f color[4])
{
    lanes_f texel[4];

    if (kind.source == SOURCE_TEXTURE)
        sample_texture(state, kind, at, triangle, w, texel);
    for (uint32_t c = 0; c < 4; ++c) {
        /* Alpha that is this near to 1 becomes the byte 255 all the same. */
        if (kind.source == SOURCE_COLOR && kind.solid && c == VARYING_ALPHA)
            color[c] = lanes_splat(1.0f);
        else
            color[c] = ready_varying(state, kind, at, triangle, c, w);
        if (kind.source == SOURCE_TEXTURE)
            color[c] = lanes_mul(color[c], texel[c]);
    }
}

/* Writes a shader's colours to all attachments; each colour is four rows of lanes. */
GN_INLINE void write_colors(const fragment_state *state, fragment_kind kind,
                            const fragment_place *at, uint32_t coverage,
                            const float (*shaded)[GN_LANES])
{
    const uint32_t last = GN_HAVE_ATTACHMENTS && !kind.plain ? state->more_count : 0;
    lanes_f color[4];

    for (uint32_t a = 0; a <= last; ++a) {
        const gn_surface *const surface = a > 0 ? &state->more[a - 1].surface : &state->color;
        const color_state *const combine = a > 0 ? &state->more[a - 1].combine : &state->combine;

        if (surface->format == GN_FORMAT_NONE)
            continue;
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_load(shaded[4 * a + (uint32_t)c]);
        if (kind.plain)
            write_color(combine, surface, kind.color_format, kind.use, at, coverage, color);
        else
            write_color(combine, surface, known_format(surface->format),
                        GN_HAVE_COMBINING ? combine->use : COLOR_REPLACES, at, coverage, color);
    }
}

/* Computes and writes the colours of a group whose tests come first. */
GN_INLINE void color_group(const fragment_state *state, fragment_kind kind,
                           const fragment_place *at, raster_triangle triangle, uint32_t coverage)
{
    const lanes_f w = kind.level ? *at->w : w_at(at, triangle);
    float shaded[4 * COLOR_LIMIT][GN_LANES];
    lanes_f color[4];
    shader_verdict verdict;

    if (kind.source == SOURCE_SHADER) {
        set_verdict(&verdict);
        call_fragment_shader(state, triangle, &at->block, &at->places, coverage, w, shaded,
                             &verdict);
        write_colors(state, kind, at, coverage, (const float(*)[GN_LANES])shaded);
        return;
    }
    ready_color(state, kind, at, triangle, w, color);
    write_color(&state->combine, &state->color, kind.color_format, kind.use, at, coverage, color);
}

/* Shades a block in OpenGL's order where the shader decides on coverage or depth: it runs before
 * the tests. Depths that the shader writes get no polygon offset. Returns the fragments that
 * passed. */
GN_INLINE uint32_t shade_late(const fragment_state *state, fragment_kind kind,
                              const fragment_place *at, raster_triangle triangle, uint32_t coverage)
{
    const gn_pipeline *p = state->pipeline;
    lanes_f depth = interpolate(at, triangle, DEPTH_PLANE);
    float written[GN_LANES];
    float color[4 * COLOR_LIMIT][GN_LANES];
    shader_verdict verdict;

    set_verdict(&verdict);
    if (p->program.fragment_writes_depth) {
        lanes_store(written, depth);
        verdict.depth = written;
    } else {
        depth = depth_of_group(state, kind, at, triangle);
    }
    call_fragment_shader(state, triangle, &at->block, &at->places, coverage, w_at(at, triangle),
                         color, &verdict);
    if (p->program.fragment_discards)
        coverage &= verdict.kept;
    if (p->program.fragment_writes_depth)
        depth = lanes_load(written);
    if (coverage)
        coverage = test_group(state, kind, at, triangle, coverage, depth);
    if (coverage)
        write_colors(state, kind, at, coverage, (const float(*)[GN_LANES])color);
    return coverage;
}

/* Shades a group with all that a state may ask for. Returns the fragments that passed. */
GN_INLINE uint32_t shade_group(const fragment_state *state, fragment_kind kind,
                               const fragment_place *at, raster_triangle triangle,
                               uint32_t coverage)
{
    if (state->is_late)
        return shade_late(state, kind, at, triangle, coverage);
    coverage = test_group(state, kind, at, triangle, coverage,
                          depth_of_group(state, kind, at, triangle));
    if (coverage && has_colors(state))
        color_group(state, kind, at, triangle, coverage);
    return coverage;
}

#endif
