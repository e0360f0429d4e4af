/* Decodes small image files that are written here byte by byte from the specifications (TGA 2.0,
 * Exif 2.32), or with libpng. */
#define _POSIX_C_SOURCE 200809L
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#include "image.h"
#include "image_exif.h"

enum { MOST = 4096 };

/* A file that a test writes. */
typedef struct file {
    uint8_t bytes[MOST];
    size_t size;
} file;

static void add(file *f, const void *bytes, size_t size)
{
    assert_true(size <= MOST - f->size);
    if (size > 0)
        memcpy(f->bytes + f->size, bytes, size);
    f->size += size;
}

static void add_byte(file *f, int value)
{
    const uint8_t byte = (uint8_t)value;
    add(f, &byte, 1);
}

static void add_16(file *f, int value)
{
    add_byte(f, value & 255);
    add_byte(f, value >> 8);
}

/* The header of a TGA, fields 1 to 5, with an ID of `id` bytes and a colour map of `length` entries
 * from `first` on. */
typedef struct tga {
    int type, width, height, bits, descriptor;
    int id, first, length, entry_bits;
} tga;

static file tga_begin(tga t)
{
    file f = {{0}, 0};
    add_byte(&f, t.id);
    add_byte(&f, t.length > 0);
    add_byte(&f, t.type);
    add_16(&f, t.first);
    add_16(&f, t.length);
    add_byte(&f, t.entry_bits);
    add_16(&f, 11); /* x and y of the origin on a screen have no effect */
    add_16(&f, 12);
    add_16(&f, t.width);
    add_16(&f, t.height);
    add_byte(&f, t.bits);
    add_byte(&f, t.descriptor);
    for (int i = 0; i < t.id; ++i)
        add_byte(&f, 0xee);
    return f;
}

#define TGA(t, ...)                                                                                \
    tga_file(t, (const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__}))
static file tga_file(tga t, const uint8_t *rest, size_t size)
{
    file f = tga_begin(t);
    add(&f, rest, size);
    return f;
}

/* Adds the extension area with this attributes type (field 24), and the footer. */
static void add_extension(file *f, int attributes_type)
{
    static const char mark[] = "TRUEVISION-XFILE.";
    const int at = (int)f->size;
    add_16(f, 495);
    for (int i = 2; i < 494; ++i)
        add_byte(f, 0);
    add_byte(f, attributes_type);
    add_16(f, at);
    add_16(f, 0);
    add_16(f, 0);
    add_16(f, 0);
    add(f, mark, sizeof mark);
}

/* Decodes with a copy that ends where the file ends, so that sanitizers see what is read behind. */
static bool decode(const file *f, image *result, const char **reason)
{
    image_budget budget = {64, (uint64_t)1 << 30};
    uint8_t *copy = malloc(f->size > 0 ? f->size : 1);
    assert_non_null(copy);
    memcpy(copy, f->bytes, f->size);
    const bool good = image_decode(copy, f->size, &budget, result, reason);
    free(copy);
    return good;
}

/* Expects these texels, 0xrrggbbaa, the upper row first. */
#define EXPECT_TEXELS(f, width, height, texels) expect_texels(f, width, height, texels, __LINE__)
#define EXPECT(f, width, height, ...)                                                              \
    EXPECT_TEXELS(f, width, height, ((const uint32_t[]){__VA_ARGS__}))
static void expect_texels(file f, uint32_t width, uint32_t height, const uint32_t *texels, int line)
{
    const char *reason = NULL;
    image i;
    if (!decode(&f, &i, &reason))
        fail_msg("line %d: %s", line, reason);
    if (i.width != width || i.height != height)
        fail_msg("line %d: %ux%u", line, (unsigned)i.width, (unsigned)i.height);
    for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
            const uint32_t t = i.texels[(height - 1 - y) * width + x];
            const uint32_t found =
                (t & 255) << 24 | (t >> 8 & 255) << 16 | (t >> 16 & 255) << 8 | t >> 24;
            const uint32_t expected = texels[y * width + x];
            if (found != expected)
                fail_msg("line %d: %08x at %u,%u, expected %08x", line, (unsigned)found,
                         (unsigned)x, (unsigned)y, (unsigned)expected);
        }
    }
    image_free(&i);
}

static void expect_refused(file f, const char *words)
{
    const char *reason = NULL;
    image i;
    if (decode(&f, &i, &reason))
        fail_msg("decoded, expected '%s'", words);
    assert_null(i.texels);
    if (strstr(reason, words) == NULL)
        fail_msg("'%s', expected '%s'", reason, words);
}

/* Bits 5 and 4 of the descriptor say in which corner the first pixel is (field 5.6, table 2). */
TEST(tga_begins_in_any_corner)
{
    const uint32_t a = 0x010101ff, b = 0x020202ff, c = 0x030303ff, d = 0x040404ff, e = 0x050505ff,
                   f = 0x060606ff;
    tga t = {.type = 3, .width = 3, .height = 2, .bits = 8, .descriptor = 0x20};
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6), 3, 2, a, b, c, d, e, f);
    t.descriptor = 0x30;
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6), 3, 2, c, b, a, f, e, d);
    t.descriptor = 0x00;
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6), 3, 2, d, e, f, a, b, c);
    t.descriptor = 0x10;
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6), 3, 2, f, e, d, c, b, a);
    /* Compressed: a run of 4, then 2 pixels. */
    t.type = 11;
    EXPECT(TGA(t, 0x83, 1, 0x01, 5, 6), 3, 2, f, e, a, a, a, a);
}

/* Five bits become the nearest of 255 steps: 1 is 8.2, 3 is 24.7, 16 is 131.6. */
TEST(tga_has_any_depth)
{
    tga t = {.type = 2, .width = 2, .height = 1, .bits = 24, .descriptor = 0};
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6), 2, 1, 0x030201ff, 0x060504ff);
    t.bits = 32;
    EXPECT(TGA(t, 1, 2, 3, 0, 4, 5, 6, 7), 2, 1, 0x030201ff, 0x060504ff);
    t.descriptor = 8;
    EXPECT(TGA(t, 1, 2, 3, 0, 4, 5, 6, 7), 2, 1, 0x03020100, 0x06050407);
    /* Bits from the highest: attribute, 5 red, 5 green, 5 blue; the lower byte first. */
    t = (tga){.type = 2, .width = 2, .height = 1, .bits = 16, .descriptor = 0};
    EXPECT(TGA(t, 0x03, 0x04, 0x10, 0xfc), 2, 1, 0x080019ff, 0xff0084ff);
    t.descriptor = 1;
    EXPECT(TGA(t, 0x03, 0x04, 0x10, 0xfc), 2, 1, 0x08001900, 0xff0084ff);
    t.bits = 15;
    EXPECT(TGA(t, 0x20, 0x00, 0xe0, 0x83), 2, 1, 0x000800ff, 0x00ff00ff);
    t = (tga){.type = 3, .width = 2, .height = 1, .bits = 16, .descriptor = 8};
    EXPECT(TGA(t, 9, 0, 10, 200), 2, 1, 0x09090900, 0x0a0a0ac8);
    t.descriptor = 0;
    EXPECT(TGA(t, 9, 0, 10, 200), 2, 1, 0x090909ff, 0x0a0a0aff);
}

/* A pixel is an index; the first entry's index need not be 0 (field 4.1). */
TEST(tga_has_colour_maps)
{
    tga t = {.type = 1, .width = 3, .height = 1, .bits = 8, .first = 5, .length = 2};
    t.entry_bits = 24;
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6, /**/ 6, 5, 6), 3, 1, 0x060504ff, 0x030201ff, 0x060504ff);
    t.entry_bits = 32;
    EXPECT(TGA(t, 1, 2, 3, 0, 4, 5, 6, 7, /**/ 5, 6, 6), 3, 1, 0x030201ff, 0x060504ff, 0x060504ff);
    t.descriptor = 8;
    EXPECT(TGA(t, 1, 2, 3, 0, 4, 5, 6, 7, /**/ 5, 6, 6), 3, 1, 0x03020100, 0x06050407, 0x06050407);
    t.descriptor = 0;
    t.entry_bits = 15;
    EXPECT(TGA(t, 0x1f, 0x00, 0x00, 0x7c, /**/ 5, 6, 5), 3, 1, 0x0000ffff, 0xff0000ff, 0x0000ffff);
    t.entry_bits = 16;
    t.descriptor = 1;
    EXPECT(TGA(t, 0x1f, 0x80, 0x00, 0x7c, /**/ 5, 6, 5), 3, 1, 0x0000ffff, 0xff000000, 0x0000ffff);
    t = (tga){.type = 1, .width = 2, .height = 1, .bits = 16, .first = 300, .length = 2};
    t.entry_bits = 24;
    t.id = 3;
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6, /**/ 0x2d, 1, 0x2c, 1), 2, 1, 0x060504ff, 0x030201ff);
    /* A true-colour image may have a colour map too, which it does not use. */
    t.type = 2;
    t.bits = 24;
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6, /**/ 7, 8, 9, 10, 11, 12), 2, 1, 0x090807ff, 0x0c0b0aff);
}

/* Packets of types 9, 10 and 11 may go on in the next row; the last may have pixels too many. */
TEST(tga_is_compressed)
{
    tga t = {.type = 10, .width = 2, .height = 2, .bits = 24, .descriptor = 0x20, .id = 2};
    EXPECT(TGA(t, 0x82, 1, 2, 3, 0x00, 4, 5, 6), 2, 2, 0x030201ff, 0x030201ff, 0x030201ff,
           0x060504ff);
    EXPECT(TGA(t, 0x00, 4, 5, 6, 0x82, 1, 2, 3), 2, 2, 0x060504ff, 0x030201ff, 0x030201ff,
           0x030201ff);
    EXPECT(TGA(t, 0x02, 4, 5, 6, 1, 2, 3, 7, 8, 9, 0xff, 1, 1, 1), 2, 2, 0x060504ff, 0x030201ff,
           0x090807ff, 0x010101ff);
    t = (tga){.type = 9, .width = 2, .height = 2, .bits = 8, .first = 1, .length = 2};
    t.entry_bits = 24;
    EXPECT(TGA(t, 1, 2, 3, 4, 5, 6, /**/ 0x82, 2, 0x00, 1), 2, 2, 0x060504ff, 0x030201ff,
           0x060504ff, 0x060504ff);
    t = (tga){.type = 11, .width = 2, .height = 2, .bits = 16, .descriptor = 0x28};
    EXPECT(TGA(t, 0x83, 9, 200), 2, 2, 0x090909c8, 0x090909c8, 0x090909c8, 0x090909c8);
}

/* The extension area says what alpha means (field 24). A premultiplied color is divided by alpha:
 * 100 of 200 is 127.5 of 255; more than alpha is white. */
TEST(tga_says_what_alpha_means)
{
    const tga t = {.type = 2, .width = 3, .height = 1, .bits = 32, .descriptor = 8};
    const uint8_t pixels[12] = {1, 2, 3, 0, 100, 50, 200, 200, 255, 0, 40, 100};
    for (int type = 0; type < 3; ++type) {
        file f = tga_file(t, pixels, sizeof pixels);
        add_extension(&f, type);
        EXPECT(f, 3, 1, 0x030201ff, 0xc83264ff, 0x2800ffff);
    }
    file f = tga_file(t, pixels, sizeof pixels);
    add_extension(&f, 3);
    EXPECT(f, 3, 1, 0x03020100, 0xc83264c8, 0x2800ff64);
    f = tga_file(t, pixels, sizeof pixels);
    add_extension(&f, 4);
    EXPECT(f, 3, 1, 0x00000000, 0xff4080c8, 0x6600ff64);
    /* Without attribute bits alpha has no meaning either. */
    f.bytes[17] = 0;
    EXPECT(f, 3, 1, 0x030201ff, 0xc83264ff, 0x2800ffff);
    /* A footer that names no extension area, and one that lies outside the file. */
    f = tga_file(t, pixels, sizeof pixels);
    add_extension(&f, 0);
    memset(f.bytes + f.size - 26, 0, 4);
    EXPECT(f, 3, 1, 0x03020100, 0xc83264c8, 0x2800ff64);
    memset(f.bytes + f.size - 26, 0xff, 4);
    EXPECT(f, 3, 1, 0x03020100, 0xc83264c8, 0x2800ff64);
}

TEST(odd_tgas_are_refused)
{
    tga t = {.type = 1, .width = 2, .height = 1, .bits = 8, .first = 5, .length = 2};
    t.entry_bits = 24;
    expect_refused(TGA(t, 1, 2, 3, 4, 5, 6, /**/ 5, 7), "names entry 7 of a colour map with 2 "
                                                        "entries from 5 on");
    expect_refused(TGA(t, 1, 2, 3, 4, 5, 6, /**/ 4, 5), "names entry 4");
    expect_refused(TGA(t, 1, 2, 3, 4, 5, 6, /**/ 5), "cut short");
    expect_refused(TGA(t, 1, 2, 3), "cut short");
    t.entry_bits = 8;
    expect_refused(TGA(t, 1, 2, 5, 6), "type 1 with 8 bits an entry of the colour map");
    t.entry_bits = 24;
    t.bits = 24;
    expect_refused(TGA(t, 1, 2, 3, 4, 5, 6, 7, 8, 9, 7, 8, 9), "type 1 with 24 bits a pixel");
    t = (tga){.type = 2, .width = 1, .height = 1, .bits = 8};
    expect_refused(TGA(t, 1), "type 2 with 8 bits a pixel");
    t.bits = 24;
    t.descriptor = 0x40;
    expect_refused(TGA(t, 1, 2, 3), "interleaved");
    t.descriptor = 0;
    t.id = 200;
    file f = tga_begin(t);
    f.size = 100;
    expect_refused(f, "cut short");
    t = (tga){.type = 10, .width = 4, .height = 1, .bits = 24};
    expect_refused(TGA(t, 0x81, 1, 2, 3), "cut short");
    expect_refused(TGA(t, 0x81, 1, 2, 3, 0x81), "cut short");
    expect_refused(TGA(t, 0x03, 1, 2, 3, 4, 5, 6), "cut short");
}

enum { PNG_SIZE = 5 };

static void take_bytes(png_structp png, png_bytep bytes, size_t size)
{
    add(png_get_io_ptr(png), bytes, size);
}

static void flush_nothing(png_structp png)
{
    (void)png;
}

/* The bytes of samples. The lower ones of 16 bits decide which 8 bits are nearest, up and down. */
static uint8_t sample(size_t i)
{
    return (uint8_t)(37 * i * i + 11);
}

/* Writes a PNG of red, green, blue and alpha. */
static file write_png(int bits)
{
    const size_t row_size = (size_t)(PNG_SIZE * bits / 2);
    uint8_t row[PNG_SIZE * 8];
    file f = {{0}, 0};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)) != 0)
        fail_msg("libpng does not write %d bits", bits);
    png_set_write_fn(png, &f, take_bytes, flush_nothing);
    png_set_IHDR(png, info, PNG_SIZE, PNG_SIZE, bits, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (size_t y = 0; y < PNG_SIZE; ++y) {
        for (size_t i = 0; i < row_size; ++i)
            row[i] = sample(y * row_size + i);
        png_write_row(png, row);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return f;
}

/* Textures have the nearest of 255 steps, and pictures all 16 bits. */
TEST(pngs_keep_their_bits)
{
    for (int bits = 8; bits <= 16; bits += 8) {
        const file f = write_png(bits);
        uint32_t texels[PNG_SIZE * PNG_SIZE] = {0};
        uint16_t wide[PNG_SIZE * PNG_SIZE * 4];
        uint8_t narrow[PNG_SIZE * PNG_SIZE * 4];
        image_budget budget = {1, 1 << 20};
        const char *reason = NULL;
        image_values v;
        for (size_t i = 0; i < COUNT(narrow); ++i) {
            wide[i] = (uint16_t)(sample(2 * i) << 8 | sample(2 * i + 1));
            narrow[i] = bits == 8 ? sample(i) : (uint8_t)lround(wide[i] / 257.0);
            texels[i / 4] = texels[i / 4] << 8 | narrow[i];
        }
        EXPECT_TEXELS(f, PNG_SIZE, PNG_SIZE, texels);

        char path[] = "/tmp/gnomon_image_XXXXXX";
        FILE *to = fdopen(mkstemp(path), "wb");
        assert_int_equal(fwrite(f.bytes, 1, f.size, to), f.size);
        fclose(to);
        const bool good = image_read_values(path, &budget, &v, &reason);
        remove(path);
        if (!good)
            fail_msg("%s", reason);
        assert_int_equal(v.bits, bits);
        if (bits == 16)
            assert_memory_equal(v.values, wide, sizeof wide);
        else
            assert_memory_equal(v.values, narrow, sizeof narrow);
        free(v.values);
    }
}

/* The beginning of a JPEG: a JFIF segment, then Exif data whose directory has two entries, of which
 * the second is the orientation. */
static file jpeg_with_orientation(bool is_big_endian, int orientation)
{
    static const uint8_t little[] = {'I', 'I', 42, 0, 8, 0,    0, 0, 2, 0, 0, 1, 3, 0, 1, 0, 0,
                                     0,   9,   0,  0, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, 0, 0, 0, 0};
    static const uint8_t big[] = {'M', 'M', 0, 42, 0, 0, 0,    8, 0, 2, 1, 0, 0, 3, 0, 0, 0,
                                  1,   0,   9, 0,  0, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, 0, 0, 0};
    file f = {{0}, 0};
    add(&f,
        "\xff\xd8\xff\xe0\0\x10JFIF\0\1\1\0\0\1\0\1\0\0\xff\xff\xe1\0\x2a"
        "Exif\0",
        31);
    add(&f, is_big_endian ? big : little, sizeof big);
    f.bytes[f.size - (is_big_endian ? 3 : 4)] = (uint8_t)orientation;
    add(&f, "\xff\xda", 2);
    return f;
}

/* Whether any part of the file that ends before its end has no orientation; what is missing is not
 * read. */
static void expect_none_before(const file *f, size_t end)
{
    for (size_t size = 0; size < end; ++size) {
        uint8_t *copy = malloc(size + 1);
        memcpy(copy, f->bytes, size);
        assert_int_equal(image_exif_orientation(copy, size), 1);
        free(copy);
    }
}

TEST(orientations_of_jpegs_are_found)
{
    for (int i = 0; i < 2; ++i) {
        for (int o = 0; o <= 9; ++o) {
            const file f = jpeg_with_orientation(i == 1, o);
            assert_int_equal(image_exif_orientation(f.bytes, f.size), o >= 1 && o <= 8 ? o : 1);
        }
        const file f = jpeg_with_orientation(i == 1, 6);
        expect_none_before(&f, f.size - 2);
        /* A directory outside the segment. */
        file far = f;
        memset(far.bytes + 35, 0xff, 4);
        assert_int_equal(image_exif_orientation(far.bytes, far.size), 1);
        /* Another type than SHORT. */
        far = f;
        far.bytes[far.size - 2 - 12 + (i == 1 ? 3 : 2)] = 4;
        assert_int_equal(image_exif_orientation(far.bytes, far.size), 1);
    }
}

/* A PNG has the same data in a chunk eXIf (PNG, section 11.3.4.5), here as the last but one. */
TEST(orientations_of_pngs_are_found)
{
    const file plain = write_png(8), jpeg = jpeg_with_orientation(true, 8);
    file f = plain;
    assert_int_equal(image_exif_orientation(plain.bytes, plain.size), 1);
    f.size -= 12;
    add(&f,
        "\0\0\0\x22"
        "eXIf",
        8);
    add(&f, jpeg.bytes + 31, 34);
    add(&f, "\0\0\0\0", 4); /* the check value, which nothing checks here */
    expect_none_before(&f, f.size);
    add(&f, plain.bytes + plain.size - 12, 12);
    assert_int_equal(image_exif_orientation(f.bytes, f.size), 8);
}
