/* Chooses Phong's shaders for a pipeline. The library cannot compile a user's function for wider
 * vectors. A user who wants speed compiles a shader once per instruction set, and takes the one for
 * the back end that will run it: that the back end is available shows that the processor has the
 * instruction set. */
#include "phong.h"

#include <string.h>

gn_vertex_shader phong_vertex_baseline, phong_vertex_avx2, phong_vertex_avx512;
gn_fragment_shader phong_fragment_baseline, phong_fragment_avx2, phong_fragment_avx512;

typedef void phong_use_function(gn_pipeline *pipeline, const phong_uniforms *uniforms);
phong_use_function phong_use_functions_baseline, phong_use_functions_avx2,
    phong_use_functions_avx512;

/* The back end may be an emulated one. */
static bool processor_has_avx512(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
    return __builtin_cpu_supports("avx512f");
#else
    return false;
#endif
}

gn_status phong_use(gn_pipeline *pipeline, const phong_uniforms *uniforms, gn_backend backend)
{
    const char *name = gn_backend_name(backend == GN_BACKEND_AUTO ? gn_backend_best() : backend);
    gn_status status = gn_texture_check(&uniforms->texture);

    if (status == GN_OK)
        status = gn_sampler_check(&uniforms->sampler);
    if (status != GN_OK)
        return status;
    if (strcmp(name, "avx512") == 0 && processor_has_avx512()) {
        pipeline->program.vertex_shader = phong_vertex_avx512;
        pipeline->program.fragment_shader = phong_fragment_avx512;
    } else if (strcmp(name, "avx2") == 0) {
        pipeline->program.vertex_shader = phong_vertex_avx2;
        pipeline->program.fragment_shader = phong_fragment_avx2;
    } else {
        pipeline->program.vertex_shader = phong_vertex_baseline;
        pipeline->program.fragment_shader = phong_fragment_baseline;
    }
    pipeline->program.uniforms = uniforms;
    pipeline->program.varying_count = PHONG_VARYINGS;
    for (int n = 0; n < PHONG_VARYINGS; ++n)
        pipeline->program.interpolation[n] = GN_SMOOTH;
    return GN_OK;
}

gn_status phong_use_functions(gn_pipeline *pipeline, const phong_uniforms *uniforms,
                              gn_backend backend)
{
    const gn_status status = phong_use(pipeline, uniforms, backend);

    if (status != GN_OK)
        return status;
    if (pipeline->program.fragment_shader == phong_fragment_avx512)
        phong_use_functions_avx512(pipeline, uniforms);
    else if (pipeline->program.fragment_shader == phong_fragment_avx2)
        phong_use_functions_avx2(pipeline, uniforms);
    else
        phong_use_functions_baseline(pipeline, uniforms);
    return GN_OK;
}
