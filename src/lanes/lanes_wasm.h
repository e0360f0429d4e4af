/* Lanes in four of WebAssembly's 128-bit vectors. The results are those of lanes_portable.h, which
 * defines each operation. In WebAssembly conversions to integers saturate and turn NaN into 0, so
 * they are composed with a comparison. pmin(a, b) is b < a ? b : a and pmax(a, b) is a < b ? b : a;
 * with the operands exchanged they are min and max (WebAssembly specification, section 4.3.3).
 * Not alone: lanes.h chooses one form and includes it after GN_LANES and GN_EACH_LANE. */
#ifndef GN_LANES_LANES_WASM_H
#define GN_LANES_LANES_WASM_H

#if defined(GN_LANES_INTRINSICS_HEADER)
#include GN_LANES_INTRINSICS_HEADER
#else
#include <wasm_simd128.h>
#endif

#include "four_registers.h"

typedef struct lanes_f {
    v128_t q[4];
} lanes_f;

typedef struct lanes_i {
    v128_t q[4];
} lanes_i;

typedef struct lanes_m {
    v128_t q[4];
} lanes_m;

GN_OPERATION lanes_f lanes_load(const float p[GN_LANES])
{
    LANES_EACH_REGISTER(lanes_f, wasm_v128_load(p + 4 * n));
}

GN_OPERATION void lanes_store(float *p, lanes_f a)
{
    wasm_v128_store(p, a.q[0]);
    wasm_v128_store(p + 4, a.q[1]);
    wasm_v128_store(p + 8, a.q[2]);
    wasm_v128_store(p + 12, a.q[3]);
}

GN_OPERATION lanes_f lanes_splat(float a)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_splat(a));
}

GN_OPERATION lanes_f lanes_columns(float per_x, float x, float origin)
{
    const v128_t column = wasm_f32x4_add(wasm_f32x4_splat(x), wasm_f32x4_make(0, 1, 2, 3));
    const v128_t value =
        wasm_f32x4_add(wasm_f32x4_mul(wasm_f32x4_splat(per_x), column), wasm_f32x4_splat(origin));

    LANES_EACH_REGISTER(lanes_f, value);
}

GN_OPERATION lanes_f lanes_rows(float per_y, float y)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_splat(per_y * (y + (float)n)));
}

GN_OPERATION lanes_f lanes_add(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_add(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_sub(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_sub(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_mul(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_mul(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_div(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_div(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_sqrt(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_sqrt(a.q[n]));
}

GN_OPERATION lanes_m lanes_greater(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, wasm_f32x4_gt(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_less_equal(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, wasm_f32x4_le(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_and(lanes_m a, lanes_m b)
{
    LANES_EACH_REGISTER(lanes_m, wasm_v128_and(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_not(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_m, wasm_v128_not(a.q[n]));
}

GN_OPERATION uint32_t lanes_wasm_bits(const v128_t q[4])
{
    return (uint32_t)wasm_i32x4_bitmask(q[0]) | (uint32_t)wasm_i32x4_bitmask(q[1]) << 4 |
           (uint32_t)wasm_i32x4_bitmask(q[2]) << 8 | (uint32_t)wasm_i32x4_bitmask(q[3]) << 12;
}

GN_OPERATION uint32_t lanes_bits(lanes_m a)
{
    return lanes_wasm_bits(a.q);
}

GN_OPERATION lanes_m lanes_from_bits(uint32_t bits)
{
    const v128_t all = wasm_i32x4_splat((int32_t)bits);

    LANES_EACH_REGISTER(lanes_m,
                        wasm_i32x4_ne(wasm_v128_and(all, wasm_i32x4_make(1 << 4 * n, 2 << 4 * n,
                                                                         4 << 4 * n, 8 << 4 * n)),
                                      wasm_i32x4_splat(0)));
}

GN_OPERATION lanes_f lanes_select(lanes_m m, lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, wasm_v128_bitselect(a.q[n], b.q[n], m.q[n]));
}

GN_OPERATION lanes_f lanes_min(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_pmin(b.q[n], a.q[n]));
}

GN_OPERATION lanes_f lanes_max(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_pmax(b.q[n], a.q[n]));
}

GN_OPERATION lanes_i lanes_i_splat(int32_t a)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_splat(a));
}

GN_OPERATION lanes_i lanes_i_halves(int32_t lower, int32_t upper)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_splat(n < 2 ? lower : upper));
}

GN_OPERATION lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    const v128_t columns =
        wasm_i32x4_mul(wasm_i32x4_splat(per_column), wasm_i32x4_make(0, 1, 2, 3));

    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_add(columns, wasm_i32x4_splat(n * per_row)));
}

GN_OPERATION lanes_i lanes_i_load(const int32_t p[GN_LANES])
{
    LANES_EACH_REGISTER(lanes_i, wasm_v128_load(p + 4 * n));
}

GN_OPERATION void lanes_i_store(int32_t *p, lanes_i a)
{
    wasm_v128_store(p, a.q[0]);
    wasm_v128_store(p + 4, a.q[1]);
    wasm_v128_store(p + 8, a.q[2]);
    wasm_v128_store(p + 12, a.q[3]);
}

GN_OPERATION lanes_i lanes_i_add(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_add(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_sub(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_mul(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul_short(lanes_i a, int32_t b)
{
    return lanes_i_mul(a, lanes_i_splat(b));
}

GN_OPERATION lanes_i lanes_i_mul_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i16x8_mul(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_high_bytes(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_i, wasm_u16x8_shr(a.q[n], 8));
}

GN_OPERATION lanes_i lanes_i_add_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_u8x16_add_sat(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_u8x16_sub_sat(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_add_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_u16x8_add_sat(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_u16x8_sub_sat(a.q[n], b.q[n]));
}

/* Returns the scaled products of four shorts, given the products. */
static inline v128_t lanes_wasm_scaled(v128_t product)
{
    const v128_t corrected = wasm_i32x4_add(product, wasm_u32x4_shr(product, 16));

    return wasm_u32x4_shr(wasm_i32x4_add(corrected, wasm_i32x4_splat(1 << 15)), 16);
}

GN_OPERATION lanes_i lanes_i_scale_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(
        lanes_i,
        wasm_u16x8_narrow_i32x4(lanes_wasm_scaled(wasm_u32x4_extmul_low_u16x8(a.q[n], b.q[n])),
                                lanes_wasm_scaled(wasm_u32x4_extmul_high_u16x8(a.q[n], b.q[n]))));
}

GN_OPERATION lanes_i lanes_i_shift_left(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_shl(a.q[n], (uint32_t)count));
}

GN_OPERATION lanes_i lanes_i_shift_right(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_shr(a.q[n], (uint32_t)count));
}

GN_OPERATION lanes_i lanes_i_min(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_min(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_max(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_i32x4_max(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_or(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_v128_or(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_and(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_v128_and(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_xor(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_v128_xor(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_i_greater(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, wasm_i32x4_gt(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_i_equal(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, wasm_i32x4_eq(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_select(lanes_m m, lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, wasm_v128_bitselect(a.q[n], b.q[n], m.q[n]));
}

GN_OPERATION lanes_i lanes_m_as_int(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n]);
}

GN_OPERATION uint32_t lanes_i_sign_bits(lanes_i a)
{
    return lanes_wasm_bits(a.q);
}

GN_OPERATION lanes_f lanes_to_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_convert_i32x4(a.q[n]));
}

GN_OPERATION lanes_i lanes_as_int(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n]);
}

/* Returns INT32_MIN where a is NaN or at least 2^31. Below -2^31, saturation already returns
 * INT32_MIN. */
GN_OPERATION v128_t lanes_wasm_truncate(v128_t a)
{
    return wasm_v128_bitselect(wasm_i32x4_trunc_sat_f32x4(a), wasm_i32x4_splat(INT32_MIN),
                               wasm_f32x4_lt(a, wasm_f32x4_splat(2147483648.0f)));
}

GN_OPERATION lanes_f lanes_as_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n]);
}

GN_OPERATION lanes_i lanes_truncate(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, lanes_wasm_truncate(a.q[n]));
}

GN_OPERATION lanes_f lanes_floor(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, wasm_f32x4_floor(a.q[n]));
}

GN_OPERATION lanes_f lanes_quad_left(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, wasm_i32x4_shuffle(a.q[n], a.q[n], 0, 0, 2, 2));
}

GN_OPERATION lanes_f lanes_quad_right(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, wasm_i32x4_shuffle(a.q[n], a.q[n], 1, 1, 3, 3));
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
    LANES_EACH_REGISTER(lanes_i, lanes_wasm_truncate(wasm_f32x4_nearest(a.q[n])));
}

GN_OPERATION v128_t lanes_wasm_unorm8(v128_t a)
{
    return lanes_wasm_truncate(wasm_f32x4_nearest(wasm_f32x4_mul(a, wasm_f32x4_splat(255.0f))));
}

/* Rounds four pixels and transposes their bytes; narrowing saturates. */
GN_OPERATION v128_t lanes_wasm_pack(v128_t red, v128_t green, v128_t blue, v128_t alpha)
{
    const v128_t rg = wasm_i16x8_narrow_i32x4(lanes_wasm_unorm8(red), lanes_wasm_unorm8(green));
    const v128_t ba = wasm_i16x8_narrow_i32x4(lanes_wasm_unorm8(blue), lanes_wasm_unorm8(alpha));
    const v128_t planes = wasm_u8x16_narrow_i16x8(rg, ba);

    return wasm_i8x16_shuffle(planes, planes, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
}

GN_OPERATION lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    LANES_EACH_REGISTER(lanes_i, lanes_wasm_pack(red.q[n], green.q[n], blue.q[n], alpha.q[n]));
}

GN_OPERATION lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                        ptrdiff_t stride)
{
    LANES_EACH_REGISTER(lanes_i, wasm_v128_load((n < 2 ? lower : upper) + n % 2 * stride));
}

GN_OPERATION void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                      lanes_i a)
{
    wasm_v128_store(lower, a.q[0]);
    wasm_v128_store(lower + stride, a.q[1]);
    wasm_v128_store(upper, a.q[2]);
    wasm_v128_store(upper + stride, a.q[3]);
}

/* Transposes 4x4 words. */
GN_OPERATION void lanes_wasm_transpose(v128_t r[4])
{
    const v128_t a = wasm_i32x4_shuffle(r[0], r[1], 0, 4, 1, 5);
    const v128_t b = wasm_i32x4_shuffle(r[0], r[1], 2, 6, 3, 7);
    const v128_t c = wasm_i32x4_shuffle(r[2], r[3], 0, 4, 1, 5);
    const v128_t d = wasm_i32x4_shuffle(r[2], r[3], 2, 6, 3, 7);

    r[0] = wasm_i32x4_shuffle(a, c, 0, 1, 4, 5);
    r[1] = wasm_i32x4_shuffle(a, c, 2, 3, 6, 7);
    r[2] = wasm_i32x4_shuffle(b, d, 0, 1, 4, 5);
    r[3] = wasm_i32x4_shuffle(b, d, 2, 3, 6, 7);
}

GN_OPERATION void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset,
                                      uint32_t step, lanes_i out[4])
{
    for (uint32_t n = 0; n < 4; ++n) {
        v128_t r[4];

        for (uint32_t l = 0; l < 4; ++l)
            r[l] = wasm_v128_load(memory + offset[(4 * n + l) * step]);
        lanes_wasm_transpose(r);
        for (int c = 0; c < 4; ++c)
            out[c].q[n] = r[c];
    }
}

GN_OPERATION void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    for (size_t n = 0; n < 4; ++n) {
        v128_t r[4];

        for (int c = 0; c < 4; ++c)
            r[c] = in[c].q[n];
        lanes_wasm_transpose(r);
        for (size_t l = 0; l < 4; ++l)
            wasm_v128_store(memory + (4 * n + l) * stride, r[l]);
    }
}

GN_OPERATION v128_t lanes_wasm_unpack(v128_t packed, int channel)
{
    const v128_t byte =
        wasm_v128_and(wasm_u32x4_shr(packed, (uint32_t)(8 * channel)), wasm_i32x4_splat(0xFF));

    return wasm_f32x4_mul(wasm_f32x4_convert_i32x4(byte), wasm_f32x4_splat((float)(1.0 / 255.0)));
}

GN_OPERATION lanes_f lanes_unpack_unorm8(lanes_i packed, int channel)
{
    LANES_EACH_REGISTER(lanes_f, lanes_wasm_unpack(packed.q[n], channel));
}

GN_OPERATION lanes_i lanes_i_gather(const stored_word *base, lanes_i index)
{
    int32_t word[GN_LANES];

    lanes_i_store(word, index);
    GN_EACH_LANE (l)
        word[l] = base[word[l]];
    return lanes_i_load(word);
}

GN_OPERATION void lanes_i_gather_pairs(const stored_word *base, lanes_i index, lanes_i *first,
                                       lanes_i *second)
{
    int32_t at[GN_LANES], next[GN_LANES];

    lanes_i_store(at, index);
    GN_EACH_LANE (l) {
        next[l] = base[at[l] + 1];
        at[l] = base[at[l]];
    }
    *first = lanes_i_load(at);
    *second = lanes_i_load(next);
}

#endif
