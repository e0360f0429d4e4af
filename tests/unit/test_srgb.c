/* Clears of GN_FORMAT_SRGB8_A8 store the nearest byte of sRGB's transfer function (OpenGL 4.5
 * section 17.3.7), computed here in long double, on both sides of every step of the function and of
 * every entry of the library's table. */
#include <math.h>
#include <string.h>

#include "unit.h"

static float float_of(uint32_t bits)
{
    float f;

    memcpy(&f, &bits, sizeof f);
    return f;
}

static int byte_by_definition(float linear)
{
    const long double x = linear;
    const long double encoded =
        x < 0.0031308L ? 12.92L * x : 1.055L * powl(x, 1.0L / 2.4L) - 0.055L;

    return (int)floorl(encoded * 255.0L + 0.5L);
}

static void check(uint32_t bits)
{
    unsigned char pixel[4];
    const gn_surface surface = gn_surface_bottom_up(pixel, GN_FORMAT_SRGB8_A8, 1, 1);
    const float linear = float_of(bits);

    assert_int_equal(gn_clear_color(&surface, linear, linear, linear, 1.0f), GN_OK);
    for (int c = 0; c < 3; ++c)
        if (pixel[c] != byte_by_definition(linear))
            fail_msg("%a is stored as %d, not as %d", (double)linear, pixel[c],
                     byte_by_definition(linear));
}

/* The bits of positive floats order as the floats do. */
static void every_step(void **state)
{
    (void)state;
    for (int byte = 1; byte <= 255; ++byte) {
        uint32_t low = 0, high = 0x3F800000; /* below the step, and from the step on */

        while (high - low > 1) {
            const uint32_t middle = low + (high - low) / 2;

            if (byte_by_definition(float_of(middle)) >= byte)
                high = middle;
            else
                low = middle;
        }
        check(low);
        check(high);
    }
}

static void every_entry(void **state)
{
    (void)state;
    for (uint32_t upper = 0; upper < 0x3F80; ++upper) {
        check(upper << 16);
        check(upper << 16 | 0xFFFF);
    }
    check(0x3F800000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_step), cmocka_unit_test(every_entry)};

    return cmocka_run_group_tests_name("srgb", tests, NULL, NULL);
}
