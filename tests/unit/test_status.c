/* The texts of statuses. */
#include <string.h>

#include "unit.h"

static void every_status_has_its_own_text(void **state)
{
    (void)state;
    for (int i = 0; i < GN_STATUS_COUNT; ++i) {
        assert_true(strlen(gn_status_text((gn_status)i)) > 5);
        assert_string_not_equal(gn_status_text((gn_status)i), "unknown status");
        for (int j = 0; j < i; ++j)
            assert_string_not_equal(gn_status_text((gn_status)i), gn_status_text((gn_status)j));
    }
}

static void other_values_are_unknown(void **state)
{
    (void)state;
    assert_string_equal(gn_status_text(GN_STATUS_COUNT), "unknown status");
    assert_string_equal(gn_status_text((gn_status)-1), "unknown status");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_status_has_its_own_text),
        cmocka_unit_test(other_values_are_unknown),
    };
    return cmocka_run_group_tests_name("status", tests, NULL, NULL);
}
