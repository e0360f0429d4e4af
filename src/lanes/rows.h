/* Lanes of pixels that are no words of 32 bits: four rows of four pixels, which are bytes, shorts
 * or pairs of words. Rows lie anywhere in memory.
 *
 *   load_bytes store_bytes     one byte a pixel; stores take a lane's low 8 bits
 *   load_shorts store_shorts   one short a pixel, aligned; stores take a lane's low 16 bits
 *   load_pairs store_pairs     two words a pixel, aligned to shorts at least
 *   load_threes store_threes   three bytes a pixel; stores take a lane's low 24 bits
 *   load_fours store_fours     four words a pixel */
#ifndef GN_LANES_ROWS_H
#define GN_LANES_ROWS_H

#include "lanes.h"

/* Whether lanes are in x86's registers, and are not emulated. */
#if (defined(GN_LANES_AVX512) || defined(GN_LANES_AVX2) || defined(GN_LANES_SSE2)) &&              \
    !defined(GN_LANES_INTRINSICS_HEADER)
#define LANES_ROWS_OF_X86 1
#else
#define LANES_ROWS_OF_X86 0
#endif

/* Whether there are loads and stores of pairs, threes and fours. They take the first word from the
 * lower address, as only little-endian processors have both pairs of shorts and pairs of words. */
#if defined(GN_LANES_VECTORS) && defined(__BYTE_ORDER__) &&                                        \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define GN_LANES_HAVE_PAIRS 1
#include "rows_vectors.h"
#else
#define GN_LANES_HAVE_PAIRS LANES_ROWS_OF_X86
#endif

#if LANES_ROWS_OF_X86

/* A word at any address. */
typedef int32_t __attribute__((may_alias, aligned(1))) lanes_any_word;

/* Returns the low words of four rows, one after the other. */
static inline __m128i lanes_word_rows(unsigned char *const row[4])
{
    return _mm_setr_epi32(*(const lanes_any_word *)(const void *)row[0],
                          *(const lanes_any_word *)(const void *)row[1],
                          *(const lanes_any_word *)(const void *)row[2],
                          *(const lanes_any_word *)(const void *)row[3]);
}

static inline void lanes_store_word_rows(unsigned char *const row[4], __m128i a)
{
    int32_t word[4];

    _mm_storeu_si128((__m128i *)(void *)word, a);
    for (int r = 0; r < 4; ++r)
        *(lanes_any_word *)(void *)row[r] = word[r];
}

/* Returns eight bytes of two rows. */
static inline __m128i lanes_short_rows(const unsigned char *first, const unsigned char *second)
{
    return _mm_unpacklo_epi64(_mm_loadl_epi64((const __m128i *)(const void *)first),
                              _mm_loadl_epi64((const __m128i *)(const void *)second));
}

static inline void lanes_store_short_rows(unsigned char *first, unsigned char *second, __m128i a)
{
    _mm_storel_epi64((__m128i *)(void *)first, a);
    _mm_storel_epi64((__m128i *)(void *)second, _mm_unpackhi_epi64(a, a));
}

/* Loads a row of pairs: the words of four pixels. */
static inline void lanes_pair_row(const unsigned char *row, __m128i *first, __m128i *second)
{
    const __m128 a = _mm_loadu_ps((const float *)(const void *)row);
    const __m128 b = _mm_loadu_ps((const float *)(const void *)(row + 16));

    *first = _mm_castps_si128(_mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)));
    *second = _mm_castps_si128(_mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)));
}

static inline void lanes_store_pair_row(unsigned char *row, __m128i first, __m128i second)
{
    _mm_storeu_si128((__m128i *)(void *)row, _mm_unpacklo_epi32(first, second));
    _mm_storeu_si128((__m128i *)(void *)(row + 16), _mm_unpackhi_epi32(first, second));
}

/* The first and the second pixel in each half of a register. */
#define LANES_FIRST_THREE _mm_set1_epi64x(0xFFFFFF)
#define LANES_SECOND_THREE _mm_set1_epi64x(0x00FFFFFF00000000)

/* Loads a row of threes: twelve bytes. The second half of a register begins with byte 6. */
static inline __m128i lanes_three_row(const unsigned char *row)
{
    const __m128i bytes =
        _mm_unpacklo_epi64(_mm_loadl_epi64((const __m128i *)(const void *)row),
                           _mm_cvtsi32_si128(*(const lanes_any_word *)(const void *)(row + 8)));
    const __m128i halves = _mm_unpacklo_epi64(bytes, _mm_srli_si128(bytes, 6));

    return _mm_or_si128(_mm_and_si128(halves, LANES_FIRST_THREE),
                        _mm_and_si128(_mm_slli_epi64(halves, 8), LANES_SECOND_THREE));
}

static inline void lanes_store_three_row(unsigned char *row, __m128i a)
{
    const __m128i halves = _mm_or_si128(_mm_and_si128(a, LANES_FIRST_THREE),
                                        _mm_srli_epi64(_mm_and_si128(a, LANES_SECOND_THREE), 8));
    const __m128i second = _mm_unpackhi_epi64(halves, halves);

    _mm_storel_epi64((__m128i *)(void *)row, _mm_or_si128(halves, _mm_slli_epi64(second, 48)));
    *(lanes_any_word *)(void *)(row + 8) = _mm_cvtsi128_si32(_mm_srli_epi64(second, 16));
}

#endif

#if LANES_ROWS_OF_X86 && defined(GN_LANES_AVX512)

/* The rows of four lanes. */
static inline void lanes_quarters(lanes_i a, __m128i quarter[4])
{
    quarter[0] = _mm512_castsi512_si128(a.q);
    quarter[1] = _mm512_extracti32x4_epi32(a.q, 1);
    quarter[2] = _mm512_extracti32x4_epi32(a.q, 2);
    quarter[3] = _mm512_extracti32x4_epi32(a.q, 3);
}

static inline lanes_i lanes_of_quarters(const __m128i quarter[4])
{
    return lanes_avx512_i(
        _mm512_inserti64x4(_mm512_castsi256_si512(_mm256_set_m128i(quarter[1], quarter[0])),
                           _mm256_set_m128i(quarter[3], quarter[2]), 1));
}

static inline lanes_i lanes_i_load_bytes(unsigned char *const row[4])
{
    return lanes_avx512_i(_mm512_cvtepu8_epi32(lanes_word_rows(row)));
}

static inline void lanes_i_store_bytes(unsigned char *const row[4], lanes_i a)
{
    lanes_store_word_rows(row, _mm512_cvtepi32_epi8(a.q));
}

static inline lanes_i lanes_i_load_shorts(unsigned char *const row[4])
{
    return lanes_avx512_i(_mm512_cvtepu16_epi32(
        _mm256_inserti128_si256(_mm256_castsi128_si256(lanes_short_rows(row[0], row[1])),
                                lanes_short_rows(row[2], row[3]), 1)));
}

static inline void lanes_i_store_shorts(unsigned char *const row[4], lanes_i a)
{
    const __m256i shorts = _mm512_cvtepi32_epi16(a.q);

    lanes_store_short_rows(row[0], row[1], _mm256_castsi256_si128(shorts));
    lanes_store_short_rows(row[2], row[3], _mm256_extracti128_si256(shorts, 1));
}

#elif LANES_ROWS_OF_X86 && defined(GN_LANES_AVX2)

static inline void lanes_quarters(lanes_i a, __m128i quarter[4])
{
    for (int n = 0; n < 2; ++n) {
        quarter[2 * n] = _mm256_castsi256_si128(a.q[n]);
        quarter[2 * n + 1] = _mm256_extracti128_si256(a.q[n], 1);
    }
}

static inline lanes_i lanes_of_quarters(const __m128i quarter[4])
{
    LANES_EACH_REGISTER(lanes_i, _mm256_set_m128i(quarter[2 * n + 1], quarter[2 * n]));
}

static inline lanes_i lanes_i_load_bytes(unsigned char *const row[4])
{
    const __m128i bytes = lanes_word_rows(row);
    lanes_i a;

    a.q[0] = _mm256_cvtepu8_epi32(bytes);
    a.q[1] = _mm256_cvtepu8_epi32(_mm_unpackhi_epi64(bytes, bytes));
    return a;
}

/* Packs the low 16 bits of lanes: rows 0, 2, 1 and 3. */
static inline __m256i lanes_avx2_shorts(lanes_i a)
{
    const __m256i low = _mm256_set1_epi32(0xFFFF);

    return _mm256_packus_epi32(_mm256_and_si256(a.q[0], low), _mm256_and_si256(a.q[1], low));
}

static inline void lanes_i_store_bytes(unsigned char *const row[4], lanes_i a)
{
    const __m256i low = _mm256_set1_epi32(0xFF);
    const __m256i shorts =
        _mm256_packus_epi32(_mm256_and_si256(a.q[0], low), _mm256_and_si256(a.q[1], low));
    const __m128i bytes =
        _mm_packus_epi16(_mm256_castsi256_si128(shorts), _mm256_extracti128_si256(shorts, 1));

    lanes_store_word_rows(row, _mm_shuffle_epi32(bytes, _MM_SHUFFLE(3, 1, 2, 0)));
}

static inline lanes_i lanes_i_load_shorts(unsigned char *const row[4])
{
    lanes_i a;

    for (int n = 0; n < 2; ++n)
        a.q[n] = _mm256_cvtepu16_epi32(lanes_short_rows(row[2 * n], row[2 * n + 1]));
    return a;
}

static inline void lanes_i_store_shorts(unsigned char *const row[4], lanes_i a)
{
    const __m256i shorts = lanes_avx2_shorts(a);

    lanes_store_short_rows(row[0], row[2], _mm256_castsi256_si128(shorts));
    lanes_store_short_rows(row[1], row[3], _mm256_extracti128_si256(shorts, 1));
}

#elif LANES_ROWS_OF_X86

static inline void lanes_quarters(lanes_i a, __m128i quarter[4])
{
    for (int n = 0; n < 4; ++n)
        quarter[n] = a.q[n];
}

static inline lanes_i lanes_of_quarters(const __m128i quarter[4])
{
    LANES_EACH_REGISTER(lanes_i, quarter[n]);
}

static inline lanes_i lanes_i_load_bytes(unsigned char *const row[4])
{
    const __m128i zero = _mm_setzero_si128();
    const __m128i bytes = lanes_word_rows(row);
    const __m128i low = _mm_unpacklo_epi8(bytes, zero);
    const __m128i high = _mm_unpackhi_epi8(bytes, zero);
    lanes_i a;

    a.q[0] = _mm_unpacklo_epi16(low, zero);
    a.q[1] = _mm_unpackhi_epi16(low, zero);
    a.q[2] = _mm_unpacklo_epi16(high, zero);
    a.q[3] = _mm_unpackhi_epi16(high, zero);
    return a;
}

/* Packs the low 16 bits of two registers. Their sign is extended, so that no value saturates. */
static inline __m128i lanes_sse2_shorts(__m128i a, __m128i b)
{
    return _mm_packs_epi32(_mm_srai_epi32(_mm_slli_epi32(a, 16), 16),
                           _mm_srai_epi32(_mm_slli_epi32(b, 16), 16));
}

static inline void lanes_i_store_bytes(unsigned char *const row[4], lanes_i a)
{
    const __m128i byte = _mm_set1_epi16(0xFF);

    lanes_store_word_rows(row,
                          _mm_packus_epi16(_mm_and_si128(lanes_sse2_shorts(a.q[0], a.q[1]), byte),
                                           _mm_and_si128(lanes_sse2_shorts(a.q[2], a.q[3]), byte)));
}

static inline lanes_i lanes_i_load_shorts(unsigned char *const row[4])
{
    lanes_i a;

    for (int n = 0; n < 4; ++n)
        a.q[n] = _mm_unpacklo_epi16(_mm_loadl_epi64((const __m128i *)(const void *)row[n]),
                                    _mm_setzero_si128());
    return a;
}

static inline void lanes_i_store_shorts(unsigned char *const row[4], lanes_i a)
{
    lanes_store_short_rows(row[0], row[1], lanes_sse2_shorts(a.q[0], a.q[1]));
    lanes_store_short_rows(row[2], row[3], lanes_sse2_shorts(a.q[2], a.q[3]));
}

#elif !GN_LANES_HAVE_PAIRS

/* The pixels of a row, and the rows. */
#define LANES_ROW (GN_LANES == 1 ? 1 : GN_LANES / 4)
#define LANES_ROWS (GN_LANES / LANES_ROW)

static inline lanes_i lanes_i_load_bytes(unsigned char *const row[4])
{
    int32_t value[GN_LANES];

    for (int r = 0; r < LANES_ROWS; ++r)
        for (int n = 0; n < LANES_ROW; ++n)
            value[LANES_ROW * r + n] = row[r][n];
    return lanes_i_load(value);
}

static inline void lanes_i_store_bytes(unsigned char *const row[4], lanes_i a)
{
    int32_t value[GN_LANES];

    lanes_i_store(value, a);
    for (int r = 0; r < LANES_ROWS; ++r)
        for (int n = 0; n < LANES_ROW; ++n)
            row[r][n] = (unsigned char)value[LANES_ROW * r + n];
}

static inline lanes_i lanes_i_load_shorts(unsigned char *const row[4])
{
    int32_t value[GN_LANES];

    for (int r = 0; r < LANES_ROWS; ++r)
        for (int n = 0; n < LANES_ROW; ++n)
            value[LANES_ROW * r + n] = ((const stored_half *)(const void *)row[r])[n];
    return lanes_i_load(value);
}

static inline void lanes_i_store_shorts(unsigned char *const row[4], lanes_i a)
{
    int32_t value[GN_LANES];

    lanes_i_store(value, a);
    for (int r = 0; r < LANES_ROWS; ++r)
        for (int n = 0; n < LANES_ROW; ++n)
            ((stored_half *)(void *)row[r])[n] = (uint16_t)value[LANES_ROW * r + n];
}

#endif

#if LANES_ROWS_OF_X86

static inline void lanes_i_load_pairs(unsigned char *const row[4], lanes_i *first, lanes_i *second)
{
    __m128i a[4], b[4];

    for (int r = 0; r < 4; ++r)
        lanes_pair_row(row[r], &a[r], &b[r]);
    *first = lanes_of_quarters(a);
    *second = lanes_of_quarters(b);
}

static inline void lanes_i_store_pairs(unsigned char *const row[4], lanes_i first, lanes_i second)
{
    __m128i a[4], b[4];

    lanes_quarters(first, a);
    lanes_quarters(second, b);
    for (int r = 0; r < 4; ++r)
        lanes_store_pair_row(row[r], a[r], b[r]);
}

/* Loads the four words of each pixel. */
static inline void lanes_i_load_fours(unsigned char *const row[4], lanes_i word[4])
{
    __m128i quarter[4][4];

    for (int r = 0; r < 4; ++r) {
        __m128 a[4];

        for (int i = 0; i < 4; ++i)
            a[i] = _mm_loadu_ps((const float *)(const void *)(row[r] + 16 * i));
        _MM_TRANSPOSE4_PS(a[0], a[1], a[2], a[3]);
        for (int i = 0; i < 4; ++i)
            quarter[i][r] = _mm_castps_si128(a[i]);
    }
    for (int i = 0; i < 4; ++i)
        word[i] = lanes_of_quarters(quarter[i]);
}

static inline void lanes_i_store_fours(unsigned char *const row[4], const lanes_i word[4])
{
    __m128i quarter[4][4];

    for (int i = 0; i < 4; ++i)
        lanes_quarters(word[i], quarter[i]);
    for (int r = 0; r < 4; ++r) {
        __m128 a[4];

        for (int i = 0; i < 4; ++i)
            a[i] = _mm_castsi128_ps(quarter[i][r]);
        _MM_TRANSPOSE4_PS(a[0], a[1], a[2], a[3]);
        for (int i = 0; i < 4; ++i)
            _mm_storeu_ps((float *)(void *)(row[r] + 16 * i), a[i]);
    }
}

static inline lanes_i lanes_i_load_threes(unsigned char *const row[4])
{
    __m128i a[4];

    for (int r = 0; r < 4; ++r)
        a[r] = lanes_three_row(row[r]);
    return lanes_of_quarters(a);
}

static inline void lanes_i_store_threes(unsigned char *const row[4], lanes_i a)
{
    __m128i quarter[4];

    lanes_quarters(a, quarter);
    for (int r = 0; r < 4; ++r)
        lanes_store_three_row(row[r], quarter[r]);
}

#endif

#endif
