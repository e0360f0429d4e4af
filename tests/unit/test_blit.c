/* Blits and resolves: faults, places of texels, masks of depth and stencil, overlapping memory, and
 * large ones beside small ones. Expected values follow from OpenGL 4.5 section 18.3.2;
 * tests/parity/blits compares with the reference. */
#include <string.h>

#include "formats.h"
#include "noise.h"
#include "untouched.h"

#define SIDE 8

static uint32_t from_memory[4 * SIDE * SIDE], to_memory[4 * SIDE * SIDE];

static gn_surface source_of(gn_format format)
{
    return gn_surface_bottom_up(from_memory, format, SIDE, SIDE);
}

static gn_surface destination_of(gn_format format)
{
    return gn_surface_bottom_up(to_memory, format, SIDE, SIDE);
}

/* Texel (x, y) of R8 is 16 y + x. */
static gn_surface numbered(void)
{
    uint8_t *const bytes = (uint8_t *)from_memory;

    for (int i = 0; i < SIDE * SIDE; ++i)
        bytes[i] = (uint8_t)(i / SIDE * 16 + i % SIDE);
    mark(to_memory);
    return source_of(GN_FORMAT_R8);
}

static int at(int x, int y)
{
    return ((const uint8_t *)to_memory)[y * SIDE + x];
}

/* Asserts the status, and that nothing is written. */
static void refuses(gn_status wanted, const gn_surface *to, const gn_rectangle *to_rectangle,
                    const gn_surface *from, const gn_rectangle *from_rectangle,
                    const gn_blit_options *options)
{
    memset(from_memory, 0x33, sizeof from_memory);
    mark(to_memory);
    assert_int_equal(gn_blit(to, to_rectangle, from, from_rectangle, options), wanted);
    assert_untouched(to_memory);
}

static void faults_are_named_and_nothing_is_written(void **state)
{
    const gn_surface color = source_of(GN_FORMAT_RGBA8), to = destination_of(GN_FORMAT_RGBA8);
    const gn_surface depth = source_of(GN_FORMAT_D24S8), to_depth = destination_of(GN_FORMAT_D24S8);
    const gn_surface to_other = destination_of(GN_FORMAT_D32FS8);
    const gn_blit_options linear = {.filter = GN_BLIT_LINEAR};
    const gn_blit_options filters[2] = {{.filter = (gn_blit_filter)2},
                                        {.filter = (gn_blit_filter)-1}};
    const struct {
        gn_status status;
        gn_surface surface;
    } bad[] = {
        {GN_INVALID_FORMAT, gn_surface_bottom_up(to_memory, GN_FORMAT_NONE, SIDE, SIDE)},
        {GN_INVALID_FORMAT, gn_surface_bottom_up(to_memory, (gn_format)99, SIDE, SIDE)},
        {GN_INVALID_SIZE, gn_surface_bottom_up(to_memory, GN_FORMAT_RGBA8, 0, SIDE)},
        {GN_INVALID_STRIDE, {to_memory, 4, SIDE, SIDE, GN_FORMAT_RGBA8, 0, 0}},
        {GN_NULL_POINTER, gn_surface_bottom_up(NULL, GN_FORMAT_RGBA8, SIDE, SIDE)},
        {GN_MISALIGNED, gn_surface_bottom_up((char *)to_memory + 2, GN_FORMAT_RGBA8, SIDE, SIDE)},
        {GN_INVALID_SAMPLES, gn_surface_multisampled(&to)},
    };

    refuses(GN_NULL_POINTER, NULL, NULL, &color, NULL, NULL);
    refuses(GN_NULL_POINTER, &to, NULL, NULL, NULL, NULL);
    for (size_t i = 0; i < COUNT(bad); ++i) {
        refuses(bad[i].status, &bad[i].surface, NULL, &color, NULL, NULL);
        refuses(bad[i].status, &to, NULL, &bad[i].surface, NULL, NULL);
    }
    for (int i = 0; i < 2; ++i)
        refuses(GN_INVALID_ENUM, &to, NULL, &color, NULL, &filters[i]);
    refuses(GN_INVALID_FORMAT, &to, NULL, &depth, NULL, NULL);
    refuses(GN_INVALID_FORMAT, &to_depth, NULL, &color, NULL, NULL);
    refuses(GN_INVALID_FORMAT, &to_other, NULL, &depth, NULL, NULL);
    refuses(GN_INVALID_FORMAT, &to_depth, NULL, &depth, NULL, &linear);
    refuses(GN_OVERLAP, &to, NULL, &to, NULL, NULL);
    /* Every corner has a range. */
    for (int i = 0; i < 8; ++i) {
        const int32_t sign = i % 2 ? 1 : -1;
        gn_rectangle r = {0, 0, 4, 4};
        int32_t *const corner[] = {&r.x0, &r.y0, &r.x1, &r.y1};

        *corner[i / 2] = sign * (GN_MAX_SIZE + 1);
        refuses(GN_OUT_OF_RANGE, &to, &r, &color, NULL, NULL);
        refuses(GN_OUT_OF_RANGE, &to, NULL, &color, &r, NULL);
        *corner[i / 2] = sign * GN_MAX_SIZE;
        assert_int_equal(gn_blit(&to, &r, &color, NULL, NULL), GN_OK);
        assert_int_equal(gn_blit(&to, NULL, &color, &r, NULL), GN_OK);
    }
}

static void empty_rectangles_are_no_fault(void **state)
{
    const gn_surface from = source_of(GN_FORMAT_RGBA8);
    const gn_surface to = destination_of(GN_FORMAT_RGBA8);
    const gn_rectangle flat = {1, 2, 5, 2}, thin = {3, 0, 3, 8}, outside = {-4, 0, 0, 8};
    gn_blit_options none = {0};

    none.scissor.enabled = true;
    refuses(GN_OK, &to, &flat, &from, NULL, NULL);
    refuses(GN_OK, &to, NULL, &from, &thin, NULL);
    refuses(GN_OK, &to, &outside, &from, NULL, NULL);
    refuses(GN_OK, &to, NULL, &from, &outside, NULL);
    refuses(GN_OK, &to, NULL, &from, NULL, &none);
    none.scissor.x = INT32_MAX;
    none.scissor.y = INT32_MIN;
    none.scissor.width = UINT32_MAX;
    none.scissor.height = UINT32_MAX;
    refuses(GN_OK, &to, NULL, &from, NULL, &none);
}

/* Moved, mirrored, enlarged, and cut by the source, the destination and a scissor: the texel that
 * each column and each row shows. */
static void rectangles_move_mirror_scale_and_cut(void **state)
{
    static const struct {
        gn_rectangle to, from;
        gn_scissor scissor;
        const char *columns, *rows;
    } cases[] = {
        {{5, 1, 7, 3}, {2, 3, 4, 5}, {0}, "-----23-", "-34-----"},
        {{7, 3, 5, 1}, {2, 3, 4, 5}, {0}, "-----32-", "-43-----"},
        {{0, 0, 8, 8}, {2, 3, 4, 5}, {0}, "22223333", "33334444"},
        {{0, 0, 8, 8}, {-3, 4, 5, 12}, {true, 1, -5, 4, 8}, "---01---", "456-----"},
    };
    const gn_surface to = destination_of(GN_FORMAT_R8);

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const gn_surface from = numbered();
        const gn_blit_options options = {.scissor = cases[i].scissor};

        assert_int_equal(gn_blit(&to, &cases[i].to, &from, &cases[i].from, &options), GN_OK);
        for (int k = 0; k < SIDE * SIDE; ++k) {
            const char x = cases[i].columns[k % SIDE], y = cases[i].rows[k / SIDE];
            assert_int_equal(at(k % SIDE, k / SIDE),
                             x == '-' || y == '-' ? MARK : (y - '0') * 16 + x - '0');
        }
    }
}

/* The source has 8 of 4,001 columns that 4,251 columns of the destination show: 8.4999 of them, so
 * 8 are written. Mirrored, these are the last 8. */
static void cut_ends_are_rounded_to_pixels(void **state)
{
    enum { COLUMNS = 4251 };
    static uint8_t row[COLUMNS];
    const gn_surface from = numbered();
    const gn_surface to = gn_surface_bottom_up(row, GN_FORMAT_R8, COLUMNS, 1);
    const gn_rectangle texels = {0, 1, 4001, 2};
    const gn_rectangle columns[2] = {{0, 0, COLUMNS, 1}, {COLUMNS, 0, 0, 1}};

    for (int mirrored = 0; mirrored < 2; ++mirrored) {
        memset(row, MARK, sizeof row);
        assert_int_equal(gn_blit(&to, &columns[mirrored], &from, &texels, NULL), GN_OK);
        for (int x = 0; x < COLUMNS; ++x)
            assert_int_equal(row[mirrored ? COLUMNS - 1 - x : x], x < 8 ? 0x10 + x : MARK);
    }
}

/* What the destination shows lies beyond the source, less than half a texel from the end of the
 * rectangle: columns 0 to 8 of 1,010 that show texels -1 to 1 lie from -0.98 to -0.96, and of 1,018
 * that show texels 7 to 9, from 8.96 to 8.98. Columns 0 to 8 of 1,010 that show texels 3 to 5 lie
 * from 3.02 to 3.04. */
static void cuts_that_round_to_no_texel(void **state)
{
    static const gn_rectangle columns[3] = {
        {-10, 0, 1000, 8}, {-1000, 0, 18, 8}, {-10, 0, 1000, 8}};
    static const gn_rectangle texels[3] = {{-1, 0, 1, 8}, {7, 0, 9, 8}, {3, 0, 5, 8}};
    const gn_surface from = numbered(), to = destination_of(GN_FORMAT_R8);

    assert_int_equal(gn_blit(&to, &columns[2], &from, &texels[2], NULL), GN_OK);
    for (int i = 0; i < SIDE * SIDE; ++i)
        assert_int_equal(at(i % SIDE, i / SIDE), i / SIDE * 16 + 3);
    for (int i = 0; i < 2; ++i) {
        const gn_rectangle c = columns[i], t = texels[i];
        const gn_rectangle rows = {c.y0, c.x0, c.y1, c.x1}, texel_rows = {t.y0, t.x0, t.y1, t.x1};

        refuses(GN_OK, &to, &c, &from, &t, NULL);
        refuses(GN_OK, &to, &rows, &from, &texel_rows, NULL);
    }
}

/* Rows are converted in runs of at most 256 pixels. */
static void long_rows_are_mirrored_and_converted(void **state)
{
    enum { TEXELS = 523, COLUMNS = 520 };
    static uint8_t row[TEXELS];
    static uint32_t out[COLUMNS];
    const gn_surface from = gn_surface_bottom_up(row, GN_FORMAT_R8, TEXELS, 1);
    const gn_surface to = gn_surface_bottom_up(out, GN_FORMAT_RGBA8, COLUMNS, 1);
    const gn_rectangle backwards = {COLUMNS + 1, 0, 1, 1};

    for (uint32_t x = 0; x < TEXELS; ++x)
        row[x] = (uint8_t)(x * 7 % 251);
    assert_int_equal(gn_blit(&to, NULL, &from, &backwards, NULL), GN_OK);
    for (uint32_t x = 0; x < COLUMNS; ++x)
        assert_int_equal(out[x], 0xFF000000u | (COLUMNS - x) * 7 % 251);
}

/* Every bit of depth and stencil is copied or kept, twice as wide, mirrored and as it is. */
static void depth_and_stencil_are_kept_apart(void **state)
{
    static const gn_rectangle shapes[3] = {{0, 0, 40, 1}, {20, 0, 0, 1}, {0, 0, 20, 1}};

    for (int i = 0; i < 2 * 4 * 3; ++i) {
        const uint32_t words = 1 + (uint32_t)i % 2, shape = (uint32_t)i / 8;
        const gn_format format = words == 1 ? GN_FORMAT_D24S8 : GN_FORMAT_D32FS8;
        const gn_surface from = gn_surface_bottom_up(from_memory, format, 20, 1);
        const gn_surface to = gn_surface_bottom_up(to_memory, format, 40, 1);
        const bool keeps_depth = i / 2 & 1, keeps_stencil = i / 4 & 1;
        const gn_blit_options options = {.depth_disabled = keeps_depth,
                                         .stencil_disabled = keeps_stencil};
        /* The bits of both that are written in the first and the second word. */
        const uint32_t depth = keeps_depth ? 0 : words == 1 ? 0xFFFFFF : UINT32_MAX;
        const uint32_t stencil = keeps_stencil ? 0 : words == 1 ? 0xFF000000 : 0xFF;
        const uint32_t written[2] = {words == 1 ? depth | stencil : depth, stencil};

        for (uint32_t k = 0; k < 20; ++k) {
            from_memory[words * k] = words == 1 ? 0x10203040 + k : 0x3F000000 + k;
            if (words == 2)
                from_memory[2 * k + 1] = 100 + k;
        }
        mark(to_memory);
        assert_int_equal(gn_blit(&to, &shapes[shape], &from, NULL, &options), GN_OK);
        for (uint32_t k = 0; k < 40 * words; ++k) {
            const uint32_t x = k / words, word = k % words;
            const uint32_t read = shape == 0 ? x / 2 : shape == 1 ? 19 - x : x;
            const uint32_t bits = shape == 0 || x < 20 ? written[word] : 0;
            const uint32_t copied = bits ? from_memory[words * read + word] & bits : 0;

            assert_int_equal(to_memory[k], (0x5A5A5A5A & ~bits) | copied);
        }
    }
}

/* Depth is not averaged, and one sample is copied. */
static void resolved_sizes_and_depths(void **state)
{
    const gn_surface image = gn_surface_bottom_up(from_memory, GN_FORMAT_D32F, 4, 4);
    const gn_surface samples = gn_surface_multisampled(&image);
    const gn_surface *const from[2] = {&samples, &image};
    gn_surface to = gn_surface_bottom_up(to_memory, GN_FORMAT_D32F, 4, 3);

    for (uint32_t i = 0; i < 64; ++i)
        from_memory[i] = 0x3F000000u + i;
    mark(to_memory);
    assert_int_equal(gn_resolve(&to, &samples), GN_SIZE_MISMATCH);
    to = gn_surface_bottom_up(to_memory, GN_FORMAT_D32F, 3, 4);
    assert_int_equal(gn_resolve(&to, &samples), GN_SIZE_MISMATCH);
    assert_untouched(to_memory);
    to = gn_surface_bottom_up(to_memory, GN_FORMAT_D32F, 4, 4);
    for (int i = 0; i < 2; ++i) {
        mark(to_memory);
        assert_int_equal(gn_resolve(&to, from[i]), GN_OK);
        assert_memory_equal(to_memory, from_memory, 64);
        assert_int_equal(to_memory[16], 0x5A5A5A5A);
    }
}

/* Views of one image overlap if their addresses do; pixels are only compared if pixels, stride and
 * format are equal. */
static void overlap_of_views(void **state)
{
    const gn_rectangle left = {0, 0, 2, 4}, right = {2, 0, 4, 4};
    const gn_surface a = gn_surface_bottom_up(to_memory, GN_FORMAT_RGBA8, 4, 4);
    const gn_surface b[] = {{to_memory, 32, 4, 4, GN_FORMAT_RGBA8, 0, 0},
                            gn_surface_bottom_up(to_memory, GN_FORMAT_R32F, 4, 4),
                            {to_memory + 1, 16, 3, 4, GN_FORMAT_RGBA8, 0, 0}};

    assert_int_equal(gn_blit(&a, &left, &a, &right, NULL), GN_OK);
    refuses(GN_OVERLAP, &a, &left, &a, &left, NULL);
    for (size_t i = 0; i < COUNT(b); ++i)
        refuses(GN_OVERLAP, &a, &left, &b[i], i < 2 ? &right : &left, NULL);
}

/* A view of one row whose stride is shorter than the row: it has the pixels of another view's rows
 * one behind the other. Much enlarged, the coordinate of a pixel near the side of a texel may round
 * to the next texel. An empty rectangle has no texels beside it that could be read. */
static void overlap_of_rows_and_enlarged_texels(void **state)
{
    static uint8_t memory[16384];
    const gn_surface line = gn_surface_bottom_up(memory, GN_FORMAT_R8, 16384, 1);
    const gn_surface image = gn_surface_bottom_up(to_memory, GN_FORMAT_RGBA8, 4, 4);
    const gn_surface row = {to_memory, image.row_stride, 16, 1, GN_FORMAT_RGBA8, 0, 0};
    const gn_surface bytes = destination_of(GN_FORMAT_R8);
    const gn_blit_options linear = {.filter = GN_BLIT_LINEAR};
    const struct {
        const gn_surface *to, *from;
        gn_rectangle drawn, read;
        const gn_blit_options *options;
        gn_status status;
    } cases[] = {
        {&row, &image, {6, 0, 10, 1}, {0, 1, 4, 2}, NULL, GN_OVERLAP},
        {&image, &row, {0, 1, 4, 2}, {6, 0, 10, 1}, NULL, GN_OVERLAP},
        {&row, &image, {6, 0, 10, 1}, {0, 3, 4, 4}, NULL, GN_OK},
        {&image, &row, {0, 3, 4, 4}, {6, 0, 10, 1}, NULL, GN_OK},
        {&line, &line, {12001, 0, 16384, 1}, {12000, 0, 12001, 1}, NULL, GN_OVERLAP},
        {&line, &line, {12002, 0, 16384, 1}, {12000, 0, 12001, 1}, NULL, GN_OK},
        {&line, &line, {12001, 0, 12002, 1}, {12000, 0, 12001, 1}, NULL, GN_OK},
        {&line, &line, {12000, 0, 12001, 1}, {12001, 0, 16384, 1}, NULL, GN_OK},
        {&bytes, &bytes, {0, 0, 4, 4}, {2, 2, 2, 2}, NULL, GN_OK},
        {&bytes, &bytes, {0, 0, 4, 4}, {2, 2, 6, 2}, NULL, GN_OK},
        {&bytes, &bytes, {0, 0, 4, 4}, {2, 2, 6, 2}, &linear, GN_OK},
        {&bytes, &bytes, {2, 2, 6, 2}, {0, 0, 4, 4}, &linear, GN_OK},
    };

    for (size_t i = 0; i < COUNT(cases); ++i)
        if (gn_blit(cases[i].to, &cases[i].drawn, cases[i].from, &cases[i].read,
                    cases[i].options) != cases[i].status)
            fail_msg("case %zu", i);
}

/* One part of an image may be blitted to another part; a linear filter reads one texel more. */
static void overlap_is_refused_pixel_by_pixel_in_one_image(void **state)
{
    const gn_surface image = destination_of(GN_FORMAT_R8);
    const gn_surface rows = gn_surface_rows(&image, 4, 4);
    const gn_rectangle left = {0, 0, 4, 8}, right = {4, 0, 8, 8}, middle = {3, 0, 7, 8};
    const gn_rectangle narrow = {5, 0, 8, 8};
    gn_blit_options linear = {0};

    linear.filter = GN_BLIT_LINEAR;
    refuses(GN_OVERLAP, &image, &left, &image, &middle, NULL);
    refuses(GN_OVERLAP, &image, &right, &image, &left, &linear);
    refuses(GN_OVERLAP, &image, NULL, &rows, NULL, NULL);
    refuses(GN_OVERLAP, &rows, NULL, &image, &left, NULL);
    memset(to_memory, 0, sizeof to_memory);
    ((uint8_t *)to_memory)[0] = 77;
    assert_int_equal(gn_blit(&image, &right, &image, &left, NULL), GN_OK);
    assert_int_equal(at(4, 0), 77);
    assert_int_equal(gn_blit(&image, &narrow, &image, &left, &linear), GN_OK);
}

/* 0.5 is 128 of 255, and the nearest byte of sRGB is 188. Channels that a format lacks are 0, 0,
 * 1. Halfway between 1 and 3 a linear filter mixes 1.5 and 2.5. */
static void formats_are_converted_and_texels_mixed(void **state)
{
    float two[2] = {1, 3}, four[4], half = 0.5f;
    const gn_surface red = gn_surface_bottom_up(&half, GN_FORMAT_R32F, 1, 1);
    const gn_surface pair = gn_surface_bottom_up(two, GN_FORMAT_R32F, 2, 1);
    const gn_surface wide = gn_surface_bottom_up(four, GN_FORMAT_R32F, 4, 1);
    const gn_surface rgba = destination_of(GN_FORMAT_RGBA8);
    const gn_surface srgb = destination_of(GN_FORMAT_SRGB8_A8);
    const gn_surface rgb565 = destination_of(GN_FORMAT_RGB565);
    const gn_blit_options linear = {.filter = GN_BLIT_LINEAR};

    assert_int_equal(gn_blit(&rgba, NULL, &red, NULL, NULL), GN_OK);
    assert_int_equal(to_memory[SIDE * SIDE - 1], 0xFF000080);
    assert_int_equal(gn_blit(&srgb, NULL, &red, NULL, NULL), GN_OK);
    assert_int_equal(to_memory[3], 0xFF0000BC);
    assert_int_equal(gn_blit(&rgb565, NULL, &red, NULL, NULL), GN_OK);
    assert_int_equal(((uint16_t *)to_memory)[5], 16 << 11);
    assert_int_equal(gn_blit(&wide, NULL, &pair, NULL, &linear), GN_OK);
    assert_true(four[0] == 1 && four[1] == 1.5f && four[2] == 2.5f && four[3] == 3);
}

/* Large enough that AVX2 is used where the processor has it. In strips it is not. */
#define LARGE_WIDTH 323
#define LARGE_HEIGHT 256
#define STRIP 32

static uint32_t large_from[4 * 4 * LARGE_WIDTH * LARGE_HEIGHT];
static uint32_t large_to[4 * LARGE_WIDTH * LARGE_HEIGHT],
    large_strips[4 * LARGE_WIDTH * LARGE_HEIGHT];

static gn_surface large(void *memory, gn_format format)
{
    return gn_surface_bottom_up(memory, format, LARGE_WIDTH, LARGE_HEIGHT);
}

/* Blits all at once and in strips. */
static void blit_large(const gn_surface *from, gn_format format, gn_blit_filter filter)
{
    const gn_surface to = large(large_to, format), strips = large(large_strips, format);
    gn_blit_options options = {.filter = filter};

    assert_int_equal(gn_blit(&to, NULL, from, NULL, &options), GN_OK);
    options.scissor = (gn_scissor){.enabled = true, .width = LARGE_WIDTH, .height = STRIP};
    for (; options.scissor.y < LARGE_HEIGHT; options.scissor.y += STRIP)
        assert_int_equal(gn_blit(&strips, NULL, from, NULL, &options), GN_OK);
    assert_memory_equal(large_to, large_strips, sizeof large_to);
}

static void resolve_large(gn_format format)
{
    const gn_surface image = large(large_from, format), samples = gn_surface_multisampled(&image);
    const gn_surface to = large(large_to, format), strips = large(large_strips, format);

    assert_int_equal(gn_resolve(&to, &samples), GN_OK);
    for (uint32_t y = 0; y < LARGE_HEIGHT; y += STRIP) {
        const gn_surface to_strip = gn_surface_rows(&strips, y, STRIP);
        const gn_surface strip = gn_surface_rows(&samples, y, STRIP);

        assert_int_equal(gn_resolve(&to_strip, &strip), GN_OK);
    }
    assert_memory_equal(large_to, large_strips, sizeof large_to);
}

/* Level 1 of a large texture is a linear blit of level 0, and the blit is small. */
static void level_of_large(gn_format format)
{
    const gn_blit_options options = {.filter = GN_BLIT_LINEAR};
    const gn_surface from = gn_surface_bottom_up(large_from, format, 320, 256);
    const gn_surface to = gn_surface_bottom_up(large_strips, format, 160, 128);
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, format, 320, 256, 1, 1, large_from, &t),
                     GN_OK);
    assert_int_equal(gn_texture_generate_levels(&t, large_to, sizeof large_to), GN_OK);
    assert_int_equal(gn_blit(&to, NULL, &from, NULL, &options), GN_OK);
    assert_int_equal(t.level[1].row_stride, to.row_stride);
    assert_memory_equal(t.level[1].texels, large_strips, 128 * (size_t)to.row_stride);
}

static void large_surfaces_have_the_bits_of_small_ones(void **state)
{
    uint64_t seed = 1;

    for (size_t i = 0; i < COUNT(large_from); ++i)
        large_from[i] = random_bits(&seed);
    for (size_t n = 0; n < COUNT(formats); ++n) {
        const gn_format format = formats[n].format;
        const gn_surface moved = large(large_from, format);
        const gn_surface smaller = gn_surface_bottom_up(large_from, format, 100, 170);
        const gn_surface twice =
            gn_surface_bottom_up(large_from, format, 2 * LARGE_WIDTH, 2 * LARGE_HEIGHT);

        if (!formats[n].is_color)
            continue;
        memset(large_to, 0, sizeof large_to);
        memset(large_strips, 0, sizeof large_strips);
        for (size_t m = 0; m < COUNT(formats); ++m) {
            if (!formats[m].is_color)
                continue;
            blit_large(&moved, formats[m].format, GN_BLIT_NEAREST);
            blit_large(&smaller, formats[m].format, GN_BLIT_LINEAR);
        }
        blit_large(&smaller, GN_FORMAT_RGBA32F, GN_BLIT_NEAREST);
        blit_large(&twice, GN_FORMAT_RGBA32F, GN_BLIT_LINEAR);
        resolve_large(format);
        level_of_large(format);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_are_named_and_nothing_is_written),
        cmocka_unit_test(empty_rectangles_are_no_fault),
        cmocka_unit_test(rectangles_move_mirror_scale_and_cut),
        cmocka_unit_test(cut_ends_are_rounded_to_pixels),
        cmocka_unit_test(cuts_that_round_to_no_texel),
        cmocka_unit_test(long_rows_are_mirrored_and_converted),
        cmocka_unit_test(depth_and_stencil_are_kept_apart),
        cmocka_unit_test(resolved_sizes_and_depths),
        cmocka_unit_test(overlap_of_views),
        cmocka_unit_test(overlap_of_rows_and_enlarged_texels),
        cmocka_unit_test(overlap_is_refused_pixel_by_pixel_in_one_image),
        cmocka_unit_test(formats_are_converted_and_texels_mixed),
        cmocka_unit_test(large_surfaces_have_the_bits_of_small_ones),
    };

    return cmocka_run_group_tests_name("blit", tests, NULL, NULL);
}
