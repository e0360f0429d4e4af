/* SSE4.1's registers of four lanes, with the instructions of SSE3 and SSSE3. Conversions return
 * INT32_MIN if out of range; min and max return their second operand if either is NaN.
 * Precondition: MXCSR is in its initial state (round to nearest, denormals kept).
 * Not alone: lanes.h chooses one such file; lanes_registers.h says what it defines. */
#ifndef GN_LANES_REGISTERS_SSE41_H
#define GN_LANES_REGISTERS_SSE41_H

#include <smmintrin.h>

#define LANES_REGISTERS 4

typedef __m128 register_f;
typedef __m128i register_i, register_m;

#define register_load(p) _mm_loadu_ps((const float *)(const void *)(p))
#define register_store(p, a) _mm_storeu_ps((float *)(void *)(p), a)
#define register_i_load(p) _mm_loadu_si128((const __m128i *)(const void *)(p))
#define register_i_store(p, a) _mm_storeu_si128((__m128i *)(void *)(p), a)
#define register_splat(a) _mm_set1_ps(a)
#define register_columns() _mm_setr_ps(0.0f, 1.0f, 2.0f, 3.0f)
#define register_rows(per_y, y, n) _mm_set1_ps((per_y) * ((y) + (float)(n)))
#define register_add(a, b) _mm_add_ps(a, b)
#define register_sub(a, b) _mm_sub_ps(a, b)
#define register_mul(a, b) _mm_mul_ps(a, b)
#define register_div(a, b) _mm_div_ps(a, b)
#define register_sqrt(a) _mm_sqrt_ps(a)
#define register_min(a, b) _mm_min_ps(a, b)
#define register_max(a, b) _mm_max_ps(a, b)
#define register_greater(a, b) _mm_castps_si128(_mm_cmplt_ps(b, a))
#define register_less_equal(a, b) _mm_castps_si128(_mm_cmple_ps(a, b))
#define register_and(a, b) _mm_and_si128(a, b)
#define register_not(a) _mm_xor_si128(a, _mm_set1_epi32(-1))
#define register_select(m, a, b) _mm_blendv_ps(b, a, _mm_castsi128_ps(m))
#define register_from_bits(bits, n) sse41_from_bits(bits, n)
#define register_m_as_int(a) (a)
#define register_negative(a) (a) /* registers_bits reads only the sign */
#define register_truncate(a) _mm_cvttps_epi32(a)
#define register_round(a) _mm_cvtps_epi32(a)
#define register_floor(a) _mm_floor_ps(a)
#define register_floor_to_int(a) _mm_cvttps_epi32(_mm_floor_ps(a))
#define register_to_float(a) _mm_cvtepi32_ps(a)
#define register_as_int(a) _mm_castps_si128(a)
#define register_as_float(a) _mm_castsi128_ps(a)
#define register_quad_left(a) _mm_moveldup_ps(a)
#define register_quad_right(a) _mm_movehdup_ps(a)
#define register_i_splat(a) _mm_set1_epi32(a)
#define register_i_columns(a) _mm_setr_epi32(0, a, 2 * (a), 3 * (a))
#define register_i_rows(per_row, n) _mm_set1_epi32((n) * (per_row))
#define register_i_add(a, b) _mm_add_epi32(a, b)
#define register_i_sub(a, b) _mm_sub_epi32(a, b)
#define register_i_mul(a, b) _mm_mullo_epi32(a, b)
#define register_i_or(a, b) _mm_or_si128(a, b)
#define register_i_and(a, b) _mm_and_si128(a, b)
#define register_i_xor(a, b) _mm_xor_si128(a, b)
#define register_i_mul_shorts(a, b) _mm_mullo_epi16(a, b)
#define register_i_high_bytes(a) _mm_srli_epi16(a, 8)
#define register_i_add_bytes(a, b) _mm_adds_epu8(a, b)
#define register_i_sub_bytes(a, b) _mm_subs_epu8(a, b)
#define register_i_add_shorts(a, b) _mm_adds_epu16(a, b)
#define register_i_sub_shorts(a, b) _mm_subs_epu16(a, b)
#define register_i_scale_shorts(a, b) sse41_scale_shorts(a, b)
#define register_i_shift_left(a, count) _mm_slli_epi32(a, count)
#define register_i_shift_right(a, count) _mm_srai_epi32(a, count)
#define register_i_shift_right_logical(a, count) _mm_srli_epi32(a, count)
#define register_i_min(a, b) _mm_min_epi32(a, b)
#define register_i_max(a, b) _mm_max_epi32(a, b)
#define register_i_select(m, a, b) _mm_blendv_epi8(b, a, m)
#define register_i_greater(a, b) _mm_cmpgt_epi32(a, b)
#define register_i_equal(a, b) _mm_cmpeq_epi32(a, b)
#define register_i_load_rows(ROW) register_i_load(ROW(0))
#define register_i_store_rows(ROW, a) register_i_store(ROW(0), a)
#define register_i_load_rows_of_bytes(ROW) sse41_load_bytes(ROW(0))
#define register_i_store_rows_of_bytes(ROW, a) sse41_store_bytes(ROW(0), a)
#define register_i_load_rows_of_shorts(ROW) sse41_load_shorts(ROW(0))
#define register_i_store_rows_of_shorts(ROW, a) sse41_store_shorts(ROW(0), a)
#define register_i_load_rows_of_threes(ROW) sse41_load_threes(ROW(0))
#define register_i_store_rows_of_threes(ROW, a) sse41_store_threes(ROW(0), a)
#define register_load_pairs(AT, first) sse41_load_pairs(AT(first), AT((first) + 1))
#define register_even(a, b) _mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0))
#define register_odd(a, b) _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1))
#define register_shuffle(a, b, i, j, k, l) _mm_shuffle_ps(a, b, _MM_SHUFFLE(l, k, j, i))
#define register_spread(a, i) _mm_shuffle_ps(a, a, _MM_SHUFFLE(i, i, i, i))
#define register_splat_vec4(p) _mm_loadu_ps(p)
#define register_i_interleave_low(a, b)                                                            \
    _mm_castps_si128(_mm_unpacklo_ps(_mm_castsi128_ps(a), _mm_castsi128_ps(b)))
#define register_i_interleave_high(a, b)                                                           \
    _mm_castps_si128(_mm_unpackhi_ps(_mm_castsi128_ps(a), _mm_castsi128_ps(b)))
#define register_i_set(NUMBER) _mm_setr_epi32(NUMBER(0), NUMBER(1), NUMBER(2), NUMBER(3))
#define register_indices(at, index) register_i_store(at, index)
#define register_i_pack_words(a, b) _mm_packs_epi32(a, b)
#define register_i_pack_shorts(a, b) _mm_packus_epi16(a, b)
#define register_i_transpose_bytes(a)                                                              \
    _mm_shuffle_epi8(a, _mm_setr_epi8(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15))

/* b's upper half is 0, so each sum of two products is one product. */
#define register_i_mul_short(a, b) _mm_madd_epi16(a, _mm_set1_epi32((b)&0xFFFF))

#define sse41_bits(a, n) (uint32_t) _mm_movemask_ps(_mm_castsi128_ps(a)) << 4 * (n)
#define registers_bits(q)                                                                          \
    (sse41_bits(q[0], 0) | sse41_bits(q[1], 1) | sse41_bits(q[2], 2) | sse41_bits(q[3], 3))

GN_OPERATION __m128i sse41_from_bits(uint32_t bits, int n)
{
    const __m128i lane = _mm_set_epi32(8 << 4 * n, 4 << 4 * n, 2 << 4 * n, 1 << 4 * n);

    return _mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32((int)bits), lane), lane);
}

/* For a product high * 2^16 + low the result is high + (low + high + 2^15) / 2^16. The quotient is
 * the carry of low + high, plus bit 15 of the sum without the carry. */
static inline __m128i sse41_scale_shorts(__m128i a, __m128i b)
{
    const __m128i low = _mm_mullo_epi16(a, b);
    const __m128i high = _mm_mulhi_epu16(a, b);
    const __m128i sum = _mm_add_epi16(low, high);
    const __m128i no_carry = _mm_cmpeq_epi16(_mm_adds_epu16(low, high), sum);

    return _mm_add_epi16(_mm_add_epi16(high, _mm_srli_epi16(sum, 15)),
                         _mm_add_epi16(no_carry, _mm_set1_epi16(1)));
}

GN_OPERATION __m128 sse41_load_pairs(const void *first, const void *second)
{
    const __m128 low = _mm_castsi128_ps(_mm_loadl_epi64((const __m128i *)first));

    return _mm_loadh_pi(low, (const __m64 *)second);
}

/* Rows of four pixels, of one, two and three bytes. */

GN_OPERATION __m128i sse41_load_bytes(const void *row)
{
    return _mm_cvtepu8_epi32(_mm_cvtsi32_si128(*(const any_word *)row));
}

GN_OPERATION void sse41_store_bytes(void *row, __m128i a)
{
    *(any_word *)row = _mm_cvtsi128_si32(register_i_transpose_bytes(a));
}

GN_OPERATION __m128i sse41_load_shorts(const void *row)
{
    return _mm_cvtepu16_epi32(_mm_loadl_epi64((const __m128i *)row));
}

GN_OPERATION void sse41_store_shorts(void *row, __m128i a)
{
    const __m128i order = _mm_setr_epi8(0, 1, 4, 5, 8, 9, 12, 13, -1, -1, -1, -1, -1, -1, -1, -1);

    _mm_storel_epi64((__m128i *)row, _mm_shuffle_epi8(a, order));
}

GN_OPERATION __m128i sse41_load_threes(const unsigned char *row)
{
    return _mm_shuffle_epi8(_mm_castps_si128(sse41_load_pairs(row, row + 4)),
                            _mm_setr_epi8(GN_FROM_THREES));
}

GN_OPERATION void sse41_store_threes(unsigned char *row, __m128i a)
{
    const __m128i bytes = _mm_shuffle_epi8(a, _mm_setr_epi8(GN_TO_THREES));

    _mm_storel_epi64((__m128i *)(void *)row, bytes);
    _mm_storeh_pi((__m64 *)(void *)(row + 4), _mm_castsi128_ps(bytes));
}

#endif
