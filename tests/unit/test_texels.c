/* Textures of every target and format: their faults with texts, tight packing, and fetches of
 * texels by number, which never read outside. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "unit.h"

static const gn_format all_formats[] = {
    GN_FORMAT_RGBA8,  GN_FORMAT_RGBA32F, GN_FORMAT_D16,     GN_FORMAT_D24,     GN_FORMAT_D32F,
    GN_FORMAT_D24S8,  GN_FORMAT_D32FS8,  GN_FORMAT_BGRA8,   GN_FORMAT_R8,      GN_FORMAT_RG8,
    GN_FORMAT_RGB8,   GN_FORMAT_RGB565,  GN_FORMAT_RGB5_A1, GN_FORMAT_RGBA4,   GN_FORMAT_R16,
    GN_FORMAT_RGBA16, GN_FORMAT_R32F,    GN_FORMAT_RGBA16F, GN_FORMAT_SRGB8_A8};
enum { FORMATS = sizeof all_formats / sizeof *all_formats };

static uint64_t image[1024];

/* A 3D texture of 8x4x2 with all its levels. */
static gn_texture whole_texture(void)
{
    gn_texture t;

    memset(&t, 0xA5, sizeof t);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 2, 4, image, &t),
                     GN_OK);
    assert_int_equal(gn_texture_check(&t), GN_OK);
    assert_null(gn_texture_fault(&t));
    return t;
}

static void expect(const gn_texture *t, gn_status status, const char *text)
{
    assert_int_equal(gn_texture_check(t), status);
    assert_string_equal(gn_texture_fault(t), text);
}

static void faults_of_the_shape(void **state)
{
    (void)state;
    gn_texture t = whole_texture();

    expect(NULL, GN_NULL_POINTER, "the texture is null");
    t.target = (gn_texture_target)5;
    expect(&t, GN_INVALID_ENUM, "target is no gn_texture_target");
    t = whole_texture();
    t.format = GN_FORMAT_S8;
    expect(&t, GN_INVALID_FORMAT, "format has no texels");
    t.format = GN_FORMAT_NONE;
    expect(&t, GN_INVALID_FORMAT, "format has no texels");
    t.format = (gn_format)99;
    expect(&t, GN_INVALID_FORMAT, "format has no texels");
    t = whole_texture();
    t.width = 0;
    expect(&t, GN_INVALID_SIZE, "width is not in 1 to GN_MAX_SIZE");
    t.width = GN_MAX_SIZE + 1;
    expect(&t, GN_INVALID_SIZE, "width is not in 1 to GN_MAX_SIZE");
    t = whole_texture();
    t.height = 0;
    expect(&t, GN_INVALID_SIZE, "height is not in 1 to GN_MAX_SIZE");
    t.height = GN_MAX_SIZE + 1;
    expect(&t, GN_INVALID_SIZE, "height is not in 1 to GN_MAX_SIZE");
    t = whole_texture();
    t.depth = 0;
    expect(&t, GN_INVALID_SIZE, "depth is not in 1 to GN_MAX_SIZE");
    t.target = GN_TEXTURE_2D_ARRAY;
    expect(&t, GN_INVALID_SIZE, "depth is not in 1 to GN_MAX_SIZE");
    t.depth = GN_MAX_SIZE + 1;
    expect(&t, GN_INVALID_SIZE, "depth is not in 1 to GN_MAX_SIZE");
    t.target = GN_TEXTURE_2D;
    assert_int_equal(gn_texture_check(&t), GN_OK);
    t.target = GN_TEXTURE_1D;
    expect(&t, GN_INVALID_SIZE, "height of a 1D texture is not 1");
    t.target = GN_TEXTURE_CUBE;
    expect(&t, GN_INVALID_SIZE, "height of a cube is not its width");
    t = whole_texture();
    t.level_count = 5;
    expect(&t, GN_INVALID_SIZE, "level_count is above the number of levels of that size");
    t.level_count = UINT32_MAX;
    expect(&t, GN_INVALID_SIZE, "level_count is above the number of levels of that size");
}

/* Depth adds levels only to 3D textures. */
static void levels_of_a_size(void **state)
{
    (void)state;
    gn_texture t = whole_texture();

    t.level_count = 4;
    t.depth = 16;
    assert_int_equal(gn_texture_check(&t), GN_OK);
    assert_true(gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_R8, 8, 4, 16, 5) > 0);
    assert_true(gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_R8, 8, 4, 15, 5) == 0);
    assert_true(gn_texture_memory_size(GN_TEXTURE_2D_ARRAY, GN_FORMAT_R8, 8, 4, 16, 5) == 0);
    assert_true(gn_texture_memory_size(GN_TEXTURE_2D, GN_FORMAT_R8, GN_MAX_SIZE, 1, 0,
                                       GN_MAX_LEVELS) == 2 * GN_MAX_SIZE - 1);
    assert_true(gn_texture_memory_size(GN_TEXTURE_2D, GN_FORMAT_R8, GN_MAX_SIZE, 1, 0,
                                       GN_MAX_LEVELS + 1) == 0);
}

static void faults_of_levels(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 4; ++n) {
        gn_texture t = whole_texture();
        gn_texture_level *const l = &t.level[n];
        const gn_texture_level good = *l;
        char text[96];
        const bool has_rows = n < 2, has_layers = n < 1;

#define EXPECT_LEVEL(status, words)                                                                \
    do {                                                                                           \
        snprintf(text, sizeof text, "level[%u]." words, (unsigned)n);                              \
        expect(&t, status, text);                                                                  \
        *l = good;                                                                                 \
        assert_int_equal(gn_texture_check(&t), GN_OK);                                             \
    } while (0)

        l->texels = NULL;
        EXPECT_LEVEL(GN_NULL_POINTER, "texels is null");
        l->texels = (const char *)good.texels + 1;
        EXPECT_LEVEL(GN_MISALIGNED, "texels is not aligned to the format's element");
        ++l->row_stride;
        EXPECT_LEVEL(GN_MISALIGNED, "row_stride is no multiple of the format's element");
        if (has_rows) {
            l->row_stride = -good.row_stride + 2;
            EXPECT_LEVEL(GN_INVALID_STRIDE, "row_stride is shorter than a row");
            l->row_stride = PTRDIFF_MAX - 1;
            EXPECT_LEVEL(GN_INVALID_STRIDE, "row_stride is too long");
            l->row_stride = PTRDIFF_MIN;
            EXPECT_LEVEL(GN_INVALID_STRIDE, "row_stride is too long");
        }
        if (has_layers) {
            l->layer_stride = 2 * good.row_stride + 1;
            EXPECT_LEVEL(GN_MISALIGNED, "layer_stride is no multiple of the format's element");
            l->layer_stride = good.row_stride - 2;
            EXPECT_LEVEL(GN_INVALID_STRIDE, "layer_stride is shorter than a row");
            l->layer_stride = PTRDIFF_MAX - 1;
            EXPECT_LEVEL(GN_INVALID_STRIDE, "layer_stride is too long");
            l->layer_stride = PTRDIFF_MIN;
            EXPECT_LEVEL(GN_INVALID_STRIDE, "layer_stride is too long");
        } else {
            l->layer_stride = 1;
            assert_int_equal(gn_texture_check(&t), GN_OK);
        }
    }

    gn_texture t = whole_texture();
    t.level_count = 1;
    t.level[1].texels = NULL;
    assert_int_equal(gn_texture_check(&t), GN_OK);
    t.level_count = 0;
    assert_int_equal(gn_texture_check(&t), GN_OK);
}

/* Every level has a text of its own for each fault. */
static void words_of_all_levels(void **state)
{
    (void)state;
    static uint8_t texels[2 * GN_MAX_SIZE];
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_R8, GN_MAX_SIZE, 1, 0,
                                       GN_MAX_LEVELS, texels, &t),
                     GN_OK);
    for (int n = 0; n < GN_MAX_LEVELS; ++n) {
        char text[64];

        t.level[n].texels = NULL;
        snprintf(text, sizeof text, "level[%d].texels is null", n);
        expect(&t, GN_NULL_POINTER, text);
        t.level[n].texels = texels;
    }
}

static void alignment_of_formats(void **state)
{
    (void)state;
    for (int f = 0; f < FORMATS; ++f) {
        const gn_format format = all_formats[f];
        const size_t size = gn_format_size(format);
        const size_t element = size == 16 || format == GN_FORMAT_D32FS8 ? 4
                               : size == 8                              ? 2
                               : size == 3                              ? 1
                                                                        : size;
        gn_texture t;

        for (size_t offset = 1; offset <= 4; ++offset)
            assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, format, 2, 2, 0, 1,
                                               (const char *)image + offset, &t),
                             offset % element == 0 ? GN_OK : GN_MISALIGNED);
    }
}

static void packed_levels_follow_each_other(void **state)
{
    (void)state;
    const gn_texture t = whole_texture();
    const char *const base = (const char *)image;

    assert_true(t.target == GN_TEXTURE_3D && t.format == GN_FORMAT_RGBA16);
    assert_true(t.width == 8 && t.height == 4 && t.depth == 2 && t.level_count == 4);
    assert_ptr_equal(t.level[0].texels, base);
    assert_int_equal(t.level[0].row_stride, 64);
    assert_int_equal(t.level[0].layer_stride, 256);
    assert_ptr_equal(t.level[1].texels, base + 512); /* 4x2x1 */
    assert_int_equal(t.level[1].row_stride, 32);
    assert_int_equal(t.level[1].layer_stride, 64);
    assert_ptr_equal(t.level[2].texels, base + 576); /* 2x1x1 */
    assert_ptr_equal(t.level[3].texels, base + 592);
    assert_int_equal(gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 2, 4), 600);
    assert_int_equal(gn_texture_memory_size(GN_TEXTURE_2D_ARRAY, GN_FORMAT_RGB8, 5, 3, 7, 3),
                     3 * 7 * (15 + 2 + 1));
    assert_int_equal(gn_texture_memory_size(GN_TEXTURE_CUBE, GN_FORMAT_R16, 5, 5, 99, 2),
                     2 * 6 * (25 + 4));
    assert_int_equal(gn_texture_memory_size(GN_TEXTURE_2D, GN_FORMAT_RGBA32F, 3, 2, 0, 0), 96);
}

static void packing_refuses(void **state)
{
    (void)state;
    gn_texture t, before;

    memset(&t, 0x5A, sizeof t);
    memcpy(&before, &t, sizeof t);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R8, 1, 1, 0, 1, image, NULL),
                     GN_NULL_POINTER);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R8, 1, 1, 0, 1, NULL, &t),
                     GN_NULL_POINTER);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R8, 4, 4, 0, 4, image, &t),
                     GN_INVALID_SIZE);
    assert_int_equal(gn_texture_packed((gn_texture_target)-1, GN_FORMAT_R8, 4, 4, 0, 1, image, &t),
                     GN_INVALID_ENUM);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_S8, 4, 4, 0, 1, image, &t),
                     GN_INVALID_FORMAT);
    assert_int_equal(
        gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R32F, 4, 4, 0, 1, (char *)image + 2, &t),
        GN_MISALIGNED);
    assert_memory_equal(&t, &before, sizeof t);
    assert_true(gn_texture_memory_size(GN_TEXTURE_2D, GN_FORMAT_S8, 4, 4, 0, 1) == 0);
    assert_true(gn_texture_memory_size((gn_texture_target)9, GN_FORMAT_R8, 4, 4, 0, 1) == 0);
    /* Only 64-bit machines have 2^46 bytes of addresses. */
    assert_true((gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_RGBA32F, GN_MAX_SIZE, GN_MAX_SIZE,
                                        GN_MAX_SIZE, 1) > 0) == (PTRDIFF_MAX > INT32_MAX));
}

/* Column, row, layer and level of lane 0; the other lanes have a texel within its level. */
static void fetch_one(const gn_texture *t, const int32_t place[4], float out[4])
{
    int32_t number[4][GN_LANES];
    const int32_t *const coordinate[3] = {number[0], number[1], number[2]};
    float texel[4][GN_LANES];

    memset(number, 0, sizeof number);
    for (int n = 0; n < 4; ++n)
        number[n][0] = place[n];
    gn_fetch(t, coordinate, number[3], texel);
    for (int c = 0; c < 4; ++c)
        out[c] = texel[c][0];
}

static void expect_texel(gn_format format, const void *texels, float red, float green, float blue,
                         float alpha)
{
    const int32_t place[4] = {1, 0, 0, 0};
    const float expected[4] = {red, green, blue, alpha};
    gn_texture t;
    float texel[4];

    assert_int_equal(gn_texture_packed(GN_TEXTURE_1D, format, 2, 1, 0, 1, texels, &t), GN_OK);
    fetch_one(&t, place, texel);
    for (int c = 0; c < 4; ++c)
        if (fabsf(texel[c] - expected[c]) > 2e-7f * fabsf(expected[c]))
            fail_msg("format %d, channel %d: %a", format, c, (double)texel[c]);
}

/* The second of two texels; the values of its channels show their positions. */
static void formats_have_their_channels(void **state)
{
    (void)state;
    const uint32_t words[2] = {0, 0x04030201u};
    const uint32_t white[2] = {0, 0x00FFFFFFu};
    const uint16_t halves[2] = {0, 0x0201};
    const uint16_t packed[2] = {0, 0x1823}; /* 00011 000001 00011, 00011 00000 10001 1 */
    const uint16_t nibbles[2] = {0, 0x1234};
    const uint16_t four[8] = {0, 0, 0, 0, 1, 2, 3, 65535};
    const uint16_t floats16[8] = {0, 0, 0, 0, 0x3C00, 0xC000, 0x0001, 0x7BFF};
    const uint8_t bytes[6] = {0, 0, 0, 1, 2, 255};
    const float floats[8] = {0, 0, 0, 0, 0.5f, -2.0f, 3e30f, 1e-30f};
    union {
        float depth[4];
        uint32_t word[4];
    } with_stencil = {{0.0f, 0.0f, 0.25f, 0.0f}};

    with_stencil.word[3] = 255;
    expect_texel(GN_FORMAT_RGBA8, words, 1 / 255.0f, 2 / 255.0f, 3 / 255.0f, 4 / 255.0f);
    expect_texel(GN_FORMAT_BGRA8, words, 3 / 255.0f, 2 / 255.0f, 1 / 255.0f, 4 / 255.0f);
    expect_texel(GN_FORMAT_SRGB8_A8, words, 1 / 3213.0f, 2 / 3213.0f, 3 / 3213.0f, 4 / 255.0f);
    expect_texel(GN_FORMAT_R8, bytes + 2, 1 / 255.0f, 0, 0, 1);
    expect_texel(GN_FORMAT_RG8, halves, 1 / 255.0f, 2 / 255.0f, 0, 1);
    expect_texel(GN_FORMAT_RGB8, bytes, 1 / 255.0f, 2 / 255.0f, 1, 1);
    expect_texel(GN_FORMAT_RGB565, packed, 3 / 31.0f, 1 / 63.0f, 3 / 31.0f, 1);
    expect_texel(GN_FORMAT_RGB5_A1, packed, 3 / 31.0f, 0, 17 / 31.0f, 1);
    expect_texel(GN_FORMAT_RGBA4, nibbles, 1 / 15.0f, 2 / 15.0f, 3 / 15.0f, 4 / 15.0f);
    expect_texel(GN_FORMAT_R16, halves, 513 / 65535.0f, 0, 0, 1);
    expect_texel(GN_FORMAT_RGBA16, four, 1 / 65535.0f, 2 / 65535.0f, 3 / 65535.0f, 1);
    expect_texel(GN_FORMAT_RGBA16F, floats16, 1, -2, 0x1p-24f, 65504);
    expect_texel(GN_FORMAT_R32F, floats + 3, 0.5f, 0, 0, 1);
    expect_texel(GN_FORMAT_RGBA32F, floats, 0.5f, -2, 3e30f, 1e-30f);
    expect_texel(GN_FORMAT_D16, halves, 513 / 65535.0f, 0, 0, 1);
    expect_texel(GN_FORMAT_D24, white, 1, 0, 0, 1);
    expect_texel(GN_FORMAT_D24S8, words, 0x030201 / 16777215.0f, 0, 0, 1);
    expect_texel(GN_FORMAT_D32F, floats + 3, 0.5f, 0, 0, 1);
    expect_texel(GN_FORMAT_D32FS8, with_stencil.word, 0.25f, 0, 0, 1);
}

/* Numbers inside and outside, for all targets; every lane has its own level. */
static void fetches_within_and_beyond(void **state)
{
    (void)state;
    static const struct {
        gn_texture_target target;
        uint32_t width, height, depth, levels;
    } shapes[] = {{GN_TEXTURE_2D, 5, 3, 9, 3},       {GN_TEXTURE_1D, 7, 1, 9, 3},
                  {GN_TEXTURE_2D_ARRAY, 5, 3, 4, 2}, {GN_TEXTURE_3D, 5, 3, 7, 3},
                  {GN_TEXTURE_CUBE, 4, 4, 9, 3},     {GN_TEXTURE_3D, 1, 1, 1, 1}};
    static const int32_t far_away[] = {-1, 7, 8, 1 << 24, INT32_MAX, INT32_MIN, -1000};

    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; ++s) {
        const bool has_layers = shapes[s].target >= GN_TEXTURE_2D_ARRAY;
        const bool has_rows = shapes[s].target != GN_TEXTURE_1D;
        const size_t bytes =
            gn_texture_memory_size(shapes[s].target, GN_FORMAT_R32F, shapes[s].width,
                                   shapes[s].height, shapes[s].depth, shapes[s].levels);
        float *const texels = malloc(bytes);
        uint32_t random = 1, hits = 0;
        gn_texture t;

        assert_non_null(texels);
        for (size_t i = 0; i < bytes / 4; ++i)
            texels[i] = (float)i + 1.0f;
        assert_int_equal(gn_texture_packed(shapes[s].target, GN_FORMAT_R32F, shapes[s].width,
                                           shapes[s].height, shapes[s].depth, shapes[s].levels,
                                           texels, &t),
                         GN_OK);
        for (int i = 0; i < 2000; ++i) {
            int32_t number[4][GN_LANES];
            const int32_t *const coordinate[3] = {number[0], has_rows ? number[1] : NULL,
                                                  has_layers ? number[2] : NULL};
            float texel[4][GN_LANES];

            for (int l = 0; l < GN_LANES; ++l) {
                for (int n = 0; n < 4; ++n) {
                    random ^= random << 13;
                    random ^= random >> 17;
                    random ^= random << 5;
                    const uint32_t largest[4] = {shapes[s].width, shapes[s].height,
                                                 has_layers ? 7 : 1, shapes[s].levels};

                    number[n][l] = random >> 16 & 15u
                                       ? (int32_t)((random >> 21) % (largest[n] + 2)) - (n > 2)
                                       : far_away[(random >> 20) % 7];
                }
                if (i % 4)
                    number[3][l] = i % 4 - 1;
            }
            gn_fetch(&t, coordinate, number[3], texel);
            for (int l = 0; l < GN_LANES; ++l) {
                const int32_t level = number[3][l];
                const int32_t row = has_rows ? number[1][l] : 0;
                const int32_t layer = has_layers ? number[2][l] : 0;
                float red = 0.0f;

                if (level >= 0 && (uint32_t)level < shapes[s].levels) {
                    const int32_t w = (int32_t)shapes[s].width >> level;
                    const int32_t h = (int32_t)shapes[s].height >> level;
                    const int32_t d = (int32_t)shapes[s].depth >> level;
                    const int32_t layers = shapes[s].target == GN_TEXTURE_CUBE       ? 6
                                           : shapes[s].target == GN_TEXTURE_2D_ARRAY ? 4
                                           : shapes[s].target == GN_TEXTURE_3D && d  ? d
                                                                                     : 1;

                    if (number[0][l] >= 0 && number[0][l] < (w ? w : 1) && row >= 0 &&
                        row < (h ? h : 1) && layer >= 0 && layer < layers) {
                        const gn_texture_level *const at = &t.level[level];
                        red = *(const float *)((const char *)at->texels + row * at->row_stride +
                                               layer * at->layer_stride + 4 * number[0][l]);
                        ++hits;
                    }
                }
                assert_true(texel[0][l] == red && texel[3][l] == 1.0f);
                assert_true(texel[1][l] == 0.0f && texel[2][l] == 0.0f);
            }
        }
        assert_true(hits > 50);
        free(texels);
    }
}

/* Memory ends with the last texel, with rows and layers in either direction. Run under the address
 * sanitizer, this shows that nothing outside is read. */
static void nothing_outside_is_read(void **state)
{
    (void)state;
    for (int f = 0; f < FORMATS; ++f) {
        const size_t size = gn_format_size(all_formats[f]);

        for (int flip = 0; flip < 4; ++flip) {
            const ptrdiff_t row = (ptrdiff_t)(3 * size), layer = 2 * row;
            unsigned char *const memory = malloc((size_t)(2 * layer));
            int32_t number[3][GN_LANES];
            const int32_t *const coordinate[3] = {number[0], number[1], number[2]};
            float texel[4][GN_LANES], again[4][GN_LANES];
            gn_texture t;

            assert_non_null(memory);
            for (ptrdiff_t i = 0; i < 2 * layer; ++i)
                memory[i] = (unsigned char)(i * 37 % 61);
            assert_int_equal(
                gn_texture_packed(GN_TEXTURE_2D_ARRAY, all_formats[f], 3, 2, 2, 1, memory, &t),
                GN_OK);
            for (int l = 0; l < GN_LANES; ++l) {
                number[0][l] = l % 3;
                number[1][l] = l / 3 % 2;
                number[2][l] = l / 6 % 2;
            }
            gn_fetch(&t, coordinate, NULL, texel);
            if (flip & 1) {
                t.level[0].texels = (const char *)t.level[0].texels + row;
                t.level[0].row_stride = -row;
            }
            if (flip & 2) {
                t.level[0].texels = (const char *)t.level[0].texels + layer;
                t.level[0].layer_stride = -layer;
            }
            for (int l = 0; l < GN_LANES; ++l) {
                number[1][l] ^= flip & 1;
                number[2][l] ^= flip >> 1;
            }
            assert_int_equal(gn_texture_check(&t), GN_OK);
            gn_fetch(&t, coordinate, NULL, again);
            assert_memory_equal(texel, again, sizeof texel);
            free(memory);
        }
    }
}

/* Samples the 2D texture with a filter, between its texels and beyond its edges. */
static void sample_around(const gn_texture *t, gn_magnify magnify, gn_wrap wrap,
                          float texel[4][GN_LANES])
{
    gn_sampler sampler = {.magnify = magnify, .wrap_s = wrap, .wrap_t = wrap};
    float place[2][GN_LANES];

    sampler.minify = magnify == GN_MAGNIFY_LINEAR ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST;
    for (int l = 0; l < GN_LANES; ++l) {
        place[0][l] = 0.09f * (float)l - 0.2f;
        place[1][l] = 0.31f * (float)(l % 5) - 0.1f;
    }
    gn_sample_2d(t, &sampler, place[0], place[1], texel);
}

/* Texels are loaded in several ways, by format and alignment. Rows that begin at any multiple of
 * the format's element, in either direction, in memory that ends with the last texel, have the
 * samples of tightly packed rows. */
static void rows_lie_anywhere(void **state)
{
    (void)state;
    static const gn_wrap wraps[] = {GN_WRAP_REPEAT, GN_WRAP_CLAMP_TO_EDGE, GN_WRAP_CLAMP_TO_BORDER,
                                    GN_WRAP_MIRRORED_REPEAT};

    for (int f = 0; f < FORMATS; ++f) {
        const size_t size = gn_format_size(all_formats[f]);
        const bool is_halves =
            all_formats[f] == GN_FORMAT_RGBA16 || all_formats[f] == GN_FORMAT_RGBA16F;
        const size_t part = is_halves ? 2 : size % 4 == 0 ? 4 : size % 2 == 0 ? 2 : 1;
        const ptrdiff_t row = (ptrdiff_t)(5 * size + part);
        const size_t bytes = part + 2 * (size_t)row + 5 * size;
        unsigned char *const memory = malloc(bytes);
        gn_texture tight, loose;

        assert_non_null(memory);
        assert_int_equal(
            gn_texture_packed(GN_TEXTURE_2D, all_formats[f], 5, 3, 1, 1, image, &tight), GN_OK);
        for (size_t i = 0; i < 15 * size; ++i)
            ((unsigned char *)image)[i] = (unsigned char)(i * 37 % 61);
        loose = tight;
        for (int flip = 0; flip < 2; ++flip) {
            unsigned char *const first = memory + part + (flip ? 2 * row : 0);

            loose.level[0].texels = first;
            loose.level[0].row_stride = flip ? -row : row;
            for (int y = 0; y < 3; ++y)
                memcpy(first + (flip ? -row : row) * y,
                       (const unsigned char *)image + (size_t)y * 5 * size, 5 * size);
            assert_int_equal(gn_texture_check(&loose), GN_OK);
            for (int i = 0; i < 8; ++i) {
                const gn_magnify magnify = i & 1 ? GN_MAGNIFY_LINEAR : GN_MAGNIFY_NEAREST;
                float a[4][GN_LANES], b[4][GN_LANES];

                sample_around(&tight, magnify, wraps[i / 2], a);
                sample_around(&loose, magnify, wraps[i / 2], b);
                assert_memory_equal(a, b, sizeof a);
            }
        }
        free(memory);
    }
}

/* The last texels of the largest sizes, in memory of exactly that size. */
static void largest_sizes(void **state)
{
    (void)state;
    static const struct {
        gn_texture_target target;
        uint32_t size[3];
    } shapes[] = {{GN_TEXTURE_1D, {GN_MAX_SIZE, 1, 1}},
                  {GN_TEXTURE_2D, {GN_MAX_SIZE, 2, 1}},
                  {GN_TEXTURE_2D, {2, GN_MAX_SIZE, 1}},
                  {GN_TEXTURE_3D, {2, 2, GN_MAX_SIZE}},
                  {GN_TEXTURE_2D_ARRAY, {1, 2, GN_MAX_SIZE}}};

    for (int f = 0; f < FORMATS; ++f) {
        for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i) {
            const uint32_t *const n = shapes[i].size;
            const size_t bytes =
                gn_texture_memory_size(shapes[i].target, all_formats[f], n[0], n[1], n[2], 1);
            unsigned char *const memory = calloc(1, bytes);
            const size_t size = gn_format_size(all_formats[f]);
            const int32_t last[4] = {(int32_t)n[0] - 1, (int32_t)n[1] - 1, (int32_t)n[2] - 1, 0};
            const int32_t first[4] = {0, 0, 0, 0};
            float texel[4];
            gn_texture t;

            assert_non_null(memory);
            memset(memory + bytes - size, 0x3F, size);
            assert_int_equal(gn_texture_packed(shapes[i].target, all_formats[f], n[0], n[1], n[2],
                                               1, memory, &t),
                             GN_OK);
            fetch_one(&t, last, texel);
            assert_true(texel[0] > 0.0f);
            fetch_one(&t, first, texel);
            assert_true(texel[0] == 0.0f);
            free(memory);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_of_the_shape),
        cmocka_unit_test(levels_of_a_size),
        cmocka_unit_test(faults_of_levels),
        cmocka_unit_test(words_of_all_levels),
        cmocka_unit_test(alignment_of_formats),
        cmocka_unit_test(packed_levels_follow_each_other),
        cmocka_unit_test(packing_refuses),
        cmocka_unit_test(formats_have_their_channels),
        cmocka_unit_test(fetches_within_and_beyond),
        cmocka_unit_test(nothing_outside_is_read),
        cmocka_unit_test(rows_lie_anywhere),
        cmocka_unit_test(largest_sizes),
    };
    return cmocka_run_group_tests_name("texels", tests, NULL, NULL);
}
