/* Sets users' shaders with their uniforms and varyings (phong.h, sampled.h, inputs.h, outputs.h,
 * derivatives.h). */
#include "derivatives.h"
#include "inputs.h"
#include "outputs.h"
#include "phong.h"
#include "sampled.h"
#include "user_shaders.h"

static gn_status check_sampling(const gn_texture *texture, const gn_sampler *sampler)
{
    const gn_status status = gn_texture_check(texture);

    return status == GN_OK ? gn_sampler_check(sampler) : status;
}

static void set_smooth_varyings(gn_pipeline *pipeline, uint32_t count)
{
    pipeline->program.varying_count = count;
    for (uint32_t n = 0; n < count; ++n)
        pipeline->program.interpolation[n] = GN_SMOOTH;
}

/* Sets a fragment shader that writes this many colours. */
static void set_fragment_shader(gn_pipeline *pipeline, gn_fragment_shader *shader, uint32_t colors)
{
    pipeline->program.fragment_shader = shader;
    pipeline->program.fragment_writes_all_colors = pipeline->program.color_count <= colors;
}

/* Phong's shader samples textures of two dimensions alone. */
static gn_status check_phong(const phong_uniforms *uniforms)
{
    const gn_status status = check_sampling(&uniforms->texture, &uniforms->sampler);

    return status || uniforms->texture.target == GN_TEXTURE_2D ? status : GN_INVALID_ENUM;
}

gn_status phong_use(gn_pipeline *pipeline, const phong_uniforms *uniforms, gn_backend backend)
{
    const user_shaders *const shaders = user_shaders_for(backend);
    const gn_status status = check_phong(uniforms);

    if (status == GN_OK) {
        pipeline->program.vertex_shader = shaders->phong_vertices;
        set_fragment_shader(pipeline, shaders->phong, 1);
        pipeline->program.uniforms = uniforms;
        set_smooth_varyings(pipeline, PHONG_VARYINGS);
    }
    return status;
}

gn_status phong_use_functions(gn_pipeline *pipeline, const phong_uniforms *uniforms,
                              gn_backend backend)
{
    const gn_status status = check_phong(uniforms);

    return status ? status : user_shaders_for(backend)->use_phong_functions(pipeline, uniforms);
}

gn_status sampled_use(gn_pipeline *pipeline, const scene_uniforms *uniforms, gn_backend backend)
{
    const user_shaders *const shaders = user_shaders_for(backend);
    const gn_status status = check_sampling(&uniforms->texture, &uniforms->sampler);

    if (status == GN_OK) {
        pipeline->program.vertex_shader = shaders->sampled_vertices;
        set_fragment_shader(pipeline, shaders->sampled, 1);
        pipeline->program.uniforms = uniforms;
        set_smooth_varyings(pipeline, SAMPLED_COORDINATES + sampled_coordinates(uniforms) +
                                          (sampled_is_compared(uniforms) ? 1 : 0));
    }
    return status;
}

gn_status inputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms, gn_backend backend)
{
    const bool discards = pipeline->program.fragment_discards;
    const gn_status status = gn_use_vertex_color(pipeline, uniforms);
    const user_shaders *const shaders = user_shaders_for(backend);

    pipeline->program.fragment_discards = discards;
    set_fragment_shader(
        pipeline,
        pipeline->program.fragment_reads_sample ? shaders->sample_inputs : shaders->inputs, 1);
    return status;
}

gn_status derivatives_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms,
                          gn_backend backend)
{
    const gn_status status = gn_use_vertex_color(pipeline, uniforms);

    set_fragment_shader(pipeline, user_shaders_for(backend)->derivatives, 1);
    return status;
}

gn_status outputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms, gn_backend backend)
{
    const gn_status status = gn_use_vertex_color(pipeline, uniforms);
    const uint32_t count = pipeline->program.color_count ? pipeline->program.color_count : 1;

    set_fragment_shader(pipeline, user_shaders_for(backend)->outputs[(count - 1) % GN_MAX_COLORS],
                        count);
    return status;
}
