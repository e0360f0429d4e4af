/* Fragments, 16 at a time: depth, varyings, shader, colour. One function becomes one for each
 * common state by constant arguments (runs.h), so that blocks ask nothing that is constant over a
 * draw. */
#ifndef GN_FRAGMENT_BLOCK_H
#define GN_FRAGMENT_BLOCK_H

#include "planes.h"
#include "state.h"

/* The functions that compute a fragment's colour. */
typedef enum fragment_source {
    SOURCE_SHADER, /* the pipeline's fragment shader */
    SOURCE_COLOR,  /* varyings 0 to 3, smooth: gn_shade_color, inlined */
    SOURCE_TEXTURE /* and 4 and 5: gn_shade_lit_texture or gn_shade_unlit_texture, inlined */
} fragment_source;

/* Values that are constant over a draw or a triangle. */
typedef struct fragment_kind {
    gn_format depth_format; /* GN_FORMAT_NONE: no test */
    gn_format color_format; /* GN_FORMAT_NONE: no colour */
    fragment_source source;
    color_use use;

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

static inline lanes_f interpolate_varying(const gn_pipeline *pipeline, raster_triangle triangle,
                                          uint32_t n, const block_places *at, lanes_f w)
{
    const gn_interpolation interpolation = pipeline->program.interpolation[n];

    if (interpolation == GN_FLAT)
        return lanes_splat(triangle_plane(triangle, VARYING_PLANES + n).origin);

    const lanes_f value = plane_at(triangle_plane(triangle, VARYING_PLANES + n), at);
    return interpolation == GN_NOPERSPECTIVE ? value : lanes_mul(value, w);
}

static inline void interpolate_varyings(const fragment_state *state, raster_triangle triangle,
                                        const block_places *at, lanes_f w,
                                        float varying[GN_MAX_VARYINGS][GN_LANES])
{
    const gn_pipeline *const pipeline = state->pipeline;
    const uint32_t count = pipeline->program.varying_count;

    if (GN_SPECIALISED && state->is_smooth) {
        for (uint32_t n = 0; n < count; ++n)
            lanes_store(varying[n],
                        lanes_mul(plane_at(triangle_plane(triangle, VARYING_PLANES + n), at), w));
        return;
    }
    for (uint32_t n = 0; n < count; ++n)
        lanes_store(varying[n], interpolate_varying(pipeline, triangle, n, at, w));
}

/* Writes gl_FragCoord of a block. Its z has the polygon offset, whether or not depth is tested. */
static void place_fragments(const gn_pipeline *pipeline, raster_triangle triangle,
                            const gn_fragment_input *input, const block_places *at,
                            float position[4][GN_LANES])
{
    lanes_f depth = plane_at(triangle_plane(triangle, DEPTH_PLANE), at);

    GN_EACH_LANE (l) {
        const int half = l / HALF_LANES;

        position[0][l] = (float)(input->x[half] + l % SQUARE_SIZE) + 0.5f;
        position[1][l] = (float)(input->y[half] + l / SQUARE_SIZE % 2) + 0.5f;
    }
    if (GN_HAVE_OFFSET && pipeline->raster.polygon_offset.set)
        depth = lanes_add(depth, lanes_splat(triangle_offset(triangle)));
    lanes_store(position[2], depth);
    lanes_store(position[3], plane_at(triangle_plane(triangle, ONE_OVER_W_PLANE), at));
}

/* Writes gl_PointCoord of a block. The caller computed w as 1 / (1 / w). */
static void locate_in_point(const gn_pipeline *pipeline, raster_triangle triangle,
                            const block_places *at, lanes_f w, float coordinate[2][GN_LANES])
{
    const float across = point_word(triangle, POINT_PER_PIXEL);
    const float up = pipeline->raster.point_origin == GN_POINT_LOWER_LEFT ? across : -across;
    const attribute_plane s = {point_word(triangle, POINT_ORIGIN_S), across, 0.0f};
    const attribute_plane t = {point_word(triangle, POINT_ORIGIN_T), 0.0f, up};
    const bool is_point = GN_HAVE_LINES && triangle_is(triangle, PRIMITIVE_IS_POINT);
    const lanes_f zero = lanes_splat(0.0f);

    lanes_store(coordinate[0], is_point ? lanes_mul(plane_at(s, at), w) : zero);
    lanes_store(coordinate[1], is_point ? lanes_mul(plane_at(t, at), w) : zero);
}

/* The decisions of a fragment shader beside colour. `kept`: the fragments that it keeps. `depth`:
 * its depths if not null; beforehand the interpolated depths. The sample masks of lanes, if not
 * null: beforehand the covered samples, afterwards the kept samples. */
typedef struct shader_verdict {
    uint32_t kept;
    float *depth;
    const uint32_t *covered_samples;
    uint32_t *kept_samples;
} shader_verdict;

/* Sets the verdict for one sample a pixel, without depths. */
static inline void set_verdict(shader_verdict *verdict)
{
    verdict->depth = 0;
    if (GN_HAVE_SAMPLES) {
        verdict->covered_samples = 0;
        verdict->kept_samples = 0;
    }
}

/* Writes gl_SampleMaskIn for one sample a pixel. */
static inline void mask_of_one_sample(uint32_t coverage, uint32_t mask[GN_LANES])
{
    GN_EACH_LANE (l)
        mask[l] = coverage >> l & 1u;
}

/* Memory for the inputs that only some shaders ask for. */
typedef struct asked_inputs {
    float position[4][GN_LANES], point_coordinate[2][GN_LANES];
    uint32_t covered[GN_LANES], kept[GN_LANES];
} asked_inputs;

/* Sets the shader's inputs and outputs beside varyings and colours, as the pipeline asks for them.
 */
GN_OUT_OF_LINE void set_asked_inputs(const gn_pipeline *pipeline, raster_triangle triangle,
                                     const block_places *at, const lanes_f *w,
                                     const shader_verdict *verdict, asked_inputs *asked,
                                     gn_fragment_input *input, gn_fragment_output *output)
{
    if (pipeline->program.fragment_reads_primitive)
        input->primitive_id = triangle_number(triangle);
    if (pipeline->program.fragment_reads_position) {
        place_fragments(pipeline, triangle, input, at, asked->position);
        input->position = (const float(*)[GN_LANES])asked->position;
    }
    if (GN_HAVE_LINES && pipeline->program.fragment_reads_point_coordinate) {
        locate_in_point(pipeline, triangle, at, *w, asked->point_coordinate);
        input->point_coordinate = (const float(*)[GN_LANES])asked->point_coordinate;
    }
    if (GN_HAVE_SAMPLES && pipeline->program.fragment_reads_sample_mask) {
        mask_of_one_sample(input->coverage, asked->covered);
        input->sample_mask = verdict->covered_samples ? verdict->covered_samples : asked->covered;
    }
    if (GN_HAVE_SAMPLES && pipeline->program.fragment_writes_sample_mask) {
        output->sample_mask = verdict->kept_samples ? verdict->kept_samples : asked->kept;
        lanes_i_store((stored_word *)(void *)output->sample_mask, lanes_i_splat(-1));
    }
}

/* Returns w. Smooth varyings are interpolated divided by w, and this multiplies them again. */
GN_INLINE lanes_f w_at(const fragment_place *at, raster_triangle triangle)
{
    return lanes_div(lanes_splat(1.0f), interpolate(at, triangle, ONE_OVER_W_PLANE));
}

/* Sets to 0 the colours that a shader may leave unwritten. A ready-made shader writes all of the
 * first colour. It is recognised by its function: the back end runs a form of its own. */
static inline void set_color_defaults(const fragment_state *state, float (*color)[GN_LANES])
{
    const gn_pipeline *const p = state->pipeline;
    const uint32_t count =
        GN_HAVE_ATTACHMENTS && p->program.color_count > 1 ? p->program.color_count : 1;
    const bool is_ready_made = state->shading->fragment_shader != p->program.fragment_shader;

    for (uint32_t n = is_ready_made ? 4 : 0; n < 4 * count; ++n)
        lanes_store(color[n], lanes_splat(0.0f));
}

/* Calls the fragment shader for a block whose planes are evaluated at `places`. Writes the colours
 * to `color`, which has room for the pipeline's color_count. */
GN_STEP void call_fragment_shader(const fragment_state *state, raster_triangle triangle,
                                  const pixel_block *block, const block_places *places,
                                  uint32_t coverage, lanes_f w, float (*color)[GN_LANES],
                                  shader_verdict *verdict)
{
    const gn_pipeline *const pipeline = state->pipeline;
    float varying[GN_MAX_VARYINGS][GN_LANES];
    asked_inputs asked;
    gn_fragment_input input;
    gn_fragment_output output;

    interpolate_varyings(state, triangle, places, w, varying);
    input.varying = (const float(*)[GN_LANES])varying;
    input.coverage = coverage;
    for (int half = 0; half < 2; ++half) {
        input.x[half] = block->x[half];
        input.y[half] = block->y[half];
    }
    input.sampling = &state->shading->sampling;
    input.front_facing = !triangle_is(triangle, PRIMITIVE_IS_BACK);
    input.primitive_id = 0;
    input.position = 0;
    input.point_coordinate = 0;
    input.sample_mask = 0;
    set_color_defaults(state, color);
    output.color = color;
    output.kept = GN_ALL_LANES;
    output.depth = verdict->depth;
    output.sample_mask = 0;
    if (state->asks_inputs) {
        const lanes_f in_memory = w;

        set_asked_inputs(pipeline, triangle, places, &in_memory, verdict, &asked, &input, &output);
    }
    state->shading->fragment_shader(pipeline->program.uniforms, &input, &output);
    verdict->kept = output.kept;
}

/* Samples the draw's texture. The linear filter is inlined for the most frequent case: rows whose
 * colours replace the surface's. */
GN_INLINE void sample_texture(const fragment_state *state, fragment_kind kind,
                              const fragment_place *at, raster_triangle triangle, lanes_f w,
                              lanes_f texel[4])
{
    const lanes_f s = lanes_mul(interpolate(at, triangle, VARYING_PLANES + VARYING_S), w);
    const lanes_f t = lanes_mul(interpolate(at, triangle, VARYING_PLANES + VARYING_T), w);

    if (at->shape == SHAPE_ROW && kind.use == COLOR_REPLACES &&
        state->sampler->magnify == GN_MAGNIFY_LINEAR)
        sample_linear_inline(state->texture, state->sampler, &s, &t, texel);
    else
        sample(state->texture, state->sampler, &s, &t, texel);
}

/* Tests stencil and depth, if there are tests. Returns the part of coverage that passed. Depths are
 * clamped to the limits; NaN becomes the upper one. */
GN_INLINE uint32_t test_whole(const fragment_state *state, const fragment_place *at,
                              raster_triangle triangle, uint32_t coverage, lanes_f depth)
{
    if (GN_HAVE_OFFSET && state->clamps_depth)
        depth = lanes_max(lanes_min(depth, lanes_splat(state->limits.high)),
                          lanes_splat(state->limits.low));
    if (GN_HAVE_STENCIL && format_has_stencil(state->depth.format))
        return test_stencil(state, at, triangle_is(triangle, PRIMITIVE_IS_BACK), coverage, depth);
    if (state->depth.format == GN_FORMAT_NONE)
        return coverage;
    return test_depth(&state->test, &state->depth, state->depth.format, at, coverage, depth, false);
}

/* Shades a block with all that a state may ask for, in OpenGL's order: the shader runs before the
 * tests if they need its decisions, otherwise after them. Depths that the shader writes get no
 * polygon offset. Returns the fragments that passed. */
GN_OUT_OF_LINE uint32_t shade_whole(const fragment_state *state, const fragment_place *at,
                                    raster_triangle triangle, uint32_t coverage)
{
    const gn_pipeline *p = state->pipeline;
    const bool late = p->program.fragment_discards || p->program.fragment_writes_depth;
    lanes_f depth = interpolate(at, triangle, DEPTH_PLANE);
    float written[GN_LANES];
    float color[4 * COLOR_LIMIT][GN_LANES];
    shader_verdict verdict;

    set_verdict(&verdict);
    if (p->program.fragment_writes_depth) {
        lanes_store(written, depth);
        verdict.depth = written;
    } else if (GN_HAVE_OFFSET && state->moves_depth) {
        depth = lanes_add(depth, lanes_splat(triangle_offset(triangle)));
    }
    if (!late)
        coverage = test_whole(state, at, triangle, coverage, depth);
    if (!coverage || (!late && !has_colors(state)))
        return coverage;

    const lanes_f w = w_at(at, triangle);
    const pixel_block block = square_block(at->x, at->y);
    call_fragment_shader(state, triangle, &block, at->places, coverage, w, color, &verdict);
    if (p->program.fragment_discards)
        coverage &= verdict.kept;
    if (p->program.fragment_writes_depth)
        depth = lanes_load(written);
    if (late && coverage)
        coverage = test_whole(state, at, triangle, coverage, depth);
    if (coverage)
        put_colors(state, at, coverage, (const float(*)[GN_LANES])color);
    return coverage;
}

/* Shades a run with all that a state may ask for. Returns how many fragments passed. */
GN_OUT_OF_LINE uint32_t shade_whole_squares(const fragment_state *state, raster_triangle triangle,
                                            int32_t x, int32_t y, uint32_t count, uint32_t coverage)
{
    uint32_t passed = 0;
    block_places places;
    fragment_place at;

    set_rows_of_block(&places, (float)y);
    set_block(&at, SHAPE_SQUARE, &places);
    at.y = y;
    for (uint32_t i = 0; i < count; ++i) {
        at.x = x + (int32_t)i * SQUARE_SIZE;
        set_columns_of_block(&places, (float)at.x);
        at.color = square_memory(&state->color, state->color.format, at.x, y);
        at.depth = square_memory(&state->depth, state->depth.format, at.x, y);
        passed += count_lanes(shade_whole(state, &at, triangle, coverage));
    }
    return passed;
}

/* Shades one row or one block; `block` is null for a row. */
GN_INLINE void shade_fragments(const fragment_state *state, fragment_kind kind,
                               const fragment_place *at, const pixel_block *block,
                               raster_triangle triangle, uint32_t coverage)
{
    float shaded[4][GN_LANES];
    lanes_f color[4], texel[4];
    shader_verdict verdict;

    if (kind.depth_format != GN_FORMAT_NONE) {
        coverage = test_depth(kind.usual_test ? &usual_depth_test : &state->test, &state->depth,
                              kind.depth_format, at, coverage,
                              interpolate(at, triangle, DEPTH_PLANE), kind.solid);
        if (!coverage)
            return;
    }
    if (kind.color_format == GN_FORMAT_NONE)
        return;

    const lanes_f w = kind.level ? *at->w : w_at(at, triangle);
    if (kind.source == SOURCE_SHADER) {
        set_verdict(&verdict);
        call_fragment_shader(state, triangle, block, at->places, coverage, w, shaded, &verdict);
        for (int c = 0; c < 4; ++c)
            color[c] = lanes_load(shaded[c]);
    } else {
        if (kind.source == SOURCE_TEXTURE)
            sample_texture(state, kind, at, triangle, w, texel);
        for (uint32_t c = 0; c < 4; ++c) {
            /* Alpha that is this near to 1 becomes the byte 255 all the same. */
            if (kind.source == SOURCE_COLOR && kind.solid && c == VARYING_ALPHA)
                color[c] = lanes_splat(1.0f);
            else
                color[c] = lanes_mul(interpolate(at, triangle, VARYING_PLANES + c), w);
            if (kind.source == SOURCE_TEXTURE)
                color[c] = lanes_mul(color[c], texel[c]);
        }
    }
    if (kind.use == COLOR_REPLACES)
        write_color(&state->color, kind.color_format, at, coverage, color);
    else
        combine_color(&state->combine, &state->color, kind.color_format, kind.use, at, coverage,
                      color);
}

#endif
