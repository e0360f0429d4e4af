/* Outcodes, the perspective division, the viewport and snapping (OpenGL 4.5 section 13.6), for
 * sixteen vertices. */
#ifndef GN_KERNEL_GEOMETRY_VIEWPORT_INL
#define GN_KERNEL_GEOMETRY_VIEWPORT_INL

#include "geometry.h"

#include "../../lanes/lanes.h"

static inline viewport_transform
viewport_transform_of(const gn_pipeline *pipeline, uint32_t target_width, uint32_t target_height)
{
    const gn_viewport *v = &pipeline->raster.viewport;
    const float x = v->enabled ? v->x : 0.0f;
    const float y = v->enabled ? v->y : 0.0f;
    const float width = v->enabled ? v->width : (float)target_width;
    const float height = v->enabled ? v->height : (float)target_height;
    const float z_near = pipeline->depth.range.enabled ? pipeline->depth.range.z_near : 0.0f;
    const float z_far = pipeline->depth.range.enabled ? pipeline->depth.range.z_far : 1.0f;

    /* The reference computes (z_far -+ z_near) / 2 in double and rounds to float once; one float
     * operation has the same result. If the exponents are at most 29 apart, the double sum is
     * exact; otherwise the smaller operand is below 2^-5 ulp of the larger and both ways return the
     * larger. Halving is exact. */
    viewport_transform t;
    t.scale[0] = 0.5f * width;
    t.scale[1] = 0.5f * height;
    t.scale[2] = 0.5f * (z_far - z_near);
    t.translate[0] = t.scale[0] + x;
    t.translate[1] = t.scale[1] + y;
    t.translate[2] = 0.5f * (z_near + z_far);
    t.planes = (1u << CLIP_DISTANCE) - 1;
    t.zero_to_one = pipeline->depth.clip_depth == GN_ZERO_TO_ONE;
    if (t.zero_to_one) {
        t.scale[2] = z_far - z_near;
        t.translate[2] = z_near;
    }
    t.snaps_from_corner = false;
    if (pipeline->depth.clamp_enabled)
        t.planes &= ~(1u << CLIP_NEAR | 1u << CLIP_FAR);
    return t;
}

/* Returns bit `plane` where a <= b does not hold. */
static inline lanes_i outside_bit(lanes_f a, lanes_f b, clipping_plane plane)
{
    return lanes_i_and(lanes_m_as_int(lanes_not(lanes_less_equal(a, b))),
                       lanes_i_splat(1 << plane));
}

GN_FRAMED lanes_i outcodes_of(const viewport_transform *viewport, const lanes_f clip[4])
{
    const lanes_f zero = lanes_splat(0.0f);
    const lanes_f w = clip[3];
    const lanes_f near_distance = viewport->zero_to_one ? clip[2] : lanes_add(clip[2], w);
    lanes_i code = outside_bit(clip[0], w, CLIP_RIGHT);

    code = lanes_i_or(code, outside_bit(zero, lanes_add(clip[0], w), CLIP_LEFT));
    code = lanes_i_or(code, outside_bit(clip[1], w, CLIP_TOP));
    code = lanes_i_or(code, outside_bit(zero, lanes_add(clip[1], w), CLIP_BOTTOM));
    code = lanes_i_or(code, outside_bit(zero, near_distance, CLIP_NEAR));
    code = lanes_i_or(code, outside_bit(clip[2], w, CLIP_FAR));
    return lanes_i_and(code, lanes_i_splat((int32_t)viewport->planes));
}

/* Returns the outcode bits of clip distances. */
GN_FRAMED lanes_i distance_outcodes(const float (*distance)[GN_LANES], uint32_t count)
{
    lanes_i code = lanes_i_splat(0);

    for (uint32_t i = 0; i < count; ++i) {
        const lanes_f d = lanes_load(distance[i]);
        const lanes_m inside = lanes_and(lanes_less_equal(lanes_splat(0.0f), d),
                                         lanes_less_equal(d, lanes_splat(FLT_MAX)));

        code = lanes_i_or(code, lanes_i_and(lanes_m_as_int(lanes_not(inside)),
                                            lanes_i_splat(1 << (CLIP_DISTANCE + i))));
    }
    return code;
}

/* Stores sixteen vertices at `first`, `stride` bytes apart: window, snapped and clip coordinates,
 * outcodes, to which `outside` is added, and point sizes (the bits of floats). Returns the
 * outcodes. */
static inline lanes_i place_vertices(const viewport_transform *viewport, const lanes_f clip[4],
                                     lanes_i outside, lanes_i point_size, unsigned char *first,
                                     uint32_t stride)
{
    const lanes_f one_over_w = lanes_div(lanes_splat(1.0f), clip[3]);
    lanes_i window[4], snapped[VERTEX_WORDS], position[4];

    GN_UNROLLED
    for (int c = 0; c < 3; ++c) {
        const lanes_f ndc = lanes_mul(clip[c], one_over_w);
        const lanes_f coordinate = lanes_add(lanes_mul(ndc, lanes_splat(viewport->scale[c])),
                                             lanes_splat(viewport->translate[c]));

        window[c] = lanes_as_int(coordinate);
        if (c < 2) {
            const bool from_corner = DRAWS_SAMPLES && viewport->snaps_from_corner;
            const lanes_f origin = lanes_splat(from_corner ? 0.0f : 0.5f);
            snapped[c] = lanes_round(lanes_mul(lanes_sub(coordinate, origin), lanes_splat(256.0f)));
            if (from_corner)
                snapped[c] = lanes_i_sub(snapped[c], lanes_i_splat(128));
        }
    }
    window[3] = lanes_as_int(one_over_w);
    snapped[SNAPPED_OUTCODE] = outcodes_of(viewport, clip);
    if (GN_HAVE_DISTANCES)
        snapped[SNAPPED_OUTCODE] = lanes_i_or(snapped[SNAPPED_OUTCODE], outside);
    snapped[SNAPPED_POINT_SIZE] = point_size;
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        position[c] = lanes_as_int(clip[c]);
    lanes_i_scatter_rows(first + VERTEX_WINDOW, stride, window);
    lanes_i_scatter_rows(first + VERTEX_SNAPPED, stride, snapped);
    lanes_i_scatter_rows(first + VERTEX_CLIP, stride, position);
    return snapped[SNAPPED_OUTCODE];
}

#endif
