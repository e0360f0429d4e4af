/* Words and numbers of a text. */
#include "model_test.h"

#include <math.h>
#include <stdlib.h>

#include "../../tools/models/text.h"

static text_word word_of(const char *text)
{
    return (text_word){text, strlen(text)};
}

static void test_numbers(void **state)
{
    static const char *const good[] = {"0",
                                       "-0",
                                       "1",
                                       "+1",
                                       ".5",
                                       "-.5",
                                       "5.",
                                       "1e3",
                                       "1E+3",
                                       "1e-3",
                                       "0.1",
                                       "123456.789",
                                       "3.4028234663852886e38",
                                       "1e-45",
                                       "9007199254740993",
                                       "0.30000000000000004",
                                       "179769313486231570000000000000000000000",
                                       "1e22",
                                       "1e23",
                                       "123456789012345678901234567890",
                                       "0.000000000000000000000000000001234567890123456789",
                                       "2.2250738585072014e-308"};
    static const char *const bad[] = {"",   "+",    "-",   ".",   "e5",  "1e",  "1e+",    "1.2.3",
                                      "1x", "0x10", "--1", "1,5", "nan", "inf", "1.#IND", "1e999"};
    double value;
    (void)state;
    for (size_t i = 0; i < sizeof good / sizeof good[0]; ++i) {
        assert_true(text_number(word_of(good[i]), false, &value));
        /* The C library rounds correctly. */
        const double expected = strtod(good[i], NULL);
        assert_memory_equal(&value, &expected, sizeof value);
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i)
        assert_false(text_number(word_of(bad[i]), false, &value));
    /* A word that is longer than any buffer keeps its exponent. */
    char zeros[700];
    memset(zeros, '0', sizeof zeros);
    memcpy(zeros, "0.", 2);
    memcpy(zeros + 690, "15e+689", 8);
    assert_true(text_number(word_of(zeros), false, &value));
    assert_true(fabs(value - 1.5) < 1e-15);
    assert_true(text_number(word_of("1d3"), false, &value));
    assert_true(value == 1000.0);
}

static void test_random_numbers(void **state)
{
    uint64_t random = 1;
    (void)state;
    for (int i = 0; i < 200000; ++i) {
        char text[64];
        double value;
        random = random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        snprintf(text, sizeof text, "%s%llu.%0*lluE%d", random & 1 ? "-" : "",
                 (unsigned long long)(random >> 40), (int)(random >> 1 & 15) + 1,
                 (unsigned long long)(random >> 20 & 0xffff), (int)(random >> 8 & 63) - 32);
        assert_true(text_number(word_of(text), false, &value));
        const double expected = strtod(text, NULL);
        assert_memory_equal(&value, &expected, sizeof value);
    }
}

static void test_spellings_of_nan(void **state)
{
    static const char *const spellings[] = {"nan",       "NaN",    "-nan",      "-nan(ind)",
                                            "nan(snan)", "inf",    "-Infinity", "1.#QNAN",
                                            "-1.#IND",   "1.#INF", "1.#IND00"};
    double value;
    (void)state;
    for (size_t i = 0; i < sizeof spellings / sizeof spellings[0]; ++i) {
        assert_true(text_number(word_of(spellings[i]), true, &value));
        assert_false(isfinite(value));
    }
    assert_false(text_number(word_of("nano"), true, &value));
}

static void test_lines(void **state)
{
    static const char text[] =
        "\xef\xbb\xbf# first\n\n  v 1 2\\\n 3 # end\r\n\tname with blanks \t\n"
        "f 1\\ \r\n2\rlast";
    text_cursor t = text_begin((const uint8_t *)text, sizeof text - 1);
    text_word w;
    int64_t number;
    (void)state;
    t.comment = '#';
    t.continues = true;
    assert_true(text_next_line(&t));
    assert_int_equal(t.statement, 3);
    assert_true(text_next_word(&t, &w) && text_is(w, "v"));
    assert_true(text_next_word(&t, &w) && text_is(w, "1"));
    assert_true(text_next_word(&t, &w) && text_is(w, "2"));
    assert_true(text_next_word(&t, &w) && text_is(w, "3"));
    assert_false(text_next_word(&t, &w));
    assert_true(text_next_line(&t));
    assert_int_equal(t.statement, 5);
    assert_true(text_is(text_rest(&t), "name with blanks"));
    assert_true(text_next_line(&t));
    assert_int_equal(t.statement, 6);
    assert_true(text_next_word(&t, &w) && text_is_any_case(w, "F"));
    assert_true(text_next_word(&t, &w) && text_integer(w, &number) && number == 1);
    assert_true(text_next_word(&t, &w) && text_integer(w, &number) && number == 2);
    assert_false(text_next_word(&t, &w));
    assert_true(text_next_line(&t));
    assert_int_equal(t.statement, 8);
    assert_true(text_is(text_rest(&t), "last"));
    assert_false(text_next_line(&t));
}

static void test_integers(void **state)
{
    int64_t value;
    (void)state;
    assert_true(text_integer(word_of("-12"), &value) && value == -12);
    assert_true(text_integer(word_of("+7"), &value) && value == 7);
    assert_false(text_integer(word_of(""), &value));
    assert_false(text_integer(word_of("1.0"), &value));
    assert_false(text_integer(word_of("99999999999999999999"), &value));
}

/* Words of every length about that of the buffer: all that fits is copied, and nothing lies behind
 * the buffer. */
static void test_copies(void **state)
{
    static const char word[] = "abcdefghijkl";
    (void)state;
    for (size_t length = 0; length < sizeof word; ++length) {
        char buffer[8 + 1];
        memset(buffer, '#', sizeof buffer);
        text_copy((text_word){word, length}, buffer, 8);
        assert_int_equal(buffer[8], '#');
        if (length <= 7) {
            assert_memory_equal(buffer, word, length);
            assert_int_equal(buffer[length], '\0');
        } else {
            assert_string_equal(buffer, "abcd...");
        }
    }
}

static void test_passed_lines(void **state)
{
    static const char text[] = "a b # c\nd \\\n e\\f\r\ng#h\ni";
    text_cursor t = text_begin((const uint8_t *)text, sizeof text - 1);
    text_word w;
    static const char *const first[] = {"a", "d", "g#h", "i"};
    (void)state;
    t.comment = '#';
    t.continues = true;
    for (size_t i = 0; i < sizeof first / sizeof first[0]; ++i) {
        assert_true(text_next_line(&t));
        text_cursor ahead = t;
        assert_true(text_next_word(&ahead, &w) && text_is(w, first[i]));
        text_pass_line(&t);
    }
    assert_false(text_next_line(&t));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers),          cmocka_unit_test(test_random_numbers),
        cmocka_unit_test(test_spellings_of_nan), cmocka_unit_test(test_lines),
        cmocka_unit_test(test_integers),         cmocka_unit_test(test_copies),
        cmocka_unit_test(test_passed_lines),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
