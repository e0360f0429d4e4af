/** @file
 * GN_LANES: how many vertices, triangles, fragments or texture lookups are processed at a time, as
 * structures of arrays. A lane is the place of one of them in these arrays; the arrays that shaders
 * and lookups take have GN_LANES elements.
 *
 * There are sixteen lanes. A library that is compiled with both GN_SMALL and GN_BASIC for targets
 * other than x86 with SSE2, 64-bit Arm and WebAssembly with SIMD128 has one: without vector
 * registers sixteen lanes lie in memory, and each operation loads and stores them. The library and
 * the programs that use it must agree, so compile both with these two macros; -DGN_LANES=1 for
 * both, with GN_SMALL and GN_BASIC for the library, asks for one lane on any processor. If a
 * program does not agree with the library, the linker does not find gn_draw. */
#ifndef GNOMON_LANES_H
#define GNOMON_LANES_H

/** The number of lanes, 16 or 1. */
#if !defined(GN_LANES)
#if defined(GN_SMALL) && defined(GN_BASIC) && !defined(__SSE2__) && !defined(__aarch64__) &&       \
    !defined(__wasm_simd128__)
#define GN_LANES 1
#else
#define GN_LANES 16
#endif
#endif

#if GN_LANES == 1
#define gn_draw gn_draw_of_one_lane
#elif GN_LANES != 16
#error "GN_LANES is 1 or 16."
#endif

#endif
