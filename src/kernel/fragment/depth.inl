/* The depth test (OpenGL 4.5 section 17.3.5), on values as the format stores them. */
#ifndef GN_KERNEL_FRAGMENT_DEPTH_INL
#define GN_KERNEL_FRAGMENT_DEPTH_INL

#include "pixels.inl"

/* Returns the state of a comparison, which writes nothing. Precondition: f is not
 * GN_COMPARE_DEFAULT, whose meaning differs between the depth test and the stencil test. */
static inline comparison comparison_of(gn_compare f)
{
    comparison s;

    s.relation = f == GN_NEVER || f == GN_ALWAYS            ? RELATION_ALWAYS
                 : f == GN_EQUAL || f == GN_NOT_EQUAL       ? RELATION_EQUAL
                 : f == GN_LESS || f == GN_GREATER_OR_EQUAL ? RELATION_LESS
                                                            : RELATION_GREATER;
    s.inverted =
        f == GN_NEVER || f == GN_NOT_EQUAL || f == GN_GREATER_OR_EQUAL || f == GN_LESS_OR_EQUAL;
    s.write = false;
    return s;
}

static inline comparison depth_comparison_of(const gn_pipeline *pipeline)
{
    const gn_compare f = pipeline->depth.function;
    comparison s = comparison_of(f == GN_COMPARE_DEFAULT ? GN_LESS : f);

    s.write = !pipeline->depth.write_disabled;
    return s;
}

/* Lesser depths pass and are written. */
static const comparison less_depth_test = {RELATION_LESS, false, true};

static inline bool is_less_depth_test(const comparison *test)
{
    return test->relation == RELATION_LESS && !test->inverted && test->write;
}

/* Returns 0 and 1, or with depth clamp the ends of the depth range, computed back from the viewport
 * transform as by the reference. */
static inline depth_limits depth_limits_of(const gn_pipeline *pipeline,
                                           const viewport_transform *viewport)
{
    const float scale = viewport->scale[2];
    const float translate = viewport->translate[2];
    const float a = viewport->zero_to_one ? translate : translate - scale;
    const float b = translate + scale;
    depth_limits limits = {0.0f, 1.0f};

    if (pipeline->depth.clamp_enabled) {
        limits.low = a < b ? a : b;
        limits.high = a < b ? b : a;
    }
    return limits;
}

/* Returns depths as a format stores them, in the low bits. D16 and D24 are rounded; D32F is the
 * float's bits, which order as integers do. Depths are clamped to 0..1, unless they are known to be
 * above 0 and at most 1 (`in_range`). */
GN_INLINE lanes_i quantize_depth(gn_format format, lanes_f depth, bool in_range)
{
    const lanes_f z =
        in_range ? depth : lanes_max(lanes_min(depth, lanes_splat(1.0f)), lanes_splat(0.0f));

    switch (format) {
    case GN_FORMAT_D16:
        /* In [128, 129) the last place is 2^-16: the addition rounds to 16 bits, which are then the
         * lowest bits of the float. */
        return lanes_i_and(lanes_as_int(lanes_add(lanes_mul(z, lanes_splat(65535.0f / 65536.0f)),
                                                  lanes_splat(128.0f))),
                           lanes_i_splat(0xFFFF));
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        return lanes_round(lanes_mul(z, lanes_splat(16777215.0f)));
    default:
        return lanes_as_int(z);
    }
}

/* Returns the lanes in which `incoming` passes against `stored`. */
GN_INLINE lanes_m passing_lanes(const comparison *state, lanes_i incoming, lanes_i stored)
{
    lanes_m passing = lanes_from_bits(GN_ALL_LANES);

    if (state->relation == RELATION_LESS)
        passing = lanes_i_greater(stored, incoming);
    else if (state->relation == RELATION_GREATER)
        passing = lanes_i_greater(incoming, stored);
    else if (state->relation == RELATION_EQUAL)
        passing = lanes_i_equal(incoming, stored);
    return state->inverted ? lanes_not(passing) : passing;
}

/* Tests depths against a surface of the given format, which has no stencil, and writes those that
 * pass, if the state says so. Returns the part of coverage that passed. */
GN_INLINE uint32_t test_depth(const comparison *state, const gn_surface *surface, gn_format format,
                              const fragment_place *at, uint32_t coverage, lanes_f depth,
                              bool in_range)
{
    const pixel_layout layout = format == GN_FORMAT_D16 ? LAYOUT_SHORT : LAYOUT_WORD;
    const lane_pixels memory = pixels_at(at, surface, layout);
    lanes_i incoming[4], stored[4];

    incoming[0] = quantize_depth(format, depth, in_range);
    load_pixels(layout, &memory, coverage, stored);
    const uint32_t passed = coverage & lanes_bits(passing_lanes(state, incoming[0], stored[0]));

    if (state->write && passed) {
        if (passed != GN_ALL_LANES || at->shape != SHAPE_ROW)
            incoming[0] = lanes_i_select(lanes_from_bits(passed), incoming[0], stored[0]);
        store_pixels(layout, &memory, coverage, incoming);
    }
    return passed;
}

#endif
