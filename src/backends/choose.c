/* What the processor can run. */
#include "gnomon/backend.h"

#include "../config/have.h"

#if GN_HAVE_AVX2
#include <cpuid.h>
#include <stdint.h>

/* The best back end of an x86 processor: SSE2 is the least of them, and one with AVX-512
 * has AVX2. Registers need the processor's word for them, and the operating system's that
 * it saves them: OSXSAVE, and in XCR0 bits 1 and 2 for AVX2, and 5 to 7 (mask registers,
 * the upper halves of 16 registers, 16 more) for AVX-512 (Intel SDM volume 1, sections
 * 14.3 and 15.2). */
static gn_backend best_of_x86(void)
{
    const uint32_t avx512 = bit_AVX512F | bit_AVX512DQ | bit_AVX512BW | bit_AVX512VL;
    uint32_t a, b, c, d, low, high;

    if (!__get_cpuid(1, &a, &b, &c, &d) || (c & bit_OSXSAVE) == 0 || (c & bit_AVX) == 0)
        return GN_BACKEND_SSE2;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    if ((low & 0x06u) != 0x06u || !__get_cpuid_count(7, 0, &a, &b, &c, &d) || (b & bit_AVX2) == 0)
        return GN_BACKEND_SSE2;
    return (low & 0xE0u) == 0xE0u && (b & avx512) == avx512 ? GN_BACKEND_AVX512 : GN_BACKEND_AVX2;
}
#endif

gn_backend gn_backend_best(void)
{
#if GN_HAVE_AVX2
    return best_of_x86();
#elif GN_HAVE_SSE2
    return GN_BACKEND_SSE2;
#elif GN_HAVE_NEON
    return GN_BACKEND_NEON;
#elif GN_HAVE_WASM_SIMD128
    return GN_BACKEND_WASM_SIMD128;
#else
    return GN_BACKEND_PORTABLE;
#endif
}

bool gn_backend_available(gn_backend backend)
{
    switch (backend) {
    case GN_BACKEND_AUTO:
    case GN_BACKEND_PORTABLE:
        return true;
    case GN_BACKEND_SSE2:
        return GN_HAVE_SSE2;
    case GN_BACKEND_AVX2:
        return GN_HAVE_AVX2 && gn_backend_best() >= GN_BACKEND_AVX2;
    case GN_BACKEND_AVX512:
        return GN_HAVE_EMULATED || (GN_HAVE_AVX512 && gn_backend_best() == GN_BACKEND_AVX512);
    case GN_BACKEND_NEON:
        return GN_HAVE_NEON;
    case GN_BACKEND_WASM_SIMD128:
        return GN_HAVE_WASM_SIMD128;
    default:
        return false;
    }
}

const char *gn_backend_name(gn_backend backend)
{
    /* Fixed-width text, since a table of pointers would need relocation. */
    static const char names[GN_BACKEND_COUNT][16] = {"auto",   "portable", "sse2",        "avx2",
                                                     "avx512", "neon",     "wasm-simd128"};

    return (unsigned)backend < GN_BACKEND_COUNT ? names[backend] : "unknown";
}
