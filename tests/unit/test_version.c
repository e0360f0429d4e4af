/* The library and its headers have one version. */
#include "unit.h"

#if GN_VERSION < GN_VERSION_NUMBER(0, 1, 0) ||                                                     \
    GN_VERSION >= GN_VERSION_NUMBER(GN_VERSION_MAJOR + 1, 0, 0)
#error "GN_VERSION is not for #if"
#endif

static void library_and_headers_agree(void **state)
{
    (void)state;
    assert_int_equal(gn_version(), GN_VERSION);
    assert_int_equal(gn_version() / 1000000, GN_VERSION_MAJOR);
    assert_int_equal(gn_version() / 1000 % 1000, GN_VERSION_MINOR);
    assert_int_equal(gn_version() % 1000, GN_VERSION_PATCH);
}

static void versions_are_in_order(void **state)
{
    (void)state;
    assert_true(GN_VERSION_NUMBER(0, 999, 999) < GN_VERSION_NUMBER(1, 0, 0));
    assert_true(GN_VERSION_NUMBER(1, 0, 999) < GN_VERSION_NUMBER(1, 1, 0));
}

int main(void)
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(library_and_headers_agree),
        cmocka_unit_test(versions_are_in_order),
    };
    return cmocka_run_group_tests_name("version", tests, NULL, NULL);
}
