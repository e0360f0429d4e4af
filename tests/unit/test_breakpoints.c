/* Scalar functions are made of pieces. Around every multiple of 1/16 up to 4 and every power of
 * two, where pieces may end, the form in doubles and the form in integers return the same bits. */
#include <math.h>
#include <string.h>

#include "unit.h"

#include "../../src/scalars/integer_forms.h"

typedef float function(float x);

static function *const forms[][2] = {
    {gn_asin, gn_asin_integer}, {gn_acos, gn_acos_integer},  {gn_atan, gn_atan_integer},
    {gn_sin, gn_sin_integer},   {gn_cos, gn_cos_integer},    {gn_tan, gn_tan_integer},
    {gn_exp2, gn_exp2_integer}, {gn_exp, gn_exp_integer},    {gn_log2, gn_log2_integer},
    {gn_log, gn_log_integer},   {gn_rsqrt, gn_rsqrt_integer}};

enum { FORMS = sizeof forms / sizeof *forms, NEIGHBOURS = 4000, STEP = 13 };

static uint32_t bits_of(float x)
{
    uint32_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static void compare_around(float point)
{
    for (int32_t n = -NEIGHBOURS; n <= NEIGHBOURS; n += n >= -20 && n < 20 ? 1 : STEP) {
        const uint32_t bits = bits_of(point) + (uint32_t)n;
        float x;

        memcpy(&x, &bits, sizeof x);
        for (int sign = 0; sign < 2; ++sign, x = -x)
            for (int f = 0; f < FORMS; ++f)
                assert_int_equal(bits_of(forms[f][0](x)), bits_of(forms[f][1](x)));
    }
}

static void forms_agree_where_pieces_end(void **state)
{
    (void)state;
    for (int n = 1; n <= 64; ++n)
        compare_around((float)n / 16.0f);
    for (int exponent = -30; exponent <= 30; exponent += 3)
        compare_around(ldexpf(1.0f, exponent));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(forms_agree_where_pieces_end)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
