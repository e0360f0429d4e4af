/* Lanes in one AVX-512 register, with the rows of a block in its four 128-bit parts, and masks in
 * mask registers (AVX-512 F, BW and DQ). The results are those of lanes_portable.h, which defines
 * each operation. Conversions return INT32_MIN if out of range; min and max return their second
 * operand if either is NaN (Intel SDM volume 1, section 11.5.2).
 * Not alone: lanes.h chooses one form and includes it after GN_LANES and GN_EACH_LANE. */
#ifndef GN_LANES_LANES_AVX512_H
#define GN_LANES_LANES_AVX512_H

#if defined(GN_LANES_INTRINSICS_HEADER)
#include GN_LANES_INTRINSICS_HEADER
#else
#include <immintrin.h>
#endif

typedef struct lanes_f {
    __m512 q;
} lanes_f;

typedef struct lanes_i {
    __m512i q;
} lanes_i;

typedef struct lanes_m {
    __mmask16 q;
} lanes_m;

GN_OPERATION lanes_f lanes_avx512_f(__m512 q)
{
    const lanes_f r = {q};
    return r;
}

GN_OPERATION lanes_i lanes_avx512_i(__m512i q)
{
    const lanes_i r = {q};
    return r;
}

GN_OPERATION lanes_m lanes_avx512_m(uint32_t q)
{
    const lanes_m r = {(__mmask16)q};
    return r;
}

GN_OPERATION lanes_f lanes_load(const float p[GN_LANES])
{
    return lanes_avx512_f(_mm512_loadu_ps(p));
}

GN_OPERATION void lanes_store(float *p, lanes_f a)
{
    _mm512_storeu_ps(p, a.q);
}

GN_OPERATION lanes_f lanes_splat(float a)
{
    return lanes_avx512_f(_mm512_set1_ps(a));
}

GN_OPERATION lanes_f lanes_columns(float per_x, float x, float origin)
{
    const __m512 column = _mm512_add_ps(
        _mm512_set1_ps(x), _mm512_setr_ps(0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3));

    return lanes_avx512_f(
        _mm512_add_ps(_mm512_mul_ps(_mm512_set1_ps(per_x), column), _mm512_set1_ps(origin)));
}

GN_OPERATION lanes_f lanes_rows(float per_y, float y)
{
    const __m512 row = _mm512_add_ps(
        _mm512_set1_ps(y), _mm512_setr_ps(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3));

    return lanes_avx512_f(_mm512_mul_ps(_mm512_set1_ps(per_y), row));
}

GN_OPERATION lanes_f lanes_add(lanes_f a, lanes_f b)
{
    return lanes_avx512_f(_mm512_add_ps(a.q, b.q));
}

GN_OPERATION lanes_f lanes_sub(lanes_f a, lanes_f b)
{
    return lanes_avx512_f(_mm512_sub_ps(a.q, b.q));
}

GN_OPERATION lanes_f lanes_mul(lanes_f a, lanes_f b)
{
    return lanes_avx512_f(_mm512_mul_ps(a.q, b.q));
}

GN_OPERATION lanes_f lanes_div(lanes_f a, lanes_f b)
{
    return lanes_avx512_f(_mm512_div_ps(a.q, b.q));
}

GN_OPERATION lanes_f lanes_sqrt(lanes_f a)
{
    return lanes_avx512_f(_mm512_sqrt_ps(a.q));
}

GN_OPERATION lanes_m lanes_greater(lanes_f a, lanes_f b)
{
    return lanes_avx512_m(_mm512_cmp_ps_mask(a.q, b.q, _CMP_GT_OQ));
}

GN_OPERATION lanes_m lanes_less_equal(lanes_f a, lanes_f b)
{
    return lanes_avx512_m(_mm512_cmp_ps_mask(a.q, b.q, _CMP_LE_OQ));
}

GN_OPERATION lanes_m lanes_and(lanes_m a, lanes_m b)
{
    return lanes_avx512_m((uint32_t)a.q & b.q);
}

GN_OPERATION lanes_m lanes_not(lanes_m a)
{
    return lanes_avx512_m(a.q ^ GN_ALL_LANES);
}

GN_OPERATION uint32_t lanes_bits(lanes_m a)
{
    return a.q;
}

GN_OPERATION lanes_m lanes_from_bits(uint32_t bits)
{
    return lanes_avx512_m(bits);
}

GN_OPERATION lanes_f lanes_select(lanes_m m, lanes_f a, lanes_f b)
{
    return lanes_avx512_f(_mm512_mask_blend_ps(m.q, b.q, a.q));
}

GN_OPERATION lanes_f lanes_min(lanes_f a, lanes_f b)
{
    return lanes_avx512_f(_mm512_min_ps(a.q, b.q));
}

GN_OPERATION lanes_f lanes_max(lanes_f a, lanes_f b)
{
    return lanes_avx512_f(_mm512_max_ps(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_splat(int32_t a)
{
    return lanes_avx512_i(_mm512_set1_epi32(a));
}

GN_OPERATION lanes_i lanes_i_halves(int32_t lower, int32_t upper)
{
    return lanes_avx512_i(
        _mm512_inserti32x8(_mm512_set1_epi32(lower), _mm256_set1_epi32(upper), 1));
}

GN_OPERATION lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    const __m512i column = _mm512_setr_epi32(0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
    const __m512i row = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);

    return lanes_avx512_i(
        _mm512_add_epi32(_mm512_mullo_epi32(_mm512_set1_epi32(per_column), column),
                         _mm512_mullo_epi32(_mm512_set1_epi32(per_row), row)));
}

GN_OPERATION lanes_i lanes_i_load(const int32_t p[GN_LANES])
{
    return lanes_avx512_i(_mm512_loadu_si512(p));
}

GN_OPERATION void lanes_i_store(int32_t *p, lanes_i a)
{
    _mm512_storeu_si512(p, a.q);
}

GN_OPERATION lanes_i lanes_i_add(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_add_epi32(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_sub(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_sub_epi32(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_mul(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_mullo_epi32(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_mul_short(lanes_i a, int32_t b)
{
    return lanes_i_mul(a, lanes_i_splat(b));
}

GN_OPERATION lanes_i lanes_i_mul_shorts(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_mullo_epi16(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_high_bytes(lanes_i a)
{
    return lanes_avx512_i(_mm512_srli_epi16(a.q, 8));
}

GN_OPERATION lanes_i lanes_i_add_bytes(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_adds_epu8(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_sub_bytes(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_subs_epu8(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_add_shorts(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_adds_epu16(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_sub_shorts(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_subs_epu16(a.q, b.q));
}

/* With the halves of a product the sum is low + high + 2^15, of which high gets the carry: one if
 * low + high has one, and one more if bit 15 of what is left is set. */
static inline __m512i lanes_avx512_scale(__m512i a, __m512i b)
{
    const __m512i low = _mm512_mullo_epi16(a, b);
    const __m512i high = _mm512_mulhi_epu16(a, b);
    const __m512i sum = _mm512_add_epi16(low, high);
    const __m512i lost = _mm512_sub_epi16(_mm512_adds_epu16(low, high), sum);

    return _mm512_add_epi16(_mm512_add_epi16(high, _mm512_srli_epi16(sum, 15)),
                            _mm512_min_epu16(lost, _mm512_set1_epi16(1)));
}

GN_OPERATION lanes_i lanes_i_scale_shorts(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(lanes_avx512_scale(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_shift_left(lanes_i a, int count)
{
    return lanes_avx512_i(_mm512_sll_epi32(a.q, _mm_cvtsi32_si128(count)));
}

GN_OPERATION lanes_i lanes_i_shift_right(lanes_i a, int count)
{
    return lanes_avx512_i(_mm512_sra_epi32(a.q, _mm_cvtsi32_si128(count)));
}

GN_OPERATION lanes_i lanes_i_min(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_min_epi32(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_max(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_max_epi32(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_or(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_or_si512(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_and(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_and_si512(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_xor(lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_xor_si512(a.q, b.q));
}

GN_OPERATION lanes_m lanes_i_greater(lanes_i a, lanes_i b)
{
    return lanes_avx512_m(_mm512_cmpgt_epi32_mask(a.q, b.q));
}

GN_OPERATION lanes_m lanes_i_equal(lanes_i a, lanes_i b)
{
    return lanes_avx512_m(_mm512_cmpeq_epi32_mask(a.q, b.q));
}

GN_OPERATION lanes_i lanes_i_select(lanes_m m, lanes_i a, lanes_i b)
{
    return lanes_avx512_i(_mm512_mask_blend_epi32(m.q, b.q, a.q));
}

GN_OPERATION lanes_i lanes_m_as_int(lanes_m a)
{
    return lanes_avx512_i(_mm512_movm_epi32(a.q));
}

GN_OPERATION uint32_t lanes_i_sign_bits(lanes_i a)
{
    return _mm512_movepi32_mask(a.q);
}

GN_OPERATION lanes_f lanes_to_float(lanes_i a)
{
    return lanes_avx512_f(_mm512_cvtepi32_ps(a.q));
}

GN_OPERATION lanes_i lanes_as_int(lanes_f a)
{
    return lanes_avx512_i(_mm512_castps_si512(a.q));
}

GN_OPERATION lanes_f lanes_as_float(lanes_i a)
{
    return lanes_avx512_f(_mm512_castsi512_ps(a.q));
}

GN_OPERATION lanes_i lanes_truncate(lanes_f a)
{
    return lanes_avx512_i(_mm512_cvttps_epi32(a.q));
}

GN_OPERATION lanes_f lanes_floor(lanes_f a)
{
    return lanes_avx512_f(_mm512_floor_ps(a.q));
}

GN_OPERATION lanes_f lanes_quad_left(lanes_f a)
{
    return lanes_avx512_f(_mm512_permutexvar_ps(
        _mm512_setr_epi32(0, 0, 2, 2, 4, 4, 6, 6, 8, 8, 10, 10, 12, 12, 14, 14), a.q));
}

GN_OPERATION lanes_f lanes_quad_right(lanes_f a)
{
    return lanes_avx512_f(_mm512_permutexvar_ps(
        _mm512_setr_epi32(1, 1, 3, 3, 5, 5, 7, 7, 9, 9, 11, 11, 13, 13, 15, 15), a.q));
}

GN_OPERATION lanes_f lanes_quad_lower(lanes_f a)
{
    return lanes_avx512_f(_mm512_permutexvar_ps(
        _mm512_setr_epi32(0, 1, 2, 3, 0, 1, 2, 3, 8, 9, 10, 11, 8, 9, 10, 11), a.q));
}

GN_OPERATION lanes_f lanes_quad_upper(lanes_f a)
{
    return lanes_avx512_f(_mm512_permutexvar_ps(
        _mm512_setr_epi32(4, 5, 6, 7, 4, 5, 6, 7, 12, 13, 14, 15, 12, 13, 14, 15), a.q));
}

GN_OPERATION lanes_i lanes_round(lanes_f a)
{
    return lanes_avx512_i(_mm512_cvtps_epi32(a.q));
}

/* The packs saturate and interleave within each row of the block; the bytes of each row are then
 * transposed. */
GN_OPERATION lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    const __m512 scale = _mm512_set1_ps(255.0f);
    const __m512i rg = _mm512_packs_epi32(_mm512_cvtps_epi32(_mm512_mul_ps(red.q, scale)),
                                          _mm512_cvtps_epi32(_mm512_mul_ps(green.q, scale)));
    const __m512i ba = _mm512_packs_epi32(_mm512_cvtps_epi32(_mm512_mul_ps(blue.q, scale)),
                                          _mm512_cvtps_epi32(_mm512_mul_ps(alpha.q, scale)));
    const __m512i order = _mm512_set4_epi32(0x0F0B0703, 0x0E0A0602, 0x0D090501, 0x0C080400);

    return lanes_avx512_i(_mm512_shuffle_epi8(_mm512_packus_epi16(rg, ba), order));
}

GN_OPERATION __m128i lanes_avx512_load_row(const unsigned char *memory)
{
    return _mm_loadu_si128((const __m128i *)(const void *)memory);
}

GN_OPERATION lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                        ptrdiff_t stride)
{
    __m512i r = _mm512_castsi128_si512(lanes_avx512_load_row(lower));

    r = _mm512_inserti32x4(r, lanes_avx512_load_row(lower + stride), 1);
    r = _mm512_inserti32x4(r, lanes_avx512_load_row(upper), 2);
    return lanes_avx512_i(_mm512_inserti32x4(r, lanes_avx512_load_row(upper + stride), 3));
}

GN_OPERATION void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                      lanes_i a)
{
    _mm_storeu_si128((__m128i *)(void *)lower, _mm512_castsi512_si128(a.q));
    _mm_storeu_si128((__m128i *)(void *)(lower + stride), _mm512_extracti32x4_epi32(a.q, 1));
    _mm_storeu_si128((__m128i *)(void *)upper, _mm512_extracti32x4_epi32(a.q, 2));
    _mm_storeu_si128((__m128i *)(void *)(upper + stride), _mm512_extracti32x4_epi32(a.q, 3));
}

/* Transposes 4x4 words in each 128-bit part. */
GN_OPERATION void lanes_avx512_transpose(__m512i r[4])
{
    const __m512i a = _mm512_unpacklo_epi32(r[0], r[1]);
    const __m512i b = _mm512_unpackhi_epi32(r[0], r[1]);
    const __m512i c = _mm512_unpacklo_epi32(r[2], r[3]);
    const __m512i d = _mm512_unpackhi_epi32(r[2], r[3]);

    r[0] = _mm512_unpacklo_epi64(a, c);
    r[1] = _mm512_unpackhi_epi64(a, c);
    r[2] = _mm512_unpacklo_epi64(b, d);
    r[3] = _mm512_unpackhi_epi64(b, d);
}

GN_OPERATION void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset,
                                      uint32_t step, lanes_i out[4])
{
    __m512i r[4];

    for (uint32_t l = 0; l < 4; ++l) {
        const uint32_t *const at = offset + l * step;

        r[l] = _mm512_castsi128_si512(lanes_avx512_load_row(memory + at[0]));
        r[l] = _mm512_inserti32x4(r[l], lanes_avx512_load_row(memory + at[4 * step]), 1);
        r[l] = _mm512_inserti32x4(r[l], lanes_avx512_load_row(memory + at[8 * step]), 2);
        r[l] = _mm512_inserti32x4(r[l], lanes_avx512_load_row(memory + at[12 * step]), 3);
    }
    lanes_avx512_transpose(r);
    for (int c = 0; c < 4; ++c)
        out[c].q = r[c];
}

GN_OPERATION void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    __m512i r[4];

    for (int c = 0; c < 4; ++c)
        r[c] = in[c].q;
    lanes_avx512_transpose(r);
    for (size_t l = 0; l < 4; ++l)
        lanes_i_store_block(memory + l * stride, memory + (l + 8) * stride, (ptrdiff_t)(4 * stride),
                            lanes_avx512_i(r[l]));
}

/* A byte above the lowest is converted in place, and the factor is smaller by the same power of
 * two, which changes no rounding. */
GN_OPERATION lanes_f lanes_unpack_unorm8(lanes_i packed, int channel)
{
    const float scale = (float)(1.0 / 255.0) / (float)(1 << 8 * (channel % 3));
    const __m512i byte = _mm512_set1_epi32(0xFF << 8 * (channel % 3));
    const __m512i in_place =
        channel == 3 ? _mm512_srli_epi32(packed.q, 24) : _mm512_and_si512(packed.q, byte);

    return lanes_avx512_f(_mm512_mul_ps(_mm512_cvtepi32_ps(in_place), _mm512_set1_ps(scale)));
}

/* Loads of single words and pairs take less time than the gather instructions, which block the
 * units of arithmetic. The indices leave the register two at a time. */
GN_OPERATION void lanes_avx512_indices(lanes_i index, int32_t at[GN_LANES])
{
    const __m128i part[4] = {_mm512_castsi512_si128(index.q), _mm512_extracti32x4_epi32(index.q, 1),
                             _mm512_extracti32x4_epi32(index.q, 2),
                             _mm512_extracti32x4_epi32(index.q, 3)};

    for (int n = 0; n < 4; ++n) {
        const int64_t low = _mm_cvtsi128_si64(part[n]);
        const int64_t high = _mm_cvtsi128_si64(_mm_unpackhi_epi64(part[n], part[n]));

        at[4 * n] = (int32_t)low;
        at[4 * n + 1] = (int32_t)(low >> 32);
        at[4 * n + 2] = (int32_t)high;
        at[4 * n + 3] = (int32_t)(high >> 32);
    }
}

GN_OPERATION __m512i lanes_avx512_join(__m128i a, __m128i b, __m128i c, __m128i d)
{
    const __m256i low = _mm256_inserti128_si256(_mm256_castsi128_si256(a), b, 1);
    const __m256i high = _mm256_inserti128_si256(_mm256_castsi128_si256(c), d, 1);

    return _mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1);
}

GN_OPERATION __m128i lanes_avx512_words(const stored_word *base, const int32_t *index)
{
    return _mm_setr_epi32(base[index[0]], base[index[1]], base[index[2]], base[index[3]]);
}

GN_INLINE lanes_i lanes_i_gather(const stored_word *base, lanes_i index)
{
    int32_t at[GN_LANES];

    lanes_avx512_indices(index, at);
    return lanes_avx512_i(
        lanes_avx512_join(lanes_avx512_words(base, at), lanes_avx512_words(base, at + 4),
                          lanes_avx512_words(base, at + 8), lanes_avx512_words(base, at + 12)));
}

/* Loads two pairs of words. */
GN_OPERATION __m128i lanes_avx512_pairs(const stored_word *base, const int32_t *index)
{
    const __m128 low =
        _mm_castsi128_ps(_mm_loadl_epi64((const __m128i *)(const void *)(base + index[0])));

    return _mm_castps_si128(_mm_loadh_pi(low, (const __m64 *)(const void *)(base + index[1])));
}

GN_INLINE void lanes_i_gather_pairs(const stored_word *base, lanes_i index, lanes_i *first,
                                    lanes_i *second)
{
    int32_t at[GN_LANES];

    lanes_avx512_indices(index, at);
    const __m512 a = _mm512_castsi512_ps(
        lanes_avx512_join(lanes_avx512_pairs(base, at), lanes_avx512_pairs(base, at + 4),
                          lanes_avx512_pairs(base, at + 8), lanes_avx512_pairs(base, at + 12)));
    const __m512 b = _mm512_castsi512_ps(
        lanes_avx512_join(lanes_avx512_pairs(base, at + 2), lanes_avx512_pairs(base, at + 6),
                          lanes_avx512_pairs(base, at + 10), lanes_avx512_pairs(base, at + 14)));
    first->q = _mm512_castps_si512(_mm512_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)));
    second->q = _mm512_castps_si512(_mm512_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)));
}

#endif
