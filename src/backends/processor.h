/* The x86 processors with AVX-512 on which AVX2 is chosen.
 *
 * AVX-512 is chosen where it is there, because it measures faster. On Zen 4, whose units are 256
 * bits wide, 307 states take 1.08 times as long with AVX2 (geometric mean; the extremes are 0.8 and
 * 1.9), and the scenes of the benchmark 1.09 times; on Sapphire Rapids, whose units are 512 bits
 * wide, the scenes take 1.15 to 1.55 times as long.
 *
 * The exception is family 6, model 85: Skylake-X and the Xeons of Skylake, Cascade Lake and Cooper
 * Lake. It could not be measured; the facts are these:
 * - Multiplications and additions of 512 bits put a core at power licence level 2, at which its
 *   clock is limited to the AVX-512 turbo frequencies; those of 256 bits stay at level 1 (Intel's
 *   performance events of that model, CORE_POWER.LVL1_TURBO_LICENSE and LVL2_TURBO_LICENSE). A Xeon
 *   Gold 6154 has 3.6 and 3.5 GHz if one core is busy, but 3.3 and 2.7 GHz if all are.
 * - The core keeps the lower clock for about 2 ms, so that the program's other code pays too.
 * - Some models, all of Xeon Silver among them, have one such unit of 512 bits beside two of 256,
 *   and CPUID does not tell which.
 * With the gain of Sapphire Rapids, AVX-512 would be 1.1 times as fast on all cores of a 6154. With
 * the gain of Zen 4 it would be 0.9 times as fast there. AVX2 is the choice whose worst case is the
 * better one. GCC and Clang prefer 256 bits on that model too.
 *
 * Intel's later processors lower the clock little or not at all. Knights Landing and Knights
 * Mill need no exception: they lack BW, DQ and VL, so that the AVX-512 back end cannot run there
 * (Intel SDM volume 1, section 15.2). */
#ifndef GN_BACKENDS_PROCESSOR_H
#define GN_BACKENDS_PROCESSOR_H

#include <stdbool.h>
#include <stdint.h>

/* The first four letters of a vendor's name, which CPUID's function 0 returns in EBX: "Genu". */
#define VENDOR_INTEL 0x756E6547u

/* Returns the family in a processor's signature, which CPUID's function 1 returns in EAX (Intel SDM
 * volume 2A, CPUID; AMD64 APM volume 3, function 1). */
static inline uint32_t signature_family(uint32_t signature)
{
    const uint32_t family = signature >> 8 & 0x0Fu;

    return family == 15 ? family + (signature >> 20 & 0xFFu) : family;
}

/* Returns the model in a signature. Its upper digit counts only in families 6 and 15. */
static inline uint32_t signature_model(uint32_t signature)
{
    const uint32_t family = signature >> 8 & 0x0Fu;
    const uint32_t upper = family == 6 || family == 15 ? signature >> 12 & 0xF0u : 0;

    return upper | (signature >> 4 & 0x0Fu);
}

/* Returns whether AVX2 is chosen on a processor that has AVX-512. */
static inline bool prefers_avx2(uint32_t vendor, uint32_t signature)
{
    return vendor == VENDOR_INTEL && signature_family(signature) == 6 &&
           signature_model(signature) == 85;
}

#endif
