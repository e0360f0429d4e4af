/* The comparison of frames (scene_compare) takes the listed differences from the reference as equal
 * (tools/guide/verification.md), and nothing beside them. */
#include <string.h>

#include "scene.h"
#include "unit.h"

/* Whether image `image` of two frames of one pixel counts as equal if one holds `a` and the other
 * `b`, both ways. Everything else in the frames is zero. */
static bool equal_in(gn_format format, uint32_t samples, uint32_t image, const void *a,
                     const void *b)
{
    const bool is_color = scene_is_color_format(format);
    const size_t size = gn_format_size(format);
    scene_frame x, y;
    scene s;

    memset(&s, 0, sizeof s);
    s.width = s.height = 1;
    s.samples = samples;
    s.color_format = is_color ? format : GN_FORMAT_RGBA8;
    s.depth_format = is_color ? GN_FORMAT_NONE : format;
    assert_true(scene_frame_allocate(&x, &s) && scene_frame_allocate(&y, &s));
    memcpy((char *)(is_color ? x.color : x.depth) + image * size, a, size);
    memcpy((char *)(is_color ? y.color : y.depth) + image * size, b, size);
    const bool equal = scene_compare(&s, &x, &y).pixels == 0;

    assert_int_equal(scene_compare(&s, &y, &x).pixels == 0, equal);
    scene_frame_free(&x);
    scene_frame_free(&y);
    return equal;
}

/* Whether bytes of SRGB8_A8 that differ in one channel by `steps` count as equal. */
static bool equal_bytes(uint32_t samples, uint32_t image, int channel, int steps)
{
    unsigned char a[4] = {100, 100, 100, 100}, b[4] = {100, 100, 100, 100};

    b[channel] = (unsigned char)(100 + steps);
    return equal_in(GN_FORMAT_SRGB8_A8, samples, image, a, b);
}

/* One step in a sample, two in the resolved image, none in alpha. */
static void steps_of_srgb(void **state)
{
    for (int channel = 0; channel < 4; ++channel) {
        const int most = channel < 3 ? 1 : 0;

        assert_true(equal_bytes(0, 0, channel, most));
        assert_false(equal_bytes(0, 0, channel, most + 1));
        for (uint32_t image = 0; image <= GN_SAMPLES; ++image) {
            const int allowed = image < GN_SAMPLES ? most : 2 * most;

            assert_true(equal_bytes(GN_SAMPLES, image, channel, allowed));
            assert_false(equal_bytes(GN_SAMPLES, image, channel, allowed + 1));
        }
    }
}

/* Denormals may be flushed, and any NaN is any other, but not in halves; the highest depths of
 * samples are those of the reference where it resolves (reference/osmesa/samples.c). */
static void words(void **state)
{
    static const struct {
        gn_format format;
        uint64_t a, b;
        uint32_t samples;
        bool equal;
    } cases[] = {
        {GN_FORMAT_RGBA8, 0x64646464, 0x64646465, 0, false},
        {GN_FORMAT_R32F, 0x007FFFFF, 0, 0, true},
        {GN_FORMAT_R32F, 0x80000001, 0x80000000, 0, true},
        {GN_FORMAT_D32F, 1, 0, 0, true},
        {GN_FORMAT_R32F, 0x00800000, 0, 0, false},
        {GN_FORMAT_R32F, 1, 2, 0, false},
        {GN_FORMAT_R32F, 0x80000000, 0, 0, false},
        {GN_FORMAT_RGBA16F, 1, 0, 0, false},
        {GN_FORMAT_D32FS8, 1, 0, 0, false},
        {GN_FORMAT_R32F, 0x7FC00000, 0xFF800001, 0, true},
        {GN_FORMAT_R32F, 0x7FC00000, 0x7F800000, 0, false},
        {GN_FORMAT_RGBA16F, 0x7E00, 0xFC01, 0, true},
        {GN_FORMAT_RGBA16F, 0x7E00, 0x7C00, 0, false},
        {GN_FORMAT_D24, 0xFFFFFF, 0xFFFFFE, GN_SAMPLES, true},
        {GN_FORMAT_D24S8, 0xFFFFFF, 0xFFFFFE, GN_SAMPLES, true},
        {GN_FORMAT_D24, 0xFFFFFE, 0xFFFFFD, GN_SAMPLES, false},
        {GN_FORMAT_D24, 0xFFFFFF, 0xFFFFFE, 0, false},
    };

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const uint32_t a = (uint32_t)cases[i].a, b = (uint32_t)cases[i].b;
        const bool is_wide = gn_format_size(cases[i].format) == sizeof cases[i].a;

        if (equal_in(cases[i].format, cases[i].samples, 0, is_wide ? (const void *)&cases[i].a : &a,
                     is_wide ? (const void *)&cases[i].b : &b) != cases[i].equal)
            fail_msg("case %zu", i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_of_srgb),
        cmocka_unit_test(words),
    };
    return cmocka_run_group_tests_name("frames compared", tests, NULL, NULL);
}
