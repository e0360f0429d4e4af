/* A call of the fragment shader for a block: where in their pixels fragments of multisampled
 * targets are shaded (OpenGL 4.5 section 14.3.1; reference/RULES.md, "Samples"), its inputs, and
 * what it decides. */
#ifndef GN_KERNEL_FRAGMENT_SHADER_INL
#define GN_KERNEL_FRAGMENT_SHADER_INL

#include "../raster/cover_samples.inl"
#include "planes.inl"

/* Returns a sample's place in a pixel, in pixels from the pixel's lower left corner. */
static inline float sample_place(uint32_t sample, int axis)
{
    return (float)(128 + sample_offset(sample, axis)) * (1.0f / 256.0f);
}

/* Whether all varyings are at samples, because the pipeline asks for more than one call a pixel. */
static inline bool shades_all_samples(const gn_pipeline *pipeline)
{
    return pipeline->samples.shading_enabled && pipeline->samples.least_shading * GN_SAMPLES > 1.0f;
}

/* Sets the places of centroids: the first present sample, or the centre if all samples or none are
 * present. `present` has the lanes of each sample. */
static inline void set_centroid_places(block_places *at, const pixel_block *block,
                                       const uint32_t present[GN_SAMPLES])
{
    lanes_f inside[2] = {lanes_splat(0.5f), lanes_splat(0.5f)};
    uint32_t all = GN_ALL_LANES;

    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        all &= present[s];
    for (uint32_t s = GN_SAMPLES; s-- > 0;) {
        const lanes_m moved = lanes_from_bits(present[s] & ~all);

        for (int axis = 0; axis < 2; ++axis)
            inside[axis] = lanes_select(moved, lanes_splat(sample_place(s, axis)), inside[axis]);
    }
    set_places(at, block, 0);
    at->x = lanes_add(at->x, inside[0]);
    at->y = lanes_add(at->y, inside[1]);
}

static inline lanes_f interpolate_varying(const gn_pipeline *pipeline, raster_primitive primitive,
                                          uint32_t n, const block_places *at, lanes_f w)
{
    const gn_interpolation interpolation = pipeline->program.interpolation[n];

    if (interpolation == GN_FLAT)
        return lanes_splat(primitive_plane(primitive, VARYING_PLANES + n).origin);

    const lanes_f value = plane_at(primitive_plane(primitive, VARYING_PLANES + n), at);
    return interpolation == GN_NOPERSPECTIVE ? value : lanes_mul(value, w);
}

static inline void interpolate_varyings(const fragment_state *state, raster_primitive primitive,
                                        const block_places *at, lanes_f w,
                                        float varying[GN_MAX_VARYINGS][GN_LANES])
{
    const gn_pipeline *const pipeline = state->pipeline;
    const uint32_t count = pipeline->program.varying_count;

    if (GN_HAVE_ROWS && state->is_smooth) {
        for (uint32_t n = 0; n < count; ++n)
            lanes_store(varying[n],
                        lanes_mul(plane_at(primitive_plane(primitive, VARYING_PLANES + n), at), w));
        return;
    }
    for (uint32_t n = 0; n < count; ++n)
        lanes_store(varying[n], interpolate_varying(pipeline, primitive, n, at, w));
}

/* Interpolates varyings, each at its location. `w` is that at `center`, the pixels' centres. */
GN_OUT_OF_LINE void interpolate_located(const fragment_state *state, raster_primitive primitive,
                                        const pixel_block *block, const block_places *center,
                                        const lanes_f *w, const uint32_t present[GN_SAMPLES],
                                        float varying[GN_MAX_VARYINGS][GN_LANES])
{
    const gn_program *const program = &state->pipeline->program;
    const attribute_plane one_over_w = primitive_plane(primitive, ONE_OVER_W_PLANE);
    block_places place[GN_AT_SAMPLE + 1];
    lanes_f w_at_place[GN_AT_SAMPLE + 1];

    copy_places(&place[GN_AT_CENTER], center);
    w_at_place[GN_AT_CENTER] = *w;
    set_centroid_places(&place[GN_AT_CENTROID], block, present);
    set_places(&place[GN_AT_SAMPLE], block, state->test_at);
    for (int l = GN_AT_CENTROID; l <= GN_AT_SAMPLE; ++l)
        w_at_place[l] = lanes_div(lanes_splat(1.0f), plane_at(one_over_w, &place[l]));
    for (uint32_t n = 0; n < program->varying_count; ++n) {
        const gn_interpolation_point l = program->interpolated_at[n];

        lanes_store(varying[n],
                    interpolate_varying(state->pipeline, primitive, n, &place[l], w_at_place[l]));
    }
}

/* Writes gl_FragCoord of a block: x, y and z at `at`, whose coordinates are `beyond` less than
 * those of the window, and 1/w at `center`. z includes the polygon offset even if depth is not
 * tested. */
GN_INLINE void place_fragments(const fragment_state *state, raster_primitive primitive,
                               const block_places *at, const float beyond[2],
                               const block_places *center, float position[4][GN_LANES])
{
    const attribute_plane x = {beyond[0], 1.0f, 0.0f}, y = {beyond[1], 0.0f, 1.0f};
    lanes_f depth = plane_at(primitive_plane(primitive, DEPTH_PLANE), at);

    lanes_store(position[0], plane_at(x, at));
    lanes_store(position[1], plane_at(y, at));
    if (GN_HAVE_OFFSET && state->pipeline->raster.polygon_offset.enabled)
        depth = lanes_add(depth, lanes_splat(primitive.setup->offset[lane_of(primitive)]));
    lanes_store(position[2], depth);
    lanes_store(position[3], plane_at(primitive_plane(primitive, ONE_OVER_W_PLANE), center));
}

/* Writes gl_PointCoord of a block; 0 unless the primitive is a point. `w` is 1 / (1/w). */
static void locate_in_point(const gn_pipeline *pipeline, raster_primitive primitive,
                            const block_places *at, lanes_f w, float coordinate[2][GN_LANES])
{
    const float(*const point)[LANES] = primitive.setup->corner.point;
    const float across = point[POINT_PER_PIXEL][lane_of(primitive)];
    const float up = pipeline->raster.point_origin == GN_POINT_LOWER_LEFT ? across : -across;
    const attribute_plane s = {point[POINT_ORIGIN_S][lane_of(primitive)], across, 0.0f};
    const attribute_plane t = {point[POINT_ORIGIN_T][lane_of(primitive)], 0.0f, up};
    const bool is_point = DRAWS_LINES && primitive_is(primitive, PRIMITIVE_IS_POINT);
    const lanes_f zero = lanes_splat(0.0f);

    lanes_store(coordinate[0], is_point ? lanes_mul(plane_at(s, at), w) : zero);
    lanes_store(coordinate[1], is_point ? lanes_mul(plane_at(t, at), w) : zero);
}

/* The decisions of a fragment shader beside colour, and what they start from. */
typedef struct shader_verdict {
    uint32_t kept;                   /* the lanes that it does not discard */
    float *depth;                    /* interpolated before, the shader's after; or null */
    const uint32_t *covered_samples; /* the covered samples of each lane; or null */
    uint32_t *kept_samples;          /* the sample mask of each lane that it writes; or null */
    const uint32_t *present; /* lanes of each sample that decide on centroids; set if is_located */
} shader_verdict;

/* Sets the verdict for one sample a pixel, without depths. */
static inline void set_verdict(shader_verdict *verdict)
{
    verdict->depth = 0;
    if (DRAWS_SAMPLES) {
        verdict->covered_samples = 0;
        verdict->kept_samples = 0;
        verdict->present = 0;
    }
}

/* Writes gl_SampleMaskIn for one sample a pixel. */
static inline void mask_of_one_sample(uint32_t coverage, uint32_t mask[GN_LANES])
{
    GN_EACH_LANE (l)
        mask[l] = coverage >> l & 1u;
}

/* Memory for the inputs that only some shaders ask for. */
typedef struct optional_inputs {
    GN_ALIGNED_LANES float position[4][GN_LANES];
    float point_coordinate[2][GN_LANES];
    uint32_t covered[GN_LANES], kept[GN_LANES];
} optional_inputs;

/* Writes gl_FragCoord where the shader runs: x, y and z at samples, 1/w at the pixels' centres. */
static inline void place_samples(const fragment_state *state, raster_primitive primitive,
                                 const gn_fragment_input *input, float position[4][GN_LANES])
{
    static const float middle[2] = {0.5f, 0.5f}, none[2] = {0.0f, 0.0f};
    const pixel_block block = {{input->x[0], input->x[1]}, {input->y[0], input->y[1]}};
    block_places sample, center;

    set_places(&sample, &block, state->test_at);
    set_places(&center, &block, middle);
    place_fragments(state, primitive, &sample, none, &center, position);
}

/* Writes gl_FragCoord at the pixels' centres. */
GN_INLINE void place_centers(const fragment_state *state, raster_primitive primitive,
                             const block_places *at, float position[4][GN_LANES])
{
    const float beyond[2] = {0.5f - state->shade_at[0], 0.5f - state->shade_at[1]};

    place_fragments(state, primitive, at, beyond, at, position);
}

/* Sets the inputs and outputs that only some pipelines ask for. */
GN_OUT_OF_LINE void set_optional_inputs(const fragment_state *state, raster_primitive primitive,
                                        const block_places *at, const lanes_f *w,
                                        const shader_verdict *verdict, optional_inputs *optional,
                                        gn_fragment_input *input, gn_fragment_output *output)
{
    const gn_pipeline *const pipeline = state->pipeline;

    if (DRAWS_SAMPLES && pipeline->program.fragment_reads_position && state->runs_per_sample) {
        place_samples(state, primitive, input, optional->position);
        input->position = (const float(*)[GN_LANES])optional->position;
    }
    if (DRAWS_LINES && pipeline->program.fragment_reads_point_coordinate) {
        locate_in_point(pipeline, primitive, at, *w, optional->point_coordinate);
        input->point_coordinate = (const float(*)[GN_LANES])optional->point_coordinate;
    }
    if (DRAWS_SAMPLES && pipeline->program.fragment_reads_sample_mask) {
        mask_of_one_sample(input->coverage, optional->covered);
        input->sample_mask =
            verdict->covered_samples ? verdict->covered_samples : optional->covered;
    }
    if (DRAWS_SAMPLES && pipeline->program.fragment_writes_sample_mask) {
        output->sample_mask = verdict->kept_samples ? verdict->kept_samples : optional->kept;
        lanes_i_store((stored_word *)(void *)output->sample_mask, lanes_i_splat(-1));
    }
}

/* Returns w, by which smooth varyings are multiplied: their planes are divided by w. */
GN_INLINE lanes_f w_at(const fragment_place *at, raster_primitive primitive)
{
    return lanes_div(lanes_splat(1.0f), interpolate(at, primitive, ONE_OVER_W_PLANE));
}

/* Returns how many colours a shader writes. */
static inline uint32_t shader_colors(const fragment_state *state)
{
    const uint32_t count = state->pipeline->program.color_count;

    return GN_HAVE_ATTACHMENTS && count > 1 ? count : 1;
}

/* Returns where in the pixel the depth is that a shader finds in its output: at the sample if it
 * runs for each, even where varyings are at the centre. */
static inline const float *place_of_depth(const fragment_state *state)
{
    return DRAWS_SAMPLES && state->runs_per_sample ? state->test_at : state->shade_at;
}

/* Sets to 0 the colours of all attachments but the first. */
GN_OUT_OF_LINE void clear_more_colors(float (*color)[GN_LANES], uint32_t count)
{
    for (uint32_t n = 4; n < 4 * count; ++n)
        lanes_store(color[n], lanes_splat(0.0f));
}

/* Sets to 0 the colours that a shader may leave unwritten. A ready-made shader writes all of the
 * first colour and none of the others, whatever the pipeline says of it. It is recognised only
 * where the back end runs its own form of it. */
static inline void set_color_defaults(const fragment_state *state, float (*color)[GN_LANES])
{
    const uint32_t count = shader_colors(state);

    if (!state->pipeline->program.fragment_writes_all_colors && !state->is_ready_made)
        for (int c = 0; c < 4; ++c)
            lanes_store(color[c], lanes_splat(0.0f));
    if (count > 1)
        clear_more_colors(color, count);
}

/* What calls of the shader need beside colours. */
typedef struct shader_call {
    gn_fragment_input input;
    gn_fragment_output output;
    optional_inputs optional;
    GN_ALIGNED_LANES float varying[GN_MAX_VARYINGS][GN_LANES];
} shader_call;

/* Sets what the calls for a triangle share. */
static inline void start_shader_calls(const fragment_state *state, raster_primitive primitive,
                                      shader_call *call)
{
    call->input.varying = (const float(*)[GN_LANES])call->varying;
    call->input.count = LANES;
    call->input.texture_functions = &primitive.setup->shading->texture_functions;
    call->input.front_facing = !primitive_is(primitive, PRIMITIVE_IS_BACK);
    call->input.primitive_id = state->pipeline->program.fragment_reads_primitive
                                   ? (uint32_t)primitive.setup->primitive[lane_of(primitive)]
                                   : 0;
    call->input.position = 0;
    call->input.point_coordinate = 0;
    call->input.sample_mask = 0;
    call->output.sample_mask = 0;
    call->input.sample_id = state->sample;
    for (int axis = 0; axis < 2; ++axis)
        call->input.sample_position[axis] =
            DRAWS_SAMPLES && state->runs_per_sample ? state->test_at[axis] : 0.5f;
}

/* Calls the fragment shader for a block whose planes are evaluated at `places`, after
 * start_shader_calls and with the input's x and y set. `color` has room for the pipeline's
 * color_count. */
GN_INLINE void call_shader(const fragment_state *state, raster_primitive primitive,
                           const pixel_block *block, const block_places *places, uint32_t coverage,
                           lanes_f w, float (*color)[GN_LANES], shader_verdict *verdict,
                           shader_call *call)
{
    if (DRAWS_SAMPLES && state->is_located) {
        const lanes_f in_memory = w;
        block_places at;

        copy_places(&at, places);
        interpolate_located(state, primitive, block, &at, &in_memory, verdict->present,
                            call->varying);
    } else {
        interpolate_varyings(state, primitive, places, w, call->varying);
    }
    call->input.coverage = coverage;
    set_color_defaults(state, color);
    call->output.color = color;
    call->output.kept = GN_ALL_LANES;
    call->output.depth = verdict->depth;
    if (state->reads_centers) {
        place_centers(state, primitive, places, call->optional.position);
        call->input.position = (const float(*)[GN_LANES])call->optional.position;
    }
    if (state->has_optional_inputs) {
        /* Copies, so that the originals stay in registers. */
        const lanes_f in_memory = w;
        block_places at;

        copy_places(&at, places);
        set_optional_inputs(state, primitive, &at, &in_memory, verdict, &call->optional,
                            &call->input, &call->output);
    }
    primitive.setup->shading->fragment_shader(state->pipeline->program.uniforms, &call->input,
                                              &call->output);
    verdict->kept = call->output.kept;
}

/* Calls the fragment shader for a block of any triangle. */
GN_INLINE void call_fragment_shader(const fragment_state *state, raster_primitive primitive,
                                    const pixel_block *block, const block_places *places,
                                    uint32_t coverage, lanes_f w, float (*color)[GN_LANES],
                                    shader_verdict *verdict)
{
    shader_call call;

    start_shader_calls(state, primitive, &call);
    for (int half = 0; half < 2; ++half) {
        call.input.x[half] = block->x[half];
        call.input.y[half] = block->y[half];
    }
    call_shader(state, primitive, block, places, coverage, w, color, verdict, &call);
}

#endif
