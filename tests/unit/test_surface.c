/* Surfaces: construction, every fault of a target, clears of every format. */
#include <math.h>
#include <string.h>

#include "unit.h"

enum { WIDTH = 5, HEIGHT = 3 };

static uint32_t words[WIDTH * HEIGHT * 4];

static void format_sizes(void **state)
{
    (void)state;
    assert_int_equal(gn_format_size(GN_FORMAT_NONE), 0);
    assert_int_equal(gn_format_size(GN_FORMAT_RGBA8), 4);
    assert_int_equal(gn_format_size(GN_FORMAT_RGBA32F), 16);
    assert_int_equal(gn_format_size(GN_FORMAT_D16), 2);
    assert_int_equal(gn_format_size(GN_FORMAT_D24), 4);
    assert_int_equal(gn_format_size(GN_FORMAT_D32F), 4);
    assert_int_equal(gn_format_size((gn_format)99), 0);
}

static void constructors_place_row_zero(void **state)
{
    (void)state;
    const gn_surface up = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, WIDTH, HEIGHT);
    const gn_surface down = gn_surface_top_down(words, GN_FORMAT_RGBA8, WIDTH, HEIGHT);

    assert_ptr_equal(up.pixels, words);
    assert_int_equal(up.row_stride, WIDTH * 4);
    assert_int_equal(up.width, WIDTH);
    assert_int_equal(up.height, HEIGHT);
    assert_int_equal(up.format, GN_FORMAT_RGBA8);
    assert_ptr_equal(down.pixels, words + WIDTH * (HEIGHT - 1));
    assert_int_equal(down.row_stride, -WIDTH * 4);
    assert_ptr_equal(gn_surface_top_down(words, GN_FORMAT_RGBA32F, UINT32_MAX, UINT32_MAX).pixels,
                     words);
    assert_null(gn_surface_top_down(NULL, GN_FORMAT_RGBA8, WIDTH, HEIGHT).pixels);
}

static gn_target good_target(void)
{
    static uint32_t depth[WIDTH * HEIGHT];
    gn_target t = {0};

    t.color[0] = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, WIDTH, HEIGHT);
    t.depth = gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT);
    return t;
}

static void rows_are_a_surface(void **state)
{
    (void)state;
    for (int down = 0; down < 2; ++down) {
        const gn_surface all = down ? gn_surface_top_down(words, GN_FORMAT_D32F, WIDTH, HEIGHT)
                                    : gn_surface_bottom_up(words, GN_FORMAT_D32F, WIDTH, HEIGHT);
        const gn_surface band = gn_surface_rows(&all, 1, 2);
        const size_t lowest = down ? HEIGHT - 3 : 1;

        assert_int_equal(band.width, WIDTH);
        assert_int_equal(band.height, 2);
        memset(words, 0, sizeof words);
        assert_int_equal(gn_clear_depth(&band, 1.0f), GN_OK);
        for (size_t i = 0; i < sizeof words / sizeof *words; ++i)
            assert_int_equal(words[i],
                             i >= lowest * WIDTH && i < (lowest + 2) * WIDTH ? 0x3F800000u : 0u);
    }
}

/* The stride of a single row does not matter, so its images may lie one after the other. */
static void samples_of_a_single_row(void **state)
{
    (void)state;
    static uint32_t memory[GN_SAMPLES * WIDTH];
    gn_surface image = gn_surface_bottom_up(memory, GN_FORMAT_RGBA8, WIDTH, 1);
    for (ptrdiff_t stride = 0; stride <= 4 * WIDTH; stride += 4) {
        image.row_stride = stride;
        gn_target target = {0};
        target.color[0] = gn_surface_multisampled(&image);
        assert_int_equal(target.color[0].sample_stride, 4 * WIDTH);
        assert_int_equal(gn_target_check(&target), GN_OK);
    }
}

/* An image that fits memory alone, but not four times: the stride is what is wrong. */
static void samples_that_do_not_fit(void **state)
{
    (void)state;
    static uint32_t memory[1];
    gn_surface image = gn_surface_bottom_up(memory, GN_FORMAT_RGBA8, WIDTH, 4);
    image.row_stride = (PTRDIFF_MAX / 3 - 64) / 4 * 4;
    gn_target target = {0};
    target.color[0] = image;
    assert_int_equal(gn_target_check(&target), GN_OK);
    target.color[0] = gn_surface_multisampled(&image);
    assert_int_equal(gn_target_check(&target), GN_INVALID_STRIDE);
}

static void rows_beyond_a_surface_are_absent(void **state)
{
    (void)state;
    const gn_surface all = gn_surface_bottom_up(words, GN_FORMAT_D32F, WIDTH, HEIGHT);

    assert_int_equal(gn_surface_rows(&all, HEIGHT - 1, 1).format, GN_FORMAT_D32F);
    assert_int_equal(gn_surface_rows(&all, HEIGHT - 1, 2).format, GN_FORMAT_NONE);
    assert_int_equal(gn_surface_rows(&all, HEIGHT, 0).format, GN_FORMAT_NONE);
    assert_int_equal(gn_surface_rows(&all, 0, 0).format, GN_FORMAT_NONE);
    assert_int_equal(gn_surface_rows(&all, UINT32_MAX, 2).format, GN_FORMAT_NONE);
    assert_int_equal(gn_surface_rows(&all, 1, UINT32_MAX).format, GN_FORMAT_NONE);
    assert_int_equal(gn_surface_rows(NULL, 0, 1).format, GN_FORMAT_NONE);
}

static void target_faults(void **state)
{
    (void)state;
    gn_target t = good_target();
    const gn_surface absent = {0};

    assert_int_equal(gn_target_check(&t), GN_OK);
    assert_int_equal(gn_target_check(NULL), GN_NULL_POINTER);

    t.color[0] = absent;
    assert_int_equal(gn_target_check(&t), GN_OK);
    t.depth = absent;
    assert_int_equal(gn_target_check(&t), GN_NO_SURFACE);

    t = good_target();
    t.color[0].format = GN_FORMAT_D24;
    assert_int_equal(gn_target_check(&t), GN_INVALID_FORMAT);
    t.color[0].format = (gn_format)77;
    assert_int_equal(gn_target_check(&t), GN_INVALID_FORMAT);

    t = good_target();
    t.depth.format = GN_FORMAT_RGBA8;
    assert_int_equal(gn_target_check(&t), GN_INVALID_FORMAT);

    t = good_target();
    t.color[0].width = 0;
    assert_int_equal(gn_target_check(&t), GN_INVALID_SIZE);
    t.color[0].width = GN_MAX_SIZE + 1;
    assert_int_equal(gn_target_check(&t), GN_INVALID_SIZE);

    t = good_target();
    t.depth.height = 0;
    assert_int_equal(gn_target_check(&t), GN_INVALID_SIZE);

    t = good_target();
    t.depth.pixels = NULL;
    assert_int_equal(gn_target_check(&t), GN_NULL_POINTER);

    t = good_target();
    t.color[0].pixels = (unsigned char *)words + 2;
    assert_int_equal(gn_target_check(&t), GN_MISALIGNED);

    t = good_target();
    t.color[0].row_stride = WIDTH * 4 + 2;
    assert_int_equal(gn_target_check(&t), GN_MISALIGNED);

    t = good_target();
    t.color[0].row_stride = WIDTH * 4 - 4;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].row_stride = -(WIDTH * 4 - 4);
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);

    t = good_target();
    t.color[0].row_stride = PTRDIFF_MAX - 3;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].row_stride = PTRDIFF_MIN;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);

    /* The rows below the last would fit memory, the last would not. */
    t = good_target();
    t.color[0].row_stride = PTRDIFF_MAX / (HEIGHT - 1) & ~(ptrdiff_t)3;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].row_stride = -t.color[0].row_stride;
    assert_int_equal(gn_target_check(&t), GN_INVALID_STRIDE);
    t.color[0].row_stride = (PTRDIFF_MAX - WIDTH * 4) / (HEIGHT - 1) & ~(ptrdiff_t)3;
    assert_int_equal(gn_target_check(&t), GN_OK);

    t = good_target();
    t.depth.height = HEIGHT - 1;
    assert_int_equal(gn_target_check(&t), GN_SIZE_MISMATCH);

    for (int i = 1; i < GN_MAX_COLORS; ++i) {
        static uint8_t more[WIDTH * HEIGHT];

        t = good_target();
        t.color[i] = gn_surface_bottom_up(more, GN_FORMAT_R8, WIDTH, HEIGHT);
        assert_int_equal(gn_target_check(&t), GN_OK);
        t.color[0] = absent;
        assert_int_equal(gn_target_check(&t), GN_OK);
        t.depth = absent;
        assert_int_equal(gn_target_check(&t), GN_OK);
        t = good_target();
        t.color[i] = gn_surface_bottom_up(more, GN_FORMAT_R8, WIDTH, HEIGHT - 1);
        assert_int_equal(gn_target_check(&t), GN_SIZE_MISMATCH);
        t.depth.pixels = NULL; /* a surface's own fault is reported first */
        assert_int_equal(gn_target_check(&t), GN_NULL_POINTER);
        t.color[i].format = GN_FORMAT_S8; /* and the earlier surface's fault first */
        assert_int_equal(gn_target_check(&t), GN_INVALID_FORMAT);
    }
}

static void clear_color_packs_by_value(void **state)
{
    (void)state;
    const gn_surface s = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, WIDTH, HEIGHT);

    memset(words, 0, sizeof words);
    assert_int_equal(gn_clear_color(&s, 1.0f, 0.5f, 0.25f, 0.0f), GN_OK);
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
        assert_int_equal(words[i], 0x004080FFu);
    assert_int_equal(words[WIDTH * HEIGHT], 0);

    assert_int_equal(gn_clear_color(&s, -1.0f, NAN, INFINITY, -INFINITY), GN_OK);
    assert_int_equal(words[0], 0x00FF0000u);
}

static void clear_color_keeps_floats(void **state)
{
    (void)state;
    const gn_surface s = gn_surface_bottom_up(words, GN_FORMAT_RGBA32F, WIDTH, HEIGHT);
    const float *p = (const float *)(const void *)words;

    assert_int_equal(gn_clear_color(&s, -3.5f, 1e30f, 0.125f, 2.0f), GN_OK);
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        assert_true(p[4 * i] == -3.5f && p[4 * i + 1] == 1e30f);
        assert_true(p[4 * i + 2] == 0.125f && p[4 * i + 3] == 2.0f);
    }
}

static void clear_respects_the_stride(void **state)
{
    (void)state;
    uint32_t padded[HEIGHT * 8];
    gn_surface s = gn_surface_bottom_up(padded, GN_FORMAT_RGBA8, WIDTH, HEIGHT);

    memset(padded, 0x55, sizeof padded);
    s.row_stride = 8 * 4;
    assert_int_equal(gn_clear_color(&s, 0, 0, 0, 0), GN_OK);
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < 8; ++x)
            assert_int_equal(padded[8 * y + x], x < WIDTH ? 0 : 0x55555555u);
}

static uint32_t cleared_depth(gn_format format, float depth)
{
    uint32_t memory[1] = {0};
    const gn_surface s = gn_surface_bottom_up(memory, format, 1, 1);
    uint16_t low;

    assert_int_equal(gn_clear_depth(&s, depth), GN_OK);
    memcpy(&low, memory, sizeof low);
    return format == GN_FORMAT_D16 ? low : memory[0];
}

/* The expected value is a double, which represents the product of a float and 2^24 - 1 exactly,
 * rounded by the C library. */
static void clear_depth_rounds_exactly(void **state)
{
    (void)state;
    uint32_t random = 12345;

    for (int i = 0; i < 100000; ++i) {
        random = random * 1664525u + 1013904223u;
        float z = (float)(random >> 8) / 16777216.0f;
        if (i % 3 == 1)
            z = ((float)(random % 65535) + 0.5f) / 65535.0f;
        if (i % 3 == 2)
            z = ldexpf(z, -(int)(random % 40));
        assert_int_equal(cleared_depth(GN_FORMAT_D16, z), (uint32_t)nearbyint((double)z * 65535.0));
        assert_int_equal(cleared_depth(GN_FORMAT_D24, z),
                         (uint32_t)nearbyint((double)z * 16777215.0));
    }
}

static void clear_depth_clamps(void **state)
{
    (void)state;
    assert_int_equal(cleared_depth(GN_FORMAT_D16, 2.0f), 65535);
    assert_int_equal(cleared_depth(GN_FORMAT_D24, 1.0f), 16777215);
    assert_int_equal(cleared_depth(GN_FORMAT_D24, -1.0f), 0);
    assert_int_equal(cleared_depth(GN_FORMAT_D24, NAN), 0);
    assert_int_equal(cleared_depth(GN_FORMAT_D24, 1e-40f), 0);
    assert_int_equal(cleared_depth(GN_FORMAT_D32F, 0.5f), 0x3F000000u);
    assert_int_equal(cleared_depth(GN_FORMAT_D32F, -0.0f), 0);
    assert_int_equal(cleared_depth(GN_FORMAT_D32F, INFINITY), 0x3F800000u);
}

/* Byte i of a row after a clear of `format` to white, or to depth 1 and stencil 0x99. */
static unsigned char cleared_byte(gn_format format, size_t i)
{
    static const unsigned char one[4] = {0, 0, 0x80, 0x3F};

    if (format == GN_FORMAT_D32FS8 && i % 8 >= 4)
        return i % 8 == 4 ? 0x99 : 0;
    if (format == GN_FORMAT_S8 || (format == GN_FORMAT_D24S8 && i % 4 == 3))
        return 0x99;
    if (format == GN_FORMAT_RGBA32F || format == GN_FORMAT_D32F || format == GN_FORMAT_D32FS8 ||
        format == GN_FORMAT_R32F)
        return one[i % 4];
    if (format == GN_FORMAT_RGBA16F)
        return i % 2 ? 0x3C : 0;
    return format == GN_FORMAT_D24 && i % 4 == 3 ? 0 : 0xFF;
}

/* Clears to depth 1 and stencil 0x99, at once and one after the other, in both orders. */
static gn_status clear_both(const gn_surface *s, uint32_t how, bool has_depth, bool has_stencil)
{
    if (how == 0)
        return gn_clear_depth_stencil(s, 1, 0x99);
    gn_status status = GN_OK;
    if (how == 1 && has_stencil)
        status = gn_clear_stencil(s, 0x99);
    if (has_depth && status == GN_OK)
        status = gn_clear_depth(s, 1);
    if (how == 2 && has_stencil && status == GN_OK)
        status = gn_clear_stencil(s, 0x99);
    return status;
}

/* Widths and heights on both sides of what is filled at a time, rows with and without a gap,
 * upwards and downwards, memory with the least alignment. No byte beside the surface may change. */
static void clear_fills_its_pixels_alone(void **state)
{
    (void)state;
    static const uint32_t widths[] = {1, 2, 15, 16, 17, 63, 255, 1023, 1024, 1025, 2050};
    static unsigned char memory[3 * (2050 * 16 + 8) + 16];

    for (int f = GN_FORMAT_RGBA8; f <= GN_FORMAT_SRGB8_A8; ++f) {
        const gn_format format = (gn_format)f;
        const bool has_stencil =
            format == GN_FORMAT_D24S8 || format == GN_FORMAT_D32FS8 || format == GN_FORMAT_S8;
        const bool has_depth = format != GN_FORMAT_S8;
        const size_t pixel = gn_format_size(format);
        const size_t element = format == GN_FORMAT_D32FS8 ? 4
                               : pixel == 3               ? 1
                               : pixel == 8               ? 2
                               : pixel < 4                ? pixel
                                                          : 4;

        for (uint32_t kind = 0; kind < 8 * sizeof widths / sizeof *widths; ++kind) {
            const uint32_t width = widths[kind / 8];
            const uint32_t height = kind & 1 ? 3 : 1;
            const size_t row = width * gn_format_size(format);
            const size_t stride = row + (kind & 2 ? element : 0);
            const size_t start = 4 + element;
            gn_surface s = gn_surface_bottom_up(memory + start, format, width, height);

            s.row_stride = (ptrdiff_t)stride;
            if (kind & 4) {
                s.pixels = memory + start + stride * (height - 1);
                s.row_stride = -(ptrdiff_t)stride;
            }
            memset(memory, 0x55, sizeof memory);
            if (format < GN_FORMAT_D16 || format > GN_FORMAT_S8)
                assert_int_equal(gn_clear_color(&s, 1, 1, 1, 1), GN_OK);
            else
                assert_int_equal(clear_both(&s, kind / 8 % 3, has_depth, has_stencil), GN_OK);
            for (size_t i = 0; i < start + stride * height + 16; ++i) {
                const bool inside =
                    i >= start && i < start + stride * height && (i - start) % stride < row;
                const unsigned char wanted =
                    inside ? cleared_byte(format, (i - start) % stride) : 0x55;
                if (memory[i] != wanted)
                    fail_msg("format %d, width %u, kind %u: byte %zu", f, width, kind, i);
            }
        }
    }
}

static void clear_faults(void **state)
{
    (void)state;
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
        cmocka_unit_test(format_sizes),
        cmocka_unit_test(constructors_place_row_zero),
        cmocka_unit_test(rows_are_a_surface),
        cmocka_unit_test(rows_beyond_a_surface_are_absent),
        cmocka_unit_test(samples_of_a_single_row),
        cmocka_unit_test(samples_that_do_not_fit),
        cmocka_unit_test(target_faults),
        cmocka_unit_test(clear_color_packs_by_value),
        cmocka_unit_test(clear_color_keeps_floats),
        cmocka_unit_test(clear_respects_the_stride),
        cmocka_unit_test(clear_depth_rounds_exactly),
        cmocka_unit_test(clear_depth_clamps),
        cmocka_unit_test(clear_fills_its_pixels_alone),
        cmocka_unit_test(clear_faults),
    };
    return cmocka_run_group_tests_name("surface", tests, NULL, NULL);
}
