/* All of a user's shaders, as one table, which each file that includes this one calls
 * USER_SHADERS. USE_PHONG_FUNCTIONS is a function of phong_function_shader.h, which is compiled
 * with other flags. Not alone: both names are defined by each file that includes it. */
#ifndef SCENE_USER_SHADERS_FORM_H
#define SCENE_USER_SHADERS_FORM_H

#include "derivatives_shader.h"
#include "inputs_shader.h"
#include "outputs_shader.h"
#include "phong_shader.h"
#include "sampled_shader.h"
#include "user_shaders.h"

extern const user_shaders USER_SHADERS;
gn_status USE_PHONG_FUNCTIONS(gn_pipeline *pipeline, const phong_uniforms *uniforms);

const user_shaders USER_SHADERS = {shade_phong_vertices,
                                   shade_sampled_vertices,
                                   shade_phong,
                                   shade_sampled,
                                   shade_inputs,
                                   shade_sample_inputs,
                                   shade_derivatives,
                                   {shade_outputs_1, shade_outputs_2, shade_outputs_3,
                                    shade_outputs_4, shade_outputs_5, shade_outputs_6,
                                    shade_outputs_7, shade_outputs_8},
                                   USE_PHONG_FUNCTIONS};

#endif
