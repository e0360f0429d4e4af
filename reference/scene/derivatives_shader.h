/* The text of the shader of derivatives, compiled once per instruction set (user_shaders_form.h).
 */
#ifndef SCENE_DERIVATIVES_SHADER_H
#define SCENE_DERIVATIVES_SHADER_H

#include <gnomon.h>

static void shade_derivatives(const void *uniforms, const gn_fragment_input *in,
                              gn_fragment_output *out)
{
    float product[GN_LANES];

    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l)
        product[l] = in->varying[3][l] * in->varying[0][l];
    gn_derivative_x(in->varying[0], out->color[0]);
    gn_derivative_y(in->varying[1], out->color[1]);
    gn_derivative_width(in->varying[2], out->color[2]);
    gn_derivative_y(product, out->color[3]);
}

#endif
