/* Surfaces: construction, views of rows and samples, sizes of formats, every fault of a target. */
#include <string.h>

#include "unit.h"

enum { WIDTH = 5, HEIGHT = 3 };

static uint32_t words[WIDTH * HEIGHT * 4];

static void sizes_of_formats(void **state)
{
    static const struct {
        int format;
        size_t size;
    } cases[] = {{GN_FORMAT_NONE, 0},
                 {GN_FORMAT_D16, 2},
                 {GN_FORMAT_D24, 4},
                 {GN_FORMAT_D32F, 4},
                 {GN_FORMAT_D24S8, 4},
                 {GN_FORMAT_D32FS8, 8},
                 {GN_FORMAT_S8, 1},
                 {-1, 0},
                 {99, 0}};

    for (size_t i = 0; i < COUNT(cases); ++i) /* test_formats.c has colours */
        assert_int_equal(gn_format_size((gn_format)cases[i].format), cases[i].size);
}

static void constructors_place_row_zero(void **state)
{
    const gn_surface up = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, WIDTH, HEIGHT);
    const gn_surface down = gn_surface_top_down(words, GN_FORMAT_RGBA8, WIDTH, HEIGHT);
    static const uint32_t no_sizes[][2] = {
        {4, 0}, {4, GN_MAX_SIZE + 1}, {GN_MAX_SIZE + 1, 4}, {UINT32_MAX, UINT32_MAX}};

    assert_ptr_equal(up.pixels, words);
    assert_int_equal(up.row_stride, WIDTH * 4);
    assert_true(up.width == WIDTH && up.height == HEIGHT && up.format == GN_FORMAT_RGBA8);
    assert_ptr_equal(down.pixels, words + WIDTH * (HEIGHT - 1));
    assert_int_equal(down.row_stride, -WIDTH * 4);
    for (size_t i = 0; i < COUNT(no_sizes); ++i)
        assert_ptr_equal(
            gn_surface_top_down(words, GN_FORMAT_RGBA32F, no_sizes[i][0], no_sizes[i][1]).pixels,
            words);
    assert_null(gn_surface_top_down(NULL, GN_FORMAT_RGBA8, WIDTH, HEIGHT).pixels);
}

static void rows_are_a_surface(void **state)
{
    static const struct {
        uint32_t first, count;
        gn_format format;
    } cases[] = {{HEIGHT - 1, 1, GN_FORMAT_D32F}, {HEIGHT - 1, 2, GN_FORMAT_NONE},
                 {HEIGHT, 0, GN_FORMAT_NONE},     {0, 0, GN_FORMAT_NONE},
                 {UINT32_MAX, 2, GN_FORMAT_NONE}, {1, UINT32_MAX, GN_FORMAT_NONE}};
    gn_surface all = gn_surface_top_down(words, GN_FORMAT_D32F, WIDTH, HEIGHT);

    for (size_t lowest = 0; lowest < 2; ++lowest) {
        const gn_surface band = gn_surface_rows(&all, 1, 2);

        assert_true(band.width == WIDTH && band.height == 2);
        memset(words, 0, sizeof words);
        assert_int_equal(gn_clear_depth(&band, 1), GN_OK);
        for (size_t i = 0; i < COUNT(words); ++i)
            assert_int_equal(words[i],
                             i >= lowest * WIDTH && i < (lowest + 2) * WIDTH ? 0x3F800000 : 0);
        all = gn_surface_bottom_up(words, GN_FORMAT_D32F, WIDTH, HEIGHT);
    }
    for (size_t i = 0; i < COUNT(cases); ++i)
        assert_int_equal(gn_surface_rows(&all, cases[i].first, cases[i].count).format,
                         cases[i].format);
    assert_int_equal(gn_surface_rows(NULL, 0, 1).format, GN_FORMAT_NONE);
    all.pixels = NULL;
    assert_int_equal(gn_surface_rows(&all, 0, 1).width, 0);
}

/* The stride of a single row does not matter, so its images may lie one after the other. Strides
 * that no memory has become the largest multiple of 16. */
static void samples_are_images(void **state)
{
    const gn_surface good = gn_surface_bottom_up(words, GN_FORMAT_RGBA8, 4, 2);
    gn_surface s = good;

    assert_int_equal(gn_surface_multisampled(&good).sample_stride, 32);
    s.height = 0;
    assert_true(gn_surface_multisampled(&s).sample_stride == PTRDIFF_MAX - 15);
    s.height = 2;
    s.row_stride = PTRDIFF_MAX;
    assert_true(gn_surface_multisampled(&s).sample_stride == PTRDIFF_MAX - 15);
    s.height = 1;
    assert_true(gn_surface_multisampled(&s).sample_stride == PTRDIFF_MAX);
    for (s.row_stride = 0; s.row_stride <= 16; s.row_stride += 4) {
        const gn_target target = {.color = {gn_surface_multisampled(&s)}};

        assert_int_equal(target.color[0].sample_stride, 16);
        assert_int_equal(gn_target_check(&target), GN_OK);
    }
    assert_null(gn_surface_multisampled(NULL).pixels);

    assert_null(gn_surface_sample(NULL, 0).pixels);
    assert_null(gn_surface_sample(&good, 1).pixels);
    assert_ptr_equal(gn_surface_sample(&good, 0).pixels, words);
    s = gn_surface_multisampled(&good);
    assert_ptr_equal(gn_surface_sample(&s, GN_SAMPLES - 1).pixels, words + 8 * (GN_SAMPLES - 1));
    assert_null(gn_surface_sample(&s, GN_SAMPLES).pixels);
    s.pixels = NULL;
    assert_null(gn_surface_sample(&s, 0).pixels);
    assert_int_equal(gn_surface_sample(&s, 0).width, 0);

    /* An image that fits memory alone, but not four times: the stride is what is wrong. */
    gn_target target = {.color = {gn_surface_bottom_up(words, GN_FORMAT_RGBA8, WIDTH, 4)}};
    target.color[0].row_stride = (PTRDIFF_MAX / 3 - 64) / 4 * 4;
    assert_int_equal(gn_target_check(&target), GN_OK);
    target.color[0] = gn_surface_multisampled(&target.color[0]);
    assert_int_equal(gn_target_check(&target), GN_INVALID_STRIDE);
}

/* The fault of a surface of its own is reported before that of sizes, and that of an earlier
 * surface before that of a later one. */
static void target_faults(void **state)
{
    enum { NONE = GN_FORMAT_NONE, RGBA8 = GN_FORMAT_RGBA8, D24 = GN_FORMAT_D24, R8 = GN_FORMAT_R8 };
    static const ptrdiff_t most = (PTRDIFF_MAX - WIDTH * 4) / (HEIGHT - 1) & ~(ptrdiff_t)3;
    static const ptrdiff_t more = PTRDIFF_MAX / (HEIGHT - 1) & ~(ptrdiff_t)3;
    const struct {
        gn_status status;
        struct {
            int format;
            uint32_t width, height;
            ptrdiff_t stride;
            int offset; /* of the pixels; -1: null */
        } color, depth;
    } cases[] = {
        {GN_OK, {RGBA8, 5, 3, 20, 0}, {D24, 5, 3, 20, 0}},
        {GN_OK, {NONE, 5, 3, 20, 0}, {D24, 5, 3, 20, 0}},
        {GN_OK, {RGBA8, 5, 3, 20, 0}, {NONE, 5, 3, 20, 0}},
        {GN_NO_SURFACE, {NONE, 5, 3, 20, 0}, {NONE, 5, 3, 20, 0}},
        {GN_INVALID_FORMAT, {D24, 5, 3, 20, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_FORMAT, {77, 5, 3, 20, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_FORMAT, {RGBA8, 5, 3, 20, 0}, {RGBA8, 5, 3, 20, 0}},
        {GN_INVALID_SIZE, {RGBA8, 0, 3, 20, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_SIZE, {RGBA8, GN_MAX_SIZE + 1, 3, 20, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_SIZE, {RGBA8, 5, 3, 20, 0}, {D24, 5, 0, 20, 0}},
        {GN_INVALID_SIZE, {RGBA8, 5, 3, 20, 0}, {D24, 5, GN_MAX_SIZE + 1, 20, 0}},
        {GN_NULL_POINTER, {RGBA8, 5, 3, 20, 0}, {D24, 5, 3, 20, -1}},
        {GN_MISALIGNED, {RGBA8, 5, 3, 20, 2}, {D24, 5, 3, 20, 0}},
        {GN_MISALIGNED, {RGBA8, 5, 3, 22, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_STRIDE, {RGBA8, 5, 3, 16, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_STRIDE, {RGBA8, 5, 3, -16, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_STRIDE, {RGBA8, 5, 3, PTRDIFF_MAX - 3, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_STRIDE, {RGBA8, 5, 3, PTRDIFF_MIN, 0}, {D24, 5, 3, 20, 0}},
        /* the rows below the last would fit memory, the last would not */
        {GN_INVALID_STRIDE, {RGBA8, 5, 3, more, 0}, {D24, 5, 3, 20, 0}},
        {GN_INVALID_STRIDE, {RGBA8, 5, 3, -more, 0}, {D24, 5, 3, 20, 0}},
        {GN_OK, {RGBA8, 5, 3, most, 0}, {D24, 5, 3, 20, 0}},
        {GN_SIZE_MISMATCH, {RGBA8, 5, 3, 20, 0}, {D24, 5, 2, 20, 0}},
        {GN_OK, {R8, 5, 3, 5, 0}, {D24, 5, 3, 20, 0}},
        {GN_SIZE_MISMATCH, {R8, 5, 2, 5, 0}, {D24, 5, 3, 20, 0}},
        {GN_NULL_POINTER, {R8, 5, 2, 5, 0}, {D24, 5, 3, 20, -1}},
        {GN_INVALID_FORMAT, {GN_FORMAT_S8, 5, 2, 5, 0}, {D24, 5, 3, 20, -1}},
    };

    assert_int_equal(gn_target_check(NULL), GN_NULL_POINTER);
    for (size_t i = 0; i < COUNT(cases); ++i) {
        for (int a = 0; a < GN_MAX_COLORS; ++a) { /* alone, at each place */
            unsigned char *const pixels = (unsigned char *)words;
            gn_target t = {0};

            t.color[a] = gn_surface_bottom_up(
                cases[i].color.offset < 0 ? NULL : pixels + cases[i].color.offset,
                (gn_format)cases[i].color.format, cases[i].color.width, cases[i].color.height);
            t.color[a].row_stride = cases[i].color.stride;
            t.depth = gn_surface_bottom_up(
                cases[i].depth.offset < 0 ? NULL : pixels + cases[i].depth.offset,
                (gn_format)cases[i].depth.format, cases[i].depth.width, cases[i].depth.height);
            t.depth.row_stride = cases[i].depth.stride;
            if (gn_target_check(&t) != cases[i].status)
                fail_msg("case %zu, attachment %d: %d", i, a, (int)gn_target_check(&t));
        }
    }
    /* Two colours of different sizes. */
    gn_target t = {.color = {gn_surface_bottom_up(words, GN_FORMAT_RGBA8, WIDTH, HEIGHT)}};
    for (int a = 1; a < GN_MAX_COLORS; ++a) {
        t.color[a] = gn_surface_bottom_up(words, GN_FORMAT_R8, WIDTH, HEIGHT - 1);
        assert_int_equal(gn_target_check(&t), GN_SIZE_MISMATCH);
        t.color[a].height = HEIGHT;
        assert_int_equal(gn_target_check(&t), GN_OK);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sizes_of_formats),   cmocka_unit_test(constructors_place_row_zero),
        cmocka_unit_test(rows_are_a_surface), cmocka_unit_test(samples_are_images),
        cmocka_unit_test(target_faults),
    };
    return cmocka_run_group_tests_name("surface", tests, NULL, NULL);
}
