/* Lanes in two AVX2 registers, two rows of a block in each. The results are those of
 * lanes_portable.h, which defines each operation.
 * Not alone: lanes.h chooses one form and includes it after GN_LANES and GN_EACH_LANE. */
#ifndef GN_LANES_LANES_AVX2_H
#define GN_LANES_LANES_AVX2_H

#include <immintrin.h>

typedef struct lanes_f {
    __m256 q[2];
} lanes_f;

typedef struct lanes_i {
    __m256i q[2];
} lanes_i;

typedef struct lanes_m {
    __m256i q[2];
} lanes_m;

/* r.q[n] = EXPRESSION for both registers. */
#define LANES_EACH_REGISTER(type, EXPRESSION)                                                      \
    type r;                                                                                        \
    {                                                                                              \
        enum { n = 0 };                                                                            \
        r.q[n] = EXPRESSION;                                                                       \
    }                                                                                              \
    {                                                                                              \
        enum { n = 1 };                                                                            \
        r.q[n] = EXPRESSION;                                                                       \
    }                                                                                              \
    return r

GN_OPERATION lanes_f lanes_load(const float p[GN_LANES])
{
    LANES_EACH_REGISTER(lanes_f, _mm256_loadu_ps(p + 8 * n));
}

GN_OPERATION void lanes_store(float *p, lanes_f a)
{
    _mm256_storeu_ps(p, a.q[0]);
    _mm256_storeu_ps(p + 8, a.q[1]);
}

GN_OPERATION lanes_f lanes_splat(float a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_set1_ps(a));
}

GN_OPERATION lanes_f lanes_columns(float per_x, float x, float origin)
{
    const __m256 column = _mm256_add_ps(_mm256_set1_ps(x), _mm256_setr_ps(0, 1, 2, 3, 0, 1, 2, 3));
    const __m256 value =
        _mm256_add_ps(_mm256_mul_ps(_mm256_set1_ps(per_x), column), _mm256_set1_ps(origin));

    LANES_EACH_REGISTER(lanes_f, value);
}

GN_OPERATION lanes_f lanes_rows(float per_y, float y)
{
    LANES_EACH_REGISTER(lanes_f,
                        _mm256_mul_ps(_mm256_set1_ps(per_y),
                                      _mm256_add_ps(_mm256_set1_ps(y + (float)(2 * n)),
                                                    _mm256_setr_ps(0, 0, 0, 0, 1, 1, 1, 1))));
}

GN_OPERATION lanes_f lanes_add(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_add_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_sub(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_sub_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_mul(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_mul_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_div(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_div_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_sqrt(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_sqrt_ps(a.q[n]));
}

GN_OPERATION lanes_m lanes_greater(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, _mm256_castps_si256(_mm256_cmp_ps(a.q[n], b.q[n], _CMP_GT_OQ)));
}

GN_OPERATION lanes_m lanes_less_equal(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, _mm256_castps_si256(_mm256_cmp_ps(a.q[n], b.q[n], _CMP_LE_OQ)));
}

GN_OPERATION lanes_m lanes_and(lanes_m a, lanes_m b)
{
    LANES_EACH_REGISTER(lanes_m, _mm256_and_si256(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_not(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_m, _mm256_xor_si256(a.q[n], _mm256_set1_epi32(-1)));
}

GN_OPERATION uint32_t lanes_bits(lanes_m a)
{
    return (uint32_t)(_mm256_movemask_ps(_mm256_castsi256_ps(a.q[0])) |
                      _mm256_movemask_ps(_mm256_castsi256_ps(a.q[1])) << 8);
}

GN_OPERATION lanes_m lanes_from_bits(uint32_t bits)
{
    const __m256i all = _mm256_set1_epi32((int)bits);
    const __m256i one = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);

    LANES_EACH_REGISTER(
        lanes_m, _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_srli_epi32(all, 8 * n), one), one));
}

GN_OPERATION lanes_f lanes_select(lanes_m m, lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_blendv_ps(b.q[n], a.q[n], _mm256_castsi256_ps(m.q[n])));
}

GN_OPERATION lanes_f lanes_min(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_min_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_max(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_max_ps(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_splat(int32_t a)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_set1_epi32(a));
}

GN_OPERATION lanes_i lanes_i_halves(int32_t lower, int32_t upper)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_set1_epi32(n == 0 ? lower : upper));
}

GN_OPERATION lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    const __m256i column = _mm256_setr_epi32(0, 1, 2, 3, 0, 1, 2, 3);
    const __m256i row = _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1);

    LANES_EACH_REGISTER(
        lanes_i,
        _mm256_add_epi32(_mm256_mullo_epi32(_mm256_set1_epi32(per_column), column),
                         _mm256_mullo_epi32(_mm256_set1_epi32(per_row),
                                            _mm256_add_epi32(row, _mm256_set1_epi32(2 * n)))));
}

GN_OPERATION lanes_i lanes_i_load(const stored_word *p)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_loadu_si256((const __m256i *)(const void *)(p + 8 * n)));
}

GN_OPERATION void lanes_i_store(stored_word *p, lanes_i a)
{
    _mm256_storeu_si256((__m256i *)(void *)p, a.q[0]);
    _mm256_storeu_si256((__m256i *)(void *)(p + 8), a.q[1]);
}

GN_OPERATION lanes_i lanes_i_add(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_add_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_sub_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_mullo_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul_short(lanes_i a, int32_t b)
{
    const __m256i low = _mm256_set1_epi32(b & 0xFFFF); /* pairs of shorts: the upper ones times 0 */

    LANES_EACH_REGISTER(lanes_i, _mm256_madd_epi16(a.q[n], low));
}

GN_OPERATION lanes_i lanes_i_mul_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_mullo_epi16(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_high_bytes(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_srli_epi16(a.q[n], 8));
}

GN_OPERATION lanes_i lanes_i_add_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_adds_epu8(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_subs_epu8(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_add_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_adds_epu16(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_subs_epu16(a.q[n], b.q[n]));
}

/* With the halves of a product the sum is low + high + 2^15, of which high gets the carry: one if
 * low + high has one, and one more if bit 15 of what is left is set. */
static inline __m256i lanes_avx2_scale(__m256i a, __m256i b)
{
    const __m256i low = _mm256_mullo_epi16(a, b);
    const __m256i high = _mm256_mulhi_epu16(a, b);
    const __m256i sum = _mm256_add_epi16(low, high);
    const __m256i no_carry = _mm256_cmpeq_epi16(_mm256_adds_epu16(low, high), sum);

    return _mm256_add_epi16(_mm256_add_epi16(high, _mm256_srli_epi16(sum, 15)),
                            _mm256_add_epi16(no_carry, _mm256_set1_epi16(1)));
}

GN_OPERATION lanes_i lanes_i_scale_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, lanes_avx2_scale(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_shift_left(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_slli_epi32(a.q[n], count));
}

GN_OPERATION lanes_i lanes_i_shift_right(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_srai_epi32(a.q[n], count));
}

GN_OPERATION lanes_i lanes_i_min(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_min_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_max(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_max_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_or(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_or_si256(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_and(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_and_si256(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_xor(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_xor_si256(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_i_greater(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, _mm256_cmpgt_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_i_equal(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, _mm256_cmpeq_epi32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_select(lanes_m m, lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_blendv_epi8(b.q[n], a.q[n], m.q[n]));
}

GN_OPERATION lanes_i lanes_m_as_int(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n]);
}

GN_OPERATION uint32_t lanes_i_sign_bits(lanes_i a)
{
    return (uint32_t)(_mm256_movemask_ps(_mm256_castsi256_ps(a.q[0])) |
                      _mm256_movemask_ps(_mm256_castsi256_ps(a.q[1])) << 8);
}

GN_OPERATION lanes_f lanes_to_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_cvtepi32_ps(a.q[n]));
}

GN_OPERATION lanes_i lanes_as_int(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_castps_si256(a.q[n]));
}

GN_OPERATION lanes_f lanes_as_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_castsi256_ps(a.q[n]));
}

GN_OPERATION lanes_i lanes_truncate(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_cvttps_epi32(a.q[n]));
}

GN_OPERATION lanes_f lanes_floor(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_floor_ps(a.q[n]));
}

GN_OPERATION lanes_f lanes_quad_left(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_moveldup_ps(a.q[n]));
}

GN_OPERATION lanes_f lanes_quad_right(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_movehdup_ps(a.q[n]));
}

GN_OPERATION lanes_f lanes_quad_lower(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_permute2f128_ps(a.q[n], a.q[n], 0x00));
}

GN_OPERATION lanes_f lanes_quad_upper(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, _mm256_permute2f128_ps(a.q[n], a.q[n], 0x11));
}

GN_OPERATION lanes_i lanes_round(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, _mm256_cvtps_epi32(a.q[n]));
}

/* Rounds eight pixels and transposes their bytes within each half; the packs saturate. */
GN_OPERATION __m256i lanes_avx2_pack(__m256 red, __m256 green, __m256 blue, __m256 alpha)
{
    const __m256 scale = _mm256_set1_ps(255.0f);
    const __m256i rg = _mm256_packs_epi32(_mm256_cvtps_epi32(_mm256_mul_ps(red, scale)),
                                          _mm256_cvtps_epi32(_mm256_mul_ps(green, scale)));
    const __m256i ba = _mm256_packs_epi32(_mm256_cvtps_epi32(_mm256_mul_ps(blue, scale)),
                                          _mm256_cvtps_epi32(_mm256_mul_ps(alpha, scale)));
    const __m256i order = _mm256_setr_epi8(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15, 0,
                                           4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);

    return _mm256_shuffle_epi8(_mm256_packus_epi16(rg, ba), order);
}

GN_OPERATION lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    LANES_EACH_REGISTER(lanes_i, lanes_avx2_pack(red.q[n], green.q[n], blue.q[n], alpha.q[n]));
}

/* Loads two rows of four values. */
GN_OPERATION __m256i lanes_avx2_load_rows(const unsigned char *memory, ptrdiff_t stride)
{
    const __m128i low = _mm_loadu_si128((const __m128i *)(const void *)memory);
    const __m128i high = _mm_loadu_si128((const __m128i *)(const void *)(memory + stride));

    return _mm256_inserti128_si256(_mm256_castsi128_si256(low), high, 1);
}

GN_OPERATION lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                        ptrdiff_t stride)
{
    LANES_EACH_REGISTER(lanes_i, lanes_avx2_load_rows(n == 0 ? lower : upper, stride));
}

GN_OPERATION void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                      lanes_i a)
{
    for (int n = 0; n < 2; ++n) {
        unsigned char *const row = n == 0 ? lower : upper;

        _mm_storeu_si128((__m128i *)(void *)row, _mm256_castsi256_si128(a.q[n]));
        _mm_storeu_si128((__m128i *)(void *)(row + stride), _mm256_extracti128_si256(a.q[n], 1));
    }
}

/* Loads row l and row l + 4, one in each half of a register. */
GN_OPERATION __m256 lanes_avx2_row_pair(const unsigned char *memory, const uint32_t *offset,
                                        uint32_t step)
{
    const __m128 low = _mm_loadu_ps((const float *)(const void *)(memory + offset[0]));
    const __m128 high = _mm_loadu_ps((const float *)(const void *)(memory + offset[4 * step]));

    return _mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1);
}

/* Transposes 4x4 words in each half. */
GN_OPERATION void lanes_avx2_transpose(__m256 r[4])
{
    const __m256d a = _mm256_castps_pd(_mm256_unpacklo_ps(r[0], r[1]));
    const __m256d b = _mm256_castps_pd(_mm256_unpackhi_ps(r[0], r[1]));
    const __m256d c = _mm256_castps_pd(_mm256_unpacklo_ps(r[2], r[3]));
    const __m256d d = _mm256_castps_pd(_mm256_unpackhi_ps(r[2], r[3]));

    r[0] = _mm256_castpd_ps(_mm256_unpacklo_pd(a, c));
    r[1] = _mm256_castpd_ps(_mm256_unpackhi_pd(a, c));
    r[2] = _mm256_castpd_ps(_mm256_unpacklo_pd(b, d));
    r[3] = _mm256_castpd_ps(_mm256_unpackhi_pd(b, d));
}

GN_OPERATION void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset,
                                      uint32_t step, lanes_i out[4])
{
    for (int n = 0; n < 2; ++n) {
        __m256 r[4];

        for (int l = 0; l < 4; ++l)
            r[l] = lanes_avx2_row_pair(memory, offset + (uint32_t)(8 * n + l) * step, step);
        lanes_avx2_transpose(r);
        for (int c = 0; c < 4; ++c)
            out[c].q[n] = _mm256_castps_si256(r[c]);
    }
}

GN_OPERATION void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    for (int n = 0; n < 2; ++n) {
        __m256 r[4];

        for (int c = 0; c < 4; ++c)
            r[c] = _mm256_castsi256_ps(in[c].q[n]);
        lanes_avx2_transpose(r);
        for (int l = 0; l < 4; ++l) {
            unsigned char *const row = memory + (size_t)(8 * n + l) * stride;

            _mm_storeu_ps((float *)(void *)row, _mm256_castps256_ps128(r[l]));
            _mm_storeu_ps((float *)(void *)(row + 4 * stride), _mm256_extractf128_ps(r[l], 1));
        }
    }
}

/* A byte above the lowest is converted in place, and the factor is smaller by the same power of
 * two, which changes no rounding. */
GN_OPERATION lanes_f lanes_unpack_unorm8(lanes_i packed, int channel)
{
    const float scale = (float)(1.0 / 255.0) / (float)(1 << 8 * (channel % 3));
    const __m256i byte = _mm256_set1_epi32(0xFF << 8 * (channel % 3));

    if (channel == 3) {
        LANES_EACH_REGISTER(lanes_f,
                            _mm256_mul_ps(_mm256_cvtepi32_ps(_mm256_srli_epi32(packed.q[n], 24)),
                                          _mm256_set1_ps(scale)));
    }
    LANES_EACH_REGISTER(lanes_f,
                        _mm256_mul_ps(_mm256_cvtepi32_ps(_mm256_and_si256(packed.q[n], byte)),
                                      _mm256_set1_ps(scale)));
}

/* Takes the indices out of the registers, two at a time: fewer operations than one at a time. */
GN_OPERATION void lanes_avx2_indices(lanes_i index, int32_t at[GN_LANES])
{
    for (int n = 0; n < 4; ++n) {
        const __m128i part = n % 2 ? _mm256_extracti128_si256(index.q[n / 2], 1)
                                   : _mm256_castsi256_si128(index.q[n / 2]);
        const int64_t low = _mm_cvtsi128_si64(part);
        const int64_t high = _mm_extract_epi64(part, 1);

        at[4 * n] = (int32_t)low;
        at[4 * n + 1] = (int32_t)(low >> 32);
        at[4 * n + 2] = (int32_t)high;
        at[4 * n + 3] = (int32_t)(high >> 32);
    }
}

/* Loads of single words measure faster than the gather instruction on some processors and no slower
 * on others. */
GN_OPERATION __m256i lanes_avx2_gather(const stored_word *base, const int32_t *index)
{
    return _mm256_setr_epi32(base[index[0]], base[index[1]], base[index[2]], base[index[3]],
                             base[index[4]], base[index[5]], base[index[6]], base[index[7]]);
}

GN_INLINE lanes_i lanes_i_gather(const stored_word *base, lanes_i index)
{
    int32_t at[GN_LANES];

    lanes_avx2_indices(index, at);
    LANES_EACH_REGISTER(lanes_i, lanes_avx2_gather(base, at + 8 * n));
}

/* Loads two pairs of words. */
GN_OPERATION __m128 lanes_avx2_pairs(const stored_word *base, const int32_t *index)
{
    const __m128 low =
        _mm_castsi128_ps(_mm_loadl_epi64((const __m128i *)(const void *)(base + index[0])));

    return _mm_loadh_pi(low, (const __m64 *)(const void *)(base + index[1]));
}

GN_INLINE void lanes_i_gather_pairs(const stored_word *base, lanes_i index, lanes_i *first,
                                    lanes_i *second)
{
    int32_t at[GN_LANES];

    lanes_avx2_indices(index, at);
    for (int n = 0; n < 2; ++n) {
        const int32_t *const i = at + 8 * n;
        const __m256 a = _mm256_insertf128_ps(_mm256_castps128_ps256(lanes_avx2_pairs(base, i)),
                                              lanes_avx2_pairs(base, i + 4), 1);
        const __m256 b = _mm256_insertf128_ps(_mm256_castps128_ps256(lanes_avx2_pairs(base, i + 2)),
                                              lanes_avx2_pairs(base, i + 6), 1);

        first->q[n] = _mm256_castps_si256(_mm256_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)));
        second->q[n] = _mm256_castps_si256(_mm256_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)));
    }
}

#endif
