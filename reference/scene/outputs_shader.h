/* The text of the shaders with several colours, compiled once per instruction set
 * (user_shaders_form.h): one shader for each number of colours, since a fragment shader cannot read
 * that number. */
#ifndef SCENE_OUTPUTS_SHADER_H
#define SCENE_OUTPUTS_SHADER_H

#include <gnomon.h>

/* Shades an attachment. `restrict` says that the arrays do not overlap, so that the compiler can
 * compute several lanes at once. */
static inline void shade_output(const float *restrict red, const float *restrict green,
                                const float *restrict blue, const float *restrict alpha,
                                bool inverts, float (*restrict color)[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        const float r = red[l], g = green[l], b = blue[l], a = alpha[l];

        color[0][l] = inverts ? 1.0f - r : r;
        color[1][l] = inverts ? 1.0f - g : g;
        color[2][l] = inverts ? 1.0f - b : b;
        color[3][l] = inverts ? 1.0f - a : a;
    }
}

static inline void shade_outputs(const gn_fragment_input *in, gn_fragment_output *out, int count)
{
    for (int a = 0; a < count; ++a)
        shade_output(in->varying[a % 4], in->varying[(a + 1) % 4], in->varying[(a + 2) % 4],
                     in->varying[(a + 3) % 4], a % 2, out->color + 4 * a);
}

#define OUTPUTS(count)                                                                             \
    static void shade_outputs_##count(const void *uniforms, const gn_fragment_input *in,           \
                                      gn_fragment_output *out)                                     \
    {                                                                                              \
        (void)uniforms;                                                                            \
        shade_outputs(in, out, count);                                                             \
    }

OUTPUTS(1)
OUTPUTS(2)
OUTPUTS(3)
OUTPUTS(4)
OUTPUTS(5)
OUTPUTS(6)
OUTPUTS(7)
OUTPUTS(8)
#undef OUTPUTS

#endif
