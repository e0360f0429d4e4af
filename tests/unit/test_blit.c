/* Blits: faults, places of texels, masks of depth and stencil, overlapping memory. Expected values
 * follow from OpenGL 4.5 section 18.3.2; tests/parity/blits compares with the reference. */
#include <string.h>

#include "../../src/formats/rows.h"
#include "unit.h"

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
    memset(to_memory, 0xEE, sizeof to_memory);
    return source_of(GN_FORMAT_R8);
}

static int at(int x, int y)
{
    return ((const uint8_t *)to_memory)[y * SIDE + x];
}

static void refuses(gn_status wanted, const gn_surface *to, const gn_rectangle *to_rectangle,
                    const gn_surface *from, const gn_rectangle *from_rectangle,
                    const gn_blit_options *options)
{
    uint32_t before[sizeof to_memory / sizeof *to_memory];

    memset(from_memory, 0x33, sizeof from_memory);
    memset(to_memory, 0xEE, sizeof to_memory);
    memcpy(before, to_memory, sizeof before);
    assert_int_equal(gn_blit(to, to_rectangle, from, from_rectangle, options), wanted);
    assert_memory_equal(before, to_memory, sizeof before);
}

static void faults_are_named_and_nothing_is_written(void **state)
{
    (void)state;
    const gn_surface color = source_of(GN_FORMAT_RGBA8);
    const gn_surface depth = source_of(GN_FORMAT_D24S8);
    const gn_surface to = destination_of(GN_FORMAT_RGBA8);
    const gn_surface to_depth = destination_of(GN_FORMAT_D24S8);
    const gn_surface to_other = destination_of(GN_FORMAT_D32FS8);
    const gn_rectangle far = {0, 0, GN_MAX_SIZE + 1, 1};
    const gn_rectangle below = {0, -GN_MAX_SIZE - 1, 1, 1};
    gn_surface bad = to;
    gn_blit_options options = {0};

    refuses(GN_NULL_POINTER, NULL, NULL, &color, NULL, NULL);
    refuses(GN_NULL_POINTER, &to, NULL, NULL, NULL, NULL);
    options.filter = (gn_blit_filter)2;
    refuses(GN_INVALID_ENUM, &to, NULL, &color, NULL, &options);
    options.filter = (gn_blit_filter)-1;
    refuses(GN_INVALID_ENUM, &to, NULL, &color, NULL, &options);
    bad.format = GN_FORMAT_NONE;
    refuses(GN_INVALID_FORMAT, &bad, NULL, &color, NULL, NULL);
    refuses(GN_INVALID_FORMAT, &to, NULL, &bad, NULL, NULL);
    bad.format = (gn_format)99;
    refuses(GN_INVALID_FORMAT, &to, NULL, &bad, NULL, NULL);
    bad = to;
    bad.width = 0;
    refuses(GN_INVALID_SIZE, &bad, NULL, &color, NULL, NULL);
    refuses(GN_INVALID_SIZE, &to, NULL, &bad, NULL, NULL);
    bad = to;
    bad.row_stride = 4;
    refuses(GN_INVALID_STRIDE, &bad, NULL, &color, NULL, NULL);
    bad = color;
    bad.pixels = NULL;
    refuses(GN_NULL_POINTER, &to, NULL, &bad, NULL, NULL);
    bad = color;
    bad.pixels = (unsigned char *)from_memory + 2;
    refuses(GN_MISALIGNED, &to, NULL, &bad, NULL, NULL);
    bad = gn_surface_multisampled(&to);
    refuses(GN_INVALID_SAMPLES, &bad, NULL, &color, NULL, NULL);
    refuses(GN_INVALID_SAMPLES, &to, NULL, &bad, NULL, NULL);
    refuses(GN_INVALID_FORMAT, &to, NULL, &depth, NULL, NULL);
    refuses(GN_INVALID_FORMAT, &to_depth, NULL, &color, NULL, NULL);
    refuses(GN_INVALID_FORMAT, &to_other, NULL, &depth, NULL, NULL);
    options.filter = GN_BLIT_LINEAR;
    refuses(GN_INVALID_FORMAT, &to_depth, NULL, &depth, NULL, &options);
    refuses(GN_OUT_OF_RANGE, &to, &far, &color, NULL, NULL);
    refuses(GN_OUT_OF_RANGE, &to, NULL, &color, &below, NULL);
    refuses(GN_OVERLAP, &to, NULL, &to, NULL, NULL);
}

static void empty_rectangles_are_no_fault(void **state)
{
    (void)state;
    const gn_surface from = source_of(GN_FORMAT_RGBA8);
    const gn_surface to = destination_of(GN_FORMAT_RGBA8);
    const gn_rectangle flat = {1, 2, 5, 2}, thin = {3, 0, 3, 8}, outside = {-4, 0, 0, 8};
    gn_blit_options none = {0};

    none.scissor.set = true;
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

static void rectangles_move_mirror_and_scale(void **state)
{
    (void)state;
    const gn_surface from = numbered();
    const gn_surface to = destination_of(GN_FORMAT_R8);
    const gn_rectangle two = {2, 3, 4, 5}, moved = {5, 1, 7, 3}, mirrored = {7, 3, 5, 1};
    const gn_rectangle large = {0, 0, 8, 8};

    assert_int_equal(gn_blit(&to, &moved, &from, &two, NULL), GN_OK);
    assert_int_equal(at(5, 1), 0x32);
    assert_int_equal(at(6, 2), 0x43);
    assert_int_equal(at(4, 1), 0xEE);
    assert_int_equal(at(7, 2), 0xEE);
    assert_int_equal(gn_blit(&to, &mirrored, &from, &two, NULL), GN_OK);
    assert_int_equal(at(5, 1), 0x43);
    assert_int_equal(at(6, 2), 0x32);
    assert_int_equal(gn_blit(&to, &large, &from, &two, NULL), GN_OK);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            assert_int_equal(at(x, y), (3 + y / 4) * 16 + 2 + x / 4);
}

static void what_has_no_counterpart_is_cut_off(void **state)
{
    (void)state;
    const gn_surface from = numbered();
    const gn_surface to = destination_of(GN_FORMAT_R8);
    const gn_rectangle beyond = {-3, 4, 5, 12};
    gn_blit_options cut = {0};

    cut.scissor.set = true;
    cut.scissor.x = 1;
    cut.scissor.y = -5;
    cut.scissor.width = 4;
    cut.scissor.height = 8;
    assert_int_equal(gn_blit(&to, NULL, &from, &beyond, &cut), GN_OK);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            assert_int_equal(at(x, y), x >= 3 && x < 5 && y < 3 ? (y + 4) * 16 + x - 3 : 0xEE);
}

/* The source has 8 of 4,001 columns that 4,251 columns of the destination show: 8.4999 of them, so
 * 8 are written. Mirrored, these are the last 8. */
static void cut_ends_are_rounded_to_pixels(void **state)
{
    (void)state;
    enum { COLUMNS = 4251 };
    static uint8_t row[COLUMNS];
    const gn_surface from = numbered();
    const gn_surface to = gn_surface_bottom_up(row, GN_FORMAT_R8, COLUMNS, 1);
    const gn_rectangle texels = {0, 1, 4001, 2};
    const gn_rectangle columns[2] = {{0, 0, COLUMNS, 1}, {COLUMNS, 0, 0, 1}};

    for (int mirrored = 0; mirrored < 2; ++mirrored) {
        memset(row, 0xEE, sizeof row);
        assert_int_equal(gn_blit(&to, &columns[mirrored], &from, &texels, NULL), GN_OK);
        for (int x = 0; x < COLUMNS; ++x)
            assert_int_equal(row[mirrored ? COLUMNS - 1 - x : x], x < 8 ? 0x10 + x : 0xEE);
    }
}

/* What the destination shows lies beyond the source, less than half a texel from the end of the
 * rectangle: columns 0 to 8 of 1,010 that show texels -1 to 1 lie from -0.98 to -0.96, and of 1,018
 * that show texels 7 to 9, from 8.96 to 8.98. */
static void cuts_that_round_to_no_texel_write_nothing(void **state)
{
    (void)state;
    static const gn_rectangle columns[2] = {{-10, 0, 1000, 8}, {-1000, 0, 18, 8}};
    static const gn_rectangle texels[2] = {{-1, 0, 1, 8}, {7, 0, 9, 8}};
    static const gn_rectangle rows[2] = {{0, -10, 8, 1000}, {0, -1000, 8, 18}};
    static const gn_rectangle texel_rows[2] = {{0, -1, 8, 1}, {0, 7, 8, 9}};
    const gn_surface from = source_of(GN_FORMAT_R8);
    const gn_surface to = destination_of(GN_FORMAT_R8);

    for (int i = 0; i < 2; ++i) {
        refuses(GN_OK, &to, &columns[i], &from, &texels[i], NULL);
        refuses(GN_OK, &to, &rows[i], &from, &texel_rows[i], NULL);
    }
}

/* Columns 0 to 8 of 1,010 that show texels 3 to 5 lie from 3.02 to 3.04. */
static void cuts_that_round_to_no_texel_read_one_inside(void **state)
{
    (void)state;
    static const gn_rectangle columns = {-10, 0, 1000, 8}, texels = {3, 0, 5, 8};
    const gn_surface from = numbered();
    const gn_surface to = destination_of(GN_FORMAT_R8);

    assert_int_equal(gn_blit(&to, &columns, &from, &texels, NULL), GN_OK);
    for (int y = 0; y < SIDE; ++y)
        for (int x = 0; x < SIDE; ++x)
            assert_int_equal(at(x, y), y * 16 + 3);
}

/* Rows are converted in runs of at most 256 pixels. */
static void long_rows_are_mirrored_and_converted(void **state)
{
    (void)state;
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

static void linear_mixes_halfway(void **state)
{
    (void)state;
    static const float two[2] = {1.0f, 3.0f};
    float out[4] = {9, 9, 9, 9};
    const gn_surface from = gn_surface_bottom_up((void *)(uintptr_t)two, GN_FORMAT_R32F, 2, 1);
    const gn_surface to = gn_surface_bottom_up(out, GN_FORMAT_R32F, 4, 1);
    gn_blit_options linear = {0};

    linear.filter = GN_BLIT_LINEAR;
    assert_int_equal(gn_blit(&to, NULL, &from, NULL, &linear), GN_OK);
    assert_true(out[0] == 1.0f && out[1] == 1.5f && out[2] == 2.5f && out[3] == 3.0f);
}

static void depth_and_stencil_are_kept_where_asked(void **state)
{
    (void)state;
    static const gn_format formats[2] = {GN_FORMAT_D24S8, GN_FORMAT_D32FS8};

    for (int f = 0; f < 2; ++f) {
        for (int keeps = 0; keeps < 4; ++keeps) {
            const gn_surface from = source_of(formats[f]);
            const gn_surface to = destination_of(formats[f]);
            gn_blit_options options = {0};
            uint32_t wanted[2];

            memset(from_memory, 0x22, sizeof from_memory);
            memset(to_memory, 0x11, sizeof to_memory);
            if (f == 1) {
                for (int i = 1; i < 2 * SIDE * SIDE; i += 2) {
                    from_memory[i] = 0x22;
                    to_memory[i] = 0x11;
                }
            }
            options.keeps_depth = keeps & 1;
            options.keeps_stencil = keeps & 2;
            assert_int_equal(gn_blit(&to, NULL, &from, NULL, &options), GN_OK);
            wanted[0] = keeps & 1 ? 0x11111111u : 0x22222222u;
            wanted[1] = keeps & 2 ? 0x11u : 0x22u;
            if (f == 0)
                wanted[0] = wanted[1] = (wanted[0] & 0xFFFFFFu) | wanted[1] << 24;
            assert_int_equal(to_memory[0], wanted[0]);
            assert_int_equal(to_memory[1], wanted[1]);
            assert_int_equal(to_memory[SIDE * SIDE - 2], wanted[0]);
            assert_int_equal(to_memory[SIDE * SIDE - 1], wanted[1]);
        }
    }
}

/* A view of one row whose stride is shorter than the row: it has the pixels of another view's rows
 * one behind the other. */
static void overlap_with_a_single_row(void **state)
{
    (void)state;
    static uint32_t memory[16];
    gn_surface row = gn_surface_bottom_up(memory, GN_FORMAT_RGBA8, 16, 1);
    const gn_surface image = gn_surface_bottom_up(memory, GN_FORMAT_RGBA8, 4, 4);
    const gn_rectangle to = {6, 0, 10, 1}, from = {0, 1, 4, 2}, apart = {0, 3, 4, 4};

    row.row_stride = image.row_stride;
    assert_int_equal(gn_blit(&row, &to, &image, &from, NULL), GN_OVERLAP);
    assert_int_equal(gn_blit(&image, &from, &row, &to, NULL), GN_OVERLAP);
    assert_int_equal(gn_blit(&row, &to, &image, &apart, NULL), GN_OK);
}

/* Much enlarged, the coordinate of a pixel near the side of a texel may round to the next texel. */
static void overlap_of_enlarged_texels(void **state)
{
    (void)state;
    static uint8_t memory[16384];
    const gn_surface image = gn_surface_bottom_up(memory, GN_FORMAT_R8, 16384, 1);
    const gn_rectangle one = {12000, 0, 12001, 1}, wide = {12001, 0, 16384, 1};
    const gn_rectangle apart = {12002, 0, 16384, 1}, narrow = {12001, 0, 12002, 1};

    assert_int_equal(gn_blit(&image, &wide, &image, &one, NULL), GN_OVERLAP);
    assert_int_equal(gn_blit(&image, &apart, &image, &one, NULL), GN_OK);
    assert_int_equal(gn_blit(&image, &narrow, &image, &one, NULL), GN_OK);
    assert_int_equal(gn_blit(&image, &one, &image, &wide, NULL), GN_OK);
}

/* An empty rectangle has no texels beside it that could be read. */
static void empty_rectangles_overlap_nothing(void **state)
{
    (void)state;
    const gn_surface image = destination_of(GN_FORMAT_R8);
    const gn_rectangle some = {0, 0, 4, 4}, empty = {2, 2, 2, 2}, low = {2, 2, 6, 2};
    const gn_blit_options linear = {.filter = GN_BLIT_LINEAR};

    assert_int_equal(gn_blit(&image, &some, &image, &empty, NULL), GN_OK);
    assert_int_equal(gn_blit(&image, &some, &image, &low, NULL), GN_OK);
    assert_int_equal(gn_blit(&image, &some, &image, &low, &linear), GN_OK);
    assert_int_equal(gn_blit(&image, &low, &image, &some, &linear), GN_OK);
}

/* One part of an image may be blitted to another part; a linear filter reads one texel more. */
static void overlap_is_refused_pixel_by_pixel_in_one_image(void **state)
{
    (void)state;
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
 * 1. */
static void formats_are_converted(void **state)
{
    (void)state;
    float *const in = (float *)from_memory;
    const gn_surface red = source_of(GN_FORMAT_R32F);
    const gn_surface rgba = destination_of(GN_FORMAT_RGBA8);
    const gn_surface srgb = destination_of(GN_FORMAT_SRGB8_A8);
    const gn_surface rgb565 = destination_of(GN_FORMAT_RGB565);

    for (int i = 0; i < SIDE * SIDE; ++i)
        in[i] = 0.5f;
    assert_int_equal(gn_blit(&rgba, NULL, &red, NULL, NULL), GN_OK);
    assert_int_equal(to_memory[SIDE * SIDE - 1], 0xFF000080u);
    assert_int_equal(gn_blit(&srgb, NULL, &red, NULL, NULL), GN_OK);
    assert_int_equal(to_memory[3], 0xFF0000BCu);
    assert_int_equal(gn_blit(&rgb565, NULL, &red, NULL, NULL), GN_OK);
    assert_int_equal(((uint16_t *)to_memory)[5], 16u << 11);
}

/* Large enough that AVX2 is used where the processor has it. In strips it is not. */
#define LARGE_WIDTH 323
#define LARGE_HEIGHT 256
#define STRIP 32

static uint32_t large_from[4 * 4 * LARGE_WIDTH * LARGE_HEIGHT];
static uint32_t large_to[4 * LARGE_WIDTH * LARGE_HEIGHT],
    large_strips[4 * LARGE_WIDTH * LARGE_HEIGHT];

static void fill_large(void)
{
    uint32_t bits = 1;

    for (size_t i = 0; i < sizeof large_from / sizeof *large_from; ++i) {
        bits = bits * 1664525u + 1013904223u;
        large_from[i] = bits ^ bits >> 15;
    }
    memset(large_to, 0, sizeof large_to);
    memset(large_strips, 0, sizeof large_strips);
}

static const gn_format colors[] = {
#define FORMAT_IF_COLOR(name) GN_FORMAT_##name,
#define FORMAT_IF_DEPTH(name)
#define FORMAT_OF(name, bytes, element, kind, ...) FORMAT_IF_##kind(name)
    GN_FORMATS(FORMAT_OF)};

/* Blits all at once and in strips. */
static void blit_large(const gn_surface *from, gn_format format, gn_blit_filter filter)
{
    const gn_surface to = gn_surface_bottom_up(large_to, format, LARGE_WIDTH, LARGE_HEIGHT);
    const gn_surface strips = gn_surface_bottom_up(large_strips, format, LARGE_WIDTH, LARGE_HEIGHT);
    gn_blit_options options = {.filter = filter};

    assert_int_equal(gn_blit(&to, NULL, from, NULL, &options), GN_OK);
    options.scissor.set = true;
    options.scissor.width = LARGE_WIDTH;
    options.scissor.height = STRIP;
    for (int y = 0; y < LARGE_HEIGHT; y += STRIP) {
        options.scissor.y = y;
        assert_int_equal(gn_blit(&strips, NULL, from, NULL, &options), GN_OK);
    }
    assert_memory_equal(large_to, large_strips, sizeof large_to);
}

static void large_blits_have_the_bits_of_strips(void **state)
{
    (void)state;
    fill_large();
    for (size_t n = 0; n < sizeof colors / sizeof *colors; ++n) {
        const gn_surface moved =
            gn_surface_bottom_up(large_from, colors[n], LARGE_WIDTH, LARGE_HEIGHT);
        const gn_surface smaller = gn_surface_bottom_up(large_from, colors[n], 100, 170);
        const gn_surface twice =
            gn_surface_bottom_up(large_from, colors[n], 2 * LARGE_WIDTH, 2 * LARGE_HEIGHT);

        for (size_t m = 0; m < sizeof colors / sizeof *colors; ++m) {
            blit_large(&moved, colors[m], GN_BLIT_NEAREST);
            blit_large(&smaller, colors[m], GN_BLIT_LINEAR);
        }
        blit_large(&smaller, GN_FORMAT_RGBA32F, GN_BLIT_NEAREST);
        blit_large(&twice, GN_FORMAT_RGBA32F, GN_BLIT_LINEAR);
    }
}

static void large_resolves_have_the_bits_of_strips(void **state)
{
    (void)state;
    fill_large();
    for (size_t n = 0; n < sizeof colors / sizeof *colors; ++n) {
        const gn_surface image =
            gn_surface_bottom_up(large_from, colors[n], LARGE_WIDTH, LARGE_HEIGHT);
        const gn_surface samples = gn_surface_multisampled(&image);
        const gn_surface to = gn_surface_bottom_up(large_to, colors[n], LARGE_WIDTH, LARGE_HEIGHT);
        const gn_surface strips =
            gn_surface_bottom_up(large_strips, colors[n], LARGE_WIDTH, LARGE_HEIGHT);

        assert_int_equal(gn_resolve(&to, &samples), GN_OK);
        for (uint32_t y = 0; y < LARGE_HEIGHT; y += STRIP) {
            const gn_surface to_strip = gn_surface_rows(&strips, y, STRIP);
            const gn_surface strip = gn_surface_rows(&samples, y, STRIP);

            assert_int_equal(gn_resolve(&to_strip, &strip), GN_OK);
        }
        assert_memory_equal(large_to, large_strips, sizeof large_to);
    }
}

/* Level 1 of a large texture is a linear blit of level 0, and the blit is small. */
static void levels_of_large_textures_have_the_bits_of_blits(void **state)
{
    (void)state;
    const gn_blit_options options = {.filter = GN_BLIT_LINEAR};

    fill_large();
    for (size_t n = 0; n < sizeof colors / sizeof *colors; ++n) {
        const gn_surface from = gn_surface_bottom_up(large_from, colors[n], 320, 256);
        const gn_surface to = gn_surface_bottom_up(large_strips, colors[n], 160, 128);
        gn_texture texture;

        assert_int_equal(
            gn_texture_packed(GN_TEXTURE_2D, colors[n], 320, 256, 1, 1, large_from, &texture),
            GN_OK);
        assert_int_equal(gn_texture_generate_levels(&texture, large_to, sizeof large_to), GN_OK);
        assert_int_equal(gn_blit(&to, NULL, &from, NULL, &options), GN_OK);
        assert_int_equal(texture.level[1].row_stride, to.row_stride);
        assert_memory_equal(texture.level[1].texels, large_strips, 128 * (size_t)to.row_stride);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_are_named_and_nothing_is_written),
        cmocka_unit_test(empty_rectangles_are_no_fault),
        cmocka_unit_test(rectangles_move_mirror_and_scale),
        cmocka_unit_test(what_has_no_counterpart_is_cut_off),
        cmocka_unit_test(cut_ends_are_rounded_to_pixels),
        cmocka_unit_test(cuts_that_round_to_no_texel_write_nothing),
        cmocka_unit_test(cuts_that_round_to_no_texel_read_one_inside),
        cmocka_unit_test(long_rows_are_mirrored_and_converted),
        cmocka_unit_test(linear_mixes_halfway),
        cmocka_unit_test(depth_and_stencil_are_kept_where_asked),
        cmocka_unit_test(overlap_with_a_single_row),
        cmocka_unit_test(overlap_of_enlarged_texels),
        cmocka_unit_test(empty_rectangles_overlap_nothing),
        cmocka_unit_test(overlap_is_refused_pixel_by_pixel_in_one_image),
        cmocka_unit_test(formats_are_converted),
        cmocka_unit_test(large_blits_have_the_bits_of_strips),
        cmocka_unit_test(large_resolves_have_the_bits_of_strips),
        cmocka_unit_test(levels_of_large_textures_have_the_bits_of_blits),
    };

    return cmocka_run_group_tests_name("blit", tests, NULL, NULL);
}
