/* Unit tests of the choice of the back end by processor. */
#include "unit.h"

#include "../../src/config/processor.h"

#define VENDOR_AMD 0x68747541u /* "Auth" */

/* Signatures as processors report them. */
typedef struct known_processor {
    const char *name;
    uint32_t vendor, signature, family, model;
    bool prefers_avx2;
} known_processor;

static const known_processor processors[] = {
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

static void signatures_are_read_and_decided(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof processors / sizeof *processors; ++i) {
        const known_processor *const p = &processors[i];

        if (prefers_avx2(p->vendor, p->signature) != p->prefers_avx2)
            print_message("%s\n", p->name);
        assert_int_equal(signature_family(p->signature), p->family);
        assert_int_equal(signature_model(p->signature), p->model);
        assert_int_equal(prefers_avx2(p->vendor, p->signature), p->prefers_avx2);
    }
}

/* A back end that is not the fastest can still be named. */
static void the_best_one_and_those_before_it_run(void **state)
{
    (void)state;
    const gn_backend best = gn_backend_best();

    assert_true(gn_backend_available(best));
#if defined(__x86_64__)
    for (int b = GN_BACKEND_SSE2; b <= (int)best; ++b)
        assert_true(gn_backend_available((gn_backend)b));
    if (best != GN_BACKEND_AVX512 && gn_backend_available(GN_BACKEND_AVX512))
        assert_int_equal(best, GN_BACKEND_AVX2);
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signatures_are_read_and_decided),
        cmocka_unit_test(the_best_one_and_those_before_it_run),
    };
    return cmocka_run_group_tests_name("processor", tests, NULL, NULL);
}
