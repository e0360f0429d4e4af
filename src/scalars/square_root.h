/* Square roots by the processor's instructions, whose bits IEEE 754 defines. The builtins for x86
 * and the instructions set no errno, unlike __builtin_sqrt, for which a compiler may call the C
 * library; on WebAssembly it does not. */
#ifndef GN_SCALARS_SQUARE_ROOT_H
#define GN_SCALARS_SQUARE_ROOT_H

#include "../config/doubles.h"

#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
#define GN_HAVE_SQUARE_ROOT 1
#else
#define GN_HAVE_SQUARE_ROOT GN_HAVE_DOUBLES
#endif

#if GN_HAVE_SQUARE_ROOT

/* Returns the square root of x. Precondition: x is not negative and not NaN. */
static inline float float_square_root(float x)
{
#if defined(__SSE2__)
    typedef float lanes __attribute__((__vector_size__(16)));
    lanes value = {x, 0.0f, 0.0f, 0.0f};
    value = __builtin_ia32_sqrtss(value);
    return value[0];
#elif defined(__aarch64__)
    float root;
    __asm__("fsqrt %s0, %s1" : "=w"(root) : "w"(x));
    return root;
#elif defined(__arm__)
    float root;
    __asm__("vsqrt.f32 %0, %1" : "=t"(root) : "t"(x));
    return root;
#elif defined(__riscv)
    float root;
    __asm__("fsqrt.s %0, %1" : "=f"(root) : "f"(x));
    return root;
#elif defined(__wasm__)
    return __builtin_sqrtf(x);
#else
#error "GN_HAVE_DOUBLES is not possible: the square root of this target is not known."
#endif
}

#endif

#if GN_HAVE_DOUBLES

/* As float_square_root. */
static inline double double_square_root(double x)
{
#if defined(__SSE2__)
    typedef double pair __attribute__((__vector_size__(16)));
    pair value = {x, 0.0};
    value = __builtin_ia32_sqrtsd(value);
    return value[0];
#elif defined(__aarch64__)
    double root;
    __asm__("fsqrt %d0, %d1" : "=w"(root) : "w"(x));
    return root;
#elif defined(__arm__)
    double root;
    __asm__("vsqrt.f64 %P0, %P1" : "=w"(root) : "w"(x));
    return root;
#elif defined(__riscv)
    double root;
    __asm__("fsqrt.d %0, %1" : "=f"(root) : "f"(x));
    return root;
#else
    return __builtin_sqrt(x);
#endif
}

#endif

#endif
