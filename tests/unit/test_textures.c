/* Textures of every target and format: their faults with texts, tight packing, and fetches of
 * texels by number, within and beyond. tests/parity/texels compares with the reference;
 * tests/property tests that nothing outside is read. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "formats.h"
#include "lookups.h"

static uint64_t image[1024];

/* A 3D texture of 8x4x2 with all its levels. */
static gn_texture whole_texture(void)
{
    gn_texture t;

    memset(&t, 0xA5, sizeof t);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 2, 4, image, &t),
                     GN_OK);
    return t;
}

static void expect(const gn_texture *t, gn_status status, const char *text)
{
    assert_int_equal(gn_texture_check(t), status);
    if (status == GN_OK)
        assert_null(gn_texture_fault(t));
    else
        assert_string_equal(gn_texture_fault(t), text);
}

static void faults_of_the_shape(void **state)
{
    static const char width[] = "width is not in 1 to GN_MAX_SIZE";
    static const char height[] = "height is not in 1 to GN_MAX_SIZE";
    static const char depth[] = "depth is not in 1 to GN_MAX_SIZE";
    static const char format[] = "format has no texels";
    static const char levels[] = "level_count is above the number of levels of that size";
    static const struct {
        int target, format;
        uint32_t width, height, depth, levels;
        gn_status status;
        const char *text;
    } cases[] = {
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 2, 4, GN_OK, NULL},
        {5, GN_FORMAT_RGBA16, 8, 4, 2, 4, GN_INVALID_ENUM, "target is no gn_texture_target"},
        {GN_TEXTURE_3D, GN_FORMAT_S8, 8, 4, 2, 4, GN_INVALID_FORMAT, format},
        {GN_TEXTURE_3D, GN_FORMAT_NONE, 8, 4, 2, 4, GN_INVALID_FORMAT, format},
        {GN_TEXTURE_3D, 99, 8, 4, 2, 4, GN_INVALID_FORMAT, format},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 0, 4, 2, 4, GN_INVALID_SIZE, width},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, GN_MAX_SIZE + 1, 4, 2, 4, GN_INVALID_SIZE, width},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 0, 2, 4, GN_INVALID_SIZE, height},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, GN_MAX_SIZE + 1, 2, 4, GN_INVALID_SIZE, height},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 0, 4, GN_INVALID_SIZE, depth},
        {GN_TEXTURE_2D_ARRAY, GN_FORMAT_RGBA16, 8, 4, 0, 4, GN_INVALID_SIZE, depth},
        {GN_TEXTURE_2D_ARRAY, GN_FORMAT_RGBA16, 8, 4, GN_MAX_SIZE + 1, 4, GN_INVALID_SIZE, depth},
        {GN_TEXTURE_2D, GN_FORMAT_RGBA16, 8, 4, GN_MAX_SIZE + 1, 4, GN_OK, NULL},
        {GN_TEXTURE_1D, GN_FORMAT_RGBA16, 8, 4, 2, 4, GN_INVALID_SIZE,
         "height of a 1D texture is not 1"},
        {GN_TEXTURE_CUBE, GN_FORMAT_RGBA16, 8, 4, 2, 4, GN_INVALID_SIZE,
         "height of a cube is not its width"},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 2, 5, GN_INVALID_SIZE, levels},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 2, UINT32_MAX, GN_INVALID_SIZE, levels},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 16, 4, GN_OK, NULL},
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 2, 0, GN_OK, NULL},
    };

    expect(NULL, GN_NULL_POINTER, "the texture is null");
    for (size_t i = 0; i < COUNT(cases); ++i) {
        gn_texture t = whole_texture();

        t.target = (gn_texture_target)cases[i].target;
        t.format = (gn_format)cases[i].format;
        t.width = cases[i].width;
        t.height = cases[i].height;
        t.depth = cases[i].depth;
        t.level_count = cases[i].levels;
        expect(&t, cases[i].status, cases[i].text);
    }
}

/* Levels of one row or one layer take any stride of rows or layers; levels that are not counted may
 * be null. */
static void faults_of_levels(void **state)
{
    static const struct {
        uint32_t levels;      /* that have such a fault */
        int texels;           /* bytes beyond the good place; -1: null */
        ptrdiff_t row, layer; /* instead of the good stride, if not 0 */
        gn_status status;
        const char *words;
    } cases[] = {
        {4, -1, 0, 0, GN_NULL_POINTER, "texels is null"},
        {4, 1, 0, 0, GN_MISALIGNED, "texels is not aligned to the format's element"},
        {4, 0, 65, 0, GN_MISALIGNED, "row_stride is no multiple of the format's element"},
        {2, 0, -6, 0, GN_INVALID_STRIDE, "row_stride is shorter than a row"},
        {2, 0, PTRDIFF_MAX - 1, 0, GN_INVALID_STRIDE, "row_stride is too long"},
        {2, 0, PTRDIFF_MIN, 0, GN_INVALID_STRIDE, "row_stride is too long"},
        {1, 0, 0, 129, GN_MISALIGNED, "layer_stride is no multiple of the format's element"},
        {1, 0, 0, 62, GN_INVALID_STRIDE, "layer_stride is shorter than a row"},
        {1, 0, 0, PTRDIFF_MAX - 1, GN_INVALID_STRIDE, "layer_stride is too long"},
        {1, 0, 0, PTRDIFF_MIN, GN_INVALID_STRIDE, "layer_stride is too long"},
    };
    static uint8_t texels[2 * GN_MAX_SIZE];
    char text[96];

    for (size_t i = 0; i < COUNT(cases); ++i) {
        for (uint32_t n = 0; n < 4; ++n) {
            gn_texture t = whole_texture();
            gn_texture_level *const l = &t.level[n];
            const bool is_fault = n < cases[i].levels;

            l->texels = cases[i].texels < 0 ? NULL : (const char *)l->texels + cases[i].texels;
            l->row_stride = cases[i].row ? cases[i].row : l->row_stride;
            l->layer_stride = cases[i].layer ? cases[i].layer : l->layer_stride;
            snprintf(text, sizeof text, "level[%u].%s", (unsigned)n, cases[i].words);
            expect(&t, is_fault ? cases[i].status : GN_OK, text);
            t.level_count = n ? n : 1;
            expect(&t, n == 0 ? cases[i].status : GN_OK, text);
        }
    }
    /* Every level has a text of its own. */
    gn_texture t =
        texture_of(GN_TEXTURE_1D, GN_FORMAT_R8, GN_MAX_SIZE, 1, 1, GN_MAX_LEVELS, texels);
    for (int n = 0; n < GN_MAX_LEVELS; ++n) {
        t.level[n].texels = NULL;
        snprintf(text, sizeof text, "level[%d].texels is null", n);
        expect(&t, GN_NULL_POINTER, text);
        t.level[n].texels = texels;
    }
}

static void packed_levels_follow_each_other(void **state)
{
    static const struct {
        int target, format;
        uint32_t width, height, depth, levels;
        size_t size;
    } cases[] = {
        {GN_TEXTURE_3D, GN_FORMAT_RGBA16, 8, 4, 2, 4, 600},
        {GN_TEXTURE_2D_ARRAY, GN_FORMAT_RGB8, 5, 3, 7, 3, 3 * 7 * (15 + 2 + 1)},
        {GN_TEXTURE_CUBE, GN_FORMAT_R16, 5, 5, 99, 2, 2 * 6 * (25 + 4)},
        {GN_TEXTURE_2D, GN_FORMAT_RGBA32F, 3, 2, 0, 0, 96},
        {GN_TEXTURE_2D, GN_FORMAT_RGBA8, 4, 4, 1, 3, 84},
        {GN_TEXTURE_2D, GN_FORMAT_R8, GN_MAX_SIZE, 1, 0, GN_MAX_LEVELS, 2 * GN_MAX_SIZE - 1},
        /* depth adds levels only to 3D textures */
        {GN_TEXTURE_3D, GN_FORMAT_R8, 8, 4, 16, 5, 8 * 4 * 16 + 4 * 2 * 8 + 2 * 4 + 2 + 1},
        {GN_TEXTURE_3D, GN_FORMAT_R8, 8, 4, 15, 5, 0},
        {GN_TEXTURE_2D_ARRAY, GN_FORMAT_R8, 8, 4, 16, 5, 0},
        {GN_TEXTURE_2D, GN_FORMAT_R8, GN_MAX_SIZE, 1, 0, GN_MAX_LEVELS + 1, 0},
        {GN_TEXTURE_2D, GN_FORMAT_RGBA8, 4, 4, 1, 4, 0},
        {GN_TEXTURE_2D, GN_FORMAT_S8, 4, 4, 0, 1, 0},
        {9, GN_FORMAT_R8, 4, 4, 0, 1, 0},
    };
    const gn_texture t = whole_texture();
    const char *const base = (const char *)image;

    for (size_t i = 0; i < COUNT(cases); ++i)
        assert_int_equal(gn_texture_memory_size((gn_texture_target)cases[i].target,
                                                (gn_format)cases[i].format, cases[i].width,
                                                cases[i].height, cases[i].depth, cases[i].levels),
                         cases[i].size);
    /* Only 64-bit machines have 2^46 bytes of addresses. */
    assert_true((gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_RGBA32F, GN_MAX_SIZE, GN_MAX_SIZE,
                                        GN_MAX_SIZE, 1) > 0) == (PTRDIFF_MAX > INT32_MAX));
    assert_true(t.target == GN_TEXTURE_3D && t.format == GN_FORMAT_RGBA16);
    assert_true(t.width == 8 && t.height == 4 && t.depth == 2 && t.level_count == 4);
    assert_true(t.level[0].row_stride == 64 && t.level[0].layer_stride == 256);
    assert_true(t.level[1].row_stride == 32 && t.level[1].layer_stride == 64);
    assert_ptr_equal(t.level[0].texels, base);
    assert_ptr_equal(t.level[1].texels, base + 512); /* 4x2x1 */
    assert_ptr_equal(t.level[2].texels, base + 576); /* 2x1x1 */
    assert_ptr_equal(t.level[3].texels, base + 592);
}

/* Texels are aligned to the format's element. */
static void packing_refuses(void **state)
{
    static const struct {
        int target, format;
        uint32_t width, levels;
        gn_status status;
    } cases[] = {{GN_TEXTURE_2D, GN_FORMAT_R8, 4, 4, GN_INVALID_SIZE},
                 {GN_TEXTURE_2D, GN_FORMAT_R8, 0, 1, GN_INVALID_SIZE},
                 {-1, GN_FORMAT_R8, 4, 1, GN_INVALID_ENUM},
                 {GN_TEXTURE_2D, GN_FORMAT_S8, 4, 1, GN_INVALID_FORMAT}};
    gn_texture t, before;

    memset(&before, 0x5A, sizeof before);
    t = before;
    for (size_t i = 0; i < COUNT(cases); ++i)
        assert_int_equal(gn_texture_packed((gn_texture_target)cases[i].target,
                                           (gn_format)cases[i].format, cases[i].width, 4, 0,
                                           cases[i].levels, image, &t),
                         cases[i].status);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R8, 1, 1, 0, 1, image, NULL),
                     GN_NULL_POINTER);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R8, 1, 1, 0, 1, NULL, &t),
                     GN_NULL_POINTER);
    for (size_t f = 0; f < 4 * COUNT(formats); ++f) {
        const struct format *const format = &formats[f / 4];
        const size_t offset = 1 + f % 4;

        t = before;
        if (format->format == GN_FORMAT_S8)
            continue;
        assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, format->format, 2, 2, 0, 1,
                                           (const char *)image + offset, &t),
                         offset % format->element ? GN_MISALIGNED : GN_OK);
        if (offset % format->element)
            assert_memory_equal(&t, &before, sizeof t);
    }
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
    gn_texture_fetch(t, coordinate, number[3], texel);
    for (int c = 0; c < 4; ++c)
        out[c] = texel[c][0];
}

/* The second of two texels; the values of its channels show their positions. Of 0x1823 the fields
 * are 00011 000001 00011, or 00011 00000 10001 1. */
static void formats_have_their_channels(void **state)
{
    static const struct {
        gn_format format;
        uint16_t texel[8];
        float expected[4];
    } cases[] = {
        {GN_FORMAT_RGBA8, {0x0201, 0x0403}, {1 / 255.0f, 2 / 255.0f, 3 / 255.0f, 4 / 255.0f}},
        {GN_FORMAT_BGRA8, {0x0201, 0x0403}, {3 / 255.0f, 2 / 255.0f, 1 / 255.0f, 4 / 255.0f}},
        {GN_FORMAT_SRGB8_A8, {0x0201, 0x0403}, {1 / 3213.0f, 2 / 3213.0f, 3 / 3213.0f, 4 / 255.0f}},
        {GN_FORMAT_R8, {1}, {1 / 255.0f, 0, 0, 1}},
        {GN_FORMAT_RG8, {0x0201}, {1 / 255.0f, 2 / 255.0f, 0, 1}},
        {GN_FORMAT_RGB8, {0x0201, 0xFF}, {1 / 255.0f, 2 / 255.0f, 1, 1}},
        {GN_FORMAT_RGB565, {0x1823}, {3 / 31.0f, 1 / 63.0f, 3 / 31.0f, 1}},
        {GN_FORMAT_RGB565_SWAPPED, {0x2318}, {3 / 31.0f, 1 / 63.0f, 3 / 31.0f, 1}},
        {GN_FORMAT_RGB5_A1, {0x1823}, {3 / 31.0f, 0, 17 / 31.0f, 1}},
        {GN_FORMAT_RGBA4, {0x1234}, {1 / 15.0f, 2 / 15.0f, 3 / 15.0f, 4 / 15.0f}},
        {GN_FORMAT_R16, {513}, {513 / 65535.0f, 0, 0, 1}},
        {GN_FORMAT_RGBA16, {1, 2, 3, 65535}, {1 / 65535.0f, 2 / 65535.0f, 3 / 65535.0f, 1}},
        {GN_FORMAT_RGBA16F, {0x3C00, 0xC000, 1, 0x7BFF}, {1, -2, 0x1p-24f, 65504}},
        {GN_FORMAT_RG16F, {0x3C00, 0xC000}, {1, -2, 0, 1}},
        {GN_FORMAT_RGB10_A2, {0x0801, 0x8030}, {1 / 1023.0f, 2 / 1023.0f, 3 / 1023.0f, 2 / 3.0f}},
        {GN_FORMAT_R11F_G11F_B10F, {0x03C0, 0x7020}, {1, 2, 0.5f, 1}},
        {GN_FORMAT_R32F, {0, 0x3F00}, {0.5f, 0, 0, 1}},
        {GN_FORMAT_RGB32F, {0, 0x3F00, 0, 0xC000, 0, 0x7000}, {0.5f, -2, 0x1p97f, 1}},
        {GN_FORMAT_RGBA32F,
         {0, 0x3F00, 0, 0xC000, 0, 0x7000, 0, 0x0F80},
         {0.5f, -2, 0x1p97f, 0x1p-96f}},
        {GN_FORMAT_D16, {513}, {513 / 65535.0f, 0, 0, 1}},
        {GN_FORMAT_D24, {0xFFFF, 0x00FF}, {1, 0, 0, 1}},
        {GN_FORMAT_D24S8, {0x0201, 0x0403}, {0x030201 / 16777215.0f, 0, 0, 1}},
        {GN_FORMAT_D32F, {0, 0x3F00}, {0.5f, 0, 0, 1}},
        {GN_FORMAT_D32FS8, {0, 0x3E80, 255}, {0.25f, 0, 0, 1}},
    };

    assert_int_equal(COUNT(cases) + 1, COUNT(formats)); /* all but S8 */
    for (size_t i = 0; i < COUNT(cases); ++i) {
        const int32_t second[4] = {1, 0, 0, 0};
        const gn_texture t = texture_of(GN_TEXTURE_1D, cases[i].format, 2, 1, 1, 1, image);
        float texel[4];

        memset(image, 0, sizeof image);
        memcpy((char *)image + gn_format_size(cases[i].format), cases[i].texel,
               gn_format_size(cases[i].format));
        fetch_one(&t, second, texel);
        for (int c = 0; c < 4; ++c)
            if (fabsf(texel[c] - cases[i].expected[c]) > 2e-7f * fabsf(cases[i].expected[c]))
                fail_msg("format %d, channel %d: %a", cases[i].format, c, (double)texel[c]);
    }
}

/* Texels are numbered from 1, level after level; outside there is 0. */
static void fetches_within_and_beyond(void **state)
{
    static const struct {
        gn_texture_target target;
        uint32_t width, height, depth, levels;
        int32_t place[4];
        float expected;
    } cases[] = {
        {GN_TEXTURE_1D, 7, 1, 1, 3, {6, 0, 0, 0}, 7},
        {GN_TEXTURE_1D, 7, 1, 1, 3, {2, 0, 0, 1}, 10},
        {GN_TEXTURE_1D, 7, 1, 1, 3, {3, 0, 0, 1}, 0},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {4, 2, 0, 0}, 15},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {0, 0, 0, 2}, 18},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {5, 0, 0, 0}, 0},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {0, 3, 0, 0}, 0},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {-1, 0, 0, 0}, 0},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {0, INT32_MIN, 0, 0}, 0},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {INT32_MAX, 0, 0, 0}, 0},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {0, 0, 0, 3}, 0},
        {GN_TEXTURE_2D, 5, 3, 1, 3, {0, 0, 0, -1}, 0},
        {GN_TEXTURE_2D_ARRAY, 5, 3, 4, 2, {1, 1, 3, 0}, 52},
        {GN_TEXTURE_2D_ARRAY, 5, 3, 4, 2, {1, 0, 3, 1}, 68},
        {GN_TEXTURE_2D_ARRAY, 5, 3, 4, 2, {0, 0, 4, 0}, 0},
        {GN_TEXTURE_3D, 5, 3, 7, 3, {0, 0, 6, 0}, 91},
        {GN_TEXTURE_3D, 5, 3, 7, 3, {1, 0, 2, 1}, 111},
        {GN_TEXTURE_3D, 5, 3, 7, 3, {0, 0, 3, 1}, 0},
        {GN_TEXTURE_3D, 5, 3, 7, 3, {0, 0, -1, 0}, 0},
        {GN_TEXTURE_CUBE, 4, 4, 6, 3, {3, 3, 5, 0}, 96},
        {GN_TEXTURE_CUBE, 4, 4, 6, 3, {1, 1, 5, 1}, 120},
        {GN_TEXTURE_CUBE, 4, 4, 6, 3, {0, 0, 6, 0}, 0},
    };
    static float texels[200];

    for (int i = 0; i < 200; ++i)
        texels[i] = (float)i + 1;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        const int32_t *const place = cases[i].place;
        gn_texture t = texture_of(cases[i].target, GN_FORMAT_R32F, cases[i].width, cases[i].height,
                                  cases[i].depth, cases[i].levels, texels);
        float texel[4];

        fetch_one(&t, place, texel);
        if (texel[0] != cases[i].expected)
            fail_msg("case %zu: %g", i, (double)texel[0]);
        assert_true(texel[1] == 0 && texel[2] == 0 && texel[3] == 1);
    }
    /* Rows and layers in the other direction; pointers that the target does not have are null. */
    const int32_t zeros[GN_LANES] = {0}, *const column[3] = {zeros, NULL, NULL};
    const gn_texture line = texture_of(GN_TEXTURE_1D, GN_FORMAT_R32F, 7, 1, 1, 1, texels);
    gn_texture t = texture_of(GN_TEXTURE_2D_ARRAY, GN_FORMAT_R32F, 5, 3, 4, 1, texels);
    float lanes[4][GN_LANES], texel[4];

    gn_texture_fetch(&line, column, NULL, lanes);
    assert_true(lanes[0][0] == 1 && lanes[0][GN_LANES - 1] == 1);
    t.level[0].texels = texels + 55; /* the lowest row of the last layer */
    t.level[0].row_stride = -20;
    t.level[0].layer_stride = -60;
    fetch_one(&t, (const int32_t[]){1, 2, 3, 0}, texel);
    assert_true(texel[0] == 2);
}

/* The last texels of the largest sizes, in memory of exactly that size. */
static void largest_sizes(void **state)
{
    static const struct {
        gn_texture_target target;
        uint32_t size[3];
    } shapes[] = {{GN_TEXTURE_1D, {GN_MAX_SIZE, 1, 1}},
                  {GN_TEXTURE_2D, {GN_MAX_SIZE, 2, 1}},
                  {GN_TEXTURE_2D, {2, GN_MAX_SIZE, 1}},
                  {GN_TEXTURE_3D, {2, 2, GN_MAX_SIZE}},
                  {GN_TEXTURE_2D_ARRAY, {1, 2, GN_MAX_SIZE}}};

    for (size_t i = 0; i < COUNT(formats) * COUNT(shapes); ++i) {
        const gn_format format = formats[i / COUNT(shapes)].format;
        const gn_texture_target target = shapes[i % COUNT(shapes)].target;
        const uint32_t *const n = shapes[i % COUNT(shapes)].size;
        const size_t bytes = gn_texture_memory_size(target, format, n[0], n[1], n[2], 1);
        const int32_t last[4] = {(int32_t)n[0] - 1, (int32_t)n[1] - 1, (int32_t)n[2] - 1, 0};
        const int32_t first[4] = {0, 0, 0, 0};
        float texel[4];

        if (format == GN_FORMAT_S8)
            continue;
        unsigned char *const memory = calloc(1, bytes);
        assert_non_null(memory);
        memset(memory + bytes - gn_format_size(format), 0x3F, gn_format_size(format));
        const gn_texture t = texture_of(target, format, n[0], n[1], n[2], 1, memory);
        fetch_one(&t, last, texel);
        assert_true(texel[0] > 0);
        fetch_one(&t, first, texel);
        assert_true(texel[0] == 0);
        free(memory);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults_of_the_shape),
        cmocka_unit_test(faults_of_levels),
        cmocka_unit_test(packed_levels_follow_each_other),
        cmocka_unit_test(packing_refuses),
        cmocka_unit_test(formats_have_their_channels),
        cmocka_unit_test(fetches_within_and_beyond),
        cmocka_unit_test(largest_sizes),
    };
    return cmocka_run_group_tests_name("textures", tests, NULL, NULL);
}
