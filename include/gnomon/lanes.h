/** @file
 * GN_LANES: how many vertices, triangles, fragments or texture lookups are processed at a time, as
 * structures of arrays. A lane is the place of one of them in these arrays; the arrays that shaders
 * and lookups take have GN_LANES elements.
 *
 * There are sixteen lanes. A library that is compiled with both GN_SMALL and GN_BASIC for targets
 * without vector registers has one, since it has nothing that needs neighbouring fragments. The
 * library and the programs that use it must agree, so compile both with these two macros;
 * -DGN_LANES=1 for both, with GN_SMALL and GN_BASIC for the library, asks for one lane on any
 * processor. If a program does not agree with the library, the linker does not find gn_draw.
 *
 * Any other library for such a target draws in sixteen lanes what needs neighbouring fragments, and
 * the rest one vertex and one fragment at a time (GN_HAVE_ONE_LANE). */
#ifndef GNOMON_LANES_H
#define GNOMON_LANES_H

/** Whether the target has registers of four floats, in which it computes as IEEE 754 says: SSE2,
 * 64-bit Arm, WebAssembly, IBM Z, Power's VSX. LoongArch and RISC-V are missing, since the forms
 * of lanes could not be compared there. The vector instructions of 32-bit Arm, of AltiVec without
 * VSX and of MIPS may flush denormals. Clang gives vectors other types on Power. */
#if defined(__SSE2__) || (defined(__aarch64__) && defined(__ARM_NEON)) ||                          \
    defined(__wasm_simd128__) || defined(__VX__) || (defined(__VSX__) && !defined(__clang__))
#define GN_HAVE_REGISTERS 1
#else
#define GN_HAVE_REGISTERS 0
#endif

/** The number of lanes, 16 or 1. */
#if !defined(GN_LANES)
#if defined(GN_SMALL) && defined(GN_BASIC) && !GN_HAVE_REGISTERS
#define GN_LANES 1
#else
#define GN_LANES 16
#endif
#endif

/** Whether a library of sixteen lanes has a form of one lane beside it: without vector registers
 * sixteen lanes lie in memory, and each operation loads and stores them. Filled triangles on
 * targets with one sample a pixel are drawn in that form if the program's `needs_quads`
 * (gnomon/program.h) says that no fragment needs its neighbours. -DGN_HAVE_ONE_LANE=0 leaves the
 * form out of the library, for 50 to 60 KB less flash and eight to twelve times the instructions; 1
 * adds it on any target. */
#if GN_LANES == 1
#undef GN_HAVE_ONE_LANE
#define GN_HAVE_ONE_LANE 0
#elif !defined(GN_HAVE_ONE_LANE)
#define GN_HAVE_ONE_LANE (!GN_HAVE_REGISTERS)
#endif

#if GN_LANES == 1
#define gn_draw gn_draw_of_one_lane
#elif GN_LANES != 16
#error "GN_LANES is 1 or 16."
#endif

#endif
