/* The page's own snprintf, strtod and pow against the C library's. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/unit.h"

#define snprintf less_snprintf
#define vsnprintf less_vsnprintf
#define strtod less_strtod
int less_snprintf(char *restrict to, size_t size, const char *restrict format, ...);
int less_vsnprintf(char *restrict to, size_t size, const char *restrict format, va_list values);
double less_strtod(const char *restrict text, char **restrict end);
#include "../../tools/web/less/snprintf.c"
#include "../../tools/web/less/strtod.c"
#undef snprintf
#undef vsnprintf
#undef strtod
#define pow less_pow
double less_pow(double base, double exponent);
#include "../../tools/web/less/maths.c"
#undef pow

#define RANDOM_NUMBERS 20000

static uint64_t seed = 11;

static uint64_t any(void)
{
    seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407;
    return seed ^ seed >> 29;
}

static double any_double(void)
{
    for (;;) {
        const uint64_t bits = any();
        double d;
        memcpy(&d, &bits, sizeof d);
        if (isfinite(d))
            return d;
    }
}

static void check_reading(const char *text)
{
    char *end;
    const double expected = strtod(text, NULL), read = less_strtod(text, &end);
    if (memcmp(&expected, &read, sizeof read) != 0)
        fail_msg("%s is %a, not %a", text, expected, read);
    assert_int_equal(*end, '\0');
}

static void numbers_are_read_to_the_nearest_double(void **state)
{
    /* Halfway between doubles and next to it, the limits, and the smallest denormal's half. */
    static const char *const special[] = {"9007199254740993",
                                          "9007199254740993.00000000000000000000000001",
                                          "9007199254740992.99999999999999999999999999",
                                          "9007199254740995",
                                          "1.7976931348623158e308",
                                          "1.7976931348623159e308",
                                          "2.2250738585072011e-308",
                                          "2.2250738585072014e-308",
                                          "4.9406564584124654e-324",
                                          "2.4703282292062327e-324",
                                          "2.4703282292062328e-324",
                                          "1e-400",
                                          "1e99999",
                                          "-0",
                                          "0.000e7",
                                          "00012.500",
                                          "5.",
                                          ".5",
                                          "+123456789012345678901234567890",
                                          "0.1",
                                          "1e23",
                                          "8.5e22"};
    for (size_t i = 0; i < sizeof special / sizeof *special; ++i)
        check_reading(special[i]);
    for (int i = 0; i < RANDOM_NUMBERS; ++i) {
        char text[64];
        const double d = any_double();
        snprintf(text, sizeof text, "%.*e", (int)(any() % 25), d);
        check_reading(text);
        snprintf(text, sizeof text, "%.20f", d / fabs(d) * (double)(any() % 100000) / 7.0);
        check_reading(text);
    }
}

/* Middles between two doubles with all their digits, up to 767, and one more digit. */
static void middles_are_read_to_the_even_double(void **state)
{
    for (int i = 0; i < 300; ++i) {
        char text[1300];
        const double low = fabs(any_double()) / 8.0;
        const long double middle = ((long double)low + (long double)nextafter(low, DBL_MAX)) / 2;
        const int length = snprintf(text, sizeof text - 2, "%.*Le", 790, middle);
        assert_true(length < (int)sizeof text - 2);
        check_reading(text);
        char *const letter = strchr(text, 'e');
        letter[-1] = '1';
        check_reading(text);
    }
}

static void what_is_no_number_is_not_read(void **state)
{
    static const char *const texts[] = {"", "-", ".", "e5", "x"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
        char *end;
        assert_true(less_strtod(texts[i], &end) == 0.0);
        assert_ptr_equal(end, texts[i]);
    }
    char *end;
    assert_true(less_strtod("1e+", &end) == 1.0);
    assert_string_equal(end, "e+");
}

#define CHECK(...)                                                                                 \
    do {                                                                                           \
        char expected[128], written[128];                                                          \
        const int length = snprintf(expected, sizeof expected, __VA_ARGS__);                       \
        const int said = less_snprintf(written, sizeof written, __VA_ARGS__);                      \
        assert_string_equal(written, expected);                                                    \
        assert_int_equal(said, length);                                                            \
    } while (false)

static void conversions_are_those_of_the_c_library(void **state)
{
    CHECK("plain, %%, %c", 'x');
    CHECK("%s|%.3s|%.*s", "word", "abcdef", 2, "abcdef");
    CHECK("%d %d %d %u", 0, INT32_MIN, INT32_MAX, UINT32_MAX);
    CHECK("%ld %lu %zu", -5L, 7UL, SIZE_MAX);
    CHECK("%lld %lld %llu", (long long)INT64_MIN, 12LL, (unsigned long long)UINT64_MAX);
    CHECK("%g %g %g %g", 0.0, -0.0, 1.0, 100000.0);
    CHECK("%g %g %g %g", 1e6, 0.0001, 0.00001, 123456.5);
    CHECK("%g %g %g", 999999.5, 9.9999995, 1e-300);
    CHECK("%.3g %.1g %.0g", 2.5, 0.25, 3.5);
    CHECK("%g %g %g", (double)INFINITY, -(double)INFINITY, (double)NAN);
    for (int i = 0; i < RANDOM_NUMBERS; ++i) {
        const double d = any_double(), small = (double)(any() % 100000) / 64.0;
        CHECK("%.17g %.9g %g", d, d, d);
        CHECK("%.17g %.9g %.3g", small, small, small);
    }
}

/* The exponents of colours and of a zoom. */
static void powers_are_as_near_as_floats_need(void **state)
{
    static const double exponents[] = {2.4, 1.0 / 2.4, 0.5, 3.0, -2.0, -17.0, 0.0};
    for (int i = 0; i < RANDOM_NUMBERS; ++i) {
        const double base = (double)(1 + any() % 1000000) / 800000.0;
        const double exponent = exponents[any() % 7], expected = pow(base, exponent);
        assert_true(fabs(less_pow(base, exponent) / expected - 1.0) < 1e-13);
    }
    assert_true(less_pow(0.0, 1.0 / 2.4) == 0.0);
    assert_true(less_pow(0.9, 2000.0) / pow(0.9, 2000.0) < 1.0 + 1e-12);
}

static void long_texts_are_cut(void **state)
{
    char text[4] = "???";
    assert_int_equal(less_snprintf(text, 3, "%d", 12345), 5);
    assert_memory_equal(text, "12\0", 4);
    assert_int_equal(less_snprintf(NULL, 0, "%s", "abc"), 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_read_to_the_nearest_double),
        cmocka_unit_test(middles_are_read_to_the_even_double),
        cmocka_unit_test(what_is_no_number_is_not_read),
        cmocka_unit_test(conversions_are_those_of_the_c_library),
        cmocka_unit_test(powers_are_as_near_as_floats_need),
        cmocka_unit_test(long_texts_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
