/* Whether scalar functions compute in double first. GN_HAVE_DOUBLES can be defined as 0 or 1 for
 * tests; the results have the same bits. Emulated doubles would be slower than the integers. The
 * integers have to be there in any case, so GN_SMALL keeps only them: 8 KB instead of 14 on x86-64
 * with -Os. */
#ifndef GN_CONFIG_DOUBLES_H
#define GN_CONFIG_DOUBLES_H

#include "features.h"

#if !defined(GN_HAVE_DOUBLES)
#if GN_IS_SMALL || !defined(__GNUC__)
#define GN_HAVE_DOUBLES 0
#elif defined(__SSE2_MATH__) || defined(__aarch64__) || defined(__wasm__)
#define GN_HAVE_DOUBLES 1
#elif defined(__arm__) && defined(__ARM_FP) && !defined(__SOFTFP__)
#define GN_HAVE_DOUBLES ((__ARM_FP & 8) != 0)
#elif defined(__riscv_flen)
#define GN_HAVE_DOUBLES (__riscv_flen >= 64)
#else
#define GN_HAVE_DOUBLES 0
#endif
#endif

#endif
