/* Compiles the text from here to target_end.inl for the instruction set of the chosen form of
 * lanes. Forms that are not named here, and emulated forms, use what every processor of the target
 * has. AVX2 is requested without fused multiply-add. AVX-512 always has it, and there
 * -ffp-contract=off keeps the compiler from fusing. Include it once in a file, before all text that
 * the stages inline, because GCC inlines no function that is tuned for another processor. The
 * intrinsics' header comes first, so that its functions keep targets of their own.
 *
 * Tuned for no processor, GCC copies lanes in two AVX2 registers by four 128-bit moves, and a load
 * of a whole register then waits until both of its halves have left the store buffer: array lookups
 * take 2.5 times as long. Tuned for skylake-avx512, it copies whole registers. */
#if defined(GN_LANES_AVX512) && !defined(GN_LANES_INTRINSICS_HEADER)
#define GN_LANES_TARGET "avx512f,avx512bw,avx512dq,avx512vl"
#elif defined(GN_LANES_AVX2) && !defined(__clang__)
#define GN_LANES_TARGET "avx2,f16c,tune=skylake-avx512"
#elif defined(GN_LANES_AVX2)
#define GN_LANES_TARGET "avx2,f16c"
#elif defined(GN_LANES_SSE41)
#define GN_LANES_TARGET "sse4.1"
#endif

#if defined(GN_LANES_TARGET)
#include <immintrin.h>

#define GN_PRAGMA_TEXT(...) _Pragma(#__VA_ARGS__)
#define GN_PRAGMA(...) GN_PRAGMA_TEXT(__VA_ARGS__)

#if defined(__clang__)
GN_PRAGMA(clang attribute push(__attribute__((target(GN_LANES_TARGET))), apply_to = function))
#else
#pragma GCC push_options
GN_PRAGMA(GCC target(GN_LANES_TARGET))
#endif
#endif
