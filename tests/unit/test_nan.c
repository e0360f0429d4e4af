/* A NaN that is written to a surface of floats has one pattern of bits on every back end, whatever
 * it was computed from. Only copies keep the bits. */
#include "covered.h"
#include "float_bits.h"

static const uint32_t values[] = {0x7FC00000, 0xFFC00000, 0xFFFFFFFF, 0x7F800001, 0x7FC12345,
                                  0x7F800000, 0xFF800000, 0x00000000, 0x3F800000};

enum { NAN_BITS = 0x7FC00000, ODD_NAN = 0x7FC12345, VALUES = COUNT(values), SIZE = 5, WIDE = 40 };

static const gn_format formats[] = {GN_FORMAT_RGBA32F, GN_FORMAT_R32F};
static const gn_pipeline plain;

static uint32_t stored(uint32_t bits)
{
    return (bits & 0x7FFFFFFF) > 0x7F800000 ? (uint32_t)NAN_BITS : bits;
}

/* Draws a value over another in a surface of one row and returns the bits of its last channel. */
static uint32_t drawn_bits(gn_backend backend, gn_format format, const gn_pipeline *pipeline,
                           uint32_t source, uint32_t destination, uint32_t width)
{
    static float pixels[WIDE * 4];
    const gn_target target = {.color = {gn_surface_bottom_up(pixels, format, width, 1)}};
    const size_t channels = width * gn_format_size(format) / 4;
    const float c = from_bits(source), color[4] = {c, c, c, c};

    for (size_t i = 0; i < channels; ++i)
        pixels[i] = from_bits(destination);
    assert_int_equal(cover_target(&target, pipeline, color, backend), GN_OK);
    return bits_of(pixels[channels - 1]);
}

/* Asserts that all back ends draw equal bits, and the one pattern for NaN. */
static void assert_one_nan(gn_format format, const gn_pipeline *pipeline, uint32_t source,
                           uint32_t destination)
{
    const uint32_t expected =
        drawn_bits(GN_BACKEND_PORTABLE, format, pipeline, source, destination, SIZE);

    assert_int_equal(expected, stored(expected));
    for (gn_backend b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; b = next_backend(b)) {
        assert_int_equal(drawn_bits(b, format, pipeline, source, destination, SIZE), expected);
        assert_int_equal(drawn_bits(b, format, pipeline, source, destination, WIDE), expected);
    }
}

/* A masked channel keeps its bits, also those of another NaN. */
static void fragments(void **state)
{
    const gn_pipeline logic = {.color.logic_enabled = true};
    const gn_pipeline masked = {.color.write_disabled = {GN_CHANNEL_ALL}};

    for (int i = 0; i < 2 * VALUES; ++i) {
        const gn_format format = formats[i % 2];
        const uint32_t value = values[i / 2];

        assert_one_nan(format, &plain, value, 0);
        assert_int_equal(drawn_bits(GN_BACKEND_AUTO, format, &plain, value, 0, SIZE),
                         stored(value));
        assert_one_nan(format, &logic, value, 0);
        for (gn_backend b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; b = next_backend(b))
            assert_int_equal(drawn_bits(b, format, &masked, 0x3F800000, value, SIZE), value);
    }
}

static void blending(void **state)
{
    enum { FACTORS = GN_FACTOR_SOURCE_ALPHA_SATURATE + 1 };

    for (int f = 0; f < 2; ++f)
        for (int i = 0; i < (GN_EQUATION_MAX + 1) * FACTORS; ++i)
            for (int s = 0; s < VALUES; ++s)
                for (int d = 0; d < VALUES; ++d) {
                    gn_pipeline p = {.color.blend[0].enabled = true};

                    p.color.blend[0].equation = (gn_blend_equation)(i / FACTORS);
                    p.color.blend[0].source = (gn_blend_factor)(i % FACTORS);
                    p.color.blend[0].destination = (gn_blend_factor)((i + s + d) % FACTORS);
                    assert_one_nan(formats[f], &p, values[s], values[d]);
                }
}

static void clears_and_resolving(void **state)
{
    enum { CHANNELS = SIZE * 4 };
    float from[CHANNELS * GN_SAMPLES], to[CHANNELS];

    for (int i = 0; i < 2 * VALUES; ++i) {
        const uint32_t value = values[i / 2];
        const float c = from_bits(value);
        const gn_surface one = gn_surface_bottom_up(to, formats[i % 2], SIZE, 1);
        const gn_surface image = gn_surface_bottom_up(from, formats[i % 2], SIZE, 1);
        const gn_surface samples = gn_surface_multisampled(&image);

        assert_int_equal(gn_clear_color(&one, c, c, c, c), GN_OK);
        for (size_t k = 0; k < SIZE * gn_format_size(formats[i % 2]) / 4; ++k)
            assert_int_equal(bits_of(to[k]), stored(value));
        for (int k = 0; k < CHANNELS * GN_SAMPLES; ++k)
            from[k] = from_bits(k % 2 ? value : 0xFFC00001);
        assert_int_equal(gn_resolve(&one, &samples), GN_OK);
        assert_canonical_nan(to[0]);
    }
}

/* Copies keep the bits; conversions, mixtures and levels of textures do not. */
static void blits_and_levels(void **state)
{
    float from[SIZE * 4], to[SIZE * 4];
    const gn_surface wide = gn_surface_bottom_up(from, GN_FORMAT_RGBA32F, SIZE, 1);
    const gn_surface copy = gn_surface_bottom_up(to, GN_FORMAT_RGBA32F, SIZE, 1);
    const gn_surface single = gn_surface_bottom_up(to, GN_FORMAT_R32F, SIZE, 1);
    const gn_surface narrower = gn_surface_bottom_up(to, GN_FORMAT_RGBA32F, SIZE - 1, 1);
    const gn_blit_options linear = {.filter = GN_BLIT_LINEAR};
    gn_texture texture;

    for (int i = 0; i < SIZE * 4; ++i)
        from[i] = from_bits(ODD_NAN);
    assert_int_equal(gn_blit(&copy, NULL, &wide, NULL, NULL), GN_OK);
    for (int i = 0; i < SIZE * 4; ++i)
        assert_int_equal(bits_of(to[i]), ODD_NAN);
    assert_int_equal(gn_blit(&single, NULL, &wide, NULL, NULL), GN_OK);
    for (int i = 0; i < SIZE; ++i)
        assert_canonical_nan(to[i]);
    assert_int_equal(gn_blit(&narrower, NULL, &wide, NULL, &linear), GN_OK);
    for (int i = 0; i < 4 * (SIZE - 1); ++i)
        assert_canonical_nan(to[i]);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R32F, 4, 1, 1, 1, from, &texture),
                     GN_OK);
    assert_int_equal(gn_texture_generate_levels(&texture, to, 3 * sizeof *to), GN_OK);
    for (int i = 0; i < 3; ++i)
        assert_canonical_nan(to[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fragments),
        cmocka_unit_test(blending),
        cmocka_unit_test(clears_and_resolving),
        cmocka_unit_test(blits_and_levels),
    };
    return cmocka_run_group_tests_name("NaN", tests, NULL, NULL);
}
