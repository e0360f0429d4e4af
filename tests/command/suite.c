/* Runs the tests of a program. */
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct CMUnitTest tests[64];
static int lines[64];
static size_t count;

/* Inserts the test by its line: constructors may run in any order. */
void suite_add(const char *name, CMUnitTestFunction test, int line)
{
    size_t i = count++;
    if (count > COUNT(tests))
        abort();
    for (; i > 0 && lines[i - 1] > line; --i) {
        tests[i] = tests[i - 1];
        lines[i] = lines[i - 1];
    }
    tests[i].name = name;
    tests[i].test_func = test;
    lines[i] = line;
}

__attribute__((weak)) void suite_begin(int argc, char **argv)
{
    (void)argc;
    (void)argv;
}

__attribute__((weak)) void suite_end(void)
{
}

int main(int argc, char **argv)
{
    const char *slash = strrchr(argv[0], '/');
    suite_begin(argc, argv);
    const int failed =
        _cmocka_run_group_tests(slash != NULL ? slash + 1 : argv[0], tests, count, NULL, NULL);
    suite_end();
    return failed != 0;
}
