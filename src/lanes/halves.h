/* Lanes of halves, the floats of 16 bits, in the low bits of words:
 *
 *   from_halves   converts to floats; the upper bits of the words must be 0
 *   to_halves     converts from floats, rounding toward zero; the upper bits become 0
 *
 * Only for processors that convert halves. A signalling NaN becomes a quiet one, as in arithmetic,
 * so use the floats only in arithmetic. A NaN keeps its sign and the first bits of its payload. */
#ifndef GN_LANES_HALVES_H
#define GN_LANES_HALVES_H

#include "lanes.h"

#if (defined(GN_LANES_AVX512) || defined(GN_LANES_AVX2)) && GN_LANES_OF_X86
#define GN_LANES_HAVE_HALVES 1
#else
#define GN_LANES_HAVE_HALVES 0
#endif

#if GN_LANES_HAVE_HALVES && defined(GN_LANES_AVX512)

static inline lanes_f lanes_from_halves(lanes_i halves)
{
    LANES_EACH_REGISTER(lanes_f, _mm512_cvtph_ps(_mm512_cvtepi32_epi16(halves.q[n])));
}

static inline lanes_i lanes_to_halves(lanes_f a)
{
    /* With a mask, since the form without one converts -1 to a mask in some headers. */
    LANES_EACH_REGISTER(lanes_i, _mm512_cvtepu16_epi32(_mm512_maskz_cvtps_ph(
                                     0xFFFF, a.q[n], _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC)));
}

#elif GN_LANES_HAVE_HALVES

static inline lanes_f lanes_from_halves(lanes_i halves)
{
    /* The pack works within 128 bits, so it yields rows 0, 2, 1 and 3. */
    const __m256i rows = _mm256_permute4x64_epi64(_mm256_packus_epi32(halves.q[0], halves.q[1]),
                                                  _MM_SHUFFLE(3, 1, 2, 0));
    lanes_f a;

    a.q[0] = _mm256_cvtph_ps(_mm256_castsi256_si128(rows));
    a.q[1] = _mm256_cvtph_ps(_mm256_extracti128_si256(rows, 1));
    return a;
}

static inline lanes_i lanes_to_halves(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_cvtepu16_epi32(_mm256_cvtps_ph(
                                     a.q[n], _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC)));
}

#endif

#endif
