/* Vertex shading: fills slots of the workspace, sixteen at a time. */
#ifndef GN_KERNEL_DRAW_VERTICES_INL
#define GN_KERNEL_DRAW_VERTICES_INL

#include "../geometry/fetch_attributes.inl"
#include "elements.inl"

/* Returns whether the vertex shader is a ready-made one. Such a shader writes the same outputs in
 * every call, so defaults are set once. */
static inline bool has_ready_made_vertices(const draw_state *draw)
{
    const gn_pipeline *const p = draw->pipeline;

    return GN_STATES_SPECIALISED && (p->program.vertex_shader == gni_shade_vertex_lit ||
                                     p->program.vertex_shader == gni_shade_vertex_color ||
                                     p->program.vertex_shader == gni_shade_vertex_unlit ||
                                     draw->job->shading.vertex_shader != p->program.vertex_shader);
}

/* Calls the vertex shader. The smallest ready-made shaders are inlined. */
static void call_vertex_shader(const draw_state *draw, const gn_vertex_input *input,
                               gn_vertex_output *output)
{
    const gn_pipeline *const pipeline = draw->pipeline;
    const gn_color_uniforms *const colors = (const gn_color_uniforms *)pipeline->program.uniforms;
    const gn_unlit_uniforms *const unlit = (const gn_unlit_uniforms *)pipeline->program.uniforms;
    const bool is_unlit = pipeline->program.vertex_shader == gni_shade_vertex_unlit;

    if (GN_STATES_SPECIALISED && pipeline->program.vertex_shader == gni_shade_vertex_lit)
        shade_vertex_lit(pipeline->program.uniforms, input, output);
    else if (GN_STATES_SPECIALISED &&
             (is_unlit || pipeline->program.vertex_shader == gni_shade_vertex_color))
        shade_plain(is_unlit ? &unlit->clip_from_model : &colors->clip_from_model,
                    is_unlit ? unlit->map : 0, input, output);
    else
        draw->job->shading.vertex_shader(pipeline->program.uniforms, input, output);
}

/* Finds the vertices of sixteen slots. Only the first `count` are wanted; the others repeat the
 * last. */
static inline void slot_vertices(const draw_state *draw, uint32_t slot, uint32_t count,
                                 uint32_t vertex[LANES])
{
    if (draw->map.shared) {
        for (uint32_t l = 0; l < count; ++l)
            vertex[l] = draw->map.base + slot + l;
    } else {
        read_drawn_elements(draw, draw->map.first + slot, count, vertex);
        if (draw->pipeline->raster.topology == GN_TRIANGLE_FAN && slot == 0)
            read_elements(&draw->slice, 0, 1, vertex);
    }
    for (uint32_t l = count; l < LANES; ++l)
        vertex[l] = vertex[count - 1];
}

/* Stores a shader's outputs for sixteen vertices in their slots; clip distances follow the
 * varyings. Returns the vertices' outcodes. */
GN_FRAMED lanes_i store_vertices(const draw_state *draw, const gn_vertex_output *output,
                                 uint32_t slot)
{
    const uint32_t values = stored_values(draw->pipeline);
    unsigned char *const first =
        draw->job->memory + draw->slots_offset + (size_t)(slot & draw->map.ring) * draw->stride;
    lanes_f clip[4];

    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        clip[c] = lanes_load(output->position[c]);
    for (uint32_t n = 0; n < values; n += 4) {
        lanes_i row[4];

        GN_UNROLLED
        for (uint32_t c = 0; c < 4; ++c)
            row[c] = n + c < values ? lanes_as_int(lanes_load(output->varying[n + c]))
                                    : lanes_i_splat(0);
        lanes_i_scatter_rows(first + VERTEX_VARYING + n / 4 * VERTEX_ROW, draw->stride, row);
    }
    return place_vertices(&draw->viewport, clip,
                          distance_outcodes((const float(*)[GN_LANES])output->clip_distance,
                                            distance_count(draw->pipeline)),
                          output->point_size ? lanes_as_int(lanes_load(output->point_size))
                                             : lanes_i_splat(0),
                          first, draw->stride);
}

/* Sets the outputs that a vertex shader may leave unwritten to the values that gn_vertex_output
 * states, in every lane, so that earlier contents of the workspace are never drawn. */
GN_FRAMED void set_vertex_defaults(const gn_pipeline *pipeline, const gn_vertex_output *output)
{
    const lanes_f zero = lanes_splat(0.0f);
    const uint32_t values = stored_values(pipeline);

    for (int c = 0; c < 4; ++c)
        lanes_store(output->position[c], lanes_splat(c == 3 ? 1.0f : 0.0f));
    for (uint32_t n = 0; n < values; ++n)
        lanes_store(output->varying[n], zero);
    if (output->point_size)
        lanes_store(output->point_size, lanes_splat(pipeline->raster.point_size));
}

/* Shades slots `from`, a multiple of sixteen, to end - 1. The shader writes to the memory of the
 * task's primitive_setup. Returns the union of the vertices' outcodes. */
static uint32_t shade_slots(const draw_state *draw, uint32_t task, uint32_t from, uint32_t end)
{
    float(*const staging)[GN_LANES] =
        (float(*)[GN_LANES])(void *)(task_scratch(draw, task) + scratch_setup_offset());
    GN_ALIGNED_LANES float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES];
    uint32_t vertex_id[GN_LANES];
    int32_t outcode[LANES];
    const bool is_ready_made = has_ready_made_vertices(draw);
    lanes_i outcodes = lanes_i_splat(0);
    gn_vertex_input input;
    gn_vertex_output output;
    uint32_t all = 0;

    input.attribute = (const float(*)[4][GN_LANES])attribute;
    input.vertex_id = vertex_id;
    input.instance = draw->slice.instance;
    input.present = present_attributes(&draw->slice);
    output.position = staging;
    output.varying = staging + 4;
    output.clip_distance = output.varying + draw->pipeline->program.varying_count;
    output.point_size = NULL;
    if (draw->pipeline->program.vertex_writes_point_size)
        output.point_size = staging[4 + stored_values(draw->pipeline)];
    fetch_constants(&draw->slice, attribute);
    set_vertex_defaults(draw->pipeline, &output);
    for (uint32_t slot = from; slot < end; slot += LANES) {
        input.count = end - slot < LANES ? end - slot : LANES;
        slot_vertices(draw, slot, input.count, vertex_id);
        fetch_attributes(&draw->slice, vertex_id, attribute);
        if (slot > from && !is_ready_made)
            set_vertex_defaults(draw->pipeline, &output);
        call_vertex_shader(draw, &input, &output);
        outcodes = lanes_i_or(outcodes, store_vertices(draw, &output, slot));
    }
    lanes_i_store(outcode, outcodes);
    GN_EACH_LANE (l)
        all |= (uint32_t)outcode[l];
    return all;
}

#endif
