/* Stands in for the shaders of scenes that no picture of the page has, so that the modules do not
 * contain them. */
#include "derivatives.h"
#include "inputs.h"
#include "outputs.h"
#include "phong.h"
#include "sampled.h"

gn_status phong_use(gn_pipeline *pipeline, const phong_uniforms *uniforms, gn_backend backend)
{
    (void)pipeline, (void)uniforms, (void)backend;
    return GN_NO_SHADER;
}

gn_status phong_use_functions(gn_pipeline *pipeline, const phong_uniforms *uniforms,
                              gn_backend backend)
{
    return phong_use(pipeline, uniforms, backend);
}

gn_status inputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms, gn_backend backend)
{
    (void)pipeline, (void)uniforms, (void)backend;
    return GN_NO_SHADER;
}

gn_status derivatives_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms,
                          gn_backend backend)
{
    return inputs_use(pipeline, uniforms, backend);
}

gn_status outputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms, gn_backend backend)
{
    return inputs_use(pipeline, uniforms, backend);
}

gn_status sampled_use(gn_pipeline *pipeline, const scene_uniforms *uniforms, gn_backend backend)
{
    (void)pipeline, (void)uniforms, (void)backend;
    return GN_NO_SHADER;
}
