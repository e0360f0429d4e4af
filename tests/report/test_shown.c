/* Tests how the report shows frames: which row is the upper one, which image and which attachment
 * is shown, the colours of every kind of format, and which pixels count as different. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "shown.h"
#include "scene_pixel.h"

enum { WIDTH = 3, HEIGHT = 2 };

static scene *make_scene(gn_format color, gn_format depth, uint32_t samples, scene_frame *frame)
{
    scene *const s = scene_create(WIDTH, HEIGHT, color, depth);
    s->samples = samples;
    assert_true(scene_frame_allocate(frame, s));
    return s;
}

/* Stores a colour in pixel i and checks how it is shown. */
static void check_color(gn_format format, float r, float g, float b, int red, int green, int blue)
{
    const float color[4] = {r, g, b, 0.5f};
    scene_frame frame;
    uint8_t rgb[3];
    scene *const s = make_scene(format, GN_FORMAT_NONE, 0, &frame);
    scene_pixel_store(frame.color, format, 4, color);
    assert_int_equal(shown_attachment(s), 0);
    shown_pixel(&frame, 0, 4, rgb);
    assert_int_equal(rgb[0], red);
    assert_int_equal(rgb[1], green);
    assert_int_equal(rgb[2], blue);
    assert_int_equal(shown_colors(&frame, 0), red + green + blue > 0 ? 2 : 1);
    scene_frame_free(&frame);
    scene_free(s);
}

static void test_colors(void **state)
{
    (void)state;
    check_color(GN_FORMAT_RGBA8, 1.0f, 0.2f, 0.0f, 255, 51, 0);
    check_color(GN_FORMAT_BGRA8, 1.0f, 0.2f, 0.0f, 255, 51, 0);
    check_color(GN_FORMAT_RGB565, 1.0f, 0.0f, 16.0f / 31.0f, 255, 0, 132);
    check_color(GN_FORMAT_RGBA16, 0.0f, 0.2f, 1.0f, 0, 51, 255);
    check_color(GN_FORMAT_R8, 0.4f, 0.0f, 0.0f, 102, 102, 102);
    check_color(GN_FORMAT_RG8, 0.4f, 1.0f, 1.0f, 102, 255, 0);
    check_color(GN_FORMAT_R32F, 0.4f, 0.0f, 0.0f, 102, 102, 102);
    check_color(GN_FORMAT_RGBA32F, 7.0f, -3.0f, 0.2f, 255, 0, 51);
    check_color(GN_FORMAT_RGBA32F, 0.0f / 0.0f, 1.0f / 0.0f, 0.0f, 0, 255, 0);
    check_color(GN_FORMAT_RGBA16F, 1.0f, 0.25f, 0.0f, 255, 64, 0);
    check_color(GN_FORMAT_SRGB8_A8, 1.0f, 0.0f, 0.5f, 255, 0, 188); /* as stored */
}

static void test_depth(void **state)
{
    static const struct {
        gn_format format;
        uint32_t bits;
        int grey;
    } rows[] = {{GN_FORMAT_D16, 0x8000, 128},        {GN_FORMAT_D24, 0xFFFFFF, 255},
                {GN_FORMAT_D32F, 0x3F000000, 128},   {GN_FORMAT_D24S8, 0xFF333333, 51},
                {GN_FORMAT_D32FS8, 0x3F800000, 255}, {GN_FORMAT_S8, 7, 7}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        const size_t element = scene_element_size(rows[i].format);
        const size_t in_pixel = gn_format_size(rows[i].format) / element;
        scene_frame frame;
        uint8_t rgb[3];
        scene *const s = make_scene(GN_FORMAT_NONE, rows[i].format, 0, &frame);
        assert_int_equal(shown_attachment(s), SHOWN_DEPTH);
        scene_set_element(frame.depth, element, 2 * in_pixel, rows[i].bits);
        shown_pixel(&frame, SHOWN_DEPTH, 2, rgb);
        for (int c = 0; c < 3; ++c)
            assert_int_equal(rgb[c], rows[i].grey);
        scene_frame_free(&frame);
        scene_free(s);
    }
}

/* The upper row is the last of the image, and of several images the last is shown. */
static void test_rows(void **state)
{
    scene_frame frame;
    (void)state;
    scene *const one = make_scene(GN_FORMAT_RGBA8, GN_FORMAT_NONE, 0, &frame);
    assert_int_equal(shown_row(&frame, 0), WIDTH);
    assert_int_equal(shown_row(&frame, 1), 0);
    scene_frame_free(&frame);
    scene_free(one);

    scene *const several = make_scene(GN_FORMAT_RGBA8, GN_FORMAT_NONE, GN_SAMPLES, &frame);
    assert_int_equal(shown_row(&frame, 0), GN_SAMPLES * WIDTH * HEIGHT + WIDTH);
    assert_int_equal(shown_row(&frame, 1), GN_SAMPLES * WIDTH * HEIGHT);
    ((uint32_t *)frame.color)[0] = 1; /* a sample, which is not shown */
    assert_int_equal(shown_colors(&frame, 0), 1);
    scene_frame_free(&frame);
    scene_free(several);
}

static void test_attachment(void **state)
{
    scene_frame frame;
    (void)state;
    scene *const s = scene_create(WIDTH, HEIGHT, GN_FORMAT_NONE, GN_FORMAT_NONE);
    s->more_colors[1] = GN_FORMAT_R8;
    assert_true(scene_frame_allocate(&frame, s));
    assert_int_equal(shown_attachment(s), 2);
    memset(frame.more_colors[1], 9, WIDTH * HEIGHT);
    uint8_t rgb[3];
    shown_pixel(&frame, 2, 0, rgb);
    assert_int_equal(rgb[1], 9);
    scene_frame_free(&frame);
    scene_free(s);
}

/* Returns how many pixels of the shown image differ. */
static int count(const scene *s, const scene_frame *a, const scene_frame *b)
{
    int differ = 0;
    for (uint32_t y = 0; y < HEIGHT; ++y)
        for (size_t x = 0; x < WIDTH; ++x)
            differ += shown_differs(s, a, b, shown_row(a, y) + x);
    return differ;
}

static void test_differences(void **state)
{
    scene_frame a, b;
    (void)state;
    scene *const s = make_scene(GN_FORMAT_RGBA8, GN_FORMAT_D24S8, GN_SAMPLES, &a);
    assert_true(scene_frame_allocate(&b, s));
    assert_int_equal(count(s, &a, &b), 0);
    ((uint32_t *)a.depth)[WIDTH * HEIGHT + 5] = 0x1000000; /* stencil of the second sample */
    assert_int_equal(count(s, &a, &b), 1);
    assert_true(shown_differs(s, &a, &b, shown_row(&a, 0) + 2));
    shown_break(&a, 0);
    assert_int_equal(count(s, &a, &b), 2);
    assert_true(shown_differs(s, &a, &b, shown_row(&a, 1) + 1));
    scene_frame_free(&a);
    scene_frame_free(&b);
    scene_free(s);
}

/* A step of sRGB is no difference, two steps are. */
static void test_allowed(void **state)
{
    scene_frame a, b;
    (void)state;
    scene *const s = make_scene(GN_FORMAT_SRGB8_A8, GN_FORMAT_NONE, 0, &a);
    assert_true(scene_frame_allocate(&b, s));
    ((unsigned char *)a.color)[4] = 1;
    assert_int_equal(count(s, &a, &b), 0);
    ((unsigned char *)a.color)[4] = 2;
    assert_int_equal(count(s, &a, &b), 1);
    scene_frame_free(&a);
    scene_frame_free(&b);
    scene_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_colors),      cmocka_unit_test(test_depth),
        cmocka_unit_test(test_rows),        cmocka_unit_test(test_attachment),
        cmocka_unit_test(test_differences), cmocka_unit_test(test_allowed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
