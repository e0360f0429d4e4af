/* The step that tests depth and stencil. */
#ifndef GN_KERNEL_FRAGMENT_TEST_INL
#define GN_KERNEL_FRAGMENT_TEST_INL

#include "batch.inl"
#include "stencil.inl"

/* Whether depths are those of the triangle, and the test is less_depth_test. */
static inline bool is_less_test(const fragment_state *state, const comparison *test)
{
    return !state->moves_depth && !state->clamps_depth && is_less_depth_test(test) &&
           !state->pipeline->program.fragment_writes_depth;
}

/* Returns the interpolated depths of a block, with the polygon offset. */
GN_INLINE lanes_f offset_depth(const fragment_state *state, const fragment_place *at,
                               raster_primitive primitive)
{
    const lanes_f depth = interpolate(at, primitive, DEPTH_PLANE);

    if (GN_HAVE_OFFSET && state->moves_depth)
        return lanes_add(depth, lanes_splat(primitive.setup->offset[lane_of(primitive)]));
    return depth;
}

/* Tests a block. Depths are clamped to the limits; NaN becomes the upper one. Returns the part of
 * coverage that passed. */
GN_INLINE uint32_t test_block(const fragment_state *state, const comparison *test, gn_format format,
                              const fragment_place *at, raster_primitive primitive,
                              uint32_t coverage, lanes_f depth)
{
    if (GN_HAVE_OFFSET && state->clamps_depth)
        depth = lanes_max(lanes_min(depth, lanes_splat(state->limits.high)),
                          lanes_splat(state->limits.low));
    if (GN_HAVE_STENCIL && format_has_stencil(format))
        return test_stencil(state, test, format, at, primitive_is(primitive, PRIMITIVE_IS_BACK),
                            coverage, depth);
    return test_depth(test, &state->depth, format, at, coverage, depth, false);
}

/* Tests the blocks of a batch. `is_less` is is_less_test, as a constant. */
GN_INLINE void test_blocks(const fragment_state *state, const comparison *test, gn_format format,
                           bool is_less, fragment_shape shape, fragment_batch *b)
{
    const bool is_written = state->pipeline->program.fragment_writes_depth;

    for (uint32_t n = 0; n < b->count; ++n) {
        const raster_primitive primitive = batch_primitive(b, shape, n);
        fragment_place at;

        set_batch_place(state, b, shape, n, state->test_at, &at);
        if (is_less) {
            b->coverage[n] =
                test_depth(&less_depth_test, &state->depth, format, &at, b->coverage[n],
                           interpolate(&at, primitive, DEPTH_PLANE), false);
            continue;
        }
        b->coverage[n] = test_block(state, test, format, &at, primitive, b->coverage[n],
                                    is_written ? lanes_load(b->shared.terms.depth[n])
                                               : offset_depth(state, &at, primitive));
    }
}

/* Tests the blocks of a batch. Each branch compiles the loop once more, with constants. */
GN_INLINE void test_format(const fragment_state *state, const comparison *test, gn_format format,
                           fragment_batch *b)
{
    const bool is_less =
        GN_STATES_SPECIALISED && !format_has_stencil(format) && is_less_test(state, test);

    if (is_of_rows(b) && is_less)
        test_blocks(state, test, format, true, SHAPE_ROW, b);
    else if (is_of_rows(b))
        test_blocks(state, test, format, false, SHAPE_ROW, b);
    else if (is_less)
        test_blocks(state, test, format, true, SHAPE_HALVES, b);
    else
        test_blocks(state, test, format, false, SHAPE_HALVES, b);
}

/* Tests a batch, whose coverage becomes what passed. `test` is the state's depth test, or one that
 * does not write. */
GN_OUT_OF_LINE void test_batch(const fragment_state *state, const comparison *test,
                               fragment_batch *b)
{
#define TEST(name, layout, kind, encoding, ...)                                                    \
    case GN_FORMAT_##name:                                                                         \
        if (FORMAT_##kind == FORMAT_DEPTH && format_is_compiled(GN_FORMAT_##name))                 \
            test_format(state, test, GN_FORMAT_##name, b);                                         \
        break;
    switch (state->depth.format) {
        GN_FORMATS(TEST)
    default:
        break;
    }
#undef TEST
}

#endif
