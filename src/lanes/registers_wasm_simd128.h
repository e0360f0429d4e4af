/* WebAssembly's vectors of four lanes. Its conversions to integers saturate and turn NaN into 0, so
 * they are composed with a comparison. pmin(a, b) is b < a ? b : a and pmax(a, b) is a < b ? b : a;
 * with the operands exchanged they are min and max (WebAssembly specification, section 4.3.3).
 * Not alone: lanes.h chooses one such file; lanes_registers.h says what it defines. */
#ifndef GN_LANES_REGISTERS_WASM_SIMD128_H
#define GN_LANES_REGISTERS_WASM_SIMD128_H

#if defined(GN_LANES_INTRINSICS_HEADER)
#include GN_LANES_INTRINSICS_HEADER
#else
#include <wasm_simd128.h>
#endif

#define LANES_REGISTERS 4

typedef v128_t register_f, register_i, register_m;

#define register_load(p) wasm_v128_load(p)
#define register_store(p, a) wasm_v128_store(p, a)
#define register_i_load(p) wasm_v128_load(p)
#define register_i_store(p, a) wasm_v128_store(p, a)
#define register_splat(a) wasm_f32x4_splat(a)
#define register_columns() wasm_f32x4_make(0, 1, 2, 3)
#define register_rows(per_y, y, n) wasm_f32x4_splat((per_y) * ((y) + (float)(n)))
#define register_add(a, b) wasm_f32x4_add(a, b)
#define register_sub(a, b) wasm_f32x4_sub(a, b)
#define register_mul(a, b) wasm_f32x4_mul(a, b)
#define register_div(a, b) wasm_f32x4_div(a, b)
#define register_sqrt(a) wasm_f32x4_sqrt(a)
#define register_min(a, b) wasm_f32x4_pmin(b, a)
#define register_max(a, b) wasm_f32x4_pmax(b, a)
#define register_greater(a, b) wasm_f32x4_gt(a, b)
#define register_less_equal(a, b) wasm_f32x4_le(a, b)
#define register_and(a, b) wasm_v128_and(a, b)
#define register_not(a) wasm_v128_not(a)
#define register_select(m, a, b) wasm_v128_bitselect(a, b, m)
#define register_from_bits(bits, n) wasm_from_bits(bits, n)
#define register_m_as_int(a) (a)
#define register_negative(a) (a) /* registers_bits reads only the sign */
#define register_truncate(a) wasm_truncate(a)
#define register_round(a) wasm_truncate(wasm_f32x4_nearest(a))
#define register_floor(a) wasm_f32x4_floor(a)
#define register_floor_to_int(a) wasm_truncate(wasm_f32x4_floor(a))
#define register_to_float(a) wasm_f32x4_convert_i32x4(a)
#define register_as_int(a) (a)
#define register_as_float(a) (a)
#define register_quad_left(a) wasm_i32x4_shuffle(a, a, 0, 0, 2, 2)
#define register_quad_right(a) wasm_i32x4_shuffle(a, a, 1, 1, 3, 3)
#define register_i_splat(a) wasm_i32x4_splat(a)
#define register_i_columns(a) wasm_i32x4_mul(wasm_i32x4_splat(a), wasm_i32x4_make(0, 1, 2, 3))
#define register_i_rows(per_row, n) wasm_i32x4_splat((n) * (per_row))
#define register_i_add(a, b) wasm_i32x4_add(a, b)
#define register_i_sub(a, b) wasm_i32x4_sub(a, b)
#define register_i_mul(a, b) wasm_i32x4_mul(a, b)
#define register_i_mul_short(a, b) wasm_i32x4_mul(a, wasm_i32x4_splat(b))
#define register_i_or(a, b) wasm_v128_or(a, b)
#define register_i_and(a, b) wasm_v128_and(a, b)
#define register_i_xor(a, b) wasm_v128_xor(a, b)
#define register_i_mul_shorts(a, b) wasm_i16x8_mul(a, b)
#define register_i_high_bytes(a) wasm_u16x8_shr(a, 8)
#define register_i_add_bytes(a, b) wasm_u8x16_add_sat(a, b)
#define register_i_sub_bytes(a, b) wasm_u8x16_sub_sat(a, b)
#define register_i_add_shorts(a, b) wasm_u16x8_add_sat(a, b)
#define register_i_sub_shorts(a, b) wasm_u16x8_sub_sat(a, b)
#define register_i_scale_shorts(a, b)                                                              \
    wasm_u16x8_narrow_i32x4(wasm_scaled(wasm_u32x4_extmul_low_u16x8(a, b)),                        \
                            wasm_scaled(wasm_u32x4_extmul_high_u16x8(a, b)))
#define register_i_shift_left(a, count) wasm_i32x4_shl(a, (uint32_t)(count))
#define register_i_shift_right(a, count) wasm_i32x4_shr(a, (uint32_t)(count))
#define register_i_shift_right_logical(a, count) wasm_u32x4_shr(a, (uint32_t)(count))
#define register_i_min(a, b) wasm_i32x4_min(a, b)
#define register_i_max(a, b) wasm_i32x4_max(a, b)
#define register_i_select(m, a, b) wasm_v128_bitselect(a, b, m)
#define register_i_greater(a, b) wasm_i32x4_gt(a, b)
#define register_i_equal(a, b) wasm_i32x4_eq(a, b)
#define register_i_load_rows(ROW) wasm_v128_load(ROW(0))
#define register_i_store_rows(ROW, a) wasm_v128_store(ROW(0), a)
#define register_i_load_rows_of_bytes(ROW) wasm_load_bytes(ROW(0))
#define register_i_store_rows_of_bytes(ROW, a)                                                     \
    wasm_v128_store32_lane(ROW(0), register_i_transpose_bytes(a), 0)
#define register_i_load_rows_of_shorts(ROW) wasm_u32x4_load16x4(ROW(0))
#define register_i_store_rows_of_shorts(ROW, a)                                                    \
    wasm_v128_store64_lane(ROW(0), wasm_i16x8_shuffle(a, a, 0, 2, 4, 6, 0, 2, 4, 6), 0)
#define register_i_load_rows_of_threes(ROW) wasm_load_threes(ROW(0))
#define register_i_store_rows_of_threes(ROW, a) wasm_store_threes(ROW(0), a)
#define register_load_pairs(AT, first) wasm_load_pairs(AT(first), AT((first) + 1))
#define register_even(a, b) wasm_i32x4_shuffle(a, b, 0, 2, 4, 6)
#define register_odd(a, b) wasm_i32x4_shuffle(a, b, 1, 3, 5, 7)
#define register_shuffle(a, b, i, j, k, l) wasm_i32x4_shuffle(a, b, i, j, (k) + 4, (l) + 4)
#define register_spread(a, i) wasm_i32x4_shuffle(a, a, i, i, i, i)
#define register_splat_vec4(p) wasm_v128_load(p)
#define register_i_interleave_low(a, b) wasm_i32x4_shuffle(a, b, 0, 4, 1, 5)
#define register_i_interleave_high(a, b) wasm_i32x4_shuffle(a, b, 2, 6, 3, 7)
#define register_i_set(NUMBER) wasm_i32x4_make(NUMBER(0), NUMBER(1), NUMBER(2), NUMBER(3))
#define register_indices(at, index) wasm_v128_store(at, index)
#define register_i_pack_words(a, b) wasm_i16x8_narrow_i32x4(a, b)
#define register_i_pack_shorts(a, b) wasm_u8x16_narrow_i16x8(a, b)
#define register_i_transpose_bytes(a)                                                              \
    wasm_i8x16_shuffle(a, a, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15)

#define wasm_bits(a, n) (uint32_t) wasm_i32x4_bitmask(a) << 4 * (n)
#define registers_bits(q)                                                                          \
    (wasm_bits(q[0], 0) | wasm_bits(q[1], 1) | wasm_bits(q[2], 2) | wasm_bits(q[3], 3))

GN_OPERATION v128_t wasm_from_bits(uint32_t bits, int n)
{
    const v128_t lane = wasm_i32x4_make(1 << 4 * n, 2 << 4 * n, 4 << 4 * n, 8 << 4 * n);

    return wasm_i32x4_ne(wasm_v128_and(wasm_i32x4_splat((int32_t)bits), lane), wasm_i32x4_splat(0));
}

/* Returns INT32_MIN where a is NaN or at least 2^31. Below -2^31, saturation already returns
 * INT32_MIN. */
GN_OPERATION v128_t wasm_truncate(v128_t a)
{
    return wasm_v128_bitselect(wasm_i32x4_trunc_sat_f32x4(a), wasm_i32x4_splat(INT32_MIN),
                               wasm_f32x4_lt(a, wasm_f32x4_splat(2147483648.0f)));
}

/* Returns (p + p / 2^16 + 2^15) / 2^16 for four products p. */
static inline v128_t wasm_scaled(v128_t product)
{
    const v128_t corrected = wasm_i32x4_add(product, wasm_u32x4_shr(product, 16));

    return wasm_u32x4_shr(wasm_i32x4_add(corrected, wasm_i32x4_splat(1 << 15)), 16);
}

GN_OPERATION v128_t wasm_load_pairs(const void *first, const void *second)
{
    return wasm_v128_load64_lane(second, wasm_v128_load64_zero(first), 1);
}

/* Rows of four pixels, of one, two and three bytes. */

GN_OPERATION v128_t wasm_load_bytes(const void *row)
{
    return wasm_u32x4_extend_low_u16x8(wasm_u16x8_extend_low_u8x16(wasm_v128_load32_zero(row)));
}

GN_OPERATION v128_t wasm_load_threes(const unsigned char *row)
{
    static const int8_t order[16] = {GN_FROM_THREES};

    return wasm_i8x16_swizzle(wasm_load_pairs(row, row + 4), wasm_v128_load(order));
}

GN_OPERATION void wasm_store_threes(unsigned char *row, v128_t a)
{
    static const int8_t order[16] = {GN_TO_THREES};
    const v128_t bytes = wasm_i8x16_swizzle(a, wasm_v128_load(order));

    wasm_v128_store64_lane(row, bytes, 0);
    wasm_v128_store64_lane(row + 4, bytes, 1);
}

#endif
