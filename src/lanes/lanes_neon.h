/* Lanes in four registers of 64-bit Arm's Advanced SIMD. The results are those of lanes_portable.h,
 * which defines each operation. On Arm, conversions to integers saturate and turn NaN into 0 (Arm
 * ARM, FPToFixed), and min and max return NaN if either operand is NaN, so these operations are
 * composed with a comparison. Precondition: FPCR is in its initial state (round to nearest,
 * denormals kept).
 * Not alone: lanes.h chooses one form and includes it after GN_LANES and GN_EACH_LANE. */
#ifndef GN_LANES_LANES_NEON_H
#define GN_LANES_LANES_NEON_H

#if defined(GN_LANES_INTRINSICS_HEADER)
#include GN_LANES_INTRINSICS_HEADER
#else
#include <arm_neon.h>
#endif

#include "four_registers.h"

typedef struct lanes_f {
    float32x4_t q[4];
} lanes_f;

typedef struct lanes_i {
    int32x4_t q[4];
} lanes_i;

typedef struct lanes_m {
    uint32x4_t q[4];
} lanes_m;

/* Returns 0, 1, 2, 3. */
GN_OPERATION float32x4_t lanes_neon_columns(void)
{
    static const float columns[4] = {0.0f, 1.0f, 2.0f, 3.0f};

    return vld1q_f32(columns);
}

/* Returns the bits of lanes 4 * n to 4 * n + 3. */
GN_OPERATION uint32x4_t lanes_neon_bits(int n)
{
    static const uint32_t bits[4] = {1, 2, 4, 8};

    return vshlq_u32(vld1q_u32(bits), vdupq_n_s32(4 * n));
}

GN_OPERATION lanes_f lanes_load(const float p[GN_LANES])
{
    LANES_EACH_REGISTER(lanes_f, vld1q_f32(p + 4 * n));
}

GN_OPERATION void lanes_store(float *p, lanes_f a)
{
    vst1q_f32(p, a.q[0]);
    vst1q_f32(p + 4, a.q[1]);
    vst1q_f32(p + 8, a.q[2]);
    vst1q_f32(p + 12, a.q[3]);
}

GN_OPERATION lanes_f lanes_splat(float a)
{
    LANES_EACH_REGISTER(lanes_f, vdupq_n_f32(a));
}

GN_OPERATION lanes_f lanes_columns(float per_x, float x, float origin)
{
    const float32x4_t column = vaddq_f32(vdupq_n_f32(x), lanes_neon_columns());
    const float32x4_t value = vaddq_f32(vmulq_f32(vdupq_n_f32(per_x), column), vdupq_n_f32(origin));

    LANES_EACH_REGISTER(lanes_f, value);
}

GN_OPERATION lanes_f lanes_rows(float per_y, float y)
{
    LANES_EACH_REGISTER(lanes_f, vdupq_n_f32(per_y * (y + (float)n)));
}

GN_OPERATION lanes_f lanes_add(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, vaddq_f32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_sub(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, vsubq_f32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_mul(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, vmulq_f32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_div(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, vdivq_f32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_sqrt(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, vsqrtq_f32(a.q[n]));
}

GN_OPERATION lanes_m lanes_greater(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, vcgtq_f32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_less_equal(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, vcleq_f32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_and(lanes_m a, lanes_m b)
{
    LANES_EACH_REGISTER(lanes_m, vandq_u32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_not(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_m, vmvnq_u32(a.q[n]));
}

GN_OPERATION uint32_t lanes_bits(lanes_m a)
{
    const uint32x4_t low =
        vorrq_u32(vandq_u32(a.q[0], lanes_neon_bits(0)), vandq_u32(a.q[1], lanes_neon_bits(1)));
    const uint32x4_t high =
        vorrq_u32(vandq_u32(a.q[2], lanes_neon_bits(2)), vandq_u32(a.q[3], lanes_neon_bits(3)));

    return vaddvq_u32(vorrq_u32(low, high));
}

GN_OPERATION lanes_m lanes_from_bits(uint32_t bits)
{
    LANES_EACH_REGISTER(lanes_m, vtstq_u32(vdupq_n_u32(bits), lanes_neon_bits(n)));
}

GN_OPERATION lanes_f lanes_select(lanes_m m, lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, vbslq_f32(m.q[n], a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_min(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, vbslq_f32(vcgtq_f32(b.q[n], a.q[n]), a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_max(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, vbslq_f32(vcgtq_f32(a.q[n], b.q[n]), a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_splat(int32_t a)
{
    LANES_EACH_REGISTER(lanes_i, vdupq_n_s32(a));
}

GN_OPERATION lanes_i lanes_i_halves(int32_t lower, int32_t upper)
{
    LANES_EACH_REGISTER(lanes_i, vdupq_n_s32(n < 2 ? lower : upper));
}

GN_OPERATION lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    static const int32_t column[4] = {0, 1, 2, 3};
    const int32x4_t columns = vmulq_s32(vdupq_n_s32(per_column), vld1q_s32(column));

    LANES_EACH_REGISTER(lanes_i, vaddq_s32(columns, vdupq_n_s32(n * per_row)));
}

GN_OPERATION lanes_i lanes_i_load(const int32_t p[GN_LANES])
{
    LANES_EACH_REGISTER(lanes_i, vld1q_s32(p + 4 * n));
}

GN_OPERATION void lanes_i_store(int32_t *p, lanes_i a)
{
    vst1q_s32(p, a.q[0]);
    vst1q_s32(p + 4, a.q[1]);
    vst1q_s32(p + 8, a.q[2]);
    vst1q_s32(p + 12, a.q[3]);
}

GN_OPERATION lanes_i lanes_i_add(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vaddq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vsubq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vmulq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul_short(lanes_i a, int32_t b)
{
    return lanes_i_mul(a, lanes_i_splat(b));
}

GN_OPERATION lanes_i lanes_i_mul_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vreinterpretq_s32_s16(vmulq_s16(vreinterpretq_s16_s32(a.q[n]),
                                                                 vreinterpretq_s16_s32(b.q[n]))));
}

GN_OPERATION lanes_i lanes_i_high_bytes(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_i,
                        vreinterpretq_s32_u16(vshrq_n_u16(vreinterpretq_u16_s32(a.q[n]), 8)));
}

GN_OPERATION lanes_i lanes_i_add_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vreinterpretq_s32_u8(vqaddq_u8(vreinterpretq_u8_s32(a.q[n]),
                                                                vreinterpretq_u8_s32(b.q[n]))));
}

GN_OPERATION lanes_i lanes_i_sub_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vreinterpretq_s32_u8(vqsubq_u8(vreinterpretq_u8_s32(a.q[n]),
                                                                vreinterpretq_u8_s32(b.q[n]))));
}

GN_OPERATION lanes_i lanes_i_add_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vreinterpretq_s32_u16(vqaddq_u16(vreinterpretq_u16_s32(a.q[n]),
                                                                  vreinterpretq_u16_s32(b.q[n]))));
}

GN_OPERATION lanes_i lanes_i_sub_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vreinterpretq_s32_u16(vqsubq_u16(vreinterpretq_u16_s32(a.q[n]),
                                                                  vreinterpretq_u16_s32(b.q[n]))));
}

/* The last shift rounds. */
static inline uint16x4_t lanes_neon_scale(uint16x4_t a, uint16x4_t b)
{
    const uint32x4_t product = vmull_u16(a, b);

    return vrshrn_n_u32(vsraq_n_u32(product, product, 16), 16);
}

static inline int32x4_t lanes_neon_scale_shorts(uint16x8_t a, uint16x8_t b)
{
    return vreinterpretq_s32_u16(
        vcombine_u16(lanes_neon_scale(vget_low_u16(a), vget_low_u16(b)),
                     lanes_neon_scale(vget_high_u16(a), vget_high_u16(b))));
}

GN_OPERATION lanes_i lanes_i_scale_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, lanes_neon_scale_shorts(vreinterpretq_u16_s32(a.q[n]),
                                                         vreinterpretq_u16_s32(b.q[n])));
}

GN_OPERATION lanes_i lanes_i_shift_left(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, vshlq_s32(a.q[n], vdupq_n_s32(count)));
}

/* A shift to the left by a negative number of bits is a shift to the right. */
GN_OPERATION lanes_i lanes_i_shift_right(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, vshlq_s32(a.q[n], vdupq_n_s32(-count)));
}

GN_OPERATION lanes_i lanes_i_min(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vminq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_max(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vmaxq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_or(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vorrq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_and(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vandq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_xor(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, veorq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_i_greater(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, vcgtq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_m lanes_i_equal(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, vceqq_s32(a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_select(lanes_m m, lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, vbslq_s32(m.q[n], a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_m_as_int(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_i, vreinterpretq_s32_u32(a.q[n]));
}

GN_OPERATION lanes_m lanes_neon_negative(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_m, vreinterpretq_u32_s32(vshrq_n_s32(a.q[n], 31)));
}

GN_OPERATION uint32_t lanes_i_sign_bits(lanes_i a)
{
    return lanes_bits(lanes_neon_negative(a));
}

GN_OPERATION lanes_f lanes_to_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, vcvtq_f32_s32(a.q[n]));
}

GN_OPERATION lanes_i lanes_as_int(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, vreinterpretq_s32_f32(a.q[n]));
}

/* Returns `converted`, but INT32_MIN where a is NaN or at least 2^31. Below -2^31, saturation
 * already returns INT32_MIN. */
GN_OPERATION int32x4_t lanes_neon_converted(float32x4_t a, int32x4_t converted)
{
    return vbslq_s32(vcgtq_f32(vdupq_n_f32(2147483648.0f), a), converted, vdupq_n_s32(INT32_MIN));
}

GN_OPERATION lanes_f lanes_as_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, vreinterpretq_f32_s32(a.q[n]));
}

GN_OPERATION lanes_i lanes_truncate(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, lanes_neon_converted(a.q[n], vcvtq_s32_f32(a.q[n])));
}

GN_OPERATION lanes_f lanes_floor(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, vrndmq_f32(a.q[n]));
}

GN_OPERATION lanes_f lanes_quad_left(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, vtrn1q_f32(a.q[n], a.q[n]));
}

GN_OPERATION lanes_f lanes_quad_right(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, vtrn2q_f32(a.q[n], a.q[n]));
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
    LANES_EACH_REGISTER(lanes_i, lanes_neon_converted(a.q[n], vcvtnq_s32_f32(a.q[n])));
}

GN_OPERATION int32x4_t lanes_neon_unorm8(float32x4_t a)
{
    const float32x4_t scaled = vmulq_f32(a, vdupq_n_f32(255.0f));

    return lanes_neon_converted(scaled, vcvtnq_s32_f32(scaled));
}

/* Rounds four pixels and transposes their bytes; the narrowing moves saturate. */
GN_OPERATION int32x4_t lanes_neon_pack(float32x4_t red, float32x4_t green, float32x4_t blue,
                                       float32x4_t alpha)
{
    static const uint8_t order[16] = {0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};
    const int16x8_t rg =
        vqmovn_high_s32(vqmovn_s32(lanes_neon_unorm8(red)), lanes_neon_unorm8(green));
    const int16x8_t ba =
        vqmovn_high_s32(vqmovn_s32(lanes_neon_unorm8(blue)), lanes_neon_unorm8(alpha));
    const uint8x16_t planes = vqmovun_high_s16(vqmovun_s16(rg), ba);

    return vreinterpretq_s32_u8(vqtbl1q_u8(planes, vld1q_u8(order)));
}

GN_OPERATION lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    LANES_EACH_REGISTER(lanes_i, lanes_neon_pack(red.q[n], green.q[n], blue.q[n], alpha.q[n]));
}

GN_OPERATION lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                        ptrdiff_t stride)
{
    LANES_EACH_REGISTER(lanes_i,
                        vreinterpretq_s32_u8(vld1q_u8((n < 2 ? lower : upper) + n % 2 * stride)));
}

GN_OPERATION void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                      lanes_i a)
{
    vst1q_u8(lower, vreinterpretq_u8_s32(a.q[0]));
    vst1q_u8(lower + stride, vreinterpretq_u8_s32(a.q[1]));
    vst1q_u8(upper, vreinterpretq_u8_s32(a.q[2]));
    vst1q_u8(upper + stride, vreinterpretq_u8_s32(a.q[3]));
}

/* Transposes 4x4 words. */
GN_OPERATION void lanes_neon_transpose(int32x4_t r[4])
{
    const int32x4x2_t a = vzipq_s32(r[0], r[2]);
    const int32x4x2_t b = vzipq_s32(r[1], r[3]);
    const int32x4x2_t low = vzipq_s32(a.val[0], b.val[0]);
    const int32x4x2_t high = vzipq_s32(a.val[1], b.val[1]);

    r[0] = low.val[0];
    r[1] = low.val[1];
    r[2] = high.val[0];
    r[3] = high.val[1];
}

GN_OPERATION void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset,
                                      uint32_t step, lanes_i out[4])
{
    for (uint32_t n = 0; n < 4; ++n) {
        int32x4_t r[4];

        for (uint32_t l = 0; l < 4; ++l)
            r[l] = vreinterpretq_s32_u8(vld1q_u8(memory + offset[(4 * n + l) * step]));
        lanes_neon_transpose(r);
        for (int c = 0; c < 4; ++c)
            out[c].q[n] = r[c];
    }
}

GN_OPERATION void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    for (size_t n = 0; n < 4; ++n) {
        int32x4_t r[4];

        for (int c = 0; c < 4; ++c)
            r[c] = in[c].q[n];
        lanes_neon_transpose(r);
        for (size_t l = 0; l < 4; ++l)
            vst1q_u8(memory + (4 * n + l) * stride, vreinterpretq_u8_s32(r[l]));
    }
}

GN_OPERATION float32x4_t lanes_neon_unpack(int32x4_t packed, int channel)
{
    const uint32x4_t shifted = vshlq_u32(vreinterpretq_u32_s32(packed), vdupq_n_s32(-8 * channel));

    return vmulq_n_f32(vcvtq_f32_u32(vandq_u32(shifted, vdupq_n_u32(0xFF))), (float)(1.0 / 255.0));
}

GN_OPERATION lanes_f lanes_unpack_unorm8(lanes_i packed, int channel)
{
    LANES_EACH_REGISTER(lanes_f, lanes_neon_unpack(packed.q[n], channel));
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
