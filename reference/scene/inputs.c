/* Implements the shader of inputs.h, in the order of operations of GLSL in the reference. */
#include "inputs.h"

/* 1/64, 1/128 and 1/16: products with powers of two are exact. */
#define PRIMITIVE_STEP 0.015625f
#define PIXEL_STEP 0.0078125f
#define SAMPLES_STEP 0.0625f

enum { RED, GREEN, BLUE, ALPHA };

/* Facing replaces red by one minus red. The primitive number (0 if it is not read) and the sample
 * mask are added to green. A mask that the shader writes is a pattern of window coordinates, with
 * bits of covered samples, of samples that are not covered, and of no sample. The pointers that are
 * not null tell what the pipeline asks of the shader. */
static void shade_inputs(const void *uniforms, const gn_fragment_input *in, gn_fragment_output *out)
{
    const float primitive = (float)(int32_t)(in->primitive_id & 1023u) * PRIMITIVE_STEP;

    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l) {
        const float red = in->varying[RED][l];
        const float alpha = in->varying[ALPHA][l];

        out->color[RED][l] = in->front_facing ? red : 1.0f - red;
        out->color[GREEN][l] = in->varying[GREEN][l] + primitive;
        out->color[BLUE][l] = in->varying[BLUE][l];
        out->color[ALPHA][l] = alpha;
        if (alpha < 0.5f)
            out->kept &= ~(1u << l);
        if (out->depth)
            out->depth[l] = in->varying[BLUE][l];
    }
    for (int l = 0; in->point_coordinate && l < GN_LANES; ++l) {
        out->color[RED][l] = in->point_coordinate[0][l];
        out->color[GREEN][l] = in->point_coordinate[1][l];
    }
    for (int l = 0; in->position && l < GN_LANES; ++l) {
        out->color[RED][l] = out->color[RED][l] + in->position[0][l] * PIXEL_STEP;
        out->color[GREEN][l] = out->color[GREEN][l] + in->position[1][l] * PIXEL_STEP;
        out->color[BLUE][l] = in->position[2][l];
        out->color[ALPHA][l] = in->position[3][l];
    }
    for (int l = 0; in->sample_mask && l < GN_LANES; ++l) {
        out->color[GREEN][l] =
            out->color[GREEN][l] + (float)(int32_t)in->sample_mask[l] * SAMPLES_STEP;
    }
    for (int l = 0; out->sample_mask && l < GN_LANES; ++l) {
        const int32_t column = in->x[l / 8] + l % 4;
        const int32_t row = in->y[l / 8] + l / 4 % 2;
        const int32_t pattern = column * 3 + row * 5;

        out->sample_mask[l] = (uint32_t)pattern ^ (in->sample_mask ? in->sample_mask[l] : 0);
    }
}

gn_status inputs_use(gn_pipeline *pipeline, const gn_color_uniforms *uniforms)
{
    const gn_status status = gn_use_vertex_color(pipeline, uniforms);

    pipeline->program.fragment_shader = shade_inputs;
    return status;
}
