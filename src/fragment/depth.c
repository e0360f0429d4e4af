/* The depth test (OpenGL 4.5 section 17.3.5), on the values the format holds. */
#include "fragment.h"

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

lanes_i gn_quantize_depth(gn_format format, lanes_f depth)
{
    const lanes_f z = lanes_max(lanes_min(depth, lanes_splat(1.0f)), lanes_splat(0.0f));

    switch (format) {
    case GN_FORMAT_D16:
        /* In [128, 129) the last place is 2^-16: the addition rounds to 16 bits,
         * which are then the lowest of the float's. */
        return lanes_i_and(lanes_as_int(lanes_add(lanes_mul(z, lanes_splat(65535.0f / 65536.0f)),
                                                  lanes_splat(128.0f))),
                           lanes_i_splat(0xFFFF));
    case GN_FORMAT_D24:
        return lanes_round(lanes_mul(z, lanes_splat(16777215.0f)));
    default:
        return lanes_as_int(z);
    }
}

/* Pixel by pixel: D16, and blocks that hang over the surface's edge. */
static lanes_i load_covered(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage)
{
    int32_t depth[GN_LANES] = {0};

    GN_EACH_LANE (l) {
        const void *const row = surface_row(surface, (uint32_t)(y + l / BLOCK_SIZE));
        const int32_t column = x + l % BLOCK_SIZE;

        if (coverage >> l & 1u)
            depth[l] = surface->format == GN_FORMAT_D16 ? ((const uint16_t *)row)[column]
                                                        : ((const int32_t *)row)[column];
    }
    return lanes_i_load(depth);
}

static void store_covered(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                          lanes_i value)
{
    int32_t depth[GN_LANES];

    lanes_i_store(depth, value);
    GN_EACH_LANE (l) {
        void *const row = surface_row(surface, (uint32_t)(y + l / BLOCK_SIZE));
        const int32_t column = x + l % BLOCK_SIZE;

        if (!(coverage >> l & 1u))
            continue;
        if (surface->format == GN_FORMAT_D16)
            ((uint16_t *)row)[column] = (uint16_t)depth[l];
        else
            ((int32_t *)row)[column] = depth[l];
    }
}

uint32_t gn_test_depth(const depth_state *state, const gn_surface *surface, int32_t x, int32_t y,
                       uint32_t coverage, lanes_f depth)
{
    const bool whole = surface->format != GN_FORMAT_D16 && surface_holds_block(surface, x, y);
    unsigned char *const memory = surface_row(surface, (uint32_t)y) + 4 * x;
    const lanes_i incoming = gn_quantize_depth(surface->format, depth);
    const lanes_i stored = whole ? lanes_i_load_block(memory, surface->row_stride)
                                 : load_covered(surface, x, y, coverage);
    const uint32_t greater = lanes_bits(lanes_i_greater(incoming, stored));
    const uint32_t equal = lanes_bits(lanes_i_equal(incoming, stored));
    const uint32_t less = ~(greater | equal);
    const uint32_t passed = coverage & ((greater & state->pass_greater) |
                                        (equal & state->pass_equal) | (less & state->pass_less));

    if (!state->write || !passed)
        return passed;
    if (whole)
        lanes_i_store_block(memory, surface->row_stride,
                            lanes_i_select(lanes_from_bits(passed), incoming, stored));
    else
        store_covered(surface, x, y, passed, incoming);
    return passed;
}
