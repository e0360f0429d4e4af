/* The depth test (OpenGL 4.5 section 17.3.5), on the values the format holds. */
#include "fragment.h"

typedef union float_bits {
    float f;
    int32_t i;
} float_bits;

depth_state gn_depth_state(const gn_target *target, const gn_pipeline *pipeline)
{
    const gn_compare f = pipeline->depth_function;
    const bool less = f == GN_LESS || f == GN_LESS_OR_EQUAL || f == GN_NOT_EQUAL || f == GN_ALWAYS;
    const bool equal =
        f == GN_EQUAL || f == GN_LESS_OR_EQUAL || f == GN_GREATER_OR_EQUAL || f == GN_ALWAYS;
    const bool greater =
        f == GN_GREATER || f == GN_GREATER_OR_EQUAL || f == GN_NOT_EQUAL || f == GN_ALWAYS;
    depth_state s;

    s.enabled = pipeline->depth_test && target->depth.format != GN_FORMAT_NONE;
    s.write = !pipeline->depth_write_disabled;
    s.pass_less = less ? GN_ALL_LANES : 0;
    s.pass_equal = equal ? GN_ALL_LANES : 0;
    s.pass_greater = greater ? GN_ALL_LANES : 0;
    return s;
}

static lanes_i float_to_bits(lanes_f a)
{
    lanes_i r;
    GN_EACH_LANE(l)
    {
        float_bits b;
        b.f = a.v[l];
        r.v[l] = b.i;
    }
    return r;
}

lanes_i gn_quantize_depth(gn_format format, lanes_f depth)
{
    const lanes_f z =
        lanes_max(lanes_min(depth, lanes_splat(1.0f)), lanes_splat(0.0f));

    switch (format) {
    case GN_FORMAT_D16:
        /* In [128, 129) the last place is 2^-16: the addition rounds to 16 bits,
         * which are then the lowest of the float's. */
        return lanes_i_and(
            float_to_bits(lanes_add(lanes_mul(z, lanes_splat(65535.0f / 65536.0f)),
                                    lanes_splat(128.0f))),
            lanes_i_splat(0xFFFF));
    case GN_FORMAT_D24:
        return lanes_round(lanes_mul(z, lanes_splat(16777215.0f)));
    default:
        return float_to_bits(z);
    }
}

static int32_t load_depth(gn_format format, const unsigned char *row, int32_t x)
{
    switch (format) {
    case GN_FORMAT_D16:
        return ((const uint16_t *)(const void *)row)[x];
    case GN_FORMAT_D24:
        return (int32_t)(((const uint32_t *)(const void *)row)[x] & 0xFFFFFFu);
    default: {
        float_bits b;
        b.f = ((const float *)(const void *)row)[x];
        return b.i;
    }
    }
}

static void store_depth(gn_format format, unsigned char *row, int32_t x, int32_t depth)
{
    switch (format) {
    case GN_FORMAT_D16:
        ((uint16_t *)(void *)row)[x] = (uint16_t)depth;
        break;
    case GN_FORMAT_D24:
        ((uint32_t *)(void *)row)[x] = (uint32_t)depth;
        break;
    default: {
        float_bits b;
        b.i = depth;
        ((float *)(void *)row)[x] = b.f;
        break;
    }
    }
}

uint32_t gn_test_depth(const depth_state *state, const gn_surface *surface, int32_t x, int32_t y,
                       uint32_t coverage, lanes_f depth)
{
    const lanes_i incoming = gn_quantize_depth(surface->format, depth);
    lanes_i stored = lanes_i_splat(0);

    GN_EACH_LANE(l)
    {
        if (coverage >> l & 1u)
            stored.v[l] = load_depth(surface->format,
                                     surface_row(surface, (uint32_t)(y + l / BLOCK_SIZE)),
                                     x + l % BLOCK_SIZE);
    }

    const uint32_t greater = lanes_bits(lanes_i_greater(incoming, stored));
    const uint32_t equal = lanes_bits(lanes_i_equal(incoming, stored));
    const uint32_t less = ~(greater | equal);
    const uint32_t passed = coverage & ((greater & state->pass_greater) |
                                        (equal & state->pass_equal) | (less & state->pass_less));

    if (state->write) {
        GN_EACH_LANE(l)
        {
            if (passed >> l & 1u)
                store_depth(surface->format, surface_row(surface, (uint32_t)(y + l / BLOCK_SIZE)),
                            x + l % BLOCK_SIZE, incoming.v[l]);
        }
    }
    return passed;
}
