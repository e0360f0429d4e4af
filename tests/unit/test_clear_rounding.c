/* Clears of formats without 8 bits a channel round to nearest, halves to even (gnomon/surface.h).
 */
#include <string.h>

#include "unit.h"

enum { SIDE = 2 };

static uint32_t memory[SIDE * SIDE];

/* Halves of RGB10_A2's alpha, which has two bits, and of R16's last step. */
static void clears_round_halves_to_even(void **state)
{
    static const struct {
        float alpha;
        uint32_t stored;
    } halves[] = {{0.5f / 3, 0}, {1.5f / 3, 2}, {2.5f / 3, 2}};
    const gn_surface packed = gn_surface_bottom_up(memory, GN_FORMAT_RGB10_A2, SIDE, SIDE);
    const gn_surface wide = gn_surface_bottom_up(memory, GN_FORMAT_R16, SIDE, SIDE);

    (void)state;
    for (size_t i = 0; i < sizeof halves / sizeof *halves; ++i) {
        assert_int_equal(gn_clear_color(&packed, 0, 0, 0, halves[i].alpha), GN_OK);
        assert_int_equal(memory[3] >> 30, halves[i].stored);
    }
    for (uint32_t step = 0; step < 8; ++step) {
        const float half = ((float)step + 0.5f) / 65535;
        uint16_t last;

        assert_float_equal(half * 65535, (float)step + 0.5f, 0);
        assert_int_equal(gn_clear_color(&wide, half, 0, 0, 0), GN_OK);
        memcpy(&last, (const char *)memory + 3 * sizeof last, sizeof last);
        assert_int_equal(last, (step + 1) / 2 * 2);
    }
}

/* Red has six bits after the point, blue five, so ties of blue are red's odd steps. */
static void unsigned_floats_round_to_nearest(void **state)
{
    static const struct {
        uint32_t single, red, blue;
    } values[] = {
        {0x3F801FFFu, 0x3C0, 0x1E0}, {0x3F81FFFFu, 0x3C1, 0x1E0}, {0x3F820000u, 0x3C1, 0x1E0},
        {0x3F810000u, 0x3C0, 0x1E0}, {0x3F830000u, 0x3C2, 0x1E1}, {0x3F860000u, 0x3C3, 0x1E2},
        {0x38800000u, 0x040, 0x020}, {0x387FFFFFu, 0x040, 0x020}, {0x35800000u, 0x001, 0x000},
        {0x357FFFFFu, 0x001, 0x000}, {0x35C00000u, 0x002, 0x001}, {0x35000000u, 0x000, 0x000},
        {0x00000001u, 0x000, 0x000}, {0x477E0000u, 0x7BF, 0x3DF}, {0x477FFFFFu, 0x7BF, 0x3DF},
        {0x7F7FFFFFu, 0x7BF, 0x3DF}, {0x7F800000u, 0x7C0, 0x3E0}, {0xFF800000u, 0x000, 0x000},
        {0xBF800000u, 0x000, 0x000}, {0x7FC00000u, 0x7E0, 0x3F0}, {0xFFC00001u, 0x7E0, 0x3F0}};
    const gn_surface s = gn_surface_bottom_up(memory, GN_FORMAT_R11F_G11F_B10F, SIDE, SIDE);

    (void)state;
    for (size_t i = 0; i < sizeof values / sizeof *values; ++i) {
        float c;

        memcpy(&c, &values[i].single, sizeof c);
        assert_int_equal(gn_clear_color(&s, c, c, c, c), GN_OK);
        assert_int_equal(memory[3], values[i].red | values[i].red << 11 | values[i].blue << 22);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clears_round_halves_to_even),
        cmocka_unit_test(unsigned_floats_round_to_nearest),
    };
    return cmocka_run_group_tests_name("rounding of clears", tests, NULL, NULL);
}
