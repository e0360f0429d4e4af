/* Textures whose rows lie so far apart that a word's index is no small number: rows that run
 * backwards, and rows that no 32-bit index reaches. Expected colours are worked by hand. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "unit.h"

enum { WIDTH = 4, HEIGHT = 2 };

/* Writes rows of which texel (x, y) is (10 x, 100 y, 0, 255). */
static void write_rows(unsigned char *first, ptrdiff_t stride)
{
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) {
            const unsigned char texel[4] = {(unsigned char)(10 * x), (unsigned char)(100 * y), 0,
                                            255};

            memcpy(first + y * stride + 4 * x, texel, sizeof texel);
        }
}

static gn_texture texture_of(const unsigned char *first, ptrdiff_t stride)
{
    gn_texture t = {0};

    t.level[0].texels = first;
    t.level[0].row_stride = stride;
    t.width = WIDTH;
    t.height = HEIGHT;
    t.format = GN_FORMAT_RGBA8;
    assert_int_equal(gn_texture_check(&t), GN_OK);
    return t;
}

/* Reads (x, y), in texels from the lower left corner, in every lane. */
static void expect(const gn_texture *texture, const gn_sampler *sampler, float x, float y,
                   float red, float green)
{
    float s[GN_LANES], t[GN_LANES], texel[4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l) {
        s[l] = x / WIDTH;
        t[l] = y / HEIGHT;
    }
    gn_sample_2d(texture, sampler, s, t, texel);
    for (int l = 0; l < GN_LANES; ++l) {
        assert_true(fabsf(255.0f * texel[0][l] - red) < 1e-3f);
        assert_true(fabsf(255.0f * texel[1][l] - green) < 1e-3f);
        assert_true(texel[2][l] == 0.0f && texel[3][l] == 1.0f);
    }
}

/* Texel (x, y) has its centre half a texel further. */
static void expect_texels(const gn_texture *texture)
{
    static const gn_wrap wraps[] = {GN_WRAP_REPEAT, GN_WRAP_CLAMP_TO_EDGE, GN_WRAP_MIRRORED_REPEAT};

    for (int i = 0; i < 3; ++i) {
        gn_sampler sampler = {0};

        sampler.wrap_s = sampler.wrap_t = wraps[i];
        sampler.magnify = GN_MAGNIFY_NEAREST;
        sampler.minify = GN_MINIFY_NEAREST;
        expect(texture, &sampler, 2.75f, 1.25f, 20.0f, 100.0f);
        expect(texture, &sampler, 3.25f, 0.75f, 30.0f, 0.0f);
        sampler.magnify = GN_MAGNIFY_LINEAR;
        sampler.minify = GN_MINIFY_LINEAR;
        expect(texture, &sampler, 1.5f, 1.5f, 10.0f, 100.0f);
        expect(texture, &sampler, 1.75f, 0.75f, 12.5f, 25.0f);
        expect(texture, &sampler, 3.0f, 1.0f, 25.0f, 50.0f);
    }
}

/* The limit of rows that are words a short way apart is 128 KiB. */
static void rows_run_backwards(void **state)
{
    (void)state;
    enum { LIMIT = 1 << 17 };
    static const ptrdiff_t strides[] = {-4 * WIDTH, 4 - LIMIT, -LIMIT, -4 - LIMIT, -3 * LIMIT};
    static uint32_t memory[3 * LIMIT / 4 + WIDTH];

    for (size_t i = 0; i < sizeof strides / sizeof *strides; ++i) {
        unsigned char *const first = (unsigned char *)memory - strides[i];

        memset(memory, 0xEE, sizeof memory);
        write_rows(first, strides[i]);
        const gn_texture texture = texture_of(first, strides[i]);
        expect_texels(&texture);
    }
}

#if PTRDIFF_MAX > INT32_MAX
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
    (void)state;
    const ptrdiff_t stride = (ptrdiff_t)1 << 33;
    const size_t bytes = (size_t)stride + 4096;
    unsigned char *const memory = sparse_memory(bytes);

    write_rows(memory, stride);
    const gn_texture upwards = texture_of(memory, stride);
    expect_texels(&upwards);
    write_rows(memory + stride, -stride);
    const gn_texture downwards = texture_of(memory + stride, -stride);
    expect_texels(&downwards);
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
    gn_fetch(t, coordinate, number[3], texel);
}

/* Two rows of three texels in each of two layers, near together and far apart. */
static void texels_of_every_size_are_fetched(void **state)
{
    (void)state;
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
        cmocka_unit_test(rows_run_backwards),
#if PTRDIFF_MAX > INT32_MAX
        cmocka_unit_test(rows_beyond_32_bit_indices),
        cmocka_unit_test(texels_of_every_size_are_fetched),
#endif
    };
    return cmocka_run_group_tests_name("far rows", tests, NULL, NULL);
}
