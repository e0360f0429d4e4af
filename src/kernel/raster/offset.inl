/* Polygon offset (OpenGL 4.5 section 14.6.5): adds to depths according to the triangle's slope and
 * in units of the depth format's resolution. */
#ifndef GN_KERNEL_RASTER_OFFSET_INL
#define GN_KERNEL_RASTER_OFFSET_INL

#include "raster.h"

#include "../../lanes/lanes.h"
#include "../../scalars/bits.h"

typedef struct offset_state {
    bool moves;    /* each triangle has an offset of its own; otherwise all are 0 */
    bool floating; /* the resolution is that of the triangle's greatest |depth| */
    float factor;
    float units; /* times the format's resolution, if that is a constant */
    float clamp; /* above 0: the greatest offset; below 0: the least; 0: none */
} offset_state;

/* For formats of 16 and 24 bits the reference takes twice the smallest difference. In the
 * reference, factor 0 with units 0 is no offset, even if the slope is infinite. */
static inline offset_state offset_state_of(const gn_pipeline *pipeline, gn_format depth_format,
                                           bool moves)
{
    const gn_polygon_offset *p = &pipeline->raster.polygon_offset;
    const bool has_24 = depth_format == GN_FORMAT_D24 || depth_format == GN_FORMAT_D24S8;
    const float per_depth = depth_format == GN_FORMAT_D16 ? 65535.0f / 2.0f
                            : has_24                      ? 16777215.0f / 2.0f
                                                          : 1.0f;
    offset_state s;

    s.floating = depth_format == GN_FORMAT_D32F || depth_format == GN_FORMAT_D32FS8;
    s.factor = p->enabled ? p->factor : 0.0f;
    s.units = p->enabled ? p->units / per_depth : 0.0f;
    s.clamp = p->enabled ? p->clamp : 0.0f;
    s.moves = moves && (s.factor != 0.0f || s.units != 0.0f);
    return s;
}

/* Returns 2^(e - 23) for the exponent e of a depth's magnitude; 0 where that is denormal. */
static inline lanes_f depth_resolution(lanes_f depth)
{
    const lanes_i exponent = lanes_i_and(lanes_as_int(depth), lanes_i_splat(0x7F800000));
    const lanes_i resolution = lanes_i_add(exponent, lanes_i_splat(-(23 << 23)));

    return lanes_as_float(lanes_i_max(resolution, lanes_i_splat(0)));
}

/* Returns the offsets of sixteen triangles with these window coordinates. As in the reference, the
 * slope is that along x if one of the two is NaN, and a clamp leaves NaN: lanes_min and lanes_max
 * return their second operand then. */
GN_FRAMED lanes_f offset_depths(const offset_state *offset, const lanes_f x[3], const lanes_f y[3],
                                const lanes_f z[3])
{
    const lanes_f dx01 = lanes_sub(x[0], x[1]);
    const lanes_f dy01 = lanes_sub(y[0], y[1]);
    const lanes_f dz01 = lanes_sub(z[0], z[1]);
    const lanes_f dx20 = lanes_sub(x[2], x[0]);
    const lanes_f dy20 = lanes_sub(y[2], y[0]);
    const lanes_f dz20 = lanes_sub(z[2], z[0]);
    const lanes_f one_over_area =
        lanes_div(lanes_splat(1.0f), lanes_sub(lanes_mul(dx01, dy20), lanes_mul(dx20, dy01)));
    const lanes_f per_x = lanes_sub(lanes_mul(dz01, dy20), lanes_mul(dz20, dy01));
    const lanes_f per_y = lanes_sub(lanes_mul(dz20, dx01), lanes_mul(dz01, dx20));
    const lanes_f slope = lanes_max(lanes_magnitude(lanes_mul(per_y, one_over_area)),
                                    lanes_magnitude(lanes_mul(per_x, one_over_area)));
    lanes_f by_units = lanes_splat(offset->units);

    if (offset->floating)
        by_units = lanes_mul(
            depth_resolution(lanes_max(lanes_max(lanes_magnitude(z[0]), lanes_magnitude(z[1])),
                                       lanes_magnitude(z[2]))),
            by_units);

    const lanes_f sum = lanes_add(by_units, lanes_mul(slope, lanes_splat(offset->factor)));
    if (offset->clamp > 0.0f)
        return lanes_min(lanes_splat(offset->clamp), sum);
    if (offset->clamp < 0.0f)
        return lanes_max(lanes_splat(offset->clamp), sum);
    return sum;
}

/* Returns the offset of one triangle of a draw in which some are not filled. The reference computes
 * such a draw's offsets in another order. */
static inline float offset_of_vertices(const offset_state *offset, const stored_vertex *const v[3])
{
    float e[3], f[3];
    float greatest = 0.0f;

    for (int c = 0; c < 3; ++c) {
        e[c] = v[0]->window[c] - v[2]->window[c];
        f[c] = v[1]->window[c] - v[2]->window[c];
    }
    const float one_over_area = 1.0f / (e[0] * f[1] - e[1] * f[0]);
    const float per_x = (e[1] * f[2] - e[2] * f[1]) * one_over_area;
    const float per_y = (e[2] * f[0] - e[0] * f[2]) * one_over_area;
    const float x = per_x < 0.0f ? -per_x : per_x;
    const float y = per_y < 0.0f ? -per_y : per_y;
    float by_units = offset->units;

    if (offset->floating) {
        for (int i = 0; i < 3; ++i) {
            const float z = v[i]->window[2] < 0.0f ? -v[i]->window[2] : v[i]->window[2];

            greatest = z > greatest ? z : greatest;
        }
        const int32_t resolution = (int32_t)(float_bits(greatest) & 0x7F800000) - (23 << 23);
        by_units *= float_from_bits((uint32_t)(resolution > 0 ? resolution : 0));
    }

    const float sum = by_units + (x > y ? x : y) * offset->factor;
    if (offset->clamp > 0.0f)
        return sum < offset->clamp ? sum : offset->clamp;
    if (offset->clamp < 0.0f)
        return sum > offset->clamp ? sum : offset->clamp;
    return sum;
}

#endif
