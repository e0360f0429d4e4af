/* A call of the fragment shader for a block: its inputs, and what it decides. */
#ifndef GN_FRAGMENT_SHADER_H
#define GN_FRAGMENT_SHADER_H

#include "planes.h"

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

    if (GN_HAVE_ROWS && state->is_smooth) {
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

/* Returns how many colours a shader writes. */
static inline uint32_t shader_colors(const fragment_state *state)
{
    const uint32_t count = state->pipeline->program.color_count;

    return GN_HAVE_ATTACHMENTS && count > 1 ? count : 1;
}

/* Sets to 0 the colours that a shader may leave unwritten. A ready-made shader writes all of the
 * first colour. It is recognised by its function: the back end runs a form of its own. */
static inline void set_color_defaults(const fragment_state *state, float (*color)[GN_LANES])
{
    const gn_pipeline *const p = state->pipeline;
    const uint32_t count = shader_colors(state);
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

#endif
