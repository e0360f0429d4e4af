/* The comparison of frames (scene_compare) takes the listed differences from the reference as equal
 * (tools/guide/verification.md), and nothing beside them. */
#include <string.h>

#include "scene.h"
#include "unit.h"

/* A scene of one pixel. */
static scene scene_of(gn_format color, gn_format depth, uint32_t samples)
{
    scene s;

    memset(&s, 0, sizeof s);
    s.width = 1;
    s.height = 1;
    s.samples = samples;
    s.color_format = color;
    s.depth_format = depth;
    return s;
}

/* Whether image `image` of two frames counts as equal if one holds `a` and the other `b`, both
 * ways. Everything else in the frames is zero. */
static bool equal_in(gn_format format, uint32_t samples, uint32_t image, const void *a,
                     const void *b)
{
    const bool is_color = scene_is_color_format(format);
    const scene s = is_color ? scene_of(format, GN_FORMAT_NONE, samples)
                             : scene_of(GN_FORMAT_RGBA8, format, samples);
    const size_t size = gn_format_size(format);
    scene_frame x, y;

    assert_true(scene_frame_allocate(&x, &s) && scene_frame_allocate(&y, &s));
    memcpy((char *)(is_color ? x.color : x.depth) + image * size, a, size);
    memcpy((char *)(is_color ? y.color : y.depth) + image * size, b, size);
    const bool equal = scene_compare(&s, &x, &y).pixels == 0;
    const bool back = scene_compare(&s, &y, &x).pixels == 0;

    scene_frame_free(&x);
    scene_frame_free(&y);
    assert_int_equal(equal, back);
    return equal;
}

static bool equal_words(gn_format format, uint32_t a, uint32_t b)
{
    return equal_in(format, 0, 0, &a, &b);
}

/* Whether bytes of SRGB8_A8 that differ in one channel by `steps` count as equal. */
static bool equal_bytes(uint32_t samples, uint32_t image, int channel, int steps)
{
    unsigned char a[4] = {100, 100, 100, 100}, b[4] = {100, 100, 100, 100};

    b[channel] = (unsigned char)(100 + steps);
    return equal_in(GN_FORMAT_SRGB8_A8, samples, image, a, b);
}

static void steps_of_srgb(void **state)
{
    for (int c = 0; c < 3; ++c) {
        assert_true(equal_bytes(0, 0, c, 1));
        assert_false(equal_bytes(0, 0, c, 2));
        for (uint32_t sample = 0; sample < GN_SAMPLES; ++sample) {
            assert_true(equal_bytes(GN_SAMPLES, sample, c, 1));
            assert_false(equal_bytes(GN_SAMPLES, sample, c, 2));
        }
        assert_true(equal_bytes(GN_SAMPLES, GN_SAMPLES, c, 2));
        assert_false(equal_bytes(GN_SAMPLES, GN_SAMPLES, c, 3));
    }
    assert_false(equal_words(GN_FORMAT_RGBA8, 0x64646464, 0x64646465));
}

static void alpha_of_srgb_is_exact(void **state)
{
    assert_true(equal_bytes(0, 0, 3, 0));
    assert_false(equal_bytes(0, 0, 3, 1));
    for (uint32_t image = 0; image <= GN_SAMPLES; ++image)
        assert_false(equal_bytes(GN_SAMPLES, image, 3, 1));
}

static void flushed_denormals(void **state)
{
    assert_true(equal_words(GN_FORMAT_R32F, 0x007FFFFF, 0));
    assert_true(equal_words(GN_FORMAT_R32F, 0x80000001, 0x80000000));
    assert_true(equal_words(GN_FORMAT_D32F, 1, 0));
    assert_false(equal_words(GN_FORMAT_R32F, 0x00800000, 0));
    assert_false(equal_words(GN_FORMAT_R32F, 1, 2));
    assert_false(equal_words(GN_FORMAT_R32F, 0x80000000, 0));

    const uint64_t half = 1, zero = 0;

    assert_false(equal_in(GN_FORMAT_RGBA16F, 0, 0, &half, &zero));
    assert_false(equal_in(GN_FORMAT_D32FS8, 0, 0, &half, &zero));
}

static void any_nan_is_any_other(void **state)
{
    const uint64_t a = 0x7E00, b = 0xFC01, infinity = 0x7C00;

    assert_true(equal_words(GN_FORMAT_R32F, 0x7FC00000, 0xFF800001));
    assert_false(equal_words(GN_FORMAT_R32F, 0x7FC00000, 0x7F800000));
    assert_true(equal_in(GN_FORMAT_RGBA16F, 0, 0, &a, &b));
    assert_false(equal_in(GN_FORMAT_RGBA16F, 0, 0, &a, &infinity));
}

/* The reference's resolved depths are replaced where it draws (reference/osmesa/samples.c). */
static void highest_depths_of_samples(void **state)
{
    const uint32_t highest = 0xFFFFFF, next = 0xFFFFFE, third = 0xFFFFFD;

    assert_true(equal_in(GN_FORMAT_D24, GN_SAMPLES, 0, &highest, &next));
    assert_true(equal_in(GN_FORMAT_D24S8, GN_SAMPLES, 0, &highest, &next));
    assert_false(equal_in(GN_FORMAT_D24, GN_SAMPLES, 0, &next, &third));
    assert_false(equal_words(GN_FORMAT_D24, highest, next));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_of_srgb),
        cmocka_unit_test(alpha_of_srgb_is_exact),
        cmocka_unit_test(flushed_denormals),
        cmocka_unit_test(any_nan_is_any_other),
        cmocka_unit_test(highest_depths_of_samples),
    };
    return cmocka_run_group_tests_name("frames compared", tests, NULL, NULL);
}
