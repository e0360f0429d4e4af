/* Which back ends are compiled for this target. Compilers that cannot switch the
 * instruction set within a program get the portable one alone. */
#ifndef GN_BACKENDS_HAVE_H
#define GN_BACKENDS_HAVE_H

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

#endif
