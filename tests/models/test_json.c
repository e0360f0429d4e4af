/* JSON: what is one and what is none by RFC 8259, and what its tokens say. */
#include "model_test.h"

#include "../../tools/models/json.h"

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
    static const char *const good[] = {"{}",
                                       "[]",
                                       " [ ] ",
                                       "0",
                                       "\"a\"",
                                       "null",
                                       "[-0,1,-1.5,1e5,1E+5,1.25e-5,10]",
                                       "{\"a\":{\"b\":[[],{}]},\"a\":1}",
                                       "[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e4\"]",
                                       "\xef\xbb\xbf{}",
                                       "\t\r\n[true,false,null]\n"};
    static const char *const bad[] = {
        "",          " ",          "{",          "[",          "[1",        "{\"a\"",
        "{\"a\":",   "{\"a\":1",   "[1,]",       "{\"a\":1,}", "[,1]",      "[1 2]",
        "{\"a\" 1}", "{a:1}",      "{1:1}",      "[01]",       "[-]",       "[1.]",
        "[.5]",      "[1e]",       "[1.2.3]",    "[+1]",       "[0x1]",     "[nul]",
        "[tru]",     "[NaN]",      "[Infinity]", "[\"a]",      "[\"\\x\"]", "[\"\\u12g4\"]",
        "[\"\\u12",  "[\"a\nb\"]", "[1]]",       "{}{}",       "]",         "[}",
        "{]",        "['a']",      "[1/*c*/]",   "\xff"};
    (void)state;
    for (size_t i = 0; i < sizeof good / sizeof good[0]; ++i) {
        if (!parse_text(good[i]))
            print_message("%s: %s\n", good[i], messages.fault);
        assert_string_equal(messages.fault, "");
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        if (parse_text(bad[i]))
            print_message("accepted: %s\n", bad[i]);
        assert_string_not_equal(messages.fault, "");
    }
    /* A zero byte is no blank. */
    assert_false(parse("[1]\0", 4));
}

static void test_faults_name_the_line(void **state)
{
    (void)state;
    assert_false(parse_text("{\n\"a\": [1,\n2 3]}"));
    assert_string_equal(messages.fault, "line 3: a comma or a closing bracket is missing");
    assert_false(parse_text("{\n\"a\": [1,\n"));
    assert_string_equal(messages.fault, "line 3: the text ends within a value");
}

static void test_members(void **state)
{
    double value = 0.0;
    (void)state;
    assert_true(parse_text("{\"a\":{\"x\":1,\"y\":[2,{\"z\":3},[]]},\"b\":\"t\"}"));
    const uint32_t a = json_member(&tree, JSON_ROOT, "a");
    const uint32_t y = json_member(&tree, a, "y");
    assert_int_equal(json_kind_of(&tree, JSON_ROOT), JSON_OBJECT);
    assert_int_equal(json_count(&tree, JSON_ROOT), 2);
    assert_int_equal(json_count(&tree, y), 3);
    assert_true(json_number(&tree, json_member(&tree, a, "x"), &value) && value == 1.0);
    const uint32_t first = json_first(&tree, y), second = json_after(&tree, first);
    assert_true(json_number(&tree, first, &value) && value == 2.0);
    assert_true(json_number(&tree, json_member(&tree, second, "z"), &value) && value == 3.0);
    const uint32_t third = json_after(&tree, second);
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
}

static void test_paths(void **state)
{
    char path[64];
    (void)state;
    assert_true(parse_text("{\"a\":1,\"m\":[0,{\"p\":[7]}]}"));
    const uint32_t m = json_member(&tree, JSON_ROOT, "m");
    const uint32_t p = json_member(&tree, json_after(&tree, json_first(&tree, m)), "p");
    assert_string_equal(json_path(&tree, json_first(&tree, p), path, sizeof path), "/m/1/p/0");
    assert_string_equal(json_path(&tree, m, path, sizeof path), "/m");
    assert_string_equal(json_path(&tree, JSON_ROOT, path, sizeof path), "/");
    assert_string_equal(json_path(&tree, json_first(&tree, p), path, 5), "/p/0");
}

static void test_strings(void **state)
{
    /* U+00E4, U+20AC and U+1F600 by escapes; half of a pair. */
    static const char text[] = "[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\", \"\\u00e4\\u20AC\\ud83d\\ude00\", "
                               "\"\\ud83dx\", \"a\xff\"]";
    char buffer[64];
    (void)state;
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
    (void)state;
    assert_true(json_is_utf8("a\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80", 10));
    assert_true(json_is_utf8("", 0));
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i)
        assert_false(json_is_utf8(bad[i], strlen(bad[i])));
}

static void test_depth(void **state)
{
    static char text[200001];
    (void)state;
    memset(text, '[', 100000);
    memset(text + 100000, ']', 100000);
    assert_true(parse_text(text));
    text[199999] = '\0';
    assert_false(parse_text(text));
}

static void test_numbers(void **state)
{
    double value;
    (void)state;
    assert_true(parse_text("[0.1,1e999]"));
    const uint32_t first = json_first(&tree, JSON_ROOT);
    assert_true(json_number(&tree, first, &value) && value == 0.1);
    assert_false(json_number(&tree, json_after(&tree, first), &value));
}

static void test_budget(void **state)
{
    (void)state;
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
        cmocka_unit_test(test_texts),   cmocka_unit_test(test_faults_name_the_line),
        cmocka_unit_test(test_members), cmocka_unit_test(test_paths),
        cmocka_unit_test(test_strings), cmocka_unit_test(test_utf8),
        cmocka_unit_test(test_depth),   cmocka_unit_test(test_numbers),
        cmocka_unit_test(test_budget),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget();
    return failed;
}
