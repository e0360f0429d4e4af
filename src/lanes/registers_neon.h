/* The registers of 64-bit Arm's Advanced SIMD, four lanes each. On Arm, conversions to integers
 * saturate and turn NaN into 0 (Arm ARM, FPToFixed), and min and max return NaN if either operand
 * is NaN, so these operations are composed with a comparison. Precondition: FPCR is in its initial
 * state (round to nearest, denormals kept).
 * Not alone: lanes.h chooses one such file; lanes_registers.h says what it defines. */
#ifndef GN_LANES_REGISTERS_NEON_H
#define GN_LANES_REGISTERS_NEON_H

#if defined(GN_LANES_INTRINSICS_HEADER)
#include GN_LANES_INTRINSICS_HEADER
#else
#include <arm_neon.h>
#endif

#define LANES_REGISTERS 4

typedef float32x4_t register_f;
typedef int32x4_t register_i;
typedef uint32x4_t register_m;

/* Loads of bytes may alias any type. */
#define register_load(p) vld1q_f32(p)
#define register_store(p, a) vst1q_f32(p, a)
#define register_i_load(p) vreinterpretq_s32_u8(vld1q_u8((const uint8_t *)(const void *)(p)))
#define register_i_store(p, a) vst1q_u8((uint8_t *)(void *)(p), vreinterpretq_u8_s32(a))
#define register_splat(a) vdupq_n_f32(a)
#define register_columns() vcvtq_f32_s32(neon_columns())
#define register_rows(per_y, y, n) vdupq_n_f32((per_y) * ((y) + (float)(n)))
#define register_add(a, b) vaddq_f32(a, b)
#define register_sub(a, b) vsubq_f32(a, b)
#define register_mul(a, b) vmulq_f32(a, b)
#define register_div(a, b) vdivq_f32(a, b)
#define register_sqrt(a) vsqrtq_f32(a)
#define register_min(a, b) vbslq_f32(vcgtq_f32(b, a), a, b)
#define register_max(a, b) vbslq_f32(vcgtq_f32(a, b), a, b)
#define register_greater(a, b) vcgtq_f32(a, b)
#define register_less_equal(a, b) vcleq_f32(a, b)
#define register_and(a, b) vandq_u32(a, b)
#define register_not(a) vmvnq_u32(a)
#define register_select(m, a, b) vbslq_f32(m, a, b)
#define register_from_bits(bits, n) vtstq_u32(vdupq_n_u32(bits), neon_bits(n))
#define register_m_as_int(a) vreinterpretq_s32_u32(a)
#define register_negative(a) vreinterpretq_u32_s32(vshrq_n_s32(a, 31))
#define register_truncate(a) neon_converted(a, vcvtq_s32_f32(a))
#define register_round(a) neon_round(a)
#define register_floor(a) vrndmq_f32(a)
#define register_floor_to_int(a) register_truncate(vrndmq_f32(a))
#define register_to_float(a) vcvtq_f32_s32(a)
#define register_as_int(a) vreinterpretq_s32_f32(a)
#define register_as_float(a) vreinterpretq_f32_s32(a)
#define register_quad_left(a) vtrn1q_f32(a, a)
#define register_quad_right(a) vtrn2q_f32(a, a)
#define register_i_splat(a) vdupq_n_s32(a)
#define register_i_columns(a) vmulq_s32(vdupq_n_s32(a), neon_columns())
#define register_i_rows(per_row, n) vdupq_n_s32((n) * (per_row))
#define register_i_add(a, b) vaddq_s32(a, b)
#define register_i_sub(a, b) vsubq_s32(a, b)
#define register_i_mul(a, b) vmulq_s32(a, b)
#define register_i_mul_short(a, b) vmulq_s32(a, vdupq_n_s32(b))
#define register_i_or(a, b) vorrq_s32(a, b)
#define register_i_and(a, b) vandq_s32(a, b)
#define register_i_xor(a, b) veorq_s32(a, b)
#define register_i_mul_shorts(a, b)                                                                \
    vreinterpretq_s32_s16(vmulq_s16(vreinterpretq_s16_s32(a), vreinterpretq_s16_s32(b)))
#define register_i_high_bytes(a) vreinterpretq_s32_u16(vshrq_n_u16(vreinterpretq_u16_s32(a), 8))
#define register_i_add_bytes(a, b)                                                                 \
    vreinterpretq_s32_u8(vqaddq_u8(vreinterpretq_u8_s32(a), vreinterpretq_u8_s32(b)))
#define register_i_sub_bytes(a, b)                                                                 \
    vreinterpretq_s32_u8(vqsubq_u8(vreinterpretq_u8_s32(a), vreinterpretq_u8_s32(b)))
#define register_i_add_shorts(a, b)                                                                \
    vreinterpretq_s32_u16(vqaddq_u16(vreinterpretq_u16_s32(a), vreinterpretq_u16_s32(b)))
#define register_i_sub_shorts(a, b)                                                                \
    vreinterpretq_s32_u16(vqsubq_u16(vreinterpretq_u16_s32(a), vreinterpretq_u16_s32(b)))
#define register_i_scale_shorts(a, b)                                                              \
    neon_scale_shorts(vreinterpretq_u16_s32(a), vreinterpretq_u16_s32(b))
#define register_i_shift_left(a, count) vshlq_s32(a, vdupq_n_s32(count))
/* A shift to the left by a negative number of bits is a shift to the right. */
#define register_i_shift_right(a, count) vshlq_s32(a, vdupq_n_s32(-(count)))
#define register_i_shift_right_logical(a, count)                                                   \
    vreinterpretq_s32_u32(vshlq_u32(vreinterpretq_u32_s32(a), vdupq_n_s32(-(count))))
#define register_i_min(a, b) vminq_s32(a, b)
#define register_i_max(a, b) vmaxq_s32(a, b)
#define register_i_select(m, a, b) vbslq_s32(m, a, b)
#define register_i_greater(a, b) vcgtq_s32(a, b)
#define register_i_equal(a, b) vceqq_s32(a, b)
#define register_i_load_rows(ROW) register_i_load(ROW(0))
#define register_i_store_rows(ROW, a) register_i_store(ROW(0), a)
#define register_i_load_rows_of_bytes(ROW) neon_load_bytes(ROW(0))
#define register_i_store_rows_of_bytes(ROW, a) neon_store_bytes(ROW(0), vreinterpretq_u32_s32(a))
#define register_i_load_rows_of_shorts(ROW) neon_load_shorts(ROW(0))
#define register_i_store_rows_of_shorts(ROW, a)                                                    \
    vst1_u8(ROW(0), vreinterpret_u8_u16(vmovn_u32(vreinterpretq_u32_s32(a))))
#define register_i_load_rows_of_threes(ROW) neon_load_threes(ROW(0))
#define register_i_store_rows_of_threes(ROW, a) neon_store_threes(ROW(0), vreinterpretq_u8_s32(a))
#define register_load_pairs(AT, first) neon_load_pairs(AT(first), AT((first) + 1))
#define register_even(a, b) vuzp1q_f32(a, b)
#define register_odd(a, b) vuzp2q_f32(a, b)
#define register_spread(a, i) vdupq_n_f32(vgetq_lane_f32(a, i))
#define register_splat_vec4(p) vld1q_f32(p)
#define register_load_vec3(p, v) neon_load_vec3(p, v)
#define register_store_vec3(p, v) neon_store_vec3(p, v)
#define register_i_interleave_low(a, b) vzip1q_s32(a, b)
#define register_i_interleave_high(a, b) vzip2q_s32(a, b)
#define register_i_set(NUMBER) neon_set(NUMBER(0), NUMBER(1), NUMBER(2), NUMBER(3))
#define register_indices(at, index) register_i_store(at, index)
#define register_i_pack_words(a, b) vreinterpretq_s32_s16(vqmovn_high_s32(vqmovn_s32(a), b))
#define register_i_pack_shorts(a, b)                                                               \
    vreinterpretq_s32_u8(                                                                          \
        vqmovun_high_s16(vqmovun_s16(vreinterpretq_s16_s32(a)), vreinterpretq_s16_s32(b)))
#define register_i_transpose_bytes(a) neon_transpose_bytes(vreinterpretq_u8_s32(a))
#define registers_bits(q)                                                                          \
    vaddvq_u32(vorrq_u32(vorrq_u32(vandq_u32(q[0], neon_bits(0)), vandq_u32(q[1], neon_bits(1))),  \
                         vorrq_u32(vandq_u32(q[2], neon_bits(2)), vandq_u32(q[3], neon_bits(3)))))

GN_OPERATION int32x4_t neon_set(int32_t a, int32_t b, int32_t c, int32_t d)
{
    const int32_t number[4] = {a, b, c, d};

    return vld1q_s32(number);
}

GN_OPERATION int32x4_t neon_columns(void)
{
    static const int32_t columns[4] = {0, 1, 2, 3};

    return vld1q_s32(columns);
}

/* Returns the bits of lanes 4 * n to 4 * n + 3. */
GN_OPERATION uint32x4_t neon_bits(int n)
{
    static const uint32_t bits[4] = {1, 2, 4, 8};

    return vshlq_u32(vld1q_u32(bits), vdupq_n_s32(4 * n));
}

/* Returns `converted`, but INT32_MIN where a is NaN or at least 2^31. Below -2^31, saturation
 * already returns INT32_MIN. */
GN_OPERATION int32x4_t neon_converted(float32x4_t a, int32x4_t converted)
{
    return vbslq_s32(vcgtq_f32(vdupq_n_f32(2147483648.0f), a), converted, vdupq_n_s32(INT32_MIN));
}

GN_OPERATION int32x4_t neon_round(float32x4_t a)
{
    return neon_converted(a, vcvtnq_s32_f32(a));
}

/* The last shift adds 2^15 first. */
static inline uint16x4_t neon_scale(uint16x4_t a, uint16x4_t b)
{
    const uint32x4_t product = vmull_u16(a, b);

    return vrshrn_n_u32(vsraq_n_u32(product, product, 16), 16);
}

static inline int32x4_t neon_scale_shorts(uint16x8_t a, uint16x8_t b)
{
    return vreinterpretq_s32_u16(vcombine_u16(neon_scale(vget_low_u16(a), vget_low_u16(b)),
                                              neon_scale(vget_high_u16(a), vget_high_u16(b))));
}

GN_OPERATION int32x4_t neon_transpose_bytes(uint8x16_t a)
{
    static const uint8_t order[16] = {0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};

    return vreinterpretq_s32_u8(vqtbl1q_u8(a, vld1q_u8(order)));
}

GN_OPERATION float32x4_t neon_load_pairs(const void *first, const void *second)
{
    return vreinterpretq_f32_u8(
        vcombine_u8(vld1_u8((const uint8_t *)first), vld1_u8((const uint8_t *)second)));
}

GN_OPERATION void neon_load_vec3(const float *p, float32x4_t v[3])
{
    const float32x4x3_t xyz = vld3q_f32(p);

    for (int i = 0; i < 3; ++i)
        v[i] = xyz.val[i];
}

GN_OPERATION void neon_store_vec3(float *p, const float32x4_t v[3])
{
    float32x4x3_t xyz;

    for (int i = 0; i < 3; ++i)
        xyz.val[i] = v[i];
    vst3q_f32(p, xyz);
}

/* Rows of four pixels, of one, two and three bytes. */

GN_OPERATION int32x4_t neon_load_bytes(const void *row)
{
    const uint8x8_t bytes = vcreate_u8((uint32_t) * (const any_word *)row);

    return vreinterpretq_s32_u32(vmovl_u16(vget_low_u16(vmovl_u8(bytes))));
}

GN_OPERATION void neon_store_bytes(void *row, uint32x4_t a)
{
    const uint16x4_t shorts = vmovn_u32(a);
    const uint8x8_t bytes = vmovn_u16(vcombine_u16(shorts, shorts));

    *(any_word *)row = (int32_t)vget_lane_u32(vreinterpret_u32_u8(bytes), 0);
}

GN_OPERATION int32x4_t neon_load_shorts(const unsigned char *row)
{
    return vreinterpretq_s32_u32(vmovl_u16(vreinterpret_u16_u8(vld1_u8(row))));
}

GN_OPERATION int32x4_t neon_load_threes(const unsigned char *row)
{
    static const int8_t order[16] = {GN_FROM_THREES};

    return vreinterpretq_s32_u8(vqtbl1q_u8(vreinterpretq_u8_f32(neon_load_pairs(row, row + 4)),
                                           vreinterpretq_u8_s8(vld1q_s8(order))));
}

GN_OPERATION void neon_store_threes(unsigned char *row, uint8x16_t a)
{
    static const uint8_t order[16] = {GN_TO_THREES};
    const uint8x16_t bytes = vqtbl1q_u8(a, vld1q_u8(order));

    vst1_u8(row, vget_low_u8(bytes));
    vst1_u8(row + 4, vget_high_u8(bytes));
}

#endif
