/* Generated levels: cases worked by hand, where they are stored, and every fault.
 * tests/parity/texels compares them with the reference. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "unit.h"

static void place(const gn_texture *t, int level, int x, int y, int z, float *red)
{
    const gn_texture_level *const l = &t->level[level];

    *red = ((const float *)((const char *)l->texels + y * l->row_stride + z * l->layer_stride))[x];
}

static void expect_texel(const gn_texture *t, int level, int x, int y, int z, float expected)
{
    float red;

    place(t, level, x, y, z, &red);
    if (fabsf(red - expected) > 1e-5f)
        fail_msg("level %d (%d, %d, %d): %g instead of %g", level, x, y, z, (double)red,
                 (double)expected);
}

/* Even sizes: the mean of four texels. A level is made from the level before it. */
static void even_sizes(void **state)
{
    (void)state;
    static const float texels[8] = {1, 2, 10, 20, 3, 4, 30, 40};
    float memory[3];
    gn_texture t;

    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R32F, 4, 2, 0, 1, texels, &t);
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_OK);
    assert_int_equal(t.level_count, 3);
    assert_int_equal(gn_texture_check(&t), GN_OK);
    assert_ptr_equal(t.level[0].texels, texels);
    assert_ptr_equal(t.level[1].texels, memory);
    assert_ptr_equal(t.level[2].texels, memory + 2);
    expect_texel(&t, 1, 0, 0, 0, 2.5f);
    expect_texel(&t, 1, 1, 0, 0, 25.0f);
    expect_texel(&t, 2, 0, 0, 0, 13.75f);
}

/* Odd sizes: mixed at the new texel's centre. So of three texels the middle one is taken; of five
 * texels the two centres lie 3/4 past the first and 1/4 past the fourth. */
static void odd_sizes(void **state)
{
    (void)state;
    static const float three[3] = {1, 50, 9}, five[5] = {0, 8, 100, 16, 32};
    float memory[3];
    gn_texture t;

    gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_R32F, 3, 1, 0, 1, three, &t);
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof *memory), GN_OK);
    expect_texel(&t, 1, 0, 0, 0, 50.0f);
    gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_R32F, 5, 1, 0, 1, five, &t);
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_OK);
    expect_texel(&t, 1, 0, 0, 0, 6.0f);
    expect_texel(&t, 1, 1, 0, 0, 20.0f);
    expect_texel(&t, 2, 0, 0, 0, 13.0f);
}

/* Layers of arrays and faces of cubes are not mixed, slices of 3D textures are. */
static void layers(void **state)
{
    (void)state;
    static float texels[4 * 6];
    float memory[6];
    gn_texture t;

    for (int i = 0; i < 24; ++i)
        texels[i] = (float)(i / 4 * 10 + i % 4);
    gn_texture_packed(GN_TEXTURE_CUBE, GN_FORMAT_R32F, 2, 2, 0, 1, texels, &t);
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_OK);
    for (int n = 0; n < 6; ++n)
        expect_texel(&t, 1, 0, 0, n, 1.5f + (float)(10 * n));
    gn_texture_packed(GN_TEXTURE_2D_ARRAY, GN_FORMAT_R32F, 2, 2, 6, 1, texels, &t);
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_OK);
    assert_int_equal(t.level_count, 2);
    for (int n = 0; n < 6; ++n)
        expect_texel(&t, 1, 0, 0, n, 1.5f + (float)(10 * n));
    gn_texture_packed(GN_TEXTURE_3D, GN_FORMAT_R32F, 2, 2, 6, 1, texels, &t);
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_OK);
    assert_int_equal(t.level_count, 3);
    for (int n = 0; n < 3; ++n)
        expect_texel(&t, 1, 0, 0, n, 6.5f + (float)(20 * n));
    expect_texel(&t, 2, 0, 0, 0, 26.5f);
}

/* In two dimensions one row is mixed with itself, in one dimension it is not: infinity minus
 * infinity is NaN. */
static void infinities(void **state)
{
    (void)state;
    static const float texels[2] = {1, INFINITY};
    float memory;
    gn_texture t;

    gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_R32F, 2, 1, 0, 1, texels, &t);
    assert_int_equal(gn_texture_generate_levels(&t, &memory, sizeof memory), GN_OK);
    assert_true(memory == INFINITY);
    t.target = GN_TEXTURE_2D;
    t.level_count = 1;
    assert_int_equal(gn_texture_generate_levels(&t, &memory, sizeof memory), GN_OK);
    assert_true(isnan(memory));
}

/* Bytes are rounded to nearest. Red, green and blue of sRGB are mixed as linear colours: half of
 * white's light is 188. */
static void conversions(void **state)
{
    (void)state;
    static const uint32_t texels[2] = {0x00000000u, 0xFFFFFFFFu};
    uint32_t memory;
    gn_texture t;

    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 2, 1, 0, 1, texels, &t);
    assert_int_equal(gn_texture_generate_levels(&t, &memory, sizeof memory), GN_OK);
    assert_int_equal(memory, 0x80808080u);
    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_SRGB8_A8, 2, 1, 0, 1, texels, &t);
    assert_int_equal(gn_texture_generate_levels(&t, &memory, sizeof memory), GN_OK);
    assert_int_equal(memory, 0x80BCBCBCu);
}

/* An image stored from the top down, with gaps between rows and layers, has equal levels. */
static void strides(void **state)
{
    (void)state;
    static float texels[5 * 3 * 2], apart[2][7][11];
    float expected[8], memory[8];
    gn_texture t;

    for (int i = 0; i < 30; ++i) {
        texels[i] = (float)(i * i % 17);
        apart[1 - i / 15][2 * (2 - i / 5 % 3)][i % 5] = texels[i];
    }
    gn_texture_packed(GN_TEXTURE_2D_ARRAY, GN_FORMAT_R32F, 5, 3, 2, 1, texels, &t);
    assert_int_equal(gn_texture_generate_levels(&t, expected, sizeof expected), GN_OK);
    t.level_count = 1;
    t.level[0].texels = apart[1][4];
    t.level[0].row_stride = -2 * (ptrdiff_t)sizeof apart[0][0];
    t.level[0].layer_stride = -(ptrdiff_t)sizeof apart[0];
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_OK);
    assert_memory_equal(memory, expected, sizeof(float) * 2 * (2 + 1));
}

/* The largest sizes, in memory of exactly that size: one value stays as it is. */
static void largest_sizes(void **state)
{
    (void)state;
    static const uint32_t sizes[][3] = {{GN_MAX_SIZE, 1, 1},     {1, GN_MAX_SIZE, 1},
                                        {1, 1, GN_MAX_SIZE},     {GN_MAX_SIZE - 1, 3, 2},
                                        {5, GN_MAX_SIZE - 1, 1}, {3, 2, 10000}};

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        const uint32_t *const n = sizes[i];
        const size_t first =
            gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_RGB8, n[0], n[1], n[2], 1);
        unsigned char *const texels = malloc(first);
        gn_texture t;

        assert_non_null(texels);
        memset(texels, 77, first);
        gn_texture_packed(GN_TEXTURE_3D, GN_FORMAT_RGB8, n[0], n[1], n[2], 1, texels, &t);

        const uint32_t levels = n[0] >= GN_MAX_SIZE || n[1] >= GN_MAX_SIZE || n[2] >= GN_MAX_SIZE
                                    ? GN_MAX_LEVELS
                                    : GN_MAX_LEVELS - 1;
        const size_t rest =
            gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_RGB8, n[0], n[1], n[2], levels) - first;
        unsigned char *const memory = malloc(rest);
        assert_non_null(memory);
        assert_int_equal(gn_texture_generate_levels(&t, memory, rest - 1), GN_WORKSPACE_TOO_SMALL);
        assert_int_equal(gn_texture_generate_levels(&t, memory, rest), GN_OK);
        assert_int_equal(t.level_count, levels);
        assert_int_equal(gn_texture_check(&t), GN_OK);
        for (size_t b = 0; b < rest; ++b)
            assert_true(memory[b] == 77);
        free(memory);
        free(texels);
    }
}

static void faults(void **state)
{
    (void)state;
    static float texels[16 + 8];
    float memory[5] = {7, 7, 7, 7, 7};
    float untouched[5];
    gn_texture t, before;

    memcpy(untouched, memory, sizeof memory);
    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R32F, 4, 4, 0, 1, texels, &t);
    memcpy(&before, &t, sizeof t);
    assert_int_equal(gn_texture_generate_levels(NULL, memory, sizeof memory), GN_NULL_POINTER);
    assert_int_equal(gn_texture_generate_levels(&t, NULL, sizeof memory), GN_NULL_POINTER);
    assert_int_equal(gn_texture_generate_levels(&t, (char *)memory + 1, 20), GN_MISALIGNED);
    assert_int_equal(gn_texture_generate_levels(&t, memory, 19), GN_WORKSPACE_TOO_SMALL);
    assert_int_equal(gn_texture_generate_levels(&t, texels + 15, 20), GN_OVERLAP);
    assert_int_equal(gn_texture_generate_levels(&t, texels, 20), GN_OVERLAP);
    assert_memory_equal(&t, &before, sizeof t);
    t.format = GN_FORMAT_D32F;
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_INVALID_FORMAT);
    t.format = GN_FORMAT_R32F;
    t.width = 0;
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_INVALID_SIZE);
    t.width = 4;
    t.level[0].row_stride = 12;
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_INVALID_STRIDE);
    assert_memory_equal(memory, untouched, sizeof memory);

    /* Adjacent memory does not overlap, also with rows upside down. */
    memcpy(&t, &before, sizeof t);
    assert_int_equal(gn_texture_generate_levels(&t, texels + 16, 20), GN_OK);
    t.level_count = 1;
    t.level[0].texels = texels + 8 + 12;
    t.level[0].row_stride = -16;
    assert_int_equal(gn_texture_generate_levels(&t, texels + 4, 20), GN_OVERLAP);
    assert_int_equal(gn_texture_generate_levels(&t, texels, 20), GN_OK);
}

/* A single texel has no more levels and needs no memory. */
static void one_texel(void **state)
{
    (void)state;
    static const uint8_t texel = 9;
    gn_texture t;

    gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_R8, 1, 1, 0, 0, &texel, &t);
    t.level_count = 0;
    assert_int_equal(gn_texture_generate_levels(&t, NULL, 0), GN_OK);
    assert_int_equal(t.level_count, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(even_sizes),    cmocka_unit_test(odd_sizes),   cmocka_unit_test(layers),
        cmocka_unit_test(infinities),    cmocka_unit_test(conversions), cmocka_unit_test(strides),
        cmocka_unit_test(largest_sizes), cmocka_unit_test(faults),      cmocka_unit_test(one_texel),
    };
    return cmocka_run_group_tests_name("levels", tests, NULL, NULL);
}
