/* What the processor can run. */
#include "gnomon/backend.h"

#include "have.h"

#if GN_HAVE_AVX2
#include <cpuid.h>
#include <stdint.h>

/* AVX2 needs the processor's word for it, and the operating system's that it saves the
 * registers: OSXSAVE, and bits 1 and 2 of XCR0 (Intel SDM volume 1, section 14.3). */
static bool processor_has_avx2(void)
{
    uint32_t a, b, c, d, low, high;

    if (!__get_cpuid(1, &a, &b, &c, &d) || (c & bit_OSXSAVE) == 0 || (c & bit_AVX) == 0)
        return false;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    if ((low & 6u) != 6u || !__get_cpuid_count(7, 0, &a, &b, &c, &d))
        return false;
    return (b & bit_AVX2) != 0;
}
#endif

bool gn_backend_available(gn_backend backend)
{
    switch (backend) {
    case GN_BACKEND_AUTO:
    case GN_BACKEND_PORTABLE:
        return true;
    case GN_BACKEND_SSE2:
        return GN_HAVE_SSE2;
    case GN_BACKEND_AVX2:
#if GN_HAVE_AVX2
        return processor_has_avx2();
#else
        return false;
#endif
    default:
        return false;
    }
}

gn_backend gn_backend_best(void)
{
    if (gn_backend_available(GN_BACKEND_AVX2))
        return GN_BACKEND_AVX2;
    return gn_backend_available(GN_BACKEND_SSE2) ? GN_BACKEND_SSE2 : GN_BACKEND_PORTABLE;
}

const char *gn_backend_name(gn_backend backend)
{
    /* Fixed-width text, since a table of pointers would need relocation. */
    static const char names[GN_BACKEND_COUNT][16] = {"auto", "portable", "sse2", "avx2"};

    return (unsigned)backend < GN_BACKEND_COUNT ? names[backend] : "unknown";
}
