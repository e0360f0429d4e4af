/* Intrinsics that the test machine may lack, emulated by SIMDe. Given to the library as
 * GN_LANES_INTRINSICS_HEADER, this header makes the back ends of AVX-512, NEON and WebAssembly run
 * on any x86. Intrinsics that SIMDe 0.7.4 lacks are implemented here with SSE2 instructions, by the
 * manuals. */
#ifndef PORTABILITY_EMULATED_H
#define PORTABILITY_EMULATED_H

#if !defined(__SSE2__)
#error "Emulation is for x86: elsewhere the stand-ins below would have to be others."
#endif

#define SIMDE_ENABLE_NATIVE_ALIASES

#if defined(GN_LANES_AVX512)
#include <simde/x86/avx512.h>

#include <stddef.h>
#include <string.h>

typedef simde__mmask16 __mmask16;

/* Intel SDM volume 2: VCVTTPS2DQ, VCVTPS2DQ and VCVTDQ2PS do in each lane what the SSE2 forms
 * do. */
static inline __m512i emulated_cvttps(__m512 a)
{
    simde__m512_private in = simde__m512_to_private(a);
    simde__m512i_private out;

    for (int n = 0; n < 4; ++n)
        out.m128i[n] = _mm_cvttps_epi32(in.m128[n]);
    return simde__m512i_from_private(out);
}

static inline __m512i emulated_cvtps(__m512 a)
{
    simde__m512_private in = simde__m512_to_private(a);
    simde__m512i_private out;

    for (int n = 0; n < 4; ++n)
        out.m128i[n] = _mm_cvtps_epi32(in.m128[n]);
    return simde__m512i_from_private(out);
}

static inline __m512 emulated_cvtepi32(__m512i a)
{
    simde__m512i_private in = simde__m512i_to_private(a);
    simde__m512_private out;

    for (int n = 0; n < 4; ++n)
        out.m128[n] = _mm_cvtepi32_ps(in.m128i[n]);
    return simde__m512_from_private(out);
}

/* VPSRAD does in each part of 128 bits what PSRAD does. */
static inline __m512i emulated_sra(__m512i a, __m128i count)
{
    simde__m512i_private in = simde__m512i_to_private(a);

    for (int n = 0; n < 4; ++n)
        in.m128i[n] = _mm_sra_epi32(in.m128i[n], count);
    return simde__m512i_from_private(in);
}

/* VPMULHUW does in each part of 128 bits what PMULHUW does. */
static inline __m512i emulated_mulhi(__m512i a, __m512i b)
{
    simde__m512i_private x = simde__m512i_to_private(a);
    simde__m512i_private y = simde__m512i_to_private(b);

    for (int n = 0; n < 4; ++n)
        x.m128i[n] = _mm_mulhi_epu16(x.m128i[n], y.m128i[n]);
    return simde__m512i_from_private(x);
}

/* VRNDSCALEPS to whole numbers, downward, the only form that is used; SIMDe 0.7.4 returns 20.5 for
 * 20.5. From 2^31 on, and for NaN, the conversion returns INT32_MIN. */
static inline __m512 emulated_floor(__m512 a)
{
    simde__m512_private x = simde__m512_to_private(a);

    for (int n = 0; n < 4; ++n) {
        const __m128i whole = _mm_cvttps_epi32(x.m128[n]);
        const __m128 t = _mm_cvtepi32_ps(whole);
        const __m128 up = _mm_and_ps(_mm_cmplt_ps(x.m128[n], t), _mm_set1_ps(1.0f));
        const __m128 kept = _mm_castsi128_ps(_mm_cmpeq_epi32(whole, _mm_set1_epi32(INT32_MIN)));

        x.m128[n] = _mm_or_ps(_mm_and_ps(kept, x.m128[n]), _mm_andnot_ps(kept, _mm_sub_ps(t, up)));
    }
    return simde__m512_from_private(x);
}

/* VPGATHERDD and VPGATHERDQ, indices in units of `scale` bytes. */
static inline __m512i emulated_gather(__m512i index, const void *base, int scale)
{
    simde__m512i_private at = simde__m512i_to_private(index);

    for (int l = 0; l < 16; ++l)
        memcpy(&at.i32[l], (const char *)base + (ptrdiff_t)at.i32[l] * scale, sizeof at.i32[l]);
    return simde__m512i_from_private(at);
}

static inline __m512i emulated_gather_pairs(__m256i index, const void *base, int scale)
{
    const simde__m256i_private at = simde__m256i_to_private(index);
    simde__m512i_private out;

    for (int l = 0; l < 8; ++l)
        memcpy(&out.i64[l], (const char *)base + (ptrdiff_t)at.i32[l] * scale, sizeof out.i64[l]);
    return simde__m512i_from_private(out);
}

#define _mm512_i32gather_epi32(index, base, scale) emulated_gather(index, base, scale)
#define _mm512_i32gather_epi64(index, base, scale) emulated_gather_pairs(index, base, scale)
/* What a version of SIMDe has itself is replaced too, so that every version emulates the same. */
#undef _mm512_roundscale_ps
#undef _mm512_cvttps_epi32
#undef _mm512_cvtps_epi32
#undef _mm512_cvtepi32_ps
#define _mm512_roundscale_ps(a, downward) emulated_floor(a)
#ifndef _MM_FROUND_TO_NEG_INF
#define _MM_FROUND_TO_NEG_INF SIMDE_MM_FROUND_TO_NEG_INF
#endif
#ifndef _MM_FROUND_NO_EXC
#define _MM_FROUND_NO_EXC SIMDE_MM_FROUND_NO_EXC
#endif
#define _mm512_mulhi_epu16(a, b) emulated_mulhi(a, b)
#define _mm512_sra_epi32(a, count) emulated_sra(a, count)
#define _mm512_cvttps_epi32(a) emulated_cvttps(a)
#define _mm512_cvtps_epi32(a) emulated_cvtps(a)
#define _mm512_cvtepi32_ps(a) emulated_cvtepi32(a)

#elif defined(GN_LANES_NEON)
#include <simde/arm/neon.h>

static inline float32x4_t emulated_div(float32x4_t a, float32x4_t b)
{
    simde_float32x4_private x = simde_float32x4_to_private(a);
    simde_float32x4_private y = simde_float32x4_to_private(b);

    x.m128 = _mm_div_ps(x.m128, y.m128);
    return simde_float32x4_from_private(x);
}

static inline float32x4_t emulated_sqrt(float32x4_t a)
{
    simde_float32x4_private x = simde_float32x4_to_private(a);

    x.m128 = _mm_sqrt_ps(x.m128);
    return simde_float32x4_from_private(x);
}

/* Arm ARM, FPToFixed with FPRounding_TIEEVEN: saturates; NaN becomes 0. */
static inline int32x4_t emulated_cvtn(float32x4_t a)
{
    simde_float32x4_private in = simde_float32x4_to_private(a);
    simde_int32x4_private out;
    const __m128i high = _mm_castps_si128(_mm_cmpge_ps(in.m128, _mm_set1_ps(2147483648.0f)));
    const __m128i number = _mm_castps_si128(_mm_cmpord_ps(in.m128, in.m128));

    out.m128i = _mm_and_si128(_mm_xor_si128(_mm_cvtps_epi32(in.m128), high), number);
    return simde_int32x4_from_private(out);
}

static inline uint8x16_t emulated_qmovun_high(uint8x8_t low, int16x8_t high)
{
    return simde_vcombine_u8(low, simde_vqmovun_s16(high));
}

#undef vdivq_f32
#undef vsqrtq_f32
#undef vcvtnq_s32_f32
#undef vqmovun_high_s16
#define vdivq_f32(a, b) emulated_div(a, b)
#define vsqrtq_f32(a) emulated_sqrt(a)
#define vcvtnq_s32_f32(a) emulated_cvtn(a)
#define vqmovun_high_s16(low, high) emulated_qmovun_high(low, high)

#elif defined(GN_LANES_WASM_SIMD128)
#include <simde/wasm/simd128.h>
#endif

#endif
