/* What the library says of itself: its version, the texts of statuses, its back ends, and which of
 * them a processor gets. */
#include "drawing.h"

#include "../../src/backends/processor.h"

#if GN_VERSION < GN_VERSION_NUMBER(0, 1, 0) ||                                                     \
    GN_VERSION >= GN_VERSION_NUMBER(GN_VERSION_MAJOR + 1, 0, 0)
#error "GN_VERSION is not for #if"
#endif

static void library_and_headers_have_one_version(void **state)
{
    assert_int_equal(gn_version(), GN_VERSION);
    assert_int_equal(gn_version() / 1000000, GN_VERSION_MAJOR);
    assert_int_equal(gn_version() / 1000 % 1000, GN_VERSION_MINOR);
    assert_int_equal(gn_version() % 1000, GN_VERSION_PATCH);
    assert_true(GN_VERSION_NUMBER(0, 999, 999) < GN_VERSION_NUMBER(1, 0, 0));
    assert_true(GN_VERSION_NUMBER(1, 0, 999) < GN_VERSION_NUMBER(1, 1, 0));
}

static void every_status_has_its_own_text(void **state)
{
    for (int i = -1; i <= GN_STATUS_COUNT; ++i) {
        const char *const text = gn_status_text((gn_status)i);

        assert_int_equal(strcmp(text, "unknown status") == 0, i < 0 || i == GN_STATUS_COUNT);
        assert_true(strlen(text) > 5);
        for (int j = 0; j < i; ++j)
            assert_string_not_equal(text, gn_status_text((gn_status)j));
    }
}

#define VENDOR_AMD 0x68747541u /* "Auth" */

/* Signatures as processors report them. */
static const struct {
    const char *name;
    uint32_t vendor, signature, family, model;
    bool prefers_avx2;
} processors[] = {
    {"Skylake-SP", VENDOR_INTEL, 0x00050654, 6, 0x55, true},
    {"Cascade Lake", VENDOR_INTEL, 0x00050657, 6, 0x55, true},
    {"Cooper Lake", VENDOR_INTEL, 0x0005065B, 6, 0x55, true},
    {"Skylake-SP's number, another vendor", VENDOR_AMD, 0x00050654, 6, 0x55, false},
    {"Skylake client", VENDOR_INTEL, 0x000506E3, 6, 0x5E, false},
    {"Knights Landing", VENDOR_INTEL, 0x00050671, 6, 0x57, false},
    {"Ice Lake-SP", VENDOR_INTEL, 0x000606A6, 6, 0x6A, false},
    {"Tiger Lake", VENDOR_INTEL, 0x000806C1, 6, 0x8C, false},
    {"Sapphire Rapids", VENDOR_INTEL, 0x000806F8, 6, 0x8F, false},
    {"Pentium 4", VENDOR_INTEL, 0x00000F4A, 15, 0x04, false},
    {"family 5, whose model has one digit", VENDOR_INTEL, 0x00050554, 5, 0x05, false},
    {"Zen 4", VENDOR_AMD, 0x00A10F11, 25, 0x11, false},
    {"Zen 5", VENDOR_AMD, 0x00B00F21, 26, 0x02, false},
};

static void processors_choose_by_their_signature(void **state)
{
    for (size_t i = 0; i < sizeof processors / sizeof *processors; ++i) {
        const uint32_t signature = processors[i].signature;

        if (signature_family(signature) != processors[i].family ||
            signature_model(signature) != processors[i].model ||
            prefers_avx2(processors[i].vendor, signature) != processors[i].prefers_avx2)
            fail_msg("%s", processors[i].name);
    }
}

/* A back end that is not the fastest can still be named. */
static void back_ends_are_named_and_there(void **state)
{
    const gn_backend best = gn_backend_best();

    assert_true(best > GN_BACKEND_AUTO && best < GN_BACKEND_COUNT);
    assert_true(gn_backend_available(best));
    assert_true(gn_backend_available(GN_BACKEND_AUTO));
    assert_true(gn_backend_available(GN_BACKEND_PORTABLE));
    assert_false(gn_backend_available(GN_BACKEND_COUNT));
    assert_false(gn_backend_available((gn_backend)-1));
    assert_string_equal(gn_backend_name(GN_BACKEND_PORTABLE), "portable");
    assert_string_equal(gn_backend_name(GN_BACKEND_COUNT), "unknown");
#if defined(__x86_64__)
    for (int b = GN_BACKEND_SSE41; b <= (int)best; ++b)
        assert_true(gn_backend_available((gn_backend)b));
    if (best != GN_BACKEND_AVX512 && gn_backend_available(GN_BACKEND_AVX512))
        assert_int_equal(best, GN_BACKEND_AVX2);
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(library_and_headers_have_one_version),
        cmocka_unit_test(every_status_has_its_own_text),
        cmocka_unit_test(processors_choose_by_their_signature),
        cmocka_unit_test(back_ends_are_named_and_there),
    };
    return cmocka_run_group_tests_name("library", tests, NULL, NULL);
}
