/* Words and numbers of a text; and JSON: what is one and what is none by RFC 8259, and what its
 * tokens say. */
#include "model_test.h"

#include "../../tools/models/json.h"
#include "../../tools/models/text.h"

static text_word word_of(const char *text)
{
    return (text_word){text, strlen(text)};
}

static void expect_number(const char *text, double expected)
{
    double value;
    assert_true(text_number(word_of(text), false, &value));
    assert_memory_equal(&value, &expected, sizeof value);
}

/* The C library rounds correctly. */
static void test_words_that_are_numbers(void **state)
{
    static const char good[] =
        "0 -0 1 +1 .5 -.5 5. 1e3 1E+3 1e-3 0.1 123456.789 3.4028234663852886e38 1e-45 "
        "9007199254740993 0.30000000000000004 179769313486231570000000000000000000000 1e22 1e23 "
        "123456789012345678901234567890 0.000000000000000000000000000001234567890123456789 "
        "2.2250738585072014e-308";
    static const char *const bad[] = {"",   "+",    "-",   ".",   "e5",  "1e",  "1e+",    "1.2.3",
                                      "1x", "0x10", "--1", "1,5", "nan", "inf", "1.#IND", "1e999"};
    uint64_t random = 1;
    char text[700];
    double value;
    strcpy(text, good);
    for (char *word = strtok(text, " "); word != NULL; word = strtok(NULL, " "))
        expect_number(word, strtod(word, NULL));
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i)
        assert_false(text_number(word_of(bad[i]), false, &value));
    for (int i = 0; i < 200000; ++i) {
        random = random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        snprintf(text, sizeof text, "%s%llu.%0*lluE%d", random & 1 ? "-" : "",
                 (unsigned long long)(random >> 40), (int)(random >> 1 & 15) + 1,
                 (unsigned long long)(random >> 20 & 0xffff), (int)(random >> 8 & 63) - 32);
        expect_number(text, strtod(text, NULL));
    }
    expect_number("1d3", 1000.0);
    /* A word that is longer than any buffer keeps its exponent. */
    memset(text, '0', sizeof text);
    memcpy(text, "0.", 2);
    memcpy(text + 690, "15e+689", 8);
    assert_true(text_number(word_of(text), false, &value));
    assert_true(fabs(value - 1.5) < 1e-15);
}

/* The statement's line, and its words as they must be, behind which nothing stands. */
static void expect_line(text_cursor *t, uint64_t statement, const char *words)
{
    text_word w;
    assert_true(text_next_line(t));
    assert_int_equal(t->statement, statement);
    for (size_t length; *words != '\0'; words += length + (words[length] == ' ')) {
        length = strcspn(words, " ");
        assert_true(text_next_word(t, &w));
        assert_int_equal(w.length, length);
        assert_memory_equal(w.start, words, length);
    }
    assert_false(text_next_word(t, &w));
}

static void test_lines(void **state)
{
    static const char text[] =
        "\xef\xbb\xbf# first\n\n  v 1 2\\\n 3 # end\r\n\tname with blanks \t\n"
        "f 1\\ \r\n2\rlast";
    text_cursor t = text_begin((const uint8_t *)text, sizeof text - 1);
    t.comment = '#';
    t.continues = true;
    expect_line(&t, 3, "v 1 2 3");
    assert_true(text_next_line(&t));
    assert_int_equal(t.statement, 5);
    assert_true(text_is(text_rest(&t), "name with blanks"));
    expect_line(&t, 6, "f 1 2");
    assert_true(text_next_line(&t));
    assert_int_equal(t.statement, 8);
    assert_true(text_is(text_rest(&t), "last"));
    assert_false(text_next_line(&t));
    assert_true(text_is_any_case(word_of("f"), "F") && !text_is_any_case(word_of("f"), "G"));
}

/* Words of every length about that of the buffer: all that fits is copied, and nothing lies behind
 * the buffer. */
static void test_copies(void **state)
{
    static const char word[] = "abcdefghijkl";
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

static model_messages messages;
static model_reader reader;
static json tree;

static void forget(void)
{
    json_free(&reader, &tree);
    model_messages_free(&messages);
}

static bool parse(const char *text, size_t size)
{
    forget();
    reader = (model_reader){"a.json", NULL, 0, NULL, BUDGET, NULL, &messages, ""};
    return json_parse(&reader, (const uint8_t *)text, size, &tree);
}

static bool parse_text(const char *text)
{
    return parse(text, strlen(text));
}

static void test_texts(void **state)
{
    char good[] = "{}|[]| [ ] |0|\"a\"|null|[-0,1,-1.5,1e5,1E+5,1.25e-5,10]|"
                  "{\"a\":{\"b\":[[],{}]},\"a\":1}|[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e4\"]|"
                  "\xef\xbb\xbf{}|\t\r\n[true,false,null]\n";
    static const char *const bad[] = {
        "",          " ",          "{",          "[",          "[1",        "{\"a\"",
        "{\"a\":",   "{\"a\":1",   "[1,]",       "{\"a\":1,}", "[,1]",      "[1 2]",
        "{\"a\" 1}", "{a:1}",      "{1:1}",      "[01]",       "[-]",       "[1.]",
        "[.5]",      "[1e]",       "[1.2.3]",    "[+1]",       "[0x1]",     "[nul]",
        "[tru]",     "[NaN]",      "[Infinity]", "[\"a]",      "[\"\\x\"]", "[\"\\u12g4\"]",
        "[\"\\u12",  "[\"a\nb\"]", "[1]]",       "{}{}",       "]",         "[}",
        "{]",        "['a']",      "[1/*c*/]",   "\xff"};
    for (const char *text = strtok(good, "|"); text != NULL; text = strtok(NULL, "|"))
        if (!parse_text(text) || messages.fault[0] != '\0')
            fail_msg("%s: %s", text, messages.fault);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i)
        if (parse_text(bad[i]) || messages.fault[0] == '\0')
            fail_msg("accepted: %s", bad[i]);
    /* A zero byte is no blank. */
    assert_false(parse("[1]\0", 4));
    assert_false(parse_text("{\n\"a\": [1,\n2 3]}"));
    assert_string_equal(messages.fault, "line 3: a comma or a closing bracket is missing");
    assert_false(parse_text("{\n\"a\": [1,\n"));
    assert_string_equal(messages.fault, "line 3: the text ends within a value");
}

static void test_members(void **state)
{
    double value = 0.0;
    char path[64];
    assert_true(parse_text("{\"a\":{\"x\":0.1,\"y\":[2,{\"z\":1e999},[]]},\"b\":\"t\"}"));
    const uint32_t a = json_member(&tree, JSON_ROOT, "a"), y = json_member(&tree, a, "y");
    const uint32_t first = json_first(&tree, y), second = json_after(&tree, first),
                   third = json_after(&tree, second), z = json_member(&tree, second, "z");
    assert_int_equal(json_count(&tree, JSON_ROOT), 2);
    assert_int_equal(json_count(&tree, y), 3);
    assert_true(json_number(&tree, json_member(&tree, a, "x"), &value) && value == 0.1);
    assert_true(json_number(&tree, first, &value) && value == 2.0);
    assert_false(json_number(&tree, z, &value));
    assert_int_equal(json_kind_of(&tree, third), JSON_ARRAY);
    assert_int_equal(json_first(&tree, third), JSON_NONE);
    assert_int_equal(json_after(&tree, third), JSON_NONE);
    assert_true(json_is(&tree, json_member(&tree, JSON_ROOT, "b"), "t"));
    /* What is not there has no members. */
    assert_int_equal(json_member(&tree, JSON_ROOT, "c"), JSON_NONE);
    assert_int_equal(json_member(&tree, JSON_NONE, "a"), JSON_NONE);
    assert_int_equal(json_first(&tree, first), JSON_NONE);
    assert_false(json_number(&tree, JSON_NONE, &value));
    assert_false(json_is(&tree, first, "2"));
    assert_string_equal(json_path(&tree, z, path, sizeof path), "/a/y/1/z");
    assert_string_equal(json_path(&tree, z, path, 5), "/1/z");
    assert_string_equal(json_path(&tree, JSON_ROOT, path, sizeof path), "/");
}

static void test_strings(void **state)
{
    /* U+00E4, U+20AC and U+1F600 by escapes; half of a pair. */
    static const char text[] = "[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\", \"\\u00e4\\u20AC\\ud83d\\ude00\", "
                               "\"\\ud83dx\", \"a\xff\"]";
    char buffer[64];
    assert_true(parse_text(text));
    uint32_t e = json_first(&tree, JSON_ROOT);
    assert_int_equal(json_unescape(&tree, e, buffer), 8);
    assert_string_equal(buffer, "\"\\/\b\f\n\r\t");
    e = json_after(&tree, e);
    json_unescape(&tree, e, buffer);
    assert_string_equal(buffer, "\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80");
    assert_string_equal(json_copy(&tree, e, buffer, 6), "\xc3\xa4\xe2\x82\xac");
    assert_string_equal(json_copy(&tree, e, buffer, 5), "\xc3\xa4");
    e = json_after(&tree, e);
    json_unescape(&tree, e, buffer);
    assert_string_equal(buffer, "\xef\xbf\xbdx");
    assert_string_equal(json_copy(&tree, json_after(&tree, e), buffer, sizeof buffer), "a?");
}

static void test_utf8(void **state)
{
    static const char *const bad[] = {"\x80",         "\xc0\x80",         "\xe0\x9f\xbf",
                                      "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
                                      "\xe2\x82",     "\xf8\x80\x80\x80", "\xc3("};
    assert_true(json_is_utf8("a\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80", 10));
    assert_true(json_is_utf8("", 0));
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i)
        assert_false(json_is_utf8(bad[i], strlen(bad[i])));
}

static void test_depth(void **state)
{
    static char text[200001];
    memset(text, '[', 100000);
    memset(text + 100000, ']', 100000);
    assert_true(parse_text(text));
    text[199999] = '\0';
    assert_false(parse_text(text));
}

static void test_budget(void **state)
{
    forget();
    reader = (model_reader){"a.json", NULL, 0, NULL, 4000, NULL, &messages, ""};
    static char text[2000] = "[";
    for (size_t i = 1; i < 1000; i += 2)
        memcpy(text + i, "0,", 2);
    memcpy(text + 1001, "0]", 3);
    assert_false(json_parse(&reader, (const uint8_t *)text, strlen(text), &tree));
    assert_string_equal(messages.fault, "not enough memory");
    json_free(&reader, &tree);
    assert_int_equal(reader.memory_left, 4000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_words_that_are_numbers),
        cmocka_unit_test(test_lines),
        cmocka_unit_test(test_copies),
        cmocka_unit_test(test_passed_lines),
        cmocka_unit_test(test_texts),
        cmocka_unit_test(test_members),
        cmocka_unit_test(test_strings),
        cmocka_unit_test(test_utf8),
        cmocka_unit_test(test_depth),
        cmocka_unit_test(test_budget),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget();
    forget_model();
    return failed;
}
