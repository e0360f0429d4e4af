/* Implements the shader of derivatives.h. */
#include "derivatives.h"

enum { RED, GREEN, BLUE, ALPHA };

static void shade_derivatives(const void *uniforms, const gn_fragment_input *in,
                              gn_fragment_output *out)
{
    float product[GN_LANES];

    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l)
        product[l] = in->varying[ALPHA][l] * in->varying[RED][l];
    gn_derivative_x(in->varying[RED], out->color[RED]);
    gn_derivative_y(in->varying[GREEN], out->color[GREEN]);
    gn_derivative_width(in->varying[BLUE], out->color[BLUE]);
    gn_derivative_y(product, out->color[ALPHA]);
}

gn_status derivatives_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms)
{
    const gn_status status = gn_use_vertex_color(pipeline, uniforms);

    pipeline->program.fragment_shader = shade_derivatives;
    return status;
}
