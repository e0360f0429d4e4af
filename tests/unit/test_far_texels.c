/* Textures at the ends of the integers: coordinates of repeated ones, which need no more than a
 * GN_BASIC library has, over any number of lanes; rows that run backwards, and rows that no 32-bit
 * index reaches. Expected colours are worked by hand. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "unit.h"

enum { SIDE = 4 };

/* Texel (x, y) is (10 x, 60 y, 0, 255). */
static gn_texture write_rows(unsigned char *first, ptrdiff_t stride, uint32_t height)
{
    gn_texture t = {.format = GN_FORMAT_RGBA8, .width = SIDE, .height = height};

    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < SIDE; ++x) {
            const unsigned char texel[4] = {(unsigned char)(10 * x), (unsigned char)(60 * y), 0,
                                            255};

            memcpy(first + (ptrdiff_t)y * stride + 4 * x, texel, sizeof texel);
        }
    t.level[0].texels = first;
    t.level[0].row_stride = stride;
    assert_int_equal(gn_texture_check(&t), GN_OK);
    return t;
}

/* Samples in every lane, and expects red and green as bytes. */
static void expect(const gn_texture *texture, gn_wrap wrap, bool is_linear, float s, float t,
                   float red, float green)
{
    const gn_sampler sampler = {.wrap_s = wrap,
                                .wrap_t = wrap,
                                .magnify = is_linear ? GN_MAGNIFY_LINEAR : GN_MAGNIFY_NEAREST,
                                .minify = is_linear ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST};
    float along_s[GN_LANES], along_t[GN_LANES], texel[4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l) {
        along_s[l] = s;
        along_t[l] = t;
    }
    gn_texture_lookup_2d(texture, &sampler, along_s, along_t, texel);
    for (int l = 0; l < GN_LANES; ++l)
        if (!(fabsf(255.0f * texel[0][l] - red) < 1e-3f) ||
            !(fabsf(255.0f * texel[1][l] - green) < 1e-3f) || texel[2][l] != 0.0f ||
            texel[3][l] != 1.0f)
            fail_msg("(%a, %a), lane %d: %g %g, not %g %g", (double)s, (double)t, l,
                     255.0 * (double)texel[0][l], 255.0 * (double)texel[1][l], (double)red,
                     (double)green);
}

/* Floats of 2^24 or more, with either sign, are whole numbers: the place of 0, in texel 0. */
static void texels_of_coordinates(void **state)
{
    static const float near[] = {0.3f, 0.75f, -0.25f, -0.3f,     -1e-45f,
                                 7.6f, -7.6f, -0.0f,  0x1.5p20f, -0x1p20f + 0.5f};
    static const int texels[] = {1, 3, 3, 2, 3, 2, 1, 0, 0, 2};
    static const float far[] = {0,    0x1.fffffep28f, 0x1p29f,        0x1.000002p29f,
                                3e9f, 1e30f,          0x1.fffffep127f};
    enum { NEAR = 10, ALL = NEAR + 2 * 7 };
    static uint32_t image[SIDE * SIDE];
    const gn_texture texture = write_rows((unsigned char *)image, 4 * SIDE, SIDE);
    float coordinate[ALL], texel[ALL];

    for (int i = 0; i < ALL; ++i) {
        const int n = (i - NEAR) / 2;

        coordinate[i] = i < NEAR ? near[i] : i % 2 ? far[n] : -far[n];
        texel[i] = i < NEAR ? (float)texels[i] : 0.0f;
    }
    for (int i = 0; i < ALL; ++i)
        for (int k = 0; k < ALL; ++k)
            expect(&texture, GN_WRAP_REPEAT, false, coordinate[i], coordinate[k], 10.0f * texel[i],
                   60.0f * texel[k]);
}

#if !defined(GN_BASIC)
/* Two rows. Texel (x, y) has its centre half a texel further. */
static void expect_texels(unsigned char *first, ptrdiff_t stride)
{
    static const gn_wrap wraps[] = {GN_WRAP_REPEAT, GN_WRAP_CLAMP_TO_EDGE, GN_WRAP_MIRRORED_REPEAT};
    const gn_texture texture = write_rows(first, stride, 2);

    for (int i = 0; i < 3; ++i) {
        expect(&texture, wraps[i], false, 2.75f / SIDE, 1.25f / 2, 20.0f, 60.0f);
        expect(&texture, wraps[i], false, 3.25f / SIDE, 0.75f / 2, 30.0f, 0.0f);
        expect(&texture, wraps[i], true, 1.5f / SIDE, 1.5f / 2, 10.0f, 60.0f);
        expect(&texture, wraps[i], true, 1.75f / SIDE, 0.75f / 2, 12.5f, 15.0f);
        expect(&texture, wraps[i], true, 3.0f / SIDE, 1.0f / 2, 25.0f, 30.0f);
    }
}

/* The limit of rows that are words a short way apart is 128 KiB. */
static void rows_run_backwards(void **state)
{
    enum { LIMIT = 1 << 17 };
    static const ptrdiff_t strides[] = {-4 * SIDE, 4 - LIMIT, -LIMIT, -4 - LIMIT, -3 * LIMIT};
    static uint32_t memory[3 * LIMIT / 4 + SIDE];

    for (size_t i = 0; i < sizeof strides / sizeof *strides; ++i) {
        memset(memory, 0xEE, sizeof memory);
        expect_texels((unsigned char *)memory - strides[i], strides[i]);
    }
}
#endif

#if !defined(GN_BASIC) && PTRDIFF_MAX > INT32_MAX
/* Returns zeroed memory of a sparse file, because 32-bit indices reach 8 GiB of words. Skips the
 * test without such a file. */
static unsigned char *sparse_memory(size_t bytes)
{
    FILE *const file = tmpfile();

    if (!file || ftruncate(fileno(file), (off_t)bytes) != 0)
        skip();
    unsigned char *const memory =
        mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(file), 0);
    fclose(file);
    if (memory == MAP_FAILED)
        skip();
    return memory;
}

static void rows_beyond_32_bit_indices(void **state)
{
    const ptrdiff_t stride = (ptrdiff_t)1 << 33;
    const size_t bytes = (size_t)stride + 4096;
    unsigned char *const memory = sparse_memory(bytes);

    expect_texels(memory, stride);
    expect_texels(memory + stride, -stride);
    munmap(memory, bytes);
}

/* Fetches texel (i % 3, i / 3 % 2) of layer i / 6 in every lane. */
static void fetch(const gn_texture *t, int32_t i, float texel[4][GN_LANES])
{
    int32_t number[4][GN_LANES];
    const int32_t *const coordinate[3] = {number[0], number[1], number[2]};

    for (int l = 0; l < GN_LANES; ++l) {
        number[0][l] = i % 3;
        number[1][l] = i / 3 % 2;
        number[2][l] = i / 6;
        number[3][l] = 0;
    }
    gn_texture_fetch(t, coordinate, number[3], texel);
}

/* Two rows of three texels in each of two layers, near together and far apart. */
static void texels_of_every_size_are_fetched(void **state)
{
    static const gn_format formats[] = {GN_FORMAT_RGBA8, GN_FORMAT_RGBA32F, GN_FORMAT_D32FS8,
                                        GN_FORMAT_RGBA16, GN_FORMAT_R8};
    static uint32_t image[12 * 4];
    const ptrdiff_t row = (ptrdiff_t)1 << 32, layer = (ptrdiff_t)5 << 31;
    const size_t bytes = (size_t)(row + layer) + 4096;
    unsigned char *const memory = sparse_memory(bytes);

    for (size_t f = 0; f < sizeof formats / sizeof *formats; ++f) {
        const size_t size = gn_format_size(formats[f]);
        gn_texture near, far;

        assert_int_equal(
            gn_texture_packed(GN_TEXTURE_2D_ARRAY, formats[f], 3, 2, 2, 1, image, &near), GN_OK);
        for (size_t i = 0; i < 12 * size; ++i)
            ((unsigned char *)image)[i] = (unsigned char)(i * 29 % 63);
        far = near;
        far.level[0].texels = memory;
        far.level[0].row_stride = row;
        far.level[0].layer_stride = layer;
        for (int n = 0; n < 4; ++n)
            memcpy(memory + n % 2 * row + n / 2 * layer, (const char *)image + (size_t)n * 3 * size,
                   3 * size);
        assert_int_equal(gn_texture_check(&far), GN_OK);
        for (int32_t i = 0; i < 12; ++i) {
            float a[4][GN_LANES], b[4][GN_LANES];

            fetch(&near, i, a);
            fetch(&far, i, b);
            assert_memory_equal(a, b, sizeof a);
        }
    }
    munmap(memory, bytes);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texels_of_coordinates),
#if !defined(GN_BASIC)
        cmocka_unit_test(rows_run_backwards),
#if PTRDIFF_MAX > INT32_MAX
        cmocka_unit_test(rows_beyond_32_bit_indices),
        cmocka_unit_test(texels_of_every_size_are_fetched),
#endif
#endif
    };
    return cmocka_run_group_tests_name("far texels", tests, NULL, NULL);
}
