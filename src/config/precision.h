/* Refuses compilers and flags whose floats are not binary32, computed as written. */
#ifndef GN_CONFIG_PRECISION_H
#define GN_CONFIG_PRECISION_H

#include <float.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "The library's bits are exact only with -fno-fast-math, after all other flags."
#endif

/* C99 section 5.2.4.2.2: 0 means that operations are evaluated in the range and precision of their
 * type. The registers of the x87 have excess precision, as have floats on s390x by default. */
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#if defined(__i386__) || defined(__x86_64__)
#error "x87 floats have excess precision, which changes bits: use SSE2, -msse2 -mfpmath=sse."
#else
#error "Floats have excess precision, which changes bits: -fexcess-precision=fast on s390x."
#endif
#endif

#endif
