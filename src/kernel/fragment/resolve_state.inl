/* Resolves, once per draw, what its pipeline and target ask of fragments. */
#ifndef GN_KERNEL_FRAGMENT_RESOLVE_STATE_INL
#define GN_KERNEL_FRAGMENT_RESOLVE_STATE_INL

#include "../shaders/vertex.inl"
#include "../texture/lookup_one_level.inl"

#include "output.inl"
#include "depth.inl"
#include "shader.inl"
#include "stencil.inl"

/* Whether the write mask leaves out every channel of the format. */
static inline bool writes_nothing(const color_state *s)
{
    return (s->written_bits[0] | s->written_bits[1] | s->written_bits[2] | s->written_bits[3]) == 0;
}

/* Sets the attachments after the first that the shader writes. */
static inline void set_more_colors(fragment_state *s, const gn_target *target,
                                   const gn_pipeline *pipeline)
{
    for (uint32_t a = 1; a < pipeline->program.color_count; ++a) {
        color_output *const output = &s->more[a - 1];

        output->surface = target->color[a];
        if (output->surface.format == GN_FORMAT_NONE)
            continue;
        set_color_state(&output->combine, pipeline, a, output->surface.format);
        if (writes_nothing(&output->combine))
            output->surface.format = GN_FORMAT_NONE;
        else
            s->more_count = a;
    }
}

/* Finds out whether the fragment shader is inlined: a colour, with or without a texture. */
static inline void set_source(fragment_state *s, const gn_pipeline *pipeline)
{
    const gn_lit_uniforms *const lit = (const gn_lit_uniforms *)pipeline->program.uniforms;
    const gn_unlit_uniforms *const unlit = (const gn_unlit_uniforms *)pipeline->program.uniforms;
    gn_fragment_shader *const shader = pipeline->program.fragment_shader;

    s->texture = 0;
    s->sampler = 0;
    s->source = SOURCE_SHADER;
    if (!GN_HAVE_ROWS || s->is_late || s->color.format == GN_FORMAT_NONE ||
        pipeline->program.color_count > 1 || pipeline->samples.alpha_to_coverage_enabled ||
        pipeline->samples.alpha_to_one_enabled || pipeline->program.fragment_writes_sample_mask ||
        s->runs_per_sample || s->is_located)
        return;
    if (shader == gni_shade_lit_texture) {
        s->texture = lit->material.diffuse_map;
        s->sampler = &lit->material.sampler;
    } else if (shader == gni_shade_unlit_texture) {
        s->texture = unlit->map;
        s->sampler = &unlit->sampler;
    } else if (shader != gni_shade_color) {
        return;
    }
    if (s->texture && !is_simple(s->texture, s->sampler))
        return;
    if (pipeline->program.varying_count < (s->texture ? MAPPED_VARYINGS : COLOR_VARYINGS))
        return;
    s->source = s->texture ? SOURCE_TEXTURE : SOURCE_COLOR;
    if (LANES == 1 && s->texture)
        set_masked_words(&s->nearest, s->texture, s->sampler);
}

static inline void set_shader_inputs(fragment_state *s, const gn_pipeline *pipeline)
{
    const bool reads_position = pipeline->program.fragment_reads_position;

    s->reads_centers = reads_position && !s->runs_per_sample;
    s->has_optional_inputs = (reads_position && s->runs_per_sample) ||
                             pipeline->program.fragment_reads_point_coordinate ||
                             pipeline->program.fragment_reads_sample_mask ||
                             pipeline->program.fragment_writes_sample_mask;
    s->is_smooth = true;
    for (uint32_t n = 0; n < pipeline->program.varying_count; ++n)
        s->is_smooth = s->is_smooth && pipeline->program.interpolation[n] == GN_SMOOTH;
}

/* Whether the stencil test is on and may write. */
static inline bool may_write_stencil(const fragment_state *s)
{
    return s->tests_stencil && (s->stencil[0].written | s->stencil[1].written) != 0;
}

/* Sets where the varyings of a multisampled target are interpolated, when the shader runs and how
 * often. */
GN_OUT_OF_LINE void set_sample_shading(fragment_state *s, const gn_pipeline *pipeline)
{
    const bool all = shades_all_samples(pipeline);

    s->covers_late =
        pipeline->program.fragment_writes_sample_mask ||
        (pipeline->samples.alpha_to_coverage_enabled && pipeline->program.fragment_shader != 0);
    s->runs_per_sample = all || pipeline->program.fragment_reads_sample;
    for (uint32_t n = 0; n < pipeline->program.varying_count; ++n) {
        const gn_interpolation_point location = pipeline->program.interpolated_at[n];

        s->runs_per_sample = s->runs_per_sample || location == GN_AT_SAMPLE;
        s->is_located = s->is_located || (location != GN_AT_CENTER && !all);
    }
}

/* Resolves the state of a draw. `any` is one of the target's surfaces, which have one size. */
static inline void set_fragment_state(fragment_state *s, const gn_target *target,
                                      const gn_surface *any, const gn_pipeline *pipeline,
                                      const viewport_transform *viewport)
{
    const gn_format format = target->depth.format;

    s->pipeline = pipeline;
    s->width = any->width;
    s->height = any->height;
    for (int i = 0; i < 2; ++i) {
        s->test_at[i] = 0.0f;
        s->shade_at[i] = 0.0f;
    }
    s->is_late = pipeline->program.fragment_discards || pipeline->program.fragment_writes_depth;
    s->runs_per_sample = s->is_located = s->covers_late = false;
    s->sample = 0;
    if (DRAWS_SAMPLES && samples_of(any) > 1)
        set_sample_shading(s, pipeline);
    set_shader_inputs(s, pipeline);
    s->color = target->color[0];
    s->depth = target->depth;
    s->combine.use = COLOR_REPLACES;
    s->combine.read = GN_CHANNEL_ALL;
    if (GN_HAVE_COMBINING) {
        set_color_state(&s->combine, pipeline, 0, s->color.format);
        if (writes_nothing(&s->combine) && !pipeline->samples.alpha_to_coverage_enabled)
            s->color.format = GN_FORMAT_NONE;
    }
    set_source(s, pipeline);
    s->tests_depth = pipeline->depth.test_enabled && format_has_depth(format);
    s->tests_stencil = pipeline->stencil.test_enabled && format_has_stencil(format);
    if (!s->tests_depth && !s->tests_stencil)
        s->depth.format = GN_FORMAT_NONE;
    s->test = depth_comparison_of(pipeline);
    if (GN_HAVE_STENCIL) {
        set_stencil_state(&s->stencil[0], &pipeline->stencil.front, format);
        set_stencil_state(&s->stencil[1], &pipeline->stencil.back, format);
    }
    s->previews_tests = DRAWS_SAMPLES && s->is_located && s->depth.format != GN_FORMAT_NONE &&
                        !pipeline->program.fragment_writes_depth && !may_write_stencil(s);
    s->moves_depth = pipeline->raster.polygon_offset.enabled &&
                     (s->tests_depth || pipeline->program.fragment_reads_position);
    s->more_count = 0;
    s->combines = combines(&s->combine, s->color.format);
    if (GN_HAVE_ATTACHMENTS)
        set_more_colors(s, target, pipeline);
    for (uint32_t a = 0; GN_HAVE_ATTACHMENTS && a < s->more_count; ++a) {
        const color_output *const output = &s->more[a];

        if (output->surface.format != GN_FORMAT_NONE &&
            combines(&output->combine, output->surface.format))
            s->combines = true;
    }
    s->replaces_rgba8 = s->source != SOURCE_SHADER && s->color.format == GN_FORMAT_RGBA8 &&
                        s->combine.use == COLOR_REPLACES;
    s->row_varyings = 0;
    if (GN_STATES_SPECIALISED && s->source != SOURCE_SHADER && s->combine.read != 0)
        s->row_varyings = s->source == SOURCE_TEXTURE ? MAPPED_VARYINGS : COLOR_VARYINGS;
    s->limits = depth_limits_of(pipeline, viewport);
    s->clamps_depth = s->tests_depth && (s->limits.low != 0.0f || s->limits.high != 1.0f);
}

#endif
