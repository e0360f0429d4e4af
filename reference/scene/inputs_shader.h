/* The text of the shader of inputs, compiled once per instruction set (user_shaders_form.h), in the
 * order of operations of GLSL in the reference. */
#ifndef SCENE_INPUTS_SHADER_H
#define SCENE_INPUTS_SHADER_H

#include <string.h>

#include <gnomon.h>

enum { RED, GREEN, BLUE, ALPHA };

/* Writes a sample mask: a pattern of window coordinates, with bits of covered samples, of samples
 * that are not covered, and of no sample. */
static inline void shade_sample_mask(const gn_fragment_input *in, uint32_t mask[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        const int32_t column = in->x[l / 8] + l % 4;
        const int32_t row = in->y[l / 8] + l / 4 % 2;
        const int32_t pattern = column * 3 + row * 5;

        mask[l] = (uint32_t)pattern ^ (in->sample_mask ? in->sample_mask[l] : 0);
    }
}

/* Writes the colours: facing replaces red by one minus red; the primitive number (0 if it is not
 * read) is added to green. Each array is apart from the others (`restrict`), so that the compiler
 * can compute several lanes at once. */
static inline void shade_varyings(const gn_fragment_input *in,
                                  const float (*restrict varying)[GN_LANES],
                                  float (*restrict color)[GN_LANES])
{
    /* Products with powers of two are exact. */
    const float primitive = (float)(int32_t)(in->primitive_id & 1023u) * 0.015625f;
    const bool front_facing = in->front_facing;

    for (int l = 0; l < GN_LANES; ++l) {
        color[RED][l] = front_facing ? varying[RED][l] : 1.0f - varying[RED][l];
        color[GREEN][l] = varying[GREEN][l] + primitive;
        color[BLUE][l] = varying[BLUE][l];
        color[ALPHA][l] = varying[ALPHA][l];
    }
}

static inline void add_position(const float (*restrict position)[GN_LANES],
                                float (*restrict color)[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        color[RED][l] = color[RED][l] + position[0][l] * 0.0078125f;
        color[GREEN][l] = color[GREEN][l] + position[1][l] * 0.0078125f;
        color[BLUE][l] = position[2][l];
        color[ALPHA][l] = position[3][l];
    }
}

/* Returns the lanes whose alpha is below one half. A table takes the place of shifts, which not all
 * processors have for vectors of different counts. */
static inline uint32_t transparent_lanes(const float *alpha)
{
    static const uint32_t bit[16] = {1,   2,   4,    8,    16,   32,   64,    128,
                                     256, 512, 1024, 2048, 4096, 8192, 16384, 32768};
    uint32_t lanes = 0;

    for (int l = 0; l < GN_LANES; ++l)
        lanes |= alpha[l] < 0.5f ? bit[l] : 0;
    return lanes;
}

/* Products with powers of two are exact. */
static inline void add_sample(const gn_fragment_input *in, float (*restrict color)[GN_LANES])
{
    const float number = (float)(int32_t)in->sample_id * 0.125f;
    const float right = in->sample_position[0] * 0.25f, up = in->sample_position[1] * 0.25f;

    for (int l = 0; l < GN_LANES; ++l) {
        color[RED][l] = color[RED][l] + right;
        color[GREEN][l] = color[GREEN][l] + number;
        color[BLUE][l] = color[BLUE][l] + up;
    }
}

/* Does what the pipeline asks for: what the pointers that are not null stand for, and the sample if
 * `reads_sample`. */
static inline void shade_asked_inputs(const gn_fragment_input *in, gn_fragment_output *out,
                                      bool reads_sample)
{
    shade_varyings(in, in->varying, out->color);
    out->kept &= ~transparent_lanes(in->varying[ALPHA]);
    if (out->depth)
        memcpy(out->depth, in->varying[BLUE], GN_LANES * sizeof *out->depth);
    if (in->point_coordinate)
        memcpy(out->color[RED], in->point_coordinate[0], 2 * sizeof *in->point_coordinate);
    if (in->position)
        add_position(in->position, out->color);
    for (int l = 0; in->sample_mask && l < GN_LANES; ++l)
        out->color[GREEN][l] = out->color[GREEN][l] + (float)(int32_t)in->sample_mask[l] * 0.0625f;
    if (reads_sample)
        add_sample(in, out->color);
    if (out->sample_mask)
        shade_sample_mask(in, out->sample_mask);
}

static void shade_inputs(const void *uniforms, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)uniforms;
    shade_asked_inputs(in, out, false);
}

static void shade_sample_inputs(const void *uniforms, const gn_fragment_input *in,
                                gn_fragment_output *out)
{
    (void)uniforms;
    shade_asked_inputs(in, out, true);
}

#endif
