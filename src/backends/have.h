/* What is compiled: which back ends for this target, and how much code of each. Compilers
 * that cannot switch the instruction set within a program get the portable one alone.
 * GN_LANES_INTRINSICS_HEADER names a header that emulates intrinsics the target does not
 * have, for tests: then the back ends that are made of them are there too. */
#ifndef GN_BACKENDS_HAVE_H
#define GN_BACKENDS_HAVE_H

/* Whether the common states of a draw have code of their own, made from the same text, and a
 * back end its own form of the ready-made shaders and of sampling. With GN_SMALL one form of
 * each serves all. The pixels are the same. */
#if defined(GN_SMALL)
#define GN_SPECIALISED 0
#else
#define GN_SPECIALISED 1
#endif

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
