/* Implements the shaders of outputs.h: one for each number of colours, since a fragment shader
 * cannot read that number. */
#include "outputs.h"

static void shade_outputs(const gn_fragment_input *in, gn_fragment_output *out, int count)
{
    for (int a = 0; a < count; ++a) {
        for (int c = 0; c < 4; ++c) {
            for (int l = 0; l < GN_LANES; ++l) {
                const float v = in->varying[(c + a) % 4][l];

                out->color[4 * a + c][l] = a % 2 ? 1.0f - v : v;
            }
        }
    }
}

#define SHADE(count)                                                                               \
    static void shade_##count(const void *uniforms, const gn_fragment_input *in,                   \
                              gn_fragment_output *out)                                             \
    {                                                                                              \
        (void)uniforms;                                                                            \
        shade_outputs(in, out, count);                                                             \
    }

SHADE(1)
SHADE(2)
SHADE(3)
SHADE(4)
SHADE(5)
SHADE(6)
SHADE(7)
SHADE(8)

gn_status outputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms)
{
    static gn_fragment_shader *const shaders[GN_MAX_COLORS] = {shade_1, shade_2, shade_3, shade_4,
                                                               shade_5, shade_6, shade_7, shade_8};
    const gn_status status = gn_use_vertex_color(pipeline, uniforms);
    const uint32_t count = pipeline->program.color_count ? pipeline->program.color_count : 1;

    pipeline->program.fragment_shader = shaders[(count - 1) % GN_MAX_COLORS];
    return status;
}
