/* AVX-512's registers of sixteen lanes, with the rows of a block in their four 128-bit parts, and
 * masks in mask registers (AVX-512 F, BW, DQ and VL). Conversions return INT32_MIN if out of range;
 * min and max return their second operand if either is NaN (Intel SDM volume 1, section 11.5.2).
 * Not alone: lanes.h chooses one such file; lanes_registers.h says what it defines. */
#ifndef GN_LANES_REGISTERS_AVX512_H
#define GN_LANES_REGISTERS_AVX512_H

#if defined(GN_LANES_INTRINSICS_HEADER)
#include GN_LANES_INTRINSICS_HEADER
#else
#include <immintrin.h>
#endif

#define LANES_REGISTERS 1

typedef __m512 register_f;
typedef __m512i register_i;
typedef __mmask16 register_m;

#define register_load(p) _mm512_loadu_ps(p)
#define register_store(p, a) _mm512_storeu_ps(p, a)
#define register_i_load(p) _mm512_loadu_si512(p)
#define register_i_store(p, a) _mm512_storeu_si512(p, a)
#define register_splat(a) _mm512_set1_ps(a)
#define register_columns() _mm512_setr_ps(0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3)
#define register_rows(per_y, y, n) avx512_rows(per_y, y)
#define register_add(a, b) _mm512_add_ps(a, b)
#define register_sub(a, b) _mm512_sub_ps(a, b)
#define register_mul(a, b) _mm512_mul_ps(a, b)
#define register_div(a, b) _mm512_div_ps(a, b)
#define register_sqrt(a) _mm512_sqrt_ps(a)
#define register_min(a, b) _mm512_min_ps(a, b)
#define register_max(a, b) _mm512_max_ps(a, b)
#define register_greater(a, b) _mm512_cmp_ps_mask(a, b, _CMP_GT_OQ)
#define register_less_equal(a, b) _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ)
#define register_and(a, b) (register_m)((uint32_t)(a) & (b))
#define register_not(a) (register_m)((a) ^ GN_ALL_LANES)
#define register_select(m, a, b) _mm512_mask_blend_ps(m, b, a)
#define register_from_bits(bits, n) (register_m)(bits)
#define register_m_as_int(a) _mm512_movm_epi32(a)
#define register_negative(a) _mm512_movepi32_mask(a)
#define register_truncate(a) _mm512_cvttps_epi32(a)
#define register_round(a) _mm512_cvtps_epi32(a)
#define register_floor(a) _mm512_floor_ps(a)
#define register_floor_to_int(a) _mm512_cvttps_epi32(_mm512_floor_ps(a))
#define register_to_float(a) _mm512_cvtepi32_ps(a)
#define register_as_int(a) _mm512_castps_si512(a)
#define register_as_float(a) _mm512_castsi512_ps(a)
#define register_quad_left(a) avx512_permuted(a, 0, 0, 2, 2, 4, 4, 6, 6)
#define register_quad_right(a) avx512_permuted(a, 1, 1, 3, 3, 5, 5, 7, 7)
#define register_quad_lower(a) avx512_permuted(a, 0, 1, 2, 3, 0, 1, 2, 3)
#define register_quad_upper(a) avx512_permuted(a, 4, 5, 6, 7, 4, 5, 6, 7)
#define register_i_splat(a) _mm512_set1_epi32(a)
#define register_i_columns(a)                                                                      \
    _mm512_mullo_epi32(_mm512_set1_epi32(a),                                                       \
                       _mm512_setr_epi32(0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3))
#define register_i_rows(per_row, n)                                                                \
    _mm512_mullo_epi32(_mm512_set1_epi32(per_row),                                                 \
                       _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3))
#define register_i_splat_two(lower, upper)                                                         \
    _mm512_inserti32x8(_mm512_set1_epi32(lower), _mm256_set1_epi32(upper), 1)
#define register_i_add(a, b) _mm512_add_epi32(a, b)
#define register_i_sub(a, b) _mm512_sub_epi32(a, b)
#define register_i_mul(a, b) _mm512_mullo_epi32(a, b)
#define register_i_mul_short(a, b) _mm512_mullo_epi32(a, _mm512_set1_epi32(b))
#define register_i_or(a, b) _mm512_or_si512(a, b)
#define register_i_and(a, b) _mm512_and_si512(a, b)
#define register_i_xor(a, b) _mm512_xor_si512(a, b)
#define register_i_mul_shorts(a, b) _mm512_mullo_epi16(a, b)
#define register_i_high_bytes(a) _mm512_srli_epi16(a, 8)
#define register_i_add_bytes(a, b) _mm512_adds_epu8(a, b)
#define register_i_sub_bytes(a, b) _mm512_subs_epu8(a, b)
#define register_i_add_shorts(a, b) _mm512_adds_epu16(a, b)
#define register_i_sub_shorts(a, b) _mm512_subs_epu16(a, b)
#define register_i_scale_shorts(a, b) avx512_scale_shorts(a, b)
#define register_i_shift_left(a, count) _mm512_sll_epi32(a, _mm_cvtsi32_si128(count))
#define register_i_shift_right(a, count) _mm512_sra_epi32(a, _mm_cvtsi32_si128(count))
#define register_i_shift_right_logical(a, count) _mm512_srli_epi32(a, count)
#define register_i_min(a, b) _mm512_min_epi32(a, b)
#define register_i_max(a, b) _mm512_max_epi32(a, b)
#define register_i_select(m, a, b) _mm512_mask_blend_epi32(m, b, a)
#define register_i_greater(a, b) _mm512_cmpgt_epi32_mask(a, b)
#define register_i_equal(a, b) _mm512_cmpeq_epi32_mask(a, b)
#define register_i_load_rows(ROW) avx512_load_rows(ROW(0), ROW(1), ROW(2), ROW(3))
#define register_i_store_rows(ROW, a) avx512_store_rows(ROW(0), ROW(1), ROW(2), ROW(3), a)
#define register_load_pairs(AT, first)                                                             \
    _mm512_castsi512_ps(avx512_join(avx512_load_pairs(AT(first), AT((first) + 1)),                 \
                                    avx512_load_pairs(AT((first) + 4), AT((first) + 5)),           \
                                    avx512_load_pairs(AT((first) + 8), AT((first) + 9)),           \
                                    avx512_load_pairs(AT((first) + 12), AT((first) + 13))))
#define register_even(a, b) _mm512_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0))
#define register_odd(a, b) _mm512_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1))
#define register_spread(a, i) _mm512_shuffle_ps(a, a, _MM_SHUFFLE(i, i, i, i))
#define register_splat_vec4(p) _mm512_broadcast_f32x4(_mm_loadu_ps(p))
#define register_load_vec3(p, v) avx512_load_vec3(p, v)
#define register_store_vec3(p, v) avx512_store_vec3(p, v)
#define register_i_interleave_low(a, b) _mm512_unpacklo_epi32(a, b)
#define register_i_interleave_high(a, b) _mm512_unpackhi_epi32(a, b)
#define register_i_set(NUMBER)                                                                     \
    avx512_join(_mm_setr_epi32(NUMBER(0), NUMBER(1), NUMBER(2), NUMBER(3)),                        \
                _mm_setr_epi32(NUMBER(4), NUMBER(5), NUMBER(6), NUMBER(7)),                        \
                _mm_setr_epi32(NUMBER(8), NUMBER(9), NUMBER(10), NUMBER(11)),                      \
                _mm_setr_epi32(NUMBER(12), NUMBER(13), NUMBER(14), NUMBER(15)))
#define register_indices(at, index) avx512_indices(at, index)
#define register_i_pack_words(a, b) _mm512_packs_epi32(a, b)
#define register_i_pack_shorts(a, b) _mm512_packus_epi16(a, b)
#define register_i_transpose_bytes(a)                                                              \
    _mm512_shuffle_epi8(a, _mm512_set4_epi32(0x0F0B0703, 0x0E0A0602, 0x0D090501, 0x0C080400))
#define registers_bits(q) q[0]

/* Lane 0 of each half is lane i of that half, lane 1 is lane j, and so on. */
#define avx512_permuted(a, i, j, k, l, m, n, o, p)                                                 \
    _mm512_permutexvar_ps(_mm512_setr_epi32(i, j, k, l, m, n, o, p, (i) + 8, (j) + 8, (k) + 8,     \
                                            (l) + 8, (m) + 8, (n) + 8, (o) + 8, (p) + 8),          \
                          a)

GN_OPERATION __m512 avx512_rows(float per_y, float y)
{
    const __m512 row = _mm512_add_ps(
        _mm512_set1_ps(y), _mm512_setr_ps(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3));

    return _mm512_mul_ps(_mm512_set1_ps(per_y), row);
}

/* For a product high * 2^16 + low the result is high + (low + high + 2^15) / 2^16. The quotient is
 * the carry of low + high, plus bit 15 of the sum without the carry. */
static inline __m512i avx512_scale_shorts(__m512i a, __m512i b)
{
    const __m512i low = _mm512_mullo_epi16(a, b);
    const __m512i high = _mm512_mulhi_epu16(a, b);
    const __m512i sum = _mm512_add_epi16(low, high);
    const __m512i lost = _mm512_sub_epi16(_mm512_adds_epu16(low, high), sum);

    return _mm512_add_epi16(_mm512_add_epi16(high, _mm512_srli_epi16(sum, 15)),
                            _mm512_min_epu16(lost, _mm512_set1_epi16(1)));
}

GN_OPERATION __m512i avx512_join(__m128i a, __m128i b, __m128i c, __m128i d)
{
    const __m256i low = _mm256_inserti128_si256(_mm256_castsi128_si256(a), b, 1);
    const __m256i high = _mm256_inserti128_si256(_mm256_castsi128_si256(c), d, 1);

    return _mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1);
}

GN_OPERATION __m128i avx512_load_row(const void *row)
{
    return _mm_loadu_si128((const __m128i *)row);
}

GN_OPERATION __m512i avx512_load_rows(const void *first, const void *second, const void *third,
                                      const void *fourth)
{
    __m512i r = _mm512_castsi128_si512(avx512_load_row(first));

    r = _mm512_inserti32x4(r, avx512_load_row(second), 1);
    r = _mm512_inserti32x4(r, avx512_load_row(third), 2);
    return _mm512_inserti32x4(r, avx512_load_row(fourth), 3);
}

GN_OPERATION void avx512_store_rows(void *first, void *second, void *third, void *fourth, __m512i a)
{
    _mm_storeu_si128((__m128i *)first, _mm512_castsi512_si128(a));
    _mm_storeu_si128((__m128i *)second, _mm512_extracti32x4_epi32(a, 1));
    _mm_storeu_si128((__m128i *)third, _mm512_extracti32x4_epi32(a, 2));
    _mm_storeu_si128((__m128i *)fourth, _mm512_extracti32x4_epi32(a, 3));
}

/* Extracts the indices two at a time, which takes fewer operations than one at a time. */
GN_OPERATION void avx512_indices(int32_t *at, __m512i index)
{
    const __m128i part[4] = {_mm512_castsi512_si128(index), _mm512_extracti32x4_epi32(index, 1),
                             _mm512_extracti32x4_epi32(index, 2),
                             _mm512_extracti32x4_epi32(index, 3)};

    for (int n = 0; n < 4; ++n) {
        const int64_t low = _mm_cvtsi128_si64(part[n]);
        const int64_t high = _mm_cvtsi128_si64(_mm_unpackhi_epi64(part[n], part[n]));

        at[4 * n] = (int32_t)low;
        at[4 * n + 1] = (int32_t)(low >> 32);
        at[4 * n + 2] = (int32_t)high;
        at[4 * n + 3] = (int32_t)(high >> 32);
    }
}

GN_OPERATION __m128i avx512_load_pairs(const void *first, const void *second)
{
    const __m128 low = _mm_castsi128_ps(_mm_loadl_epi64((const __m128i *)first));

    return _mm_castps_si128(_mm_loadh_pi(low, (const __m64 *)second));
}

/* INDEX(l, i) in lane l. */
#define AVX512_INDICES(INDEX, i)                                                                   \
    _mm512_setr_epi32(INDEX(0, i), INDEX(1, i), INDEX(2, i), INDEX(3, i), INDEX(4, i),             \
                      INDEX(5, i), INDEX(6, i), INDEX(7, i), INDEX(8, i), INDEX(9, i),             \
                      INDEX(10, i), INDEX(11, i), INDEX(12, i), INDEX(13, i), INDEX(14, i),        \
                      INDEX(15, i))

/* Loading: component i of vector l is number 3 * l + i of three registers. An instruction indexes
 * two operands as 0 to 15 and 16 to 31. So one instruction takes the components that the first two
 * registers hold; a second one keeps these and takes the others from the third register. */
#define AVX512_FROM_TWO(l, i) (3 * (l) + (i) < 32 ? 3 * (l) + (i) : 0)
#define AVX512_FROM_THIRD(l, i) (3 * (l) + (i) < 32 ? (l) : 3 * (l) + (i)-16)

GN_OPERATION void avx512_load_vec3(const float *p, __m512 v[3])
{
    const __m512 a = _mm512_loadu_ps(p), b = _mm512_loadu_ps(p + 16), c = _mm512_loadu_ps(p + 32);
    const __m512 x = _mm512_permutex2var_ps(a, AVX512_INDICES(AVX512_FROM_TWO, 0), b);
    const __m512 y = _mm512_permutex2var_ps(a, AVX512_INDICES(AVX512_FROM_TWO, 1), b);
    const __m512 z = _mm512_permutex2var_ps(a, AVX512_INDICES(AVX512_FROM_TWO, 2), b);

    v[0] = _mm512_permutex2var_ps(x, AVX512_INDICES(AVX512_FROM_THIRD, 0), c);
    v[1] = _mm512_permutex2var_ps(y, AVX512_INDICES(AVX512_FROM_THIRD, 1), c);
    v[2] = _mm512_permutex2var_ps(z, AVX512_INDICES(AVX512_FROM_THIRD, 2), c);
}

/* Storing: lane l of register r is component (16 * r + l) % 3. The first instruction takes x and y,
 * the second z. */
#define AVX512_FROM_XY(l, r) ((16 * (r) + (l)) / 3 + ((16 * (r) + (l)) % 3 == 1 ? 16 : 0))
#define AVX512_FROM_Z(l, r) ((16 * (r) + (l)) % 3 == 2 ? (16 * (r) + (l)) / 3 + 16 : (l))

GN_OPERATION void avx512_store_vec3(float *p, const __m512 v[3])
{
    const __m512 a = _mm512_permutex2var_ps(v[0], AVX512_INDICES(AVX512_FROM_XY, 0), v[1]);
    const __m512 b = _mm512_permutex2var_ps(v[0], AVX512_INDICES(AVX512_FROM_XY, 1), v[1]);
    const __m512 c = _mm512_permutex2var_ps(v[0], AVX512_INDICES(AVX512_FROM_XY, 2), v[1]);

    _mm512_storeu_ps(p, _mm512_permutex2var_ps(a, AVX512_INDICES(AVX512_FROM_Z, 0), v[2]));
    _mm512_storeu_ps(p + 16, _mm512_permutex2var_ps(b, AVX512_INDICES(AVX512_FROM_Z, 1), v[2]));
    _mm512_storeu_ps(p + 32, _mm512_permutex2var_ps(c, AVX512_INDICES(AVX512_FROM_Z, 2), v[2]));
}

/* SIMDe does not emulate the conversions of bytes and shorts. */
#if !defined(GN_LANES_INTRINSICS_HEADER)

/* Rows of four pixels, of one, two and three bytes. */
#define register_i_load_rows_of_bytes(ROW)                                                         \
    _mm512_cvtepu8_epi32(_mm_setr_epi32(                                                           \
        *(const any_word *)(const void *)ROW(0), *(const any_word *)(const void *)ROW(1),          \
        *(const any_word *)(const void *)ROW(2), *(const any_word *)(const void *)ROW(3)))
#define register_i_store_rows_of_bytes(ROW, a)                                                     \
    avx512_store_bytes(ROW(0), ROW(1), ROW(2), ROW(3), _mm512_cvtepi32_epi8(a))
#define register_i_load_rows_of_shorts(ROW)                                                        \
    _mm512_cvtepu16_epi32(                                                                         \
        _mm256_inserti128_si256(_mm256_castsi128_si256(avx512_load_pairs(ROW(0), ROW(1))),         \
                                avx512_load_pairs(ROW(2), ROW(3)), 1))
#define register_i_store_rows_of_shorts(ROW, a)                                                    \
    avx512_store_shorts(ROW(0), ROW(1), ROW(2), ROW(3), _mm512_cvtepi32_epi16(a))
#define register_i_load_rows_of_threes(ROW)                                                        \
    _mm512_shuffle_epi8(                                                                           \
        avx512_join(avx512_load_pairs(ROW(0), ROW(0) + 4), avx512_load_pairs(ROW(1), ROW(1) + 4),  \
                    avx512_load_pairs(ROW(2), ROW(2) + 4), avx512_load_pairs(ROW(3), ROW(3) + 4)), \
        _mm512_broadcast_i32x4(_mm_setr_epi8(GN_FROM_THREES)))
#define register_i_store_rows_of_threes(ROW, a)                                                    \
    avx512_store_threes(ROW(0), ROW(1), ROW(2), ROW(3), a)

GN_OPERATION void avx512_store_bytes(void *first, void *second, void *third, void *fourth,
                                     __m128i a)
{
    *(any_word *)first = _mm_cvtsi128_si32(a);
    *(any_word *)second = _mm_extract_epi32(a, 1);
    *(any_word *)third = _mm_extract_epi32(a, 2);
    *(any_word *)fourth = _mm_extract_epi32(a, 3);
}

GN_OPERATION void avx512_store_pairs(void *first, void *second, __m128i a)
{
    _mm_storel_epi64((__m128i *)first, a);
    _mm_storeh_pi((__m64 *)second, _mm_castsi128_ps(a));
}

GN_OPERATION void avx512_store_shorts(void *first, void *second, void *third, void *fourth,
                                      __m256i a)
{
    avx512_store_pairs(first, second, _mm256_castsi256_si128(a));
    avx512_store_pairs(third, fourth, _mm256_extracti128_si256(a, 1));
}

GN_OPERATION void avx512_store_threes(unsigned char *first, unsigned char *second,
                                      unsigned char *third, unsigned char *fourth, __m512i a)
{
    const __m512i bytes =
        _mm512_shuffle_epi8(a, _mm512_broadcast_i32x4(_mm_setr_epi8(GN_TO_THREES)));

    avx512_store_pairs(first, first + 4, _mm512_castsi512_si128(bytes));
    avx512_store_pairs(second, second + 4, _mm512_extracti32x4_epi32(bytes, 1));
    avx512_store_pairs(third, third + 4, _mm512_extracti32x4_epi32(bytes, 2));
    avx512_store_pairs(fourth, fourth + 4, _mm512_extracti32x4_epi32(bytes, 3));
}

#endif

#endif
