/* Generated levels: cases worked by hand, where they are stored, and every fault.
 * tests/parity/texels compares them with the reference. */
#include <math.h>
#include <stdlib.h>

#include "lookups.h"

/* Even sizes: the mean of four texels; a level is made from the level before it. Odd sizes: mixed
 * at the new texel's centre, so of three texels the middle one is taken; of five texels the two
 * centres lie 3/4 past the first and 1/4 past the fourth. Layers of arrays and faces of cubes are
 * not mixed, slices of 3D textures are. In two dimensions one row is mixed with itself, in one
 * dimension it is not: infinity minus infinity is NaN. */
static void levels_by_hand(void **state)
{
    static const struct {
        gn_texture_target target;
        uint32_t width, height, depth, levels;
        float texels[24], expected[7];
    } cases[] = {
        {GN_TEXTURE_2D, 4, 2, 1, 3, {1, 2, 10, 20, 3, 4, 30, 40}, {2.5f, 25, 13.75f}},
        {GN_TEXTURE_1D, 3, 1, 1, 2, {1, 50, 9}, {50}},
        {GN_TEXTURE_1D, 5, 1, 1, 3, {0, 8, 100, 16, 32}, {6, 20, 13}},
        {GN_TEXTURE_CUBE,
         2,
         2,
         6,
         2,
         {0,  1,  2,  3,  10, 11, 12, 13, 20, 21, 22, 23,
          30, 31, 32, 33, 40, 41, 42, 43, 50, 51, 52, 53},
         {1.5f, 11.5f, 21.5f, 31.5f, 41.5f, 51.5f}},
        {GN_TEXTURE_2D_ARRAY, 2, 2, 2, 2, {0, 1, 2, 3, 10, 11, 12, 13}, {1.5f, 11.5f}},
        {GN_TEXTURE_3D,
         2,
         2,
         6,
         3,
         {0,  1,  2,  3,  10, 11, 12, 13, 20, 21, 22, 23,
          30, 31, 32, 33, 40, 41, 42, 43, 50, 51, 52, 53},
         {6.5f, 26.5f, 46.5f, 26.5f}},
        {GN_TEXTURE_1D, 2, 1, 1, 2, {1, INFINITY}, {INFINITY}},
        {GN_TEXTURE_2D, 2, 1, 1, 2, {1, INFINITY}, {NAN}},
        {GN_TEXTURE_2D, 1, 1, 1, 1, {9}, {0}},
    };

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const float *const texels = cases[i].texels;
        gn_texture t = texture_of(cases[i].target, GN_FORMAT_R32F, cases[i].width, cases[i].height,
                                  cases[i].depth, i % 2, texels);
        const size_t size =
            gn_texture_memory_size(t.target, t.format, t.width, t.height, t.depth,
                                   cases[i].levels) -
            gn_texture_memory_size(t.target, t.format, t.width, t.height, t.depth, 1);
        float memory[7];

        /* a single texel needs no memory */
        assert_int_equal(gn_texture_generate_levels(&t, size ? memory : NULL, size), GN_OK);
        assert_int_equal(t.level_count, cases[i].levels);
        assert_int_equal(gn_texture_check(&t), GN_OK);
        assert_ptr_equal(t.level[0].texels, texels);
        if (size)
            assert_ptr_equal(t.level[1].texels, memory);
        for (size_t n = 0; n < size / sizeof *memory; ++n)
            if (!(fabsf(memory[n] - cases[i].expected[n]) < 1e-5f) &&
                memory[n] != cases[i].expected[n] && !isnan(cases[i].expected[n] + memory[n]))
                fail_msg("case %zu, texel %zu: %g", i, n, (double)memory[n]);
    }
}

/* Bytes are rounded to nearest. Red, green and blue of sRGB are mixed as linear colours: half of
 * white's light is 188. */
static void conversions(void **state)
{
    static const uint32_t texels[2] = {0x00000000, 0xFFFFFFFF};
    gn_texture t = texture_of(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 2, 1, 1, 1, texels);
    uint32_t memory;

    assert_int_equal(gn_texture_generate_levels(&t, &memory, sizeof memory), GN_OK);
    assert_int_equal(memory, 0x80808080);
    t = texture_of(GN_TEXTURE_2D, GN_FORMAT_SRGB8_A8, 2, 1, 1, 1, texels);
    assert_int_equal(gn_texture_generate_levels(&t, &memory, sizeof memory), GN_OK);
    assert_int_equal(memory, 0x80BCBCBC);
}

/* An image stored from the top down, with gaps between rows and layers, has equal levels. */
static void strides(void **state)
{
    static float texels[5 * 3 * 2], apart[2][7][11];
    float expected[8], memory[8];

    for (int i = 0; i < 30; ++i) {
        texels[i] = (float)(i * i % 17);
        apart[1 - i / 15][2 * (2 - i / 5 % 3)][i % 5] = texels[i];
    }
    gn_texture t = texture_of(GN_TEXTURE_2D_ARRAY, GN_FORMAT_R32F, 5, 3, 2, 1, texels);
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
    static const struct {
        uint32_t size[3], levels;
    } cases[] = {
        {{GN_MAX_SIZE, 1, 1}, GN_MAX_LEVELS},         {{1, GN_MAX_SIZE, 1}, GN_MAX_LEVELS},
        {{1, 1, GN_MAX_SIZE}, GN_MAX_LEVELS},         {{GN_MAX_SIZE - 1, 3, 2}, GN_MAX_LEVELS - 1},
        {{5, GN_MAX_SIZE - 1, 1}, GN_MAX_LEVELS - 1}, {{3, 2, 10000}, GN_MAX_LEVELS - 1}};

    for (size_t i = 0; i < COUNT(cases); ++i) {
        const uint32_t *const n = cases[i].size, levels = cases[i].levels;
        const size_t first =
            gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_RGB8, n[0], n[1], n[2], 1);
        const size_t rest =
            gn_texture_memory_size(GN_TEXTURE_3D, GN_FORMAT_RGB8, n[0], n[1], n[2], levels) - first;
        unsigned char *const texels = malloc(first), *const memory = malloc(rest);

        assert_true(texels && memory);
        memset(texels, 77, first);
        gn_texture t = texture_of(GN_TEXTURE_3D, GN_FORMAT_RGB8, n[0], n[1], n[2], 1, texels);
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
    static float texels[16 + 8];
    float memory[5] = {7, 7, 7, 7, 7};
    const gn_texture good = texture_of(GN_TEXTURE_2D, GN_FORMAT_R32F, 4, 4, 1, 1, texels);
    gn_texture t = good;

    assert_int_equal(gn_texture_generate_levels(NULL, memory, sizeof memory), GN_NULL_POINTER);
    assert_int_equal(gn_texture_generate_levels(&t, NULL, sizeof memory), GN_NULL_POINTER);
    assert_int_equal(gn_texture_generate_levels(&t, (char *)memory + 1, 20), GN_MISALIGNED);
    assert_int_equal(gn_texture_generate_levels(&t, memory, 19), GN_WORKSPACE_TOO_SMALL);
    assert_int_equal(gn_texture_generate_levels(&t, texels + 15, 20), GN_OVERLAP);
    assert_int_equal(gn_texture_generate_levels(&t, texels, 20), GN_OVERLAP);
    assert_memory_equal(&t, &good, sizeof t);
    t.format = GN_FORMAT_D32F;
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_INVALID_FORMAT);
    t = good;
    t.width = 0;
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_INVALID_SIZE);
    t = good;
    t.level[0].row_stride = 12;
    assert_int_equal(gn_texture_generate_levels(&t, memory, sizeof memory), GN_INVALID_STRIDE);
    for (int i = 0; i < 5; ++i)
        assert_true(memory[i] == 7);

    /* Adjacent memory does not overlap, also with rows upside down. */
    t = good;
    assert_int_equal(gn_texture_generate_levels(&t, texels + 16, 20), GN_OK);
    t.level_count = 1;
    t.level[0].texels = texels + 8 + 12;
    t.level[0].row_stride = -16;
    assert_int_equal(gn_texture_generate_levels(&t, texels + 4, 20), GN_OVERLAP);
    assert_int_equal(gn_texture_generate_levels(&t, texels, 20), GN_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels_by_hand), cmocka_unit_test(conversions), cmocka_unit_test(strides),
        cmocka_unit_test(largest_sizes),  cmocka_unit_test(faults),
    };
    return cmocka_run_group_tests_name("generated levels", tests, NULL, NULL);
}
