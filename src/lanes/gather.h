/* Gathers from memory, beside those of words in lanes.h:
 *
 *   gather_bytes   one, two or four bytes at any address, the first one lowest
 *   gather_eight   eight bytes at any address, as two numbers of four
 *   gather_quads   four neighbouring words */
#ifndef GN_LANES_GATHER_H
#define GN_LANES_GATHER_H

#include "lanes.h"

/* Returns the bytes from p on as a number: `count` of them, 1, 2 or 4. */
static inline int32_t number_of_bytes(const unsigned char *p, int count)
{
#if defined(__GNUC__) && defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    typedef int32_t __attribute__((may_alias, aligned(1))) any_word;
    typedef uint16_t __attribute__((may_alias, aligned(1))) any_half;

    if (count == 4)
        return *(const any_word *)(const void *)p;
    if (count == 2)
        return *(const any_half *)(const void *)p;
    return p[0];
#else
    uint32_t number = p[0];

    for (int n = 1; n < count; ++n)
        number |= (uint32_t)p[n] << 8 * n;
    return (int32_t)number;
#endif
}

#if !defined(GN_LANES_INTRINSICS_HEADER) &&                                                        \
    (defined(GN_LANES_AVX512) || defined(GN_LANES_AVX2) || defined(GN_LANES_SSE2))

static inline void lanes_numbers_of(lanes_i index, int32_t at[GN_LANES])
{
#if defined(GN_LANES_AVX512)
    lanes_avx512_indices(index, at);
#elif defined(GN_LANES_AVX2)
    lanes_avx2_indices(index, at);
#else
    lanes_i_store(at, index);
#endif
}

GN_INLINE __m128i lanes_four_numbers(const unsigned char *base, const int32_t at[4], int count)
{
    return _mm_setr_epi32(
        number_of_bytes(base + at[0], count), number_of_bytes(base + at[1], count),
        number_of_bytes(base + at[2], count), number_of_bytes(base + at[3], count));
}

static inline lanes_i lanes_of_four(const __m128i four[4])
{
    lanes_i a;

#if defined(GN_LANES_AVX512)
    a.q = lanes_avx512_join(four[0], four[1], four[2], four[3]);
#elif defined(GN_LANES_AVX2)
    a.q[0] = _mm256_inserti128_si256(_mm256_castsi128_si256(four[0]), four[1], 1);
    a.q[1] = _mm256_inserti128_si256(_mm256_castsi128_si256(four[2]), four[3], 1);
#else
    for (int n = 0; n < 4; ++n)
        a.q[n] = four[n];
#endif
    return a;
}

/* Returns the numbers that `count` bytes from base + offset on are. The count must be constant. */
GN_INLINE lanes_i lanes_i_gather_bytes(const unsigned char *base, lanes_i offset, int count)
{
    int32_t at[GN_LANES];
    __m128i four[4];

    lanes_numbers_of(offset, at);
    four[0] = lanes_four_numbers(base, at, count);
    four[1] = lanes_four_numbers(base, at + 4, count);
    four[2] = lanes_four_numbers(base, at + 8, count);
    four[3] = lanes_four_numbers(base, at + 12, count);
    return lanes_of_four(four);
}

static inline __m128i lanes_eight_bytes(const unsigned char *p)
{
    return _mm_loadl_epi64((const __m128i *)(const void *)p);
}

/* Writes the numbers that the eight bytes from base + offset on are. */
GN_INLINE void lanes_i_gather_eight(const unsigned char *base, lanes_i offset, lanes_i *low,
                                    lanes_i *high)
{
    int32_t at[GN_LANES];
    __m128i l[4], h[4];

    lanes_numbers_of(offset, at);
    for (int n = 0; n < 4; ++n) {
        const int32_t *const i = at + 4 * n;
        const __m128 a = _mm_castsi128_ps(
            _mm_unpacklo_epi64(lanes_eight_bytes(base + i[0]), lanes_eight_bytes(base + i[1])));
        const __m128 b = _mm_castsi128_ps(
            _mm_unpacklo_epi64(lanes_eight_bytes(base + i[2]), lanes_eight_bytes(base + i[3])));

        l[n] = _mm_castps_si128(_mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)));
        h[n] = _mm_castps_si128(_mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)));
    }
    *low = lanes_of_four(l);
    *high = lanes_of_four(h);
}

static inline __m128 lanes_four_words(const stored_word *base, int32_t at)
{
    return _mm_loadu_ps((const float *)(const void *)(base + at));
}

/* Writes base[index + c] to out[c]. */
GN_INLINE void lanes_i_gather_quads(const stored_word *base, lanes_i index, lanes_i out[4])
{
    int32_t at[GN_LANES];

    lanes_numbers_of(index, at);
#if defined(GN_LANES_AVX512)
    __m512i r[4];

    for (int l = 0; l < 4; ++l)
        r[l] = lanes_avx512_join(_mm_castps_si128(lanes_four_words(base, at[l])),
                                 _mm_castps_si128(lanes_four_words(base, at[l + 4])),
                                 _mm_castps_si128(lanes_four_words(base, at[l + 8])),
                                 _mm_castps_si128(lanes_four_words(base, at[l + 12])));
    lanes_avx512_transpose(r);
    for (int c = 0; c < 4; ++c)
        out[c].q = r[c];
#elif defined(GN_LANES_AVX2)
    for (int n = 0; n < 2; ++n) {
        __m256 r[4];

        for (int l = 8 * n; l < 8 * n + 4; ++l)
            r[l % 4] = _mm256_insertf128_ps(_mm256_castps128_ps256(lanes_four_words(base, at[l])),
                                            lanes_four_words(base, at[l + 4]), 1);
        lanes_avx2_transpose(r);
        for (int c = 0; c < 4; ++c)
            out[c].q[n] = _mm256_castps_si256(r[c]);
    }
#else
    for (int n = 0; n < 4; ++n) {
        __m128 r[4];

        for (int l = 0; l < 4; ++l)
            r[l] = lanes_four_words(base, at[4 * n + l]);
        _MM_TRANSPOSE4_PS(r[0], r[1], r[2], r[3]);
        for (int c = 0; c < 4; ++c)
            out[c].q[n] = _mm_castps_si128(r[c]);
    }
#endif
}

#else

#if defined(GN_LANES_VECTORS)

GN_INLINE vector_i lanes_four_numbers(const unsigned char *base, const int32_t at[4], int count)
{
    return (vector_i){number_of_bytes(base + at[0], count), number_of_bytes(base + at[1], count),
                      number_of_bytes(base + at[2], count), number_of_bytes(base + at[3], count)};
}

GN_INLINE lanes_i lanes_i_gather_bytes(const unsigned char *base, lanes_i offset, int count)
{
    int32_t at[GN_LANES];

    lanes_i_store(at, offset);
    LANES_EACH_REGISTER(lanes_i, lanes_four_numbers(base, at + 4 * n, count));
}

GN_INLINE void lanes_i_gather_quads(const stored_word *base, lanes_i index, lanes_i out[4])
{
    int32_t at[GN_LANES];

    lanes_i_store(at, index);
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        vector_i r[4];

        GN_UNROLLED
        for (int l = 0; l < 4; ++l)
            r[l] = lanes_vector_load(base + at[4 * n + l]);
        lanes_vector_transpose(r);
        GN_UNROLLED
        for (int c = 0; c < 4; ++c)
            out[c].q[n] = r[c];
    }
}

#else

static inline lanes_i lanes_i_gather_bytes(const unsigned char *base, lanes_i offset, int count)
{
    int32_t at[GN_LANES];

    lanes_i_store(at, offset);
    GN_EACH_LANE (l)
        at[l] = number_of_bytes(base + at[l], count);
    return lanes_i_load(at);
}

static inline void lanes_i_gather_quads(const stored_word *base, lanes_i index, lanes_i out[4])
{
    lanes_i_gather_pairs(base, index, &out[0], &out[1]);
    lanes_i_gather_pairs(base + 2, index, &out[2], &out[3]);
}

#endif

static inline void lanes_i_gather_eight(const unsigned char *base, lanes_i offset, lanes_i *low,
                                        lanes_i *high)
{
    *low = lanes_i_gather_bytes(base, offset, 4);
    *high = lanes_i_gather_bytes(base + 4, offset, 4);
}

#endif

#endif
