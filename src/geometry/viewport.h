/* Outcodes, the perspective division, the viewport and snapping
 * (OpenGL 4.5 section 13.6), for a batch of vertices. */
#ifndef GN_GEOMETRY_VIEWPORT_H
#define GN_GEOMETRY_VIEWPORT_H

#include "types.h"

#include "../lanes/lanes.h"

static inline viewport_transform
viewport_transform_of(const gn_pipeline *pipeline, uint32_t target_width, uint32_t target_height)
{
    const gn_viewport *v = &pipeline->viewport;
    const float x = v->set ? v->x : 0.0f;
    const float y = v->set ? v->y : 0.0f;
    const float width = v->set ? v->width : (float)target_width;
    const float height = v->set ? v->height : (float)target_height;
    const float z_near = pipeline->depth_range.set ? pipeline->depth_range.z_near : 0.0f;
    const float z_far = pipeline->depth_range.set ? pipeline->depth_range.z_far : 1.0f;

    /* The reference computes (z_far -+ z_near) / 2 in double and rounds to float
     * once; one float operation gives the same. Where the exponents are at most 29
     * apart the double sum is exact; otherwise the smaller operand is below 2^-5
     * ulp of the larger and both ways give the larger. Halving is exact. */
    viewport_transform t;
    t.scale[0] = 0.5f * width;
    t.scale[1] = 0.5f * height;
    t.scale[2] = 0.5f * (z_far - z_near);
    t.translate[0] = t.scale[0] + x;
    t.translate[1] = t.scale[1] + y;
    t.translate[2] = 0.5f * (z_near + z_far);
    return t;
}

static void compute_outcodes(vertex_batch *batch)
{
    GN_EACH_LANE (l) {
        const float x = batch->clip[0][l];
        const float y = batch->clip[1][l];
        const float z = batch->clip[2][l];
        const float w = batch->clip[3][l];

        batch->outcode[l] =
            (uint32_t) !(x <= w) << CLIP_RIGHT | (uint32_t) !(0.0f <= x + w) << CLIP_LEFT |
            (uint32_t) !(y <= w) << CLIP_TOP | (uint32_t) !(0.0f <= y + w) << CLIP_BOTTOM |
            (uint32_t) !(0.0f <= z + w) << CLIP_NEAR | (uint32_t) !(z <= w) << CLIP_FAR;
    }
}

static inline void transform_batch(const viewport_transform *viewport, vertex_batch *batch)
{
    const lanes_f one_over_w = lanes_div(lanes_splat(1.0f), lanes_load(batch->clip[3]));

    compute_outcodes(batch);
    for (int c = 0; c < 3; ++c) {
        const lanes_f ndc = lanes_mul(lanes_load(batch->clip[c]), one_over_w);
        const lanes_f window = lanes_add(lanes_mul(ndc, lanes_splat(viewport->scale[c])),
                                         lanes_splat(viewport->translate[c]));

        lanes_store(batch->window[c], window);
        if (c < 2) {
            const lanes_f centred = lanes_sub(window, lanes_splat(0.5f));
            lanes_i_store(batch->snapped[c], lanes_round(lanes_mul(centred, lanes_splat(256.0f))));
        }
    }
    lanes_store(batch->window[3], one_over_w);
}

#endif
