/* Clears of every format: values, rounding, clamping, the pixels that they fill and no others,
 * faults. */
#include <math.h>

#include "float_bits.h"
#include "formats.h"
#include "noise.h"

enum { WIDTH = 5, HEIGHT = 3 };

static uint32_t words[64 * 64 * 4];

/* The word of one pixel that is cleared to one value in all channels. */
static uint32_t cleared(gn_format format, float value)
{
    const gn_surface s = gn_surface_bottom_up(words, format, 1, 1);

    words[0] = 0;
    assert_int_equal(format == GN_FORMAT_D16 || format == GN_FORMAT_D24 || format == GN_FORMAT_D32F
                         ? gn_clear_depth(&s, value)
                         : gn_clear_color(&s, value, value, value, value),
                     GN_OK);
    return words[0];
}

/* Numbers beyond the format, not finite, and denormal; test_formats.c has each format's values. */
static void values_by_hand(void **state)
{
    static const struct {
        gn_format format;
        float value;
        uint32_t word;
    } cases[] = {
        {GN_FORMAT_RGBA8, -1, 0},
        {GN_FORMAT_RGBA8, NAN, 0},
        {GN_FORMAT_RGBA8, INFINITY, 0xFFFFFFFF},
        {GN_FORMAT_RGBA8, -INFINITY, 0},
        {GN_FORMAT_R32F, -3.5f, 0xC0600000},
        {GN_FORMAT_R32F, 1e30f, 0x7149F2CA},
        {GN_FORMAT_D16, 2, 65535},
        {GN_FORMAT_D24, 1, 0xFFFFFF},
        {GN_FORMAT_D24, -1, 0},
        {GN_FORMAT_D24, NAN, 0},
        {GN_FORMAT_D24, 1e-40f, 0},
        {GN_FORMAT_D24, 0x1p-60f, 0},
        {GN_FORMAT_D24, 0x1p-24f, 1},
        {GN_FORMAT_D24, 0x1p-25f, 0},
        {GN_FORMAT_D24, 0x1.8p-24f, 1},
        {GN_FORMAT_D24, 0.5f, 0x800000}, /* a half, to even */
        {GN_FORMAT_D24, 0.75f, 0xBFFFFF},
        {GN_FORMAT_D24, 0x1.fffffep-1f, 0xFFFFFE},
        {GN_FORMAT_D32F, 0.5f, 0x3F000000},
        {GN_FORMAT_D32F, -0.0f, 0},
        {GN_FORMAT_D32F, INFINITY, 0x3F800000},
    };

    for (size_t i = 0; i < COUNT(cases); ++i)
        if (cleared(cases[i].format, cases[i].value) != cases[i].word)
            fail_msg("case %zu: %x", i, words[0]);
}

/* The expected value is a double, which represents the product of a float and 2^24 - 1 exactly,
 * rounded by the C library. */
static void depths_round_to_nearest(void **state)
{
    uint32_t seed = 12345;

    for (int i = 0; i < 100000; ++i) {
        float z = noise(&seed);
        if (i % 3 == 1)
            z = ((float)(seed % 65535) + 0.5f) / 65535.0f;
        else if (i % 3 == 2)
            z = ldexpf(z, -(int)(seed % 40));
        assert_int_equal(cleared(GN_FORMAT_D16, z), (uint32_t)nearbyint((double)z * 65535.0));
        assert_int_equal(cleared(GN_FORMAT_D24, z), (uint32_t)nearbyint((double)z * 16777215.0));
    }
}

/* Halves of RGB10_A2's alpha, which has two bits, and of R16's last step, become even. */
static void colors_round_halves_to_even(void **state)
{
    assert_int_equal(cleared(GN_FORMAT_RGB10_A2, 0.5f / 3) >> 30, 0);
    assert_int_equal(cleared(GN_FORMAT_RGB10_A2, 1.5f / 3) >> 30, 2);
    assert_int_equal(cleared(GN_FORMAT_RGB10_A2, 2.5f / 3) >> 30, 2);
    for (uint32_t step = 0; step < 8; ++step)
        assert_int_equal(cleared(GN_FORMAT_R16, ((float)step + 0.5f) / 65535), (step + 1) / 2 * 2);
}

/* Red has six bits after the point, blue five, so ties of blue are red's odd steps. */
static void unsigned_floats_round_to_nearest(void **state)
{
    static const struct {
        uint32_t single, red, blue;
    } values[] = {
        {0x3F801FFF, 0x3C0, 0x1E0}, {0x3F81FFFF, 0x3C1, 0x1E0}, {0x3F820000, 0x3C1, 0x1E0},
        {0x3F810000, 0x3C0, 0x1E0}, {0x3F830000, 0x3C2, 0x1E1}, {0x3F860000, 0x3C3, 0x1E2},
        {0x38800000, 0x040, 0x020}, {0x387FFFFF, 0x040, 0x020}, {0x35800000, 0x001, 0x000},
        {0x357FFFFF, 0x001, 0x000}, {0x35C00000, 0x002, 0x001}, {0x35000000, 0x000, 0x000},
        {0x00000001, 0x000, 0x000}, {0x477E0000, 0x7BF, 0x3DF}, {0x477FFFFF, 0x7BF, 0x3DF},
        {0x7F7FFFFF, 0x7BF, 0x3DF}, {0x7F800000, 0x7C0, 0x3E0}, {0xFF800000, 0x000, 0x000},
        {0xBF800000, 0x000, 0x000}, {0x7FC00000, 0x7E0, 0x3F0}, {0xFFC00001, 0x7E0, 0x3F0}};

    for (size_t i = 0; i < COUNT(values); ++i)
        assert_int_equal(cleared(GN_FORMAT_R11F_G11F_B10F, from_bits(values[i].single)),
                         values[i].red | values[i].red << 11 | values[i].blue << 22);
}

/* The nearest byte of sRGB's transfer function (OpenGL 4.5 section 17.3.7). */
static uint32_t byte_by_definition(uint32_t bits)
{
    const long double x = from_bits(bits);
    const long double encoded =
        x < 0.0031308L ? 12.92L * x : 1.055L * powl(x, 1.0L / 2.4L) - 0.055L;

    return (uint32_t)floorl(encoded * 255.0L + 0.5L);
}

static void assert_srgb(uint32_t bits)
{
    const uint32_t byte = byte_by_definition(bits);

    if ((cleared(GN_FORMAT_SRGB8_A8, from_bits(bits)) & 0xFFFFFF) != byte * 0x10101)
        fail_msg("%a is stored as %x, not as %x", (double)from_bits(bits), words[0], byte);
}

/* On both sides of every step of the function and of every entry of the library's table. The bits
 * of positive floats order as the floats do. */
static void srgb_bytes(void **state)
{
    for (uint32_t byte = 1; byte <= 255; ++byte) {
        uint32_t low = 0, high = 0x3F800000; /* below the step, and from the step on */

        while (high - low > 1) {
            const uint32_t middle = low + (high - low) / 2;

            if (byte_by_definition(middle) >= byte)
                high = middle;
            else
                low = middle;
        }
        assert_srgb(low);
        assert_srgb(high);
    }
    for (uint32_t upper = 0; upper < 0x3F80; ++upper) {
        assert_srgb(upper << 16);
        assert_srgb(upper << 16 | 0xFFFF);
    }
    assert_srgb(0x3F800000);
}

/* Long runs of equal words may be filled in another way than runs in which one word differs. */
static void almost_equal_channels(void **state)
{
    for (int differs = 0; differs <= 4; ++differs)
        for (uint32_t width = 1; width <= 64; width += 21) {
            const gn_surface s = gn_surface_bottom_up(words, GN_FORMAT_RGBA32F, width, 64);
            float c[4] = {0.5f, 0.5f, 0.5f, 0.5f};

            if (differs < 4)
                c[differs] = 0.25f;
            memset(words, 0, sizeof words);
            assert_int_equal(gn_clear_color(&s, c[0], c[1], c[2], c[3]), GN_OK);
            for (uint32_t i = 0; i < width * 64; ++i)
                assert_memory_equal(words + 4 * i, c, sizeof c);
            for (uint32_t i = width * 64 * 4; i < COUNT(words); ++i)
                assert_int_equal(words[i], 0);
        }
}

/* Clears to white; or to depth 1 and stencil 0x99, at once and one after the other, in both
 * orders. */
static gn_status clear(const gn_surface *s, bool is_color, uint32_t how)
{
    const bool has_stencil =
        s->format == GN_FORMAT_D24S8 || s->format == GN_FORMAT_D32FS8 || s->format == GN_FORMAT_S8;
    gn_status status = GN_OK;

    if (is_color)
        return gn_clear_color(s, 1, 1, 1, 1);
    if (how == 0)
        return gn_clear_depth_stencil(s, 1, 0x99);
    if (how == 1 && has_stencil)
        status = gn_clear_stencil(s, 0x99);
    if (s->format != GN_FORMAT_S8 && status == GN_OK)
        status = gn_clear_depth(s, 1);
    if (how == 2 && has_stencil && status == GN_OK)
        status = gn_clear_stencil(s, 0x99);
    return status;
}

/* Widths and heights on both sides of what is filled at a time, rows with and without a gap,
 * upwards and downwards, memory with the least alignment. Pixels equal that of a surface of one
 * pixel; no byte beside the surface may change. */
static void clears_fill_their_pixels_alone(void **state)
{
    static const uint32_t widths[] = {1, 2, 15, 16, 17, 63, 255, 1023, 1024, 1025, 2050};
    static unsigned char memory[3 * (2050 * 16 + 8) + 16];

    for (size_t f = 0; f < COUNT(formats); ++f) {
        const struct format *const format = &formats[f];
        const gn_surface pixel = gn_surface_bottom_up(words, format->format, 1, 1);

        memset(words, 0x55, 16);
        assert_int_equal(clear(&pixel, format->is_color, 0), GN_OK);
        for (uint32_t kind = 0; kind < 8 * COUNT(widths); ++kind) {
            const uint32_t width = widths[kind / 8], height = kind & 1 ? 3 : 1;
            const size_t row = width * format->size, start = 4 + format->element;
            const size_t stride = row + (kind & 2 ? format->element : 0);
            gn_surface s = gn_surface_bottom_up(memory + start, format->format, width, height);

            s.row_stride = (ptrdiff_t)stride;
            if (kind & 4) {
                s.pixels = memory + start + stride * (height - 1);
                s.row_stride = -(ptrdiff_t)stride;
            }
            memset(memory, 0x55, sizeof memory);
            assert_int_equal(clear(&s, format->is_color, kind / 8 % 3), GN_OK);
            for (size_t i = 0; i < start + stride * height + 16; ++i) {
                const size_t at = (i - start) % stride;
                const bool inside = i >= start && i < start + stride * height && at < row;

                if (memory[i] !=
                    (inside ? ((const unsigned char *)words)[at % format->size] : 0x55))
                    fail_msg("format %d, width %u, kind %u: byte %zu", format->format, width, kind,
                             i);
            }
        }
    }
}

/* Depth 1 and stencil 0x99 as bytes. */
static void stencils_and_depths(void **state)
{
    static const struct {
        gn_format format;
        uint32_t first, second;
    } cases[] = {{GN_FORMAT_D16, 0x5555FFFF, 0x55555555},   {GN_FORMAT_D24, 0x00FFFFFF, 0x55555555},
                 {GN_FORMAT_D24S8, 0x99FFFFFF, 0x55555555}, {GN_FORMAT_S8, 0x55555599, 0x55555555},
                 {GN_FORMAT_D32F, 0x3F800000, 0x55555555},  {GN_FORMAT_D32FS8, 0x3F800000, 0x99}};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const gn_surface s = gn_surface_bottom_up(words, cases[i].format, 1, 1);

        memset(words, 0x55, 8);
        assert_int_equal(gn_clear_depth_stencil(&s, 1, 0x99), GN_OK);
        assert_int_equal(words[0], cases[i].first);
        assert_int_equal(words[1], cases[i].second);
    }
}

static void faults(void **state)
{
    gn_surface s = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, WIDTH, HEIGHT);

    assert_int_equal(gn_clear_color(NULL, 0, 0, 0, 0), GN_NULL_POINTER);
    assert_int_equal(gn_clear_depth(NULL, 0), GN_NULL_POINTER);
    assert_int_equal(gn_clear_depth(&s, 0), GN_INVALID_FORMAT);
    assert_int_equal(gn_clear_stencil(NULL, 0), GN_NULL_POINTER);
    assert_int_equal(gn_clear_stencil(&s, 0), GN_INVALID_FORMAT);
    assert_int_equal(gn_clear_depth_stencil(NULL, 0, 0), GN_NULL_POINTER);
    assert_int_equal(gn_clear_depth_stencil(&s, 0, 0), GN_INVALID_FORMAT);
    s.format = GN_FORMAT_S8;
    assert_int_equal(gn_clear_depth(&s, 0), GN_INVALID_FORMAT);
    s.format = GN_FORMAT_D32F;
    assert_int_equal(gn_clear_stencil(&s, 0), GN_INVALID_FORMAT);
    assert_int_equal(gn_clear_color(&s, 0, 0, 0, 0), GN_INVALID_FORMAT);
    s.width = 0;
    assert_int_equal(gn_clear_depth(&s, 0), GN_INVALID_SIZE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_by_hand),
        cmocka_unit_test(depths_round_to_nearest),
        cmocka_unit_test(colors_round_halves_to_even),
        cmocka_unit_test(unsigned_floats_round_to_nearest),
        cmocka_unit_test(srgb_bytes),
        cmocka_unit_test(almost_equal_channels),
        cmocka_unit_test(clears_fill_their_pixels_alone),
        cmocka_unit_test(stencils_and_depths),
        cmocka_unit_test(faults),
    };
    return cmocka_run_group_tests_name("clears", tests, NULL, NULL);
}
