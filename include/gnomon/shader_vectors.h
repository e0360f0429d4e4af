/** @file
 * Vectors for shader functions (gnomon/shader_functions.h): inline, without calls and without
 * branches, so that compilers vectorise loops over lanes that use them. Each name ends in the
 * number of components of the vectors it takes, those of gn_make2 to gn_make4 in the number of
 * floats; 1 is a float.
 *
 *     make 2 3 4; extend 3; xy xyz 4         vectors from numbers and from other vectors
 *     add subtract multiply negate scale     2 3 4: arithmetic, component by component
 *     minimum maximum clamp saturate mix     1 2 3 4: component by component
 *     select                                 1 2 3 4: one of two
 *     dot length normalize reflect           2 3 4; cross 3
 *     multiply_mat                           3 4: a matrix times a vector
 *     sqrt power to_bits from_bits           1
 *
 * For what is missing, such as exp, sin, floor and fract, call the functions of gnomon/scalar.h:
 * they give the same bits everywhere, but are not inline.
 *
 * An operation has the bits of the call of the same name (gnomon/vec.h, gnomon/mat.h;
 * gnomon/scalar.h for 1), but for the bits of a NaN. Three exceptions save time: gn_length2 to
 * gn_length4 do not scale vectors whose square overflows or underflows; gn_normalize2 to
 * gn_normalize4 multiply by a reciprocal, as GLSL does, and report nothing; gn_power1 takes a whole
 * exponent.
 *
 * The bits are the same on every machine, if the compiler does not change the arithmetic: with
 * -ffp-contract=off, which gcc and clang need on processors with fused multiply-add (64-bit Arm;
 * x86 with -mfma or -march), and without -ffast-math. NaN and infinity pass through by IEEE rules
 * except where a contract says otherwise.
 *
 * A branch or a ?: that computes something in one arm only, or a call to a function that is not
 * inline, gives the right result but keeps gcc from vectorising the shader. Instead, compute both
 * arms and choose by gn_select1 to gn_select4. */
#ifndef GNOMON_SHADER_VECTORS_H
#define GNOMON_SHADER_VECTORS_H

#include <stdbool.h>
#include <stdint.h>

#include "mat.h"
#include "vec.h"

/** The vector of these components. @{ */
static inline gn_vec2 gn_make2(float x, float y)
{
    gn_vec2 v;

    v.x = x;
    v.y = y;
    return v;
}

static inline gn_vec3 gn_make3(float x, float y, float z)
{
    gn_vec3 v;

    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

static inline gn_vec4 gn_make4(float x, float y, float z, float w)
{
    gn_vec4 v;

    v.x = x;
    v.y = y;
    v.z = z;
    v.w = w;
    return v;
}
/** @} */

/** (v, w), GLSL's vec4(v, w). */
static inline gn_vec4 gn_extend3(gn_vec3 v, float w)
{
    return gn_make4(v.x, v.y, v.z, w);
}

/** The first two components. */
static inline gn_vec2 gn_xy4(gn_vec4 v)
{
    return gn_make2(v.x, v.y);
}

/** The first three components. */
static inline gn_vec3 gn_xyz4(gn_vec4 v)
{
    return gn_make3(v.x, v.y, v.z);
}

/** a + b. @{ */
static inline gn_vec2 gn_add2(gn_vec2 a, gn_vec2 b)
{
    return gn_make2(a.x + b.x, a.y + b.y);
}

static inline gn_vec3 gn_add3(gn_vec3 a, gn_vec3 b)
{
    return gn_make3(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline gn_vec4 gn_add4(gn_vec4 a, gn_vec4 b)
{
    return gn_make4(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);
}
/** @} */

/** a - b. @{ */
static inline gn_vec2 gn_subtract2(gn_vec2 a, gn_vec2 b)
{
    return gn_make2(a.x - b.x, a.y - b.y);
}

static inline gn_vec3 gn_subtract3(gn_vec3 a, gn_vec3 b)
{
    return gn_make3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline gn_vec4 gn_subtract4(gn_vec4 a, gn_vec4 b)
{
    return gn_make4(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);
}
/** @} */

/** a * b. @{ */
static inline gn_vec2 gn_multiply2(gn_vec2 a, gn_vec2 b)
{
    return gn_make2(a.x * b.x, a.y * b.y);
}

static inline gn_vec3 gn_multiply3(gn_vec3 a, gn_vec3 b)
{
    return gn_make3(a.x * b.x, a.y * b.y, a.z * b.z);
}

static inline gn_vec4 gn_multiply4(gn_vec4 a, gn_vec4 b)
{
    return gn_make4(a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w);
}
/** @} */

/** -v. @{ */
static inline gn_vec2 gn_negate2(gn_vec2 v)
{
    return gn_make2(-v.x, -v.y);
}

static inline gn_vec3 gn_negate3(gn_vec3 v)
{
    return gn_make3(-v.x, -v.y, -v.z);
}

static inline gn_vec4 gn_negate4(gn_vec4 v)
{
    return gn_make4(-v.x, -v.y, -v.z, -v.w);
}
/** @} */

/** v * factor. @{ */
static inline gn_vec2 gn_scale2(gn_vec2 v, float factor)
{
    return gn_make2(v.x * factor, v.y * factor);
}

static inline gn_vec3 gn_scale3(gn_vec3 v, float factor)
{
    return gn_make3(v.x * factor, v.y * factor, v.z * factor);
}

static inline gn_vec4 gn_scale4(gn_vec4 v, float factor)
{
    return gn_make4(v.x * factor, v.y * factor, v.z * factor, v.w * factor);
}
/** @} */

/* A float and its bits. */
typedef union gn_shader_bits_ {
    float number;
    uint32_t bits;
} gn_shader_bits_;

/** The bits of a float. */
static inline uint32_t gn_to_bits1(float x)
{
    gn_shader_bits_ value;

    value.number = x;
    return value.bits;
}

/** The float of such bits. */
static inline float gn_from_bits1(uint32_t bits)
{
    gn_shader_bits_ value;

    value.bits = bits;
    return value.number;
}

/** which ? a : b, with the bits unchanged. Both a and b are computed. @{ */
static inline float gn_select1(bool which, float a, float b)
{
    const uint32_t mask = 0u - (uint32_t)which;

    return gn_from_bits1((gn_to_bits1(a) & mask) | (gn_to_bits1(b) & ~mask));
}

static inline gn_vec2 gn_select2(bool which, gn_vec2 a, gn_vec2 b)
{
    return gn_make2(gn_select1(which, a.x, b.x), gn_select1(which, a.y, b.y));
}

static inline gn_vec3 gn_select3(bool which, gn_vec3 a, gn_vec3 b)
{
    return gn_make3(gn_select1(which, a.x, b.x), gn_select1(which, a.y, b.y),
                    gn_select1(which, a.z, b.z));
}

static inline gn_vec4 gn_select4(bool which, gn_vec4 a, gn_vec4 b)
{
    return gn_make4(gn_select1(which, a.x, b.x), gn_select1(which, a.y, b.y),
                    gn_select1(which, a.z, b.z), gn_select1(which, a.w, b.w));
}
/** @} */

/** The lesser, a < b ? a : b. For two zeros returns b. If one is NaN, returns the other. @{ */
static inline float gn_minimum1(float a, float b)
{
    return gn_select1((a < b) | (b != b), a, b);
}

static inline gn_vec2 gn_minimum2(gn_vec2 a, gn_vec2 b)
{
    return gn_make2(gn_minimum1(a.x, b.x), gn_minimum1(a.y, b.y));
}

static inline gn_vec3 gn_minimum3(gn_vec3 a, gn_vec3 b)
{
    return gn_make3(gn_minimum1(a.x, b.x), gn_minimum1(a.y, b.y), gn_minimum1(a.z, b.z));
}

static inline gn_vec4 gn_minimum4(gn_vec4 a, gn_vec4 b)
{
    return gn_make4(gn_minimum1(a.x, b.x), gn_minimum1(a.y, b.y), gn_minimum1(a.z, b.z),
                    gn_minimum1(a.w, b.w));
}
/** @} */

/** The greater, a > b ? a : b. For two zeros returns b. If one is NaN, returns the other. @{ */
static inline float gn_maximum1(float a, float b)
{
    return gn_select1((a > b) | (b != b), a, b);
}

static inline gn_vec2 gn_maximum2(gn_vec2 a, gn_vec2 b)
{
    return gn_make2(gn_maximum1(a.x, b.x), gn_maximum1(a.y, b.y));
}

static inline gn_vec3 gn_maximum3(gn_vec3 a, gn_vec3 b)
{
    return gn_make3(gn_maximum1(a.x, b.x), gn_maximum1(a.y, b.y), gn_maximum1(a.z, b.z));
}

static inline gn_vec4 gn_maximum4(gn_vec4 a, gn_vec4 b)
{
    return gn_make4(gn_maximum1(a.x, b.x), gn_maximum1(a.y, b.y), gn_maximum1(a.z, b.z),
                    gn_maximum1(a.w, b.w));
}
/** @} */

/** Clamps every component to low to high. NaN becomes low. If low > high, every component becomes
 * high. @{ */
static inline float gn_clamp1(float x, float low, float high)
{
    return gn_minimum1(gn_maximum1(x, low), high);
}

static inline gn_vec2 gn_clamp2(gn_vec2 v, float low, float high)
{
    return gn_make2(gn_clamp1(v.x, low, high), gn_clamp1(v.y, low, high));
}

static inline gn_vec3 gn_clamp3(gn_vec3 v, float low, float high)
{
    return gn_make3(gn_clamp1(v.x, low, high), gn_clamp1(v.y, low, high),
                    gn_clamp1(v.z, low, high));
}

static inline gn_vec4 gn_clamp4(gn_vec4 v, float low, float high)
{
    return gn_make4(gn_clamp1(v.x, low, high), gn_clamp1(v.y, low, high), gn_clamp1(v.z, low, high),
                    gn_clamp1(v.w, low, high));
}
/** @} */

/** Clamps every component to 0 to 1. NaN becomes 0. @{ */
static inline float gn_saturate1(float x)
{
    return gn_clamp1(x, 0.0f, 1.0f);
}

static inline gn_vec2 gn_saturate2(gn_vec2 v)
{
    return gn_make2(gn_saturate1(v.x), gn_saturate1(v.y));
}

static inline gn_vec3 gn_saturate3(gn_vec3 v)
{
    return gn_make3(gn_saturate1(v.x), gn_saturate1(v.y), gn_saturate1(v.z));
}

static inline gn_vec4 gn_saturate4(gn_vec4 v)
{
    return gn_make4(gn_saturate1(v.x), gn_saturate1(v.y), gn_saturate1(v.z), gn_saturate1(v.w));
}
/** @} */

/** a * (1 - t) + b * t, as gn_mix computes it: from a at t = 0 to b at t = 1. t is not clamped.
 * @{ */
static inline float gn_mix1(float a, float b, float t)
{
    return a * (1.0f - t) + b * t;
}

static inline gn_vec2 gn_mix2(gn_vec2 a, gn_vec2 b, float t)
{
    return gn_make2(gn_mix1(a.x, b.x, t), gn_mix1(a.y, b.y, t));
}

static inline gn_vec3 gn_mix3(gn_vec3 a, gn_vec3 b, float t)
{
    return gn_make3(gn_mix1(a.x, b.x, t), gn_mix1(a.y, b.y, t), gn_mix1(a.z, b.z, t));
}

static inline gn_vec4 gn_mix4(gn_vec4 a, gn_vec4 b, float t)
{
    return gn_make4(gn_mix1(a.x, b.x, t), gn_mix1(a.y, b.y, t), gn_mix1(a.z, b.z, t),
                    gn_mix1(a.w, b.w, t));
}
/** @} */

/** The scalar product, summed from the last component to the first, as gn_vec3_dot, which states
 * the error. @{ */
static inline float gn_dot2(gn_vec2 a, gn_vec2 b)
{
    return a.y * b.y + a.x * b.x;
}

static inline float gn_dot3(gn_vec3 a, gn_vec3 b)
{
    return (a.z * b.z + a.y * b.y) + a.x * b.x;
}

static inline float gn_dot4(gn_vec4 a, gn_vec4 b)
{
    return ((a.w * b.w + a.z * b.z) + a.y * b.y) + a.x * b.x;
}
/** @} */

/** The vector product a x b, right-handed, as gn_vec3_cross. */
static inline gn_vec3 gn_cross3(gn_vec3 a, gn_vec3 b)
{
    return gn_make3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* The square root on processors without an instruction for it, without calls and branches.
 *
 * x is scaled by an even power of two to a in [1, 4). Two of Newton's steps on 1 / sqrt(a) leave a
 * relative error below 5e-6, and a third on the root itself one below 2^-24. So the result s, as
 * the integer S = 2^23 * s, is at most 1 from the nearest. S is nearest where
 * (S - 1/2)^2 < A < (S + 1/2)^2 for A = 2^46 * a, an integer, which is -S < A - S * S <= S. That
 * difference is below 2^26 and so exact modulo 2^32. */
static inline float gn_sqrt_in_steps_(float x)
{
    const int32_t given = (int32_t)gn_to_bits1(x);
    const bool is_denormal = given < 0x00800000;
    const bool has_root = (given > 0) & (given < 0x7F800000); /* no zero, infinity or NaN */
    const uint32_t bits = gn_to_bits1(x * gn_select1(is_denormal, 16777216.0f, 1.0f)); /* 2^24 */
    const uint32_t is_odd = (bits >> 23 & 1u) ^ 1u; /* the exponent, which has a bias of 127 */
    const float a = gn_from_bits1((bits & 0x007FFFFFu) + 0x3F800000u + (is_odd << 23));
    const uint32_t whole = (bits << 23) + ((bits << 23) & (0u - is_odd)); /* A modulo 2^32 */
    float y = gn_from_bits1(0x5F3759DFu - (gn_to_bits1(a) >> 1)); /* within 3.5 % of 1 / sqrt(a) */
    float s, none;
    uint32_t root;
    int32_t left;

    y = y * (1.5f - 0.5f * a * y * y);
    y = y * (1.5f - 0.5f * a * y * y);
    s = a * y;
    s = s + 0.5f * y * (a - s * s);
    root = gn_to_bits1(s) - 0x3F000000u; /* S, also of s just below 1 */
    left = (int32_t)(whole - root * root);
    root += (uint32_t)(left > (int32_t)root) - (uint32_t)(left <= -(int32_t)root);
    /* The root's leading bit adds 1 to the exponent, which is half of a's and that of x / a. */
    root += ((bits >> 23) + 125u - is_odd) >> 1 << 23;
    root -= (uint32_t)is_denormal * (12u << 23);
    none = gn_select1((uint32_t)given > 0x80000000u, gn_from_bits1(0x7FC00000u), x);
    return gn_select1(has_root, gn_from_bits1(root), none);
}

/** The square root, correctly rounded, as gn_sqrt: NaN below zero, -0 for -0. Compilers do not
 * vectorise a call that may set errno, as their sqrtf may. This declaration says that it does not.
 * The compiler then emits one instruction, which the processors named here have, and never a
 * call. */
#if defined(__GNUC__) && (defined(__SSE__) || defined(__aarch64__) || defined(__wasm__) ||         \
                          (defined(__ARM_FP) && (__ARM_FP & 4)))
GN_BEGIN
float __builtin_sqrtf(float x) __attribute__((const));
GN_END

static inline float gn_sqrt1(float x)
{
    return __builtin_sqrtf(x);
}
#else
static inline float gn_sqrt1(float x)
{
    return gn_sqrt_in_steps_(x);
}
#endif

/** sqrt(dot(v, v)). If the square overflows, the length is infinity; if the square underflows to 0,
 * the length is 0. gn_vec3_length scales such vectors, this function does not. @{ */
static inline float gn_length2(gn_vec2 v)
{
    return gn_sqrt1(gn_dot2(v, v));
}

static inline float gn_length3(gn_vec3 v)
{
    return gn_sqrt1(gn_dot3(v, v));
}

static inline float gn_length4(gn_vec4 v)
{
    return gn_sqrt1(gn_dot4(v, v));
}
/** @} */

/** v * (1 / length(v)), in GLSL's operations, as the ready-made shaders compute it. NaN for the
 * zero vector. Not for vectors whose square overflows or underflows (gn_length3). @{ */
static inline gn_vec2 gn_normalize2(gn_vec2 v)
{
    return gn_scale2(v, 1.0f / gn_length2(v));
}

static inline gn_vec3 gn_normalize3(gn_vec3 v)
{
    return gn_scale3(v, 1.0f / gn_length3(v));
}

static inline gn_vec4 gn_normalize4(gn_vec4 v)
{
    return gn_scale4(v, 1.0f / gn_length4(v));
}
/** @} */

/** The direction v reflected at a surface with a unit normal: v - (2 * dot(normal, v)) * normal, as
 * gn_vec3_reflect computes it. @{ */
static inline gn_vec2 gn_reflect2(gn_vec2 v, gn_vec2 normal)
{
    return gn_subtract2(v, gn_scale2(normal, 2.0f * gn_dot2(normal, v)));
}

static inline gn_vec3 gn_reflect3(gn_vec3 v, gn_vec3 normal)
{
    return gn_subtract3(v, gn_scale3(normal, 2.0f * gn_dot3(normal, v)));
}

static inline gn_vec4 gn_reflect4(gn_vec4 v, gn_vec4 normal)
{
    return gn_subtract4(v, gn_scale4(normal, 2.0f * gn_dot4(normal, v)));
}
/** @} */

/** The matrix times the column v. Products are summed from the first component to the last, as
 * gn_mat4_multiply_vec4 does. @{ */
static inline gn_vec3 gn_multiply_mat3(const gn_mat3 *m, gn_vec3 v)
{
    return gn_make3((m->m[0][0] * v.x + m->m[1][0] * v.y) + m->m[2][0] * v.z,
                    (m->m[0][1] * v.x + m->m[1][1] * v.y) + m->m[2][1] * v.z,
                    (m->m[0][2] * v.x + m->m[1][2] * v.y) + m->m[2][2] * v.z);
}

static inline gn_vec4 gn_multiply_mat4(const gn_mat4 *m, gn_vec4 v)
{
    return gn_make4(((m->m[0][0] * v.x + m->m[1][0] * v.y) + m->m[2][0] * v.z) + m->m[3][0] * v.w,
                    ((m->m[0][1] * v.x + m->m[1][1] * v.y) + m->m[2][1] * v.z) + m->m[3][1] * v.w,
                    ((m->m[0][2] * v.x + m->m[1][2] * v.y) + m->m[2][2] * v.z) + m->m[3][2] * v.w,
                    ((m->m[0][3] * v.x + m->m[1][3] * v.y) + m->m[2][3] * v.z) + m->m[3][3] * v.w);
}
/** @} */

/** x to a whole exponent, by repeated squaring from the lowest bit of the exponent on, as
 * gn_use_phong computes highlights. Exponents above 1023 count as 1023. x to the 0 is 1. An
 * exponent that the compiler knows costs its multiplications only. */
static inline float gn_power1(float x, uint32_t exponent)
{
    const uint32_t n = exponent < 1023u ? exponent : 1023u;
    const float x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8, x32 = x16 * x16;
    const float x64 = x32 * x32, x128 = x64 * x64, x256 = x128 * x128, x512 = x256 * x256;
    float power = gn_select1((n & 1u) != 0, x, 1.0f);

    power *= gn_select1((n & 2u) != 0, x2, 1.0f);
    power *= gn_select1((n & 4u) != 0, x4, 1.0f);
    power *= gn_select1((n & 8u) != 0, x8, 1.0f);
    power *= gn_select1((n & 16u) != 0, x16, 1.0f);
    power *= gn_select1((n & 32u) != 0, x32, 1.0f);
    power *= gn_select1((n & 64u) != 0, x64, 1.0f);
    power *= gn_select1((n & 128u) != 0, x128, 1.0f);
    power *= gn_select1((n & 256u) != 0, x256, 1.0f);
    return power * gn_select1((n & 512u) != 0, x512, 1.0f);
}

#endif
