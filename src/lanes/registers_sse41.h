/* SSE4.1's registers of four lanes: SSE2's, with the instructions of SSE3, SSSE3 and SSE4.1.
 * Not alone: lanes.h chooses one such file; lanes_registers.h says what it defines. */
#ifndef GN_LANES_REGISTERS_SSE41_H
#define GN_LANES_REGISTERS_SSE41_H

#include <smmintrin.h>

#include "registers_sse2.h"

#undef register_select
#undef register_floor
#undef register_floor_to_int
#undef register_quad_left
#undef register_quad_right
#undef register_i_mul
#undef register_i_min
#undef register_i_max
#undef register_i_select
#undef register_pack_two
#undef register_i_load_rows_of_bytes
#undef register_i_store_rows_of_bytes
#undef register_i_load_rows_of_shorts
#undef register_i_store_rows_of_shorts
#undef register_i_load_rows_of_threes
#undef register_i_store_rows_of_threes

#define register_select(m, a, b) _mm_blendv_ps(b, a, _mm_castsi128_ps(m))
#define register_floor(a) _mm_floor_ps(a)
#define register_floor_to_int(a) _mm_cvttps_epi32(_mm_floor_ps(a))
#define register_quad_left(a) _mm_moveldup_ps(a)
#define register_quad_right(a) _mm_movehdup_ps(a)
#define register_i_mul(a, b) _mm_mullo_epi32(a, b)
#define register_i_min(a, b) _mm_min_epi32(a, b)
#define register_i_max(a, b) _mm_max_epi32(a, b)
#define register_i_select(m, a, b) _mm_blendv_epi8(b, a, m)
#define register_i_pack_words(a, b) _mm_packs_epi32(a, b)
#define register_i_pack_shorts(a, b) _mm_packus_epi16(a, b)
#define register_i_transpose_bytes(a)                                                              \
    _mm_shuffle_epi8(a, _mm_setr_epi8(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15))
#define register_i_load_rows_of_bytes(ROW) sse41_load_bytes(ROW(0))
#define register_i_store_rows_of_bytes(ROW, a) sse41_store_bytes(ROW(0), a)
#define register_i_load_rows_of_shorts(ROW) sse41_load_shorts(ROW(0))
#define register_i_store_rows_of_shorts(ROW, a) sse41_store_shorts(ROW(0), a)
#define register_i_load_rows_of_threes(ROW) sse41_load_threes(ROW(0))
#define register_i_store_rows_of_threes(ROW, a) sse41_store_threes(ROW(0), a)

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
    return _mm_shuffle_epi8(_mm_castps_si128(sse2_load_pairs(row, row + 4)),
                            _mm_setr_epi8(GN_FROM_THREES));
}

GN_OPERATION void sse41_store_threes(unsigned char *row, __m128i a)
{
    const __m128i bytes = _mm_shuffle_epi8(a, _mm_setr_epi8(GN_TO_THREES));

    _mm_storel_epi64((__m128i *)(void *)row, bytes);
    _mm_storeh_pi((__m64 *)(void *)(row + 4), _mm_castsi128_ps(bytes));
}

#endif
