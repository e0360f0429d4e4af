/* Floats, integers and masks of sixteen lanes: the only place that knows how they are held. Stages
 * are written once over these operations. lanes_portable.h defines each operation; the other forms
 * return the same bits.
 *
 *   load store splat              memory and constants
 *   columns rows i_plane          the terms of a plane over a block
 *   add sub mul div sqrt min max  one IEEE operation per lane; min and max return their
 *                                 second operand if either is NaN
 *   greater less_equal and not    masks
 *   bits from_bits i_sign_bits    bit l is lane l of a mask, or the sign of lane l
 *   select m_as_int
 *   truncate round to_float       conversions to integers and back
 *   as_int as_float               the bits of floats
 *   floor floor_to_int            the largest integer not above, as a float or as an integer
 *   quad_left quad_right          the value in one column or row of each 2x2 quad
 *   quad_lower quad_upper
 *   i_add i_sub i_mul             integers, which wrap around
 *   i_mul_short                   products with one number, if all factors fit 16 bits
 *   i_or i_and i_xor
 *   i_mul_shorts i_high_bytes     each short of a lane: products, and shifts to the right by a byte
 *   i_add_bytes i_sub_bytes       each byte of a lane: sums up to 255, differences down to 0
 *   i_add_shorts i_sub_shorts     each short of a lane: sums up to 65535, differences down to 0
 *   i_scale_shorts                each short of a lane: a * b / 65535, rounded
 *   i_shift_left i_shift_right
 *   i_min i_max i_clamp i_select
 *   i_greater i_equal
 *   i_splat_two                   one value in the lower lanes, one in the upper
 *   i_gather i_gather_pairs       words of memory by index
 *   i_gather_rows i_scatter_rows  rows of four words, one per lane, and four lanes_i
 *   pack_unorm8 unpack_unorm8     colours
 *   i_load_block i_store_block    the two halves of a block in rows of memory
 *
 * Forms of lanes differ in the registers that hold them: registers_NAME.h defines what an
 * instruction set does with one register, and lanes_registers.h makes the operations of it.
 * A back end (backends/) selects its form by GN_LANES_SSE41, _AVX2, _AVX512, _NEON or
 * _WASM_SIMD128. With none of these, and with GN_LANES_ONE (count.h), the form is portable.
 * Portable lanes are vectors of GNU C where GN_HAVE_VECTORS says so (features.h), otherwise arrays
 * in C99; these may be called with addresses (calls.h). GN_LANES_INTRINSICS_HEADER names a header
 * that emulates the intrinsics of AVX-512, NEON or WebAssembly on other targets
 * (tests/portability). */
#ifndef GN_LANES_LANES_H
#define GN_LANES_LANES_H

#include <stddef.h>
#include <stdint.h>

#include <gnomon/lanes.h>

#include "../config/backends.h"
#include "../config/features.h"
#include "../config/precision.h"
#include "count.h"

#if defined(__wasm_simd128__) && defined(__clang_major__) && __clang_major__ < 16
#error "Clang 14 moves loads past stores with -msimd128 (splats of what is loaded); 16 does not."
#endif

/* Words and shorts of memory that hold values of any type: users' pixels and texels, and floats
 * whose bits are handled as integers. C99 section 6.5 paragraph 7 lets a compiler assume that
 * lvalues of other types do not refer to such an object. Compilers that use this assumption know
 * may_alias. */
#if defined(__GNUC__) || defined(__clang__)
typedef int32_t __attribute__((may_alias)) stored_word;
typedef uint16_t __attribute__((may_alias)) stored_short;

/* Words, shorts and pairs of words at any address. */
typedef int32_t __attribute__((may_alias, aligned(1))) any_word;
typedef uint16_t __attribute__((may_alias, aligned(1))) any_short;
typedef uint64_t __attribute__((may_alias, aligned(1))) any_pair;
#else
typedef int32_t stored_word;
typedef uint16_t stored_short;
#endif

/* Whether the target is known to be little-endian. */
#if defined(__GNUC__) && defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define GN_IS_LITTLE_ENDIAN 1
#else
#define GN_IS_LITTLE_ENDIAN 0
#endif

/* The portable form, if the back end selects no other. */
#if defined(GN_LANES_AVX512) || defined(GN_LANES_AVX2) || defined(GN_LANES_SSE41) ||               \
    defined(GN_LANES_NEON) || defined(GN_LANES_WASM_SIMD128)
#elif GN_HAVE_VECTORS && LANES > 1
#define GN_LANES_VECTORS
#else
#define GN_LANES_ARRAYS
#endif

/* Whether common states of a draw have functions of their own in this back end. In the portable one
 * of x86 they would be 170 KB for processors without SSE4.1 alone, which hardly anyone has. One
 * lane has them for spans (fused.inl). */
#if GN_SPECIALISED && LANES > 1 &&                                                                 \
    !(GN_HAVE_SSE41 == GN_PRESENT_ASKED &&                                                         \
      (defined(GN_LANES_VECTORS) || defined(GN_LANES_ARRAYS)))
#define GN_STATES_SPECIALISED 1
#else
#define GN_STATES_SPECIALISED 0
#endif

#define GN_EACH_LANE(l) for (int l = 0; l < LANES; ++l)

/* Returns how many bits of lanes are set. The builtin is an instruction where __POPCNT__ is
 * defined. */
static inline uint32_t count_lanes(uint32_t bits)
{
#if defined(__POPCNT__)
    return (uint32_t)__builtin_popcount(bits);
#else
    bits = (bits & 0x5555) + (bits >> 1 & 0x5555);
    bits = (bits & 0x3333) + (bits >> 2 & 0x3333);
    bits = (bits & 0x0F0F) + (bits >> 4 & 0x0F0F);
    return (bits & 0x1F) + (bits >> 8);
#endif
}

#if GN_LANES == 1 && !(defined(GN_SMALL) && defined(GN_BASIC))
#error "One lane is for libraries with GN_SMALL and GN_BASIC: others need the lanes of a quad."
#endif

/* GN_INLINE is for functions whose callers pass constants: they are written once and compiled once
 * per state. GN_OUT_OF_LINE is for code in them that is rarely needed. If operations are loops
 * (lanes in arrays) or carry a sanitizer's checks in every lane, forced inlining would take
 * compilers minutes, so the compiler decides. With GN_SMALL there is only one version, out of line
 * like GN_FRAMED, unless operations on one lane are an instruction or two. */
#if defined(__GNUC__)
#if GN_IS_SMALL && LANES > 1
#define GN_INLINE static __attribute__((noinline, unused))
#elif (defined(GN_LANES_ARRAYS) && LANES > 1) || defined(__SANITIZE_ADDRESS__)
#define GN_INLINE static inline
#else
#define GN_INLINE static inline __attribute__((always_inline))
#endif
#define GN_OUT_OF_LINE static __attribute__((noinline, unused))
#else
#define GN_INLINE static inline
#define GN_OUT_OF_LINE static inline
#endif

/* For long functions that several functions call for many triangles or vertices at a time.
 * Compilers would inline them into each of these. */
#if defined(__GNUC__) && !GN_IS_SMALL
#define GN_SHARED static __attribute__((noinline))
#else
#define GN_SHARED static inline
#endif

/* For functions called once a draw or once a round of tasks: small code matters more than speed. */
#if defined(__GNUC__) && !GN_IS_SMALL
#define GN_ONCE static __attribute__((noinline, cold))
#else
#define GN_ONCE static inline
#endif

/* For operations on lanes in registers. An operation of a dozen instructions exceeds a compiler's
 * limits for inlining, and out of line its lanes are passed in memory. */
#if defined(__GNUC__) && !GN_IS_SMALL && !defined(__SANITIZE_ADDRESS__)
#define GN_OPERATION static inline __attribute__((always_inline))
#else
#define GN_OPERATION static inline
#endif

/* Stands before short loops over corners, components and attributes. With one lane, and with lanes
 * in vectors, their values are kept in registers, but gcc sees that only in loops that it has
 * unrolled, and at -O2 it must be asked to unroll. */
#if (LANES == 1 || defined(GN_LANES_VECTORS)) && defined(__GNUC__) && __GNUC__ >= 8 &&             \
    !defined(__clang__)
#define GN_UNROLLED _Pragma("GCC unroll 16")
#else
#define GN_UNROLLED
#endif

/* For parts of long functions: inline, but with GN_SMALL each has a frame of its own. Compilers
 * give every value of lanes in a function its own place in the frame, so one long function needs
 * more stack than any of its parts. */
#if GN_IS_SMALL && defined(__GNUC__)
#define GN_FRAMED static __attribute__((noinline, unused))
#else
#define GN_FRAMED static inline
#endif

/* What lanes_bits returns for a mask of all lanes. */
#define GN_ALL_LANES ((1u << LANES) - 1)

/* The initialiser of an array with a number for each lane: NUMBER(lane). */
#if LANES == 1
#define GN_NUMBERS(NUMBER)                                                                         \
    {                                                                                              \
        NUMBER(0)                                                                                  \
    }
#else
#define GN_NUMBERS(NUMBER)                                                                         \
    {                                                                                              \
        NUMBER(0), NUMBER(1), NUMBER(2), NUMBER(3), NUMBER(4), NUMBER(5), NUMBER(6), NUMBER(7),    \
            NUMBER(8), NUMBER(9), NUMBER(10), NUMBER(11), NUMBER(12), NUMBER(13), NUMBER(14),      \
            NUMBER(15)                                                                             \
    }
#endif

/* Returns the lowest lane that is set. Precondition: one is set. The builtin is an instruction on
 * these targets; on others it may be a call. */
static inline uint32_t first_lane(uint32_t bits)
{
#if defined(__GNUC__) &&                                                                           \
    (defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__wasm__))
    return (uint32_t)__builtin_ctz(bits);
#else
    uint32_t lane = 0;

    while (!(bits >> lane & 1u))
        ++lane;
    return lane;
#endif
}

/* The bits of 255, 2^23 and 2^31. As integers they have the order of the floats. */
#define LANE_BITS_255 0x437F0000
#define LANE_BITS_2_23 0x4B000000
#define LANE_BITS_2_31 0x4F000000

/* The byte orders of shuffles from four pixels of three bytes each to four words, and back. On the
 * side of the pixels a register holds bytes 0 to 7 of the row, then 4 to 11. -1 makes a byte 0. */
#define GN_FROM_THREES 0, 1, 2, -1, 3, 4, 5, -1, 6, 7, 12, -1, 13, 14, 15, -1
#define GN_TO_THREES 0, 1, 2, 4, 5, 6, 8, 9, 5, 6, 8, 9, 10, 12, 13, 14

#if defined(GN_LANES_AVX512)
#include "registers_avx512.h"
#elif defined(GN_LANES_AVX2)
#include "registers_avx2.h"
#elif defined(GN_LANES_SSE41)
#include "registers_sse41.h"
#elif defined(GN_LANES_NEON)
#include "registers_neon.h"
#elif defined(GN_LANES_WASM_SIMD128)
#include "registers_wasm_simd128.h"
#elif defined(GN_LANES_VECTORS)
#include "registers_vectors.h"
#endif

#if defined(LANES_REGISTERS)
#include "lanes_registers.h"
#else
#include "lanes_portable.h"
#if GN_LANES_CALLED && LANES > 1
#include "calls.h"
#endif
#endif

/* GN_INLINE if lanes fill one or two registers. If they fill four, the values of so long a function
 * would leave the registers for memory, so the compiler decides. */
#if defined(LANES_REGISTERS) && LANES_REGISTERS <= 2
#define GN_WIDE_INLINE GN_INLINE
#else
#define GN_WIDE_INLINE static inline
#endif

/* Whether lanes are in registers of x86, not emulated. */
#if (defined(GN_LANES_AVX512) || defined(GN_LANES_AVX2) || defined(GN_LANES_SSE41)) &&             \
    !defined(GN_LANES_INTRINSICS_HEADER)
#define GN_LANES_OF_X86 1
#else
#define GN_LANES_OF_X86 0
#endif

/* Aligns arrays of lanes in local memory to lines of the cache: a vector that lies in two lines
 * takes twice the time. Processors also compare the low bits of addresses to see whether a load
 * depends on a store before it; aligned arrays that are copied are not mistaken for each other. */
#if GN_LANES_OF_X86
#define GN_ALIGNED_LANES __attribute__((aligned(64)))
#else
#define GN_ALIGNED_LANES
#endif

/* Returns a clamped to low..high. */
static inline lanes_i lanes_i_clamp(lanes_i a, lanes_i low, lanes_i high)
{
    a = lanes_i_select(lanes_i_greater(low, a), low, a);
    return lanes_i_select(lanes_i_greater(a, high), high, a);
}

/* Returns a with its sign bit cleared; also for NaN. */
static inline lanes_f lanes_magnitude(lanes_f a)
{
    return lanes_as_float(lanes_i_and(lanes_as_int(a), lanes_i_splat(INT32_MAX)));
}

#endif
