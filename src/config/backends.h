/* The list of back ends, and which of them are compiled for this target. A back end is the stages
 * of a draw compiled over one form of lanes. Compilers that cannot switch the instruction set
 * within a program get the portable one alone.
 *
 * To add a back end, here called `name`:
 * - src/lanes/registers_name.h: its registers, as lanes_registers.h says; lanes.h includes it if
 *   GN_LANES_NAME is defined;
 * - src/lanes/target_begin.inl: its instruction set, unless every processor of the target has it;
 * - include/gnomon/backend.h: its value in gn_backend; this file: GN_HAVE_NAME and its row;
 * - src/backends/name.c and shading_name.c: copies of avx2.c and shading_avx2.c with other names;
 * - src/backends/choose.c: how the processor is asked, if GN_HAVE_NAME can be GN_PRESENT_ASKED;
 *   src/backends/processor.h: the processors on which a back end of an earlier row is faster;
 * - tools/gnomon/option_table.c: its name among the values of --backend;
 * - tests/programs.mk: LANES_FORMS, so that test-lanes compares its operations with the portable
 *   ones, and EMULATED_SOURCES, if tests/portability/emulated.h emulates it;
 * - its name in tests/packaging/cplusplus.sh and tools/web/web.mk, which leave it out, and its
 *   colour in tools/bench/plot.c and tools/bench/states/plot.c.
 * Tests, benchmark and command take the list from gn_backend, gn_backend_available and
 * gn_backend_name. */
#ifndef GN_CONFIG_BACKENDS_H
#define GN_CONFIG_BACKENDS_H

#include <gnomon/backend.h>
#include <gnomon/lanes.h>

/* GN_HAVE_NAME is one of these numbers. Absent: the back end is not compiled. Emulated: it is
 * compiled over a header that stands in for its intrinsics, and every processor runs it. Asked: the
 * processor is asked whether it has the instructions. Always: every processor of the target has the
 * instructions. */
#define GN_ABSENT 0
#define GN_PRESENT_EMULATED 1
#define GN_PRESENT_ASKED 2
#define GN_PRESENT_ALWAYS 3

/* GN_LANES_INTRINSICS_HEADER names a header that emulates, for tests, intrinsics that the target
 * does not have. */
#if defined(GN_LANES_INTRINSICS_HEADER)
#define GN_HAVE_EMULATED 1
#else
#define GN_HAVE_EMULATED 0
#endif

#define GN_HAVE_PORTABLE GN_PRESENT_ALWAYS

/* Vector instructions are for sixteen lanes. */
#if GN_LANES == 1 && !defined(GN_ONLY_PORTABLE)
#define GN_ONLY_PORTABLE
#endif

#if defined(__GNUC__) && defined(__SSE2__) && !defined(GN_ONLY_PORTABLE)
#define GN_HAVE_SSE41 GN_PRESENT_ASKED
#else
#define GN_HAVE_SSE41 GN_ABSENT
#endif

#if GN_HAVE_SSE41 && defined(__x86_64__)
#define GN_HAVE_AVX2 GN_PRESENT_ASKED
#else
#define GN_HAVE_AVX2 GN_ABSENT
#endif

#if GN_HAVE_EMULATED
#define GN_HAVE_AVX512 GN_PRESENT_EMULATED
#elif GN_HAVE_AVX2
#define GN_HAVE_AVX512 GN_PRESENT_ASKED
#else
#define GN_HAVE_AVX512 GN_ABSENT
#endif

/* Not on 32-bit Arm, whose vector instructions flush denormals and do not divide; not on a
 * big-endian processor, which would take the bytes of colours in another order. */
#if GN_HAVE_EMULATED
#define GN_HAVE_NEON GN_PRESENT_EMULATED
#elif defined(__GNUC__) && defined(__aarch64__) && defined(__ARM_NEON) &&                          \
    !defined(__AARCH64EB__) && !defined(GN_ONLY_PORTABLE)
#define GN_HAVE_NEON GN_PRESENT_ALWAYS
#else
#define GN_HAVE_NEON GN_ABSENT
#endif

/* A WebAssembly module is valid on a machine as a whole or not at all, so the choice is made when
 * the program is compiled (-msimd128). */
#if GN_HAVE_EMULATED
#define GN_HAVE_WASM_SIMD128 GN_PRESENT_EMULATED
#elif defined(__wasm_simd128__) && !defined(GN_ONLY_PORTABLE)
#define GN_HAVE_WASM_SIMD128 GN_PRESENT_ALWAYS
#else
#define GN_HAVE_WASM_SIMD128 GN_ABSENT
#endif

/* ROW(X, name in functions and files, name in constants, whether compiled, printed name). The rows
 * are in gn_backend's order: a processor that has an asked back end also has the back ends of its
 * target in the rows before, which are slower on most processors (src/backends/processor.h). */
#define GN_BACKEND_ROWS(ROW, X)                                                                    \
    ROW(X, portable, PORTABLE, GN_HAVE_PORTABLE, "portable")                                       \
    ROW(X, sse41, SSE41, GN_HAVE_SSE41, "sse41")                                                   \
    ROW(X, avx2, AVX2, GN_HAVE_AVX2, "avx2")                                                       \
    ROW(X, avx512, AVX512, GN_HAVE_AVX512, "avx512")                                               \
    ROW(X, neon, NEON, GN_HAVE_NEON, "neon")                                                       \
    ROW(X, wasm_simd128, WASM_SIMD128, GN_HAVE_WASM_SIMD128, "wasm-simd128")

/* X(name, NAME, have, text) for every back end. */
#define GN_BACKENDS(X) GN_BACKEND_ROWS(GN_EVERY_ROW, X)
#define GN_EVERY_ROW(X, name, NAME, have, text) X(name, NAME, have, text)

/* X(name, NAME) for every back end that is compiled: GN_ROW_IF_0 to GN_ROW_IF_3 are chosen by the
 * number GN_HAVE_NAME. */
#define GN_COMPILED_BACKENDS(X) GN_BACKEND_ROWS(GN_COMPILED_ROW, X)
#define GN_COMPILED_ROW(X, name, NAME, have, text) GN_ROW_IF(have, X, name, NAME)
#define GN_ROW_IF(have, X, name, NAME) GN_ROW_IF_##have(X, name, NAME)
#define GN_ROW_IF_0(X, name, NAME)
#define GN_ROW_IF_1(X, name, NAME) X(name, NAME)
#define GN_ROW_IF_2(X, name, NAME) X(name, NAME)
#define GN_ROW_IF_3(X, name, NAME) X(name, NAME)

/* Returns the fastest back end that every processor of the target runs. */
static inline gn_backend backend_of_every_processor(void)
{
    gn_backend best = GN_BACKEND_PORTABLE;

#define GN_TAKE_ALWAYS(name, NAME, have, text)                                                     \
    if (have == GN_PRESENT_ALWAYS)                                                                 \
        best = GN_BACKEND_##NAME;
    GN_BACKENDS(GN_TAKE_ALWAYS)
#undef GN_TAKE_ALWAYS
    return best;
}

#endif
