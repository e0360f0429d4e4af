/* Lanes in four SSE2 registers. Conversions return INT32_MIN if out of range, so all results are
 * those of lanes_portable.h. Precondition: MXCSR is in its initial state (round to nearest,
 * denormals kept).
 * Not alone: lanes.h chooses one form and includes it after GN_LANES and GN_EACH_LANE. */
#ifndef GN_LANES_LANES_SSE2_H
#define GN_LANES_LANES_SSE2_H

#include <emmintrin.h>

#include "four_registers.h"

typedef struct lanes_f {
    __m128 q[4];
} lanes_f;

typedef struct lanes_i {
    __m128i q[4];
} lanes_i;

typedef struct lanes_m {
    __m128i q[4];
} lanes_m;

GN_OPERATION lanes_f lanes_load(const float p[GN_LANES])
{
    LANES_EACH_REGISTER(lanes_f, _mm_loadu_ps(p + 4 * n));
}

GN_OPERATION void lanes_store(float *p, lanes_f a)
{
    _mm_storeu_ps(p, a.q[0]);
    _mm_storeu_ps(p + 4, a.q[1]);
    _mm_storeu_ps(p + 8, a.q[2]);
    _mm_storeu_ps(p + 12, a.q[3]);
}

GN_OPERATION lanes_f lanes_splat(float a)
{
    LANES_EACH_REGISTER(lanes_f, _mm_set1_ps(a));
}

GN_OPERATION lanes_f lanes_columns(float per_x, float x, float origin)
{
    const __m128 column = _mm_add_ps(_mm_set1_ps(x), _mm_setr_ps(0.0f, 1.0f, 2.0f, 3.0f));
    const __m128 value = _mm_add_ps(_mm_mul_ps(_mm_set1_ps(per_x), column), _mm_set1_ps(origin));

    LANES_EACH_REGISTER(lanes_f, value);
}

GN_OPERATION lanes_f lanes_rows(float per_y, float y)
{
    LANES_EACH_REGISTER(lanes_f, _mm_set1_ps(per_y * (y + (float)n)));
}

GN_OPERATION lanes_f lanes_add(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm_add_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_sub(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm_sub_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_mul(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm_mul_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_div(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm_div_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_sqrt(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm_sqrt_ps(a.q[n]));
}

GN_OPERATION lanes_m lanes_greater(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, _mm_castps_si128(_mm_cmplt_ps(b.q[n], a.q[n])));
}

GN_OPERATION lanes_m lanes_less_equal(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, _mm_castps_si128(_mm_cmple_ps(a.q[n], b.q[n])));
}

GN_OPERATION lanes_m lanes_and(lanes_m a, lanes_m b)
{
    LANES_EACH_REGISTER(lanes_m, _mm_and_si128(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_not(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_m, _mm_xor_si128(a.q[n], _mm_set1_epi32(-1)));
}

GN_OPERATION uint32_t lanes_bits(lanes_m a)
{
    return (uint32_t)(_mm_movemask_ps(_mm_castsi128_ps(a.q[0])) |
                      _mm_movemask_ps(_mm_castsi128_ps(a.q[1])) << 4 |
                      _mm_movemask_ps(_mm_castsi128_ps(a.q[2])) << 8 |
                      _mm_movemask_ps(_mm_castsi128_ps(a.q[3])) << 12);
}

GN_OPERATION lanes_m lanes_from_bits(uint32_t bits)
{
    const __m128i all = _mm_set1_epi32((int)bits);

    LANES_EACH_REGISTER(
        lanes_m, _mm_cmpeq_epi32(_mm_and_si128(all, _mm_set_epi32(8 << 4 * n, 4 << 4 * n,
                                                                  2 << 4 * n, 1 << 4 * n)),
                                 _mm_set_epi32(8 << 4 * n, 4 << 4 * n, 2 << 4 * n, 1 << 4 * n)));
}

GN_OPERATION lanes_f lanes_select(lanes_m m, lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm_or_ps(_mm_and_ps(_mm_castsi128_ps(m.q[n]), a.q[n]),
                                           _mm_andnot_ps(_mm_castsi128_ps(m.q[n]), b.q[n])));
}

GN_OPERATION lanes_f lanes_min(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm_min_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_max(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm_max_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_splat(int32_t a)
{
    LANES_EACH_REGISTER(lanes_i, _mm_set1_epi32(a));
}

GN_OPERATION lanes_i lanes_i_halves(int32_t lower, int32_t upper)
{
    LANES_EACH_REGISTER(lanes_i, _mm_set1_epi32(n < 2 ? lower : upper));
}

GN_OPERATION lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    const __m128i columns = _mm_setr_epi32(0, per_column, 2 * per_column, 3 * per_column);

    LANES_EACH_REGISTER(lanes_i, _mm_add_epi32(columns, _mm_set1_epi32(n * per_row)));
}

GN_OPERATION lanes_i lanes_i_load(const stored_word *p)
{
    LANES_EACH_REGISTER(lanes_i, _mm_loadu_si128((const __m128i *)(const void *)(p + 4 * n)));
}

GN_OPERATION void lanes_i_store(stored_word *p, lanes_i a)
{
    _mm_storeu_si128((__m128i *)(void *)p, a.q[0]);
    _mm_storeu_si128((__m128i *)(void *)(p + 4), a.q[1]);
    _mm_storeu_si128((__m128i *)(void *)(p + 8), a.q[2]);
    _mm_storeu_si128((__m128i *)(void *)(p + 12), a.q[3]);
}

GN_OPERATION lanes_i lanes_i_add(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_add_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_sub_epi32(a.q[n], b.q[n]));
}

/* Multiplies as unsigned numbers to 64 bits, two at a time; the low halves equal those of signed
 * products. */
GN_OPERATION __m128i lanes_sse2_mul(__m128i a, __m128i b)
{
    const __m128i even = _mm_mul_epu32(a, b);
    const __m128i odd = _mm_mul_epu32(_mm_srli_epi64(a, 32), _mm_srli_epi64(b, 32));

    return _mm_unpacklo_epi32(_mm_shuffle_epi32(even, _MM_SHUFFLE(0, 0, 2, 0)),
                              _mm_shuffle_epi32(odd, _MM_SHUFFLE(0, 0, 2, 0)));
}

GN_OPERATION lanes_i lanes_i_mul(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, lanes_sse2_mul(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul_short(lanes_i a, int32_t b)
{
    const __m128i low = _mm_set1_epi32(b & 0xFFFF); /* pairs of shorts: the upper ones times 0 */

    LANES_EACH_REGISTER(lanes_i, _mm_madd_epi16(a.q[n], low));
}

GN_OPERATION lanes_i lanes_i_mul_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_mullo_epi16(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_high_bytes(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_i, _mm_srli_epi16(a.q[n], 8));
}

GN_OPERATION lanes_i lanes_i_add_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_adds_epu8(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_subs_epu8(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_add_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_adds_epu16(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_subs_epu16(a.q[n], b.q[n]));
}

/* With the halves of a product the sum is low + high + 2^15, of which high gets the carry: one if
 * low + high has one, and one more if bit 15 of what is left is set. */
static inline __m128i lanes_sse2_scale(__m128i a, __m128i b)
{
    const __m128i low = _mm_mullo_epi16(a, b);
    const __m128i high = _mm_mulhi_epu16(a, b);
    const __m128i sum = _mm_add_epi16(low, high);
    const __m128i no_carry = _mm_cmpeq_epi16(_mm_adds_epu16(low, high), sum);

    return _mm_add_epi16(_mm_add_epi16(high, _mm_srli_epi16(sum, 15)),
                         _mm_add_epi16(no_carry, _mm_set1_epi16(1)));
}

GN_OPERATION lanes_i lanes_i_scale_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, lanes_sse2_scale(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_shift_left(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, _mm_slli_epi32(a.q[n], count));
}

GN_OPERATION lanes_i lanes_i_shift_right(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, _mm_srai_epi32(a.q[n], count));
}

GN_OPERATION __m128i lanes_sse2_select(__m128i mask, __m128i a, __m128i b)
{
    return _mm_or_si128(_mm_and_si128(mask, a), _mm_andnot_si128(mask, b));
}

GN_OPERATION lanes_i lanes_i_min(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i,
                        lanes_sse2_select(_mm_cmpgt_epi32(b.q[n], a.q[n]), a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_max(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i,
                        lanes_sse2_select(_mm_cmpgt_epi32(a.q[n], b.q[n]), a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_or(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_or_si128(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_and(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_and_si128(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_xor(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm_xor_si128(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_i_greater(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, _mm_cmpgt_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_i_equal(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, _mm_cmpeq_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_select(lanes_m m, lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(
        lanes_i, _mm_or_si128(_mm_and_si128(m.q[n], a.q[n]), _mm_andnot_si128(m.q[n], b.q[n])));
}

GN_OPERATION lanes_i lanes_m_as_int(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n]);
}

GN_OPERATION uint32_t lanes_i_sign_bits(lanes_i a)
{
    return (uint32_t)(_mm_movemask_ps(_mm_castsi128_ps(a.q[0])) |
                      _mm_movemask_ps(_mm_castsi128_ps(a.q[1])) << 4 |
                      _mm_movemask_ps(_mm_castsi128_ps(a.q[2])) << 8 |
                      _mm_movemask_ps(_mm_castsi128_ps(a.q[3])) << 12);
}

GN_OPERATION lanes_f lanes_to_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, _mm_cvtepi32_ps(a.q[n]));
}

GN_OPERATION lanes_i lanes_as_int(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, _mm_castps_si128(a.q[n]));
}

GN_OPERATION lanes_f lanes_as_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, _mm_castsi128_ps(a.q[n]));
}

GN_OPERATION lanes_i lanes_truncate(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, _mm_cvttps_epi32(a.q[n]));
}

GN_OPERATION __m128 lanes_sse2_floor(__m128 a)
{
    const __m128i truncated = _mm_cvttps_epi32(a);
    const __m128 t = _mm_cvtepi32_ps(truncated);
    const __m128 below = _mm_sub_ps(t, _mm_and_ps(_mm_cmplt_ps(a, t), _mm_set1_ps(1.0f)));
    const __m128 beyond = _mm_castsi128_ps(_mm_cmpeq_epi32(truncated, _mm_set1_epi32(INT32_MIN)));

    return _mm_or_ps(_mm_and_ps(beyond, a), _mm_andnot_ps(beyond, below));
}

GN_OPERATION lanes_f lanes_floor(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, lanes_sse2_floor(a.q[n]));
}

/* Returns the integers below. Numbers that the conversion makes INT32_MIN stay so: the maximum
 * raises those below it, and NaN, to this number. */
GN_OPERATION __m128i lanes_sse2_below(__m128 a)
{
    const __m128 least = _mm_max_ps(a, _mm_set1_ps(-2147483648.0f));
    const __m128i truncated = _mm_cvttps_epi32(least);
    const __m128 is_above = _mm_cmplt_ps(least, _mm_cvtepi32_ps(truncated));

    return _mm_add_epi32(truncated, _mm_castps_si128(is_above));
}

GN_OPERATION lanes_i lanes_sse2_floor_to_int(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, lanes_sse2_below(a.q[n]));
}

GN_OPERATION lanes_f lanes_quad_left(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm_shuffle_ps(a.q[n], a.q[n], _MM_SHUFFLE(2, 2, 0, 0)));
}

GN_OPERATION lanes_f lanes_quad_right(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm_shuffle_ps(a.q[n], a.q[n], _MM_SHUFFLE(3, 3, 1, 1)));
}

GN_OPERATION lanes_f lanes_quad_lower(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n & 2]);
}

GN_OPERATION lanes_f lanes_quad_upper(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n | 1]);
}

GN_OPERATION lanes_i lanes_round(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, _mm_cvtps_epi32(a.q[n]));
}

/* Rounds a channel of eight pixels to units of 1/255. */
GN_OPERATION __m128i lanes_sse2_units(__m128 a, __m128 b)
{
    const __m128 scale = _mm_set1_ps(255.0f);

    return _mm_packs_epi32(_mm_cvtps_epi32(_mm_mul_ps(a, scale)),
                           _mm_cvtps_epi32(_mm_mul_ps(b, scale)));
}

/* Transposes the bytes of eight pixels at a time; the packs saturate. */
GN_OPERATION lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    lanes_i a;

    for (int n = 0; n < 4; n += 2) {
        const __m128i rb = _mm_packus_epi16(lanes_sse2_units(red.q[n], red.q[n + 1]),
                                            lanes_sse2_units(blue.q[n], blue.q[n + 1]));
        const __m128i ga = _mm_packus_epi16(lanes_sse2_units(green.q[n], green.q[n + 1]),
                                            lanes_sse2_units(alpha.q[n], alpha.q[n + 1]));
        const __m128i rg = _mm_unpacklo_epi8(rb, ga);
        const __m128i ba = _mm_unpackhi_epi8(rb, ga);

        a.q[n] = _mm_unpacklo_epi16(rg, ba);
        a.q[n + 1] = _mm_unpackhi_epi16(rg, ba);
    }
    return a;
}

GN_OPERATION lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                        ptrdiff_t stride)
{
    LANES_EACH_REGISTER(
        lanes_i,
        _mm_loadu_si128((const __m128i *)(const void *)((n < 2 ? lower : upper) + n % 2 * stride)));
}

GN_OPERATION void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                      lanes_i a)
{
    _mm_storeu_si128((__m128i *)(void *)lower, a.q[0]);
    _mm_storeu_si128((__m128i *)(void *)(lower + stride), a.q[1]);
    _mm_storeu_si128((__m128i *)(void *)upper, a.q[2]);
    _mm_storeu_si128((__m128i *)(void *)(upper + stride), a.q[3]);
}

/* Loads and transposes rows n * 4 to n * 4 + 3. */
GN_OPERATION void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset,
                                      uint32_t step, lanes_i out[4])
{
    for (int n = 0; n < 4; ++n) {
        __m128 r[4];

        for (int l = 0; l < 4; ++l)
            r[l] = _mm_loadu_ps(
                (const float *)(const void *)(memory + offset[(uint32_t)(4 * n + l) * step]));
        _MM_TRANSPOSE4_PS(r[0], r[1], r[2], r[3]);
        for (int c = 0; c < 4; ++c)
            out[c].q[n] = _mm_castps_si128(r[c]);
    }
}

GN_OPERATION void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    for (int n = 0; n < 4; ++n) {
        __m128 r[4];

        for (int c = 0; c < 4; ++c)
            r[c] = _mm_castsi128_ps(in[c].q[n]);
        _MM_TRANSPOSE4_PS(r[0], r[1], r[2], r[3]);
        for (int l = 0; l < 4; ++l)
            _mm_storeu_ps((float *)(void *)(memory + (size_t)(4 * n + l) * stride), r[l]);
    }
}

/* A byte above the lowest is converted in place, and the factor is smaller by the same power of
 * two, which changes no rounding. */
GN_OPERATION lanes_f lanes_unpack_unorm8(lanes_i packed, int channel)
{
    const float scale = (float)(1.0 / 255.0) / (float)(1 << 8 * (channel % 3));
    const __m128i byte = _mm_set1_epi32(0xFF << 8 * (channel % 3));

    if (channel == 3) {
        LANES_EACH_REGISTER(lanes_f, _mm_mul_ps(_mm_cvtepi32_ps(_mm_srli_epi32(packed.q[n], 24)),
                                                _mm_set1_ps(scale)));
    }
    LANES_EACH_REGISTER(
        lanes_f, _mm_mul_ps(_mm_cvtepi32_ps(_mm_and_si128(packed.q[n], byte)), _mm_set1_ps(scale)));
}

GN_OPERATION __m128i lanes_sse2_gather(const stored_word *base, const int32_t *index)
{
    return _mm_setr_epi32(base[index[0]], base[index[1]], base[index[2]], base[index[3]]);
}

GN_INLINE lanes_i lanes_i_gather(const stored_word *base, lanes_i index)
{
    int32_t at[GN_LANES];

    lanes_i_store(at, index);
    LANES_EACH_REGISTER(lanes_i, lanes_sse2_gather(base, at + 4 * n));
}

/* Loads two pairs of words. */
GN_OPERATION __m128 lanes_sse2_pairs(const stored_word *base, const int32_t *index)
{
    const __m128 low =
        _mm_castsi128_ps(_mm_loadl_epi64((const __m128i *)(const void *)(base + index[0])));

    return _mm_loadh_pi(low, (const __m64 *)(const void *)(base + index[1]));
}

GN_INLINE void lanes_i_gather_pairs(const stored_word *base, lanes_i index, lanes_i *first,
                                    lanes_i *second)
{
    int32_t at[GN_LANES];

    lanes_i_store(at, index);
    for (int n = 0; n < 4; ++n) {
        const __m128 a = lanes_sse2_pairs(base, at + 4 * n);
        const __m128 b = lanes_sse2_pairs(base, at + 4 * n + 2);

        first->q[n] = _mm_castps_si128(_mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)));
        second->q[n] = _mm_castps_si128(_mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)));
    }
}

#endif
