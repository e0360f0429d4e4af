/* AVX2's registers of eight lanes, two rows of a block in each.
 * Not alone: lanes.h chooses one such file; lanes_registers.h says what it defines. */
#ifndef GN_LANES_REGISTERS_AVX2_H
#define GN_LANES_REGISTERS_AVX2_H

#include <immintrin.h>

#define LANES_REGISTERS 2

typedef __m256 register_f;
typedef __m256i register_i, register_m;

#define register_load(p) _mm256_loadu_ps((const float *)(const void *)(p))
#define register_store(p, a) _mm256_storeu_ps((float *)(void *)(p), a)
#define register_i_load(p) _mm256_loadu_si256((const __m256i *)(const void *)(p))
#define register_i_store(p, a) _mm256_storeu_si256((__m256i *)(void *)(p), a)
#define register_splat(a) _mm256_set1_ps(a)
#define register_columns() _mm256_setr_ps(0, 1, 2, 3, 0, 1, 2, 3)
#define register_rows(per_y, y, n) avx2_rows(per_y, y, n)
#define register_add(a, b) _mm256_add_ps(a, b)
#define register_sub(a, b) _mm256_sub_ps(a, b)
#define register_mul(a, b) _mm256_mul_ps(a, b)
#define register_div(a, b) _mm256_div_ps(a, b)
#define register_sqrt(a) _mm256_sqrt_ps(a)
#define register_min(a, b) _mm256_min_ps(a, b)
#define register_max(a, b) _mm256_max_ps(a, b)
#define register_greater(a, b) _mm256_castps_si256(_mm256_cmp_ps(a, b, _CMP_GT_OQ))
#define register_less_equal(a, b) _mm256_castps_si256(_mm256_cmp_ps(a, b, _CMP_LE_OQ))
#define register_and(a, b) _mm256_and_si256(a, b)
#define register_not(a) _mm256_xor_si256(a, _mm256_set1_epi32(-1))
#define register_select(m, a, b) _mm256_blendv_ps(b, a, _mm256_castsi256_ps(m))
#define register_from_bits(bits, n) avx2_from_bits(bits, n)
#define register_m_as_int(a) (a)
#define register_negative(a) (a) /* registers_bits reads only the sign */
#define register_truncate(a) _mm256_cvttps_epi32(a)
#define register_round(a) _mm256_cvtps_epi32(a)
#define register_floor(a) _mm256_floor_ps(a)
#define register_floor_to_int(a) _mm256_cvttps_epi32(_mm256_floor_ps(a))
#define register_to_float(a) _mm256_cvtepi32_ps(a)
#define register_as_int(a) _mm256_castps_si256(a)
#define register_as_float(a) _mm256_castsi256_ps(a)
#define register_quad_left(a) _mm256_moveldup_ps(a)
#define register_quad_right(a) _mm256_movehdup_ps(a)
#define register_quad_lower(a) _mm256_permute2f128_ps(a, a, 0x00)
#define register_quad_upper(a) _mm256_permute2f128_ps(a, a, 0x11)
#define register_i_splat(a) _mm256_set1_epi32(a)
#define register_i_columns(a)                                                                      \
    _mm256_mullo_epi32(_mm256_set1_epi32(a), _mm256_setr_epi32(0, 1, 2, 3, 0, 1, 2, 3))
#define register_i_rows(per_row, n) avx2_i_rows(per_row, n)
#define register_i_add(a, b) _mm256_add_epi32(a, b)
#define register_i_sub(a, b) _mm256_sub_epi32(a, b)
#define register_i_mul(a, b) _mm256_mullo_epi32(a, b)
#define register_i_or(a, b) _mm256_or_si256(a, b)
#define register_i_and(a, b) _mm256_and_si256(a, b)
#define register_i_xor(a, b) _mm256_xor_si256(a, b)
#define register_i_mul_shorts(a, b) _mm256_mullo_epi16(a, b)
#define register_i_high_bytes(a) _mm256_srli_epi16(a, 8)
#define register_i_add_bytes(a, b) _mm256_adds_epu8(a, b)
#define register_i_sub_bytes(a, b) _mm256_subs_epu8(a, b)
#define register_i_add_shorts(a, b) _mm256_adds_epu16(a, b)
#define register_i_sub_shorts(a, b) _mm256_subs_epu16(a, b)
#define register_i_scale_shorts(a, b) avx2_scale_shorts(a, b)
#define register_i_shift_left(a, count) _mm256_slli_epi32(a, count)
#define register_i_shift_right(a, count) _mm256_srai_epi32(a, count)
#define register_i_shift_right_logical(a, count) _mm256_srli_epi32(a, count)
#define register_i_min(a, b) _mm256_min_epi32(a, b)
#define register_i_max(a, b) _mm256_max_epi32(a, b)
#define register_i_select(m, a, b) _mm256_blendv_epi8(b, a, m)
#define register_i_greater(a, b) _mm256_cmpgt_epi32(a, b)
#define register_i_equal(a, b) _mm256_cmpeq_epi32(a, b)
#define register_i_load_rows(ROW) avx2_load_rows(ROW(0), ROW(1))
#define register_i_store_rows(ROW, a) avx2_store_rows(ROW(0), ROW(1), a)
#define register_i_load_rows_of_bytes(ROW) avx2_load_bytes(ROW(0), ROW(1))
#define register_i_store_rows_of_bytes(ROW, a) avx2_store_bytes(ROW(0), ROW(1), a)
#define register_i_load_rows_of_shorts(ROW) avx2_load_shorts(ROW(0), ROW(1))
#define register_i_store_rows_of_shorts(ROW, a) avx2_store_shorts(ROW(0), ROW(1), a)
#define register_i_load_rows_of_threes(ROW) avx2_load_threes(ROW(0), ROW(1))
#define register_i_store_rows_of_threes(ROW, a) avx2_store_threes(ROW(0), ROW(1), a)
#define register_load_pairs(AT, first)                                                             \
    avx2_load_pairs(AT(first), AT((first) + 1), AT((first) + 4), AT((first) + 5))
#define register_even(a, b) _mm256_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0))
#define register_odd(a, b) _mm256_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1))
#define register_shuffle(a, b, i, j, k, l) _mm256_shuffle_ps(a, b, _MM_SHUFFLE(l, k, j, i))
#define register_spread(a, i) _mm256_permute_ps(a, _MM_SHUFFLE(i, i, i, i))
#define register_splat_vec4(p) _mm256_broadcast_ps((const __m128 *)(const void *)(p))
#define register_i_interleave_low(a, b)                                                            \
    _mm256_castps_si256(_mm256_unpacklo_ps(_mm256_castsi256_ps(a), _mm256_castsi256_ps(b)))
#define register_i_interleave_high(a, b)                                                           \
    _mm256_castps_si256(_mm256_unpackhi_ps(_mm256_castsi256_ps(a), _mm256_castsi256_ps(b)))
#define register_i_set(NUMBER)                                                                     \
    _mm256_setr_epi32(NUMBER(0), NUMBER(1), NUMBER(2), NUMBER(3), NUMBER(4), NUMBER(5), NUMBER(6), \
                      NUMBER(7))
#define register_indices(at, index) avx2_indices(at, index)
#define register_i_pack_words(a, b) _mm256_packs_epi32(a, b)
#define register_i_pack_shorts(a, b) _mm256_packus_epi16(a, b)
#define register_i_transpose_bytes(a) _mm256_shuffle_epi8(a, avx2_transposed())

/* b's upper half is 0, so each sum of two products is one product. */
#define register_i_mul_short(a, b) _mm256_madd_epi16(a, _mm256_set1_epi32((b)&0xFFFF))

#define avx2_bits(a, n) (uint32_t) _mm256_movemask_ps(_mm256_castsi256_ps(a)) << 8 * (n)
#define registers_bits(q) (avx2_bits(q[0], 0) | avx2_bits(q[1], 1))

GN_OPERATION __m256 avx2_rows(float per_y, float y, int n)
{
    return _mm256_mul_ps(
        _mm256_set1_ps(per_y),
        _mm256_add_ps(_mm256_set1_ps(y + (float)(2 * n)), _mm256_setr_ps(0, 0, 0, 0, 1, 1, 1, 1)));
}

GN_OPERATION __m256i avx2_i_rows(int32_t per_row, int n)
{
    const __m256i row = _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1);

    return _mm256_mullo_epi32(_mm256_set1_epi32(per_row),
                              _mm256_add_epi32(row, _mm256_set1_epi32(2 * n)));
}

GN_OPERATION __m256i avx2_from_bits(uint32_t bits, int n)
{
    const __m256i one = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);

    return _mm256_cmpeq_epi32(
        _mm256_and_si256(_mm256_srli_epi32(_mm256_set1_epi32((int)bits), 8 * n), one), one);
}

/* For a product high * 2^16 + low the result is high + (low + high + 2^15) / 2^16. The quotient is
 * the carry of low + high, plus bit 15 of the sum without the carry. */
static inline __m256i avx2_scale_shorts(__m256i a, __m256i b)
{
    const __m256i low = _mm256_mullo_epi16(a, b);
    const __m256i high = _mm256_mulhi_epu16(a, b);
    const __m256i sum = _mm256_add_epi16(low, high);
    const __m256i no_carry = _mm256_cmpeq_epi16(_mm256_adds_epu16(low, high), sum);

    return _mm256_add_epi16(_mm256_add_epi16(high, _mm256_srli_epi16(sum, 15)),
                            _mm256_add_epi16(no_carry, _mm256_set1_epi16(1)));
}

GN_OPERATION __m256i avx2_transposed(void)
{
    return _mm256_setr_epi8(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15, 0, 4, 8, 12, 1, 5,
                            9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
}

GN_OPERATION __m256i avx2_load_rows(const void *first, const void *second)
{
    const __m128i low = _mm_loadu_si128((const __m128i *)first);
    const __m128i high = _mm_loadu_si128((const __m128i *)second);

    return _mm256_inserti128_si256(_mm256_castsi128_si256(low), high, 1);
}

GN_OPERATION void avx2_store_rows(void *first, void *second, __m256i a)
{
    _mm_storeu_si128((__m128i *)first, _mm256_castsi256_si128(a));
    _mm_storeu_si128((__m128i *)second, _mm256_extracti128_si256(a, 1));
}

/* Extracts the indices two at a time, which takes fewer operations than one at a time. */
GN_OPERATION void avx2_indices(int32_t *at, __m256i index)
{
    for (int n = 0; n < 2; ++n) {
        const __m128i part = n ? _mm256_extracti128_si256(index, 1) : _mm256_castsi256_si128(index);
        const int64_t low = _mm_cvtsi128_si64(part);
        const int64_t high = _mm_extract_epi64(part, 1);

        at[4 * n] = (int32_t)low;
        at[4 * n + 1] = (int32_t)(low >> 32);
        at[4 * n + 2] = (int32_t)high;
        at[4 * n + 3] = (int32_t)(high >> 32);
    }
}

GN_OPERATION __m128 avx2_load_row_of_pairs(const void *first, const void *second)
{
    const __m128 low = _mm_castsi128_ps(_mm_loadl_epi64((const __m128i *)first));

    return _mm_loadh_pi(low, (const __m64 *)second);
}

GN_OPERATION __m256 avx2_load_pairs(const void *a, const void *b, const void *c, const void *d)
{
    return _mm256_insertf128_ps(_mm256_castps128_ps256(avx2_load_row_of_pairs(a, b)),
                                avx2_load_row_of_pairs(c, d), 1);
}

/* Rows of four pixels, of one, two and three bytes. */

GN_OPERATION __m256i avx2_load_bytes(const void *first, const void *second)
{
    return _mm256_cvtepu8_epi32(_mm_unpacklo_epi32(_mm_cvtsi32_si128(*(const any_word *)first),
                                                   _mm_cvtsi32_si128(*(const any_word *)second)));
}

GN_OPERATION void avx2_store_bytes(void *first, void *second, __m256i a)
{
    const __m256i bytes = register_i_transpose_bytes(a);

    *(any_word *)first = _mm_cvtsi128_si32(_mm256_castsi256_si128(bytes));
    *(any_word *)second = _mm_cvtsi128_si32(_mm256_extracti128_si256(bytes, 1));
}

GN_OPERATION __m256i avx2_load_shorts(const void *first, const void *second)
{
    return _mm256_cvtepu16_epi32(_mm_castps_si128(avx2_load_row_of_pairs(first, second)));
}

GN_OPERATION void avx2_store_shorts(void *first, void *second, __m256i a)
{
    const __m256i order = _mm256_broadcastsi128_si256(
        _mm_setr_epi8(0, 1, 4, 5, 8, 9, 12, 13, -1, -1, -1, -1, -1, -1, -1, -1));
    const __m256i shorts = _mm256_shuffle_epi8(a, order);

    _mm_storel_epi64((__m128i *)first, _mm256_castsi256_si128(shorts));
    _mm_storel_epi64((__m128i *)second, _mm256_extracti128_si256(shorts, 1));
}

GN_OPERATION __m256i avx2_load_threes(const unsigned char *first, const unsigned char *second)
{
    return _mm256_shuffle_epi8(
        _mm256_castps_si256(avx2_load_pairs(first, first + 4, second, second + 4)),
        _mm256_broadcastsi128_si256(_mm_setr_epi8(GN_FROM_THREES)));
}

GN_OPERATION void avx2_store_threes(unsigned char *first, unsigned char *second, __m256i a)
{
    const __m256i bytes =
        _mm256_shuffle_epi8(a, _mm256_broadcastsi128_si256(_mm_setr_epi8(GN_TO_THREES)));
    const __m128 low = _mm_castsi128_ps(_mm256_castsi256_si128(bytes));
    const __m128 high = _mm_castsi128_ps(_mm256_extracti128_si256(bytes, 1));

    _mm_storel_pi((__m64 *)(void *)first, low);
    _mm_storeh_pi((__m64 *)(void *)(first + 4), low);
    _mm_storel_pi((__m64 *)(void *)second, high);
    _mm_storeh_pi((__m64 *)(void *)(second + 4), high);
}

#endif
