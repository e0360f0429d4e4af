/* Finds out which back ends the processor can run, and which of them is fastest. */
#include <gnomon/backend.h>

#include "../config/backends.h"

#if GN_HAVE_SSE41
#include <cpuid.h>

#include "processor.h"

/* Returns the last back end that an x86 processor can run; it can also run those before. Sets the
 * processor's signature. A processor with AVX2 has SSE4.1, and one with AVX-512 has AVX2. For wider
 * registers than SSE's the processor must have them, and the operating system must save them:
 * OSXSAVE and bits of XCR0 are set, 1 and 2 for AVX2, and also 5 to 7 (mask registers, the upper
 * halves of 16 registers, 16 more) for AVX-512 (Intel SDM volume 1, sections 14.3 and 15.2). Both
 * back ends also convert halves, by F16C. */
static gn_backend last_of_x86(uint32_t *signature)
{
    const uint32_t sse41 = bit_SSE3 | bit_SSSE3 | bit_SSE4_1;
    const uint32_t avx512 = bit_AVX512F | bit_AVX512DQ | bit_AVX512BW | bit_AVX512VL;
    const uint32_t first = bit_OSXSAVE | bit_AVX | bit_F16C;
    uint32_t a, b, c, d, low, high;

    if (!__get_cpuid(1, signature, &b, &c, &d) || (c & sse41) != sse41)
        return GN_BACKEND_PORTABLE;
    if (!GN_HAVE_AVX2 || (c & first) != first)
        return GN_BACKEND_SSE41;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    if ((low & 0x06u) != 0x06u || !__get_cpuid_count(7, 0, &a, &b, &c, &d) || (b & bit_AVX2) == 0)
        return GN_BACKEND_SSE41;
    return (low & 0xE0u) == 0xE0u && (b & avx512) == avx512 ? GN_BACKEND_AVX512 : GN_BACKEND_AVX2;
}

#endif

gn_backend gn_backend_best(void)
{
#if GN_HAVE_SSE41
    uint32_t signature = 0, vendor = 0;
    const gn_backend last = last_of_x86(&signature);

    if (last != GN_BACKEND_AVX512)
        return last;
    __get_cpuid_max(0, &vendor);
    return prefers_avx2(vendor, signature) ? GN_BACKEND_AVX2 : last;
#else
    return backend_of_every_processor();
#endif
}

/* Returns whether the processor can run this back end, which is one of its target's. */
static bool runs(gn_backend backend)
{
#if GN_HAVE_SSE41
    uint32_t signature = 0;

    return last_of_x86(&signature) >= backend;
#else
    return backend_of_every_processor() >= backend;
#endif
}

/* Returns GN_HAVE_NAME of the back end. */
static int presence_of(gn_backend backend)
{
#define PRESENCE(name, NAME, have, text)                                                           \
    if (backend == GN_BACKEND_##NAME)                                                              \
        return have;
    GN_BACKENDS(PRESENCE)
#undef PRESENCE
    return backend == GN_BACKEND_AUTO ? GN_PRESENT_ALWAYS : GN_ABSENT;
}

bool gn_backend_available(gn_backend backend)
{
    const int presence = presence_of(backend);

    return presence == GN_PRESENT_ASKED ? runs(backend) : presence != GN_ABSENT;
}

/* Every value of gn_backend but GN_BACKEND_AUTO has a row in GN_BACKENDS. */
#define ONE(name, NAME, have, text) +1
typedef char all_are_listed[1 GN_BACKENDS(ONE) == GN_BACKEND_COUNT ? 1 : -1];
#undef ONE

const char *gn_backend_name(gn_backend backend)
{
    /* Fixed-width text, since a table of pointers would need relocation. */
#define NAMED(name, NAME, have, text) [GN_BACKEND_##NAME] = text,
    static const char names[GN_BACKEND_COUNT][16] = {[GN_BACKEND_AUTO] = "auto",
                                                     GN_BACKENDS(NAMED)};
#undef NAMED

    return (unsigned)backend < GN_BACKEND_COUNT ? names[backend] : "unknown";
}
