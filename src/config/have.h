/* Which back ends are compiled for this target. Compilers that cannot switch the
 * instruction set within a program get the portable one alone. GN_LANES_INTRINSICS_HEADER
 * names a header that emulates intrinsics the target does not have, for tests: then the
 * back ends that are made of them are there too. */
#ifndef GN_CONFIG_HAVE_H
#define GN_CONFIG_HAVE_H

#if defined(GN_LANES_INTRINSICS_HEADER)
#define GN_HAVE_EMULATED 1
#else
#define GN_HAVE_EMULATED 0
#endif

#if defined(__GNUC__) && defined(__SSE2__) && !defined(GN_ONLY_PORTABLE)
#define GN_HAVE_SSE2 1
#else
#define GN_HAVE_SSE2 0
#endif

#if GN_HAVE_SSE2 && defined(__x86_64__)
#define GN_HAVE_AVX2 1
#else
#define GN_HAVE_AVX2 0
#endif

#if GN_HAVE_AVX2 || GN_HAVE_EMULATED
#define GN_HAVE_AVX512 1
#else
#define GN_HAVE_AVX512 0
#endif

/* 32-bit Arm's registers flush denormals and do not divide; a big-endian processor would
 * take bytes of colours in another order. */
#if (defined(__GNUC__) && defined(__aarch64__) && defined(__ARM_NEON) &&                           \
     !defined(__AARCH64EB__) && !defined(GN_ONLY_PORTABLE)) ||                                     \
    GN_HAVE_EMULATED
#define GN_HAVE_NEON 1
#else
#define GN_HAVE_NEON 0
#endif

#if (defined(__wasm_simd128__) && !defined(GN_ONLY_PORTABLE)) || GN_HAVE_EMULATED
#define GN_HAVE_WASM_SIMD128 1
#else
#define GN_HAVE_WASM_SIMD128 0
#endif

#endif
