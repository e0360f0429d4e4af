/* A NaN that is written to a surface of floats has one pattern of bits on every back end, whatever
 * it was computed from. Only copies keep the bits. */
#include "float_bits.h"

static const uint32_t values[] = {0x7FC00000, 0xFFC00000, 0xFFFFFFFF, 0x7F800001, 0x7FC12345,
                                  0x7F800000, 0xFF800000, 0x00000000, 0x3F800000};

enum { VALUES = sizeof values / sizeof *values, SIZE = 5, CHANNELS = 4 * GN_SAMPLES };

static const gn_format formats[] = {GN_FORMAT_RGBA32F, GN_FORMAT_R32F};

static float shaded;

static void cover_all(const void *unused, const gn_vertex_input *in, gn_vertex_output *out)
{
    (void)unused;
    for (int l = 0; l < GN_LANES; ++l) {
        out->position[0][l] = in->vertex_id[l] == 1 ? 3.0f : -1.0f;
        out->position[1][l] = in->vertex_id[l] == 2 ? 3.0f : -1.0f;
    }
}

static void shade_value(const void *unused, const gn_fragment_input *in, gn_fragment_output *out)
{
    (void)unused;
    (void)in;
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            out->color[c][l] = shaded;
}

/* Draws a value over another in a surface of one row and returns the bits of its last channel. */
static uint32_t drawn_bits(gn_backend backend, gn_format format, gn_pipeline pipeline,
                           uint32_t source, uint32_t destination, uint32_t width)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 0)];
    static float pixels[40 * 4];
    const size_t channels = width * gn_format_size(format) / 4;
    gn_mesh mesh = {.vertex_count = 3, .count = 3};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .backend = backend};
    gn_target target = {.color = {gn_surface_bottom_up(pixels, format, width, 1)}};

    pipeline.program.vertex_shader = cover_all;
    pipeline.program.fragment_shader = shade_value;
    shaded = from_bits(source);
    for (size_t i = 0; i < channels; ++i)
        pixels[i] = from_bits(destination);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
    return bits_of(pixels[channels - 1]);
}

static bool is_nan(uint32_t bits)
{
    return (bits & 0x7FFFFFFF) > 0x7F800000;
}

/* Asserts that all back ends draw equal bits, and the one pattern for NaN. */
static void assert_one_nan(gn_format format, gn_pipeline pipeline, uint32_t source,
                           uint32_t destination)
{
    const uint32_t expected =
        drawn_bits(GN_BACKEND_PORTABLE, format, pipeline, source, destination, SIZE);

    if (is_nan(expected))
        assert_int_equal(expected, 0x7FC00000);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        if (!gn_backend_available((gn_backend)b))
            continue;
        assert_int_equal(drawn_bits((gn_backend)b, format, pipeline, source, destination, SIZE),
                         expected);
        assert_int_equal(drawn_bits((gn_backend)b, format, pipeline, source, destination, 40),
                         expected);
    }
}

static void fragments(void **state)
{
    (void)state;
    for (int f = 0; f < 2; ++f) {
        for (int s = 0; s < VALUES; ++s) {
            const uint32_t stored = is_nan(values[s]) ? 0x7FC00000 : values[s];
            gn_pipeline pipeline = {0};

            assert_one_nan(formats[f], pipeline, values[s], 0);
            assert_int_equal(drawn_bits(GN_BACKEND_AUTO, formats[f], pipeline, values[s], 0, SIZE),
                             stored);
            pipeline.color.logic = true;
            assert_one_nan(formats[f], pipeline, values[s], 0);
        }
    }
}

static void blending(void **state)
{
    (void)state;
    for (int f = 0; f < 2; ++f)
        for (int equation = 0; equation <= GN_EQUATION_MAX; ++equation)
            for (int factor = 0; factor <= GN_FACTOR_SOURCE_ALPHA_SATURATE; ++factor)
                for (int s = 0; s < VALUES; ++s)
                    for (int d = 0; d < VALUES; ++d) {
                        gn_pipeline pipeline = {0};

                        pipeline.color.blend[0].enabled = true;
                        pipeline.color.blend[0].equation = (gn_blend_equation)equation;
                        pipeline.color.blend[0].source = (gn_blend_factor)factor;
                        pipeline.color.blend[0].destination =
                            (gn_blend_factor)((factor + s + d) %
                                              (GN_FACTOR_SOURCE_ALPHA_SATURATE + 1));
                        assert_one_nan(formats[f], pipeline, values[s], values[d]);
                    }
}

/* A masked channel keeps its bits, also those of another NaN. */
static void masked_channels_stay(void **state)
{
    (void)state;
    for (int b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; ++b) {
        gn_pipeline pipeline = {.color.write_disabled = {GN_CHANNEL_ALL}};

        if (!gn_backend_available((gn_backend)b))
            continue;
        for (int f = 0; f < 2; ++f)
            assert_int_equal(
                drawn_bits((gn_backend)b, formats[f], pipeline, 0x3F800000, 0xFFC12345, SIZE),
                0xFFC12345);
    }
}

static void clears(void **state)
{
    (void)state;
    float pixels[SIZE * 4];

    for (int f = 0; f < 2; ++f) {
        const gn_surface surface = gn_surface_bottom_up(pixels, formats[f], SIZE, 1);
        const size_t channels = SIZE * gn_format_size(formats[f]) / 4;

        for (int s = 0; s < VALUES; ++s) {
            const float value = from_bits(values[s]);

            assert_int_equal(gn_clear_color(&surface, value, value, value, value), GN_OK);
            for (size_t i = 0; i < channels; ++i)
                assert_int_equal(bits_of(pixels[i]), is_nan(values[s]) ? 0x7FC00000 : values[s]);
        }
    }
}

/* Copies keep the bits, conversions and mixtures do not. */
static void blits(void **state)
{
    (void)state;
    float from[SIZE * 4], to[SIZE * 4];
    const gn_surface wide = gn_surface_bottom_up(from, GN_FORMAT_RGBA32F, SIZE, 1);
    const gn_surface wide_copy = gn_surface_bottom_up(to, GN_FORMAT_RGBA32F, SIZE, 1);
    const gn_surface single = gn_surface_bottom_up(to, GN_FORMAT_R32F, SIZE, 1);
    const gn_surface narrower = gn_surface_bottom_up(to, GN_FORMAT_RGBA32F, SIZE - 1, 1);
    const gn_blit_options linear = {.filter = GN_BLIT_LINEAR};

    for (int i = 0; i < SIZE * 4; ++i)
        from[i] = from_bits(0xFFC12345);
    assert_int_equal(gn_blit(&wide_copy, NULL, &wide, NULL, NULL), GN_OK);
    for (int i = 0; i < SIZE * 4; ++i)
        assert_int_equal(bits_of(to[i]), 0xFFC12345);
    assert_int_equal(gn_blit(&single, NULL, &wide, NULL, NULL), GN_OK);
    for (int i = 0; i < SIZE; ++i)
        assert_canonical_nan(to[i]);
    assert_int_equal(gn_blit(&narrower, NULL, &wide, NULL, &linear), GN_OK);
    for (int i = 0; i < 4 * (SIZE - 1); ++i)
        assert_canonical_nan(to[i]);
}

static void resolving(void **state)
{
    (void)state;
    float from[SIZE * CHANNELS], to[SIZE * 4];

    for (int f = 0; f < 2; ++f) {
        const gn_surface one = gn_surface_bottom_up(to, formats[f], SIZE, 1);
        const gn_surface image = gn_surface_bottom_up(from, formats[f], SIZE, 1);
        const gn_surface samples = gn_surface_multisampled(&image);

        for (int s = 0; s < VALUES; ++s) {
            for (int i = 0; i < SIZE * CHANNELS; ++i)
                from[i] = from_bits(i % 2 ? values[s] : 0xFFC00001);
            assert_int_equal(gn_resolve(&one, &samples), GN_OK);
            assert_canonical_nan(to[0]);
        }
    }
}

static void generated_levels(void **state)
{
    (void)state;
    float texels[4], memory[3];
    gn_texture texture = {.format = GN_FORMAT_R32F, .width = 4, .height = 1, .level_count = 1};

    for (int i = 0; i < 4; ++i)
        texels[i] = from_bits(0xFFC12345);
    texture.level[0].texels = texels;
    texture.level[0].row_stride = 16;
    assert_int_equal(gn_texture_generate_levels(&texture, memory, sizeof memory), GN_OK);
    for (int i = 0; i < 3; ++i)
        assert_canonical_nan(memory[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fragments),
        cmocka_unit_test(blending),
        cmocka_unit_test(masked_channels_stay),
        cmocka_unit_test(clears),
        cmocka_unit_test(blits),
        cmocka_unit_test(resolving),
        cmocka_unit_test(generated_levels),
    };
    return cmocka_run_group_tests_name("NaN", tests, NULL, NULL);
}
