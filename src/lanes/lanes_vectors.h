/* Lanes in four vectors of GNU C, 128 bits each, which compilers keep in registers of any target
 * that has such registers. Only operators and shuffles of vectors, and conversions of integers in
 * range, whose bits C and IEEE 754 define. The results are those of lanes_portable.h, which defines
 * each operation. Elements of a vector have the order of memory on every target, so nothing here
 * depends on the order of bytes.
 * Not alone: lanes.h chooses one form and includes it after GN_LANES and GN_EACH_LANE. */
#ifndef GN_LANES_LANES_VECTORS_H
#define GN_LANES_LANES_VECTORS_H

#include <gnomon/scalar.h>

#include "../scalars/square_root.h"

#include "four_registers.h"

typedef float vector_f __attribute__((vector_size(16)));
typedef int32_t vector_i __attribute__((vector_size(16)));
typedef uint32_t vector_u __attribute__((vector_size(16)));
typedef uint16_t vector_shorts __attribute__((vector_size(16)));
typedef uint8_t vector_bytes __attribute__((vector_size(16)));
typedef uint64_t vector_pairs __attribute__((vector_size(16)));

/* Vectors in memory, where words are aligned, and pairs of words there. */
typedef float stored_vector_f __attribute__((vector_size(16), aligned(4), may_alias));
typedef int32_t stored_vector_i __attribute__((vector_size(16), aligned(4), may_alias));
typedef uint64_t stored_pair __attribute__((aligned(4), may_alias));

typedef struct lanes_f {
    vector_f q[4];
} lanes_f;

typedef struct lanes_i {
    vector_i q[4];
} lanes_i;

/* Each lane is all ones or all zeros. */
typedef struct lanes_m {
    vector_i q[4];
} lanes_m;

/* A vector of four elements of a and b, which are numbered 0 to 3 and 4 to 7. */
#if defined(__clang__)
#define LANES_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define LANES_SHUFFLE(a, b, ...) __builtin_shuffle(a, b, (vector_i){__VA_ARGS__})
#endif

GN_OPERATION vector_f lanes_vector_splat(float a)
{
    return (vector_f){a, a, a, a};
}

GN_OPERATION vector_i lanes_vector_i_splat(int32_t a)
{
    return (vector_i){a, a, a, a};
}

GN_OPERATION vector_i lanes_vector_select(vector_i mask, vector_i a, vector_i b)
{
    return (mask & a) | (~mask & b);
}

GN_OPERATION vector_f lanes_vector_f_select(vector_i mask, vector_f a, vector_f b)
{
    return (vector_f)lanes_vector_select(mask, (vector_i)a, (vector_i)b);
}

GN_OPERATION vector_f lanes_vector_f_load(const void *p)
{
    return *(const stored_vector_f *)p;
}

GN_OPERATION void lanes_vector_f_store(void *p, vector_f a)
{
    *(stored_vector_f *)p = a;
}

GN_OPERATION vector_i lanes_vector_load(const void *p)
{
    return *(const stored_vector_i *)p;
}

GN_OPERATION void lanes_vector_store(void *p, vector_i a)
{
    *(stored_vector_i *)p = a;
}

GN_OPERATION lanes_f lanes_load(const float p[GN_LANES])
{
    LANES_EACH_REGISTER(lanes_f, lanes_vector_f_load(p + 4 * n));
}

GN_OPERATION void lanes_store(float *p, lanes_f a)
{
    lanes_vector_f_store(p, a.q[0]);
    lanes_vector_f_store(p + 4, a.q[1]);
    lanes_vector_f_store(p + 8, a.q[2]);
    lanes_vector_f_store(p + 12, a.q[3]);
}

GN_OPERATION lanes_f lanes_splat(float a)
{
    LANES_EACH_REGISTER(lanes_f, lanes_vector_splat(a));
}

GN_OPERATION lanes_f lanes_columns(float per_x, float x, float origin)
{
    const vector_f column = lanes_vector_splat(x) + (vector_f){0.0f, 1.0f, 2.0f, 3.0f};
    const vector_f value = lanes_vector_splat(per_x) * column + lanes_vector_splat(origin);

    LANES_EACH_REGISTER(lanes_f, value);
}

GN_OPERATION lanes_f lanes_rows(float per_y, float y)
{
    LANES_EACH_REGISTER(lanes_f, lanes_vector_splat(per_y * (y + (float)n)));
}

GN_OPERATION lanes_f lanes_add(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n] + b.q[n]);
}

GN_OPERATION lanes_f lanes_sub(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n] - b.q[n]);
}

GN_OPERATION lanes_f lanes_mul(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n] * b.q[n]);
}

GN_OPERATION lanes_f lanes_div(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n] / b.q[n]);
}

GN_OPERATION float lane_sqrt(float a)
{
#if GN_HAVE_SQUARE_ROOT
    return gn_float_square_root(a);
#else
    return gn_sqrt(a);
#endif
}

GN_OPERATION vector_f lanes_vector_sqrt(vector_f a)
{
    return (vector_f){lane_sqrt(a[0]), lane_sqrt(a[1]), lane_sqrt(a[2]), lane_sqrt(a[3])};
}

GN_OPERATION lanes_f lanes_sqrt(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, lanes_vector_sqrt(a.q[n]));
}

GN_OPERATION lanes_m lanes_greater(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, (vector_i)(a.q[n] > b.q[n]));
}

GN_OPERATION lanes_m lanes_less_equal(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_m, (vector_i)(a.q[n] <= b.q[n]));
}

GN_OPERATION lanes_m lanes_and(lanes_m a, lanes_m b)
{
    LANES_EACH_REGISTER(lanes_m, a.q[n] & b.q[n]);
}

GN_OPERATION lanes_m lanes_not(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_m, ~a.q[n]);
}

/* The bits of register n's lanes. */
#define LANES_VECTOR_BITS(n) ((vector_i){1 << 4 * (n), 2 << 4 * (n), 4 << 4 * (n), 8 << 4 * (n)})

/* Returns bit l set if lane l of these masks is. */
GN_OPERATION uint32_t lanes_vector_bits(vector_i a, vector_i b, vector_i c, vector_i d)
{
    vector_i bits = (a & LANES_VECTOR_BITS(0)) | (b & LANES_VECTOR_BITS(1)) |
                    (c & LANES_VECTOR_BITS(2)) | (d & LANES_VECTOR_BITS(3));

    bits |= LANES_SHUFFLE(bits, bits, 2, 3, 0, 1);
    bits |= LANES_SHUFFLE(bits, bits, 1, 0, 3, 2);
    return (uint32_t)bits[0];
}

GN_OPERATION uint32_t lanes_bits(lanes_m a)
{
    return lanes_vector_bits(a.q[0], a.q[1], a.q[2], a.q[3]);
}

GN_OPERATION lanes_m lanes_from_bits(uint32_t bits)
{
    const vector_i all = lanes_vector_i_splat((int32_t)bits);

    LANES_EACH_REGISTER(lanes_m, (vector_i)((all & LANES_VECTOR_BITS(n)) == LANES_VECTOR_BITS(n)));
}

GN_OPERATION lanes_f lanes_select(lanes_m m, lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f, lanes_vector_f_select(m.q[n], a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_min(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f,
                        lanes_vector_f_select((vector_i)(b.q[n] > a.q[n]), a.q[n], b.q[n]));
}

GN_OPERATION lanes_f lanes_max(lanes_f a, lanes_f b)
{
    LANES_EACH_REGISTER(lanes_f,
                        lanes_vector_f_select((vector_i)(a.q[n] > b.q[n]), a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_splat(int32_t a)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_i_splat(a));
}

GN_OPERATION lanes_i lanes_i_halves(int32_t lower, int32_t upper)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_i_splat(n < 2 ? lower : upper));
}

GN_OPERATION lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    const vector_i columns = {0, per_column, 2 * per_column, 3 * per_column};

    LANES_EACH_REGISTER(lanes_i, columns + lanes_vector_i_splat(n * per_row));
}

GN_OPERATION lanes_i lanes_i_load(const stored_word *p)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_load(p + 4 * n));
}

GN_OPERATION void lanes_i_store(stored_word *p, lanes_i a)
{
    lanes_vector_store(p, a.q[0]);
    lanes_vector_store(p + 4, a.q[1]);
    lanes_vector_store(p + 8, a.q[2]);
    lanes_vector_store(p + 12, a.q[3]);
}

/* Sums and products of unsigned numbers wrap around. */
GN_OPERATION lanes_i lanes_i_add(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, (vector_i)((vector_u)a.q[n] + (vector_u)b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, (vector_i)((vector_u)a.q[n] - (vector_u)b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, (vector_i)((vector_u)a.q[n] * (vector_u)b.q[n]));
}

GN_OPERATION lanes_i lanes_i_mul_short(lanes_i a, int32_t b)
{
    return lanes_i_mul(a, lanes_i_splat(b));
}

GN_OPERATION lanes_i lanes_i_mul_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, (vector_i)((vector_shorts)a.q[n] * (vector_shorts)b.q[n]));
}

GN_OPERATION lanes_i lanes_i_high_bytes(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_i, (vector_i)((vector_shorts)a.q[n] >> 8));
}

/* A sum of unsigned numbers that is smaller than one of them has wrapped around; so has a
 * difference that is greater than what it was taken from. */
GN_OPERATION vector_i lanes_vector_add_bytes(vector_bytes a, vector_bytes b)
{
    const vector_bytes sum = a + b;

    return (vector_i)(sum | (vector_bytes)(sum < a));
}

GN_OPERATION vector_i lanes_vector_sub_bytes(vector_bytes a, vector_bytes b)
{
    const vector_bytes difference = a - b;

    return (vector_i)(difference & (vector_bytes)(difference <= a));
}

GN_OPERATION vector_i lanes_vector_add_shorts(vector_shorts a, vector_shorts b)
{
    const vector_shorts sum = a + b;

    return (vector_i)(sum | (vector_shorts)(sum < a));
}

GN_OPERATION vector_i lanes_vector_sub_shorts(vector_shorts a, vector_shorts b)
{
    const vector_shorts difference = a - b;

    return (vector_i)(difference & (vector_shorts)(difference <= a));
}

GN_OPERATION lanes_i lanes_i_add_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i,
                        lanes_vector_add_bytes((vector_bytes)a.q[n], (vector_bytes)b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub_bytes(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i,
                        lanes_vector_sub_bytes((vector_bytes)a.q[n], (vector_bytes)b.q[n]));
}

GN_OPERATION lanes_i lanes_i_add_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i,
                        lanes_vector_add_shorts((vector_shorts)a.q[n], (vector_shorts)b.q[n]));
}

GN_OPERATION lanes_i lanes_i_sub_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i,
                        lanes_vector_sub_shorts((vector_shorts)a.q[n], (vector_shorts)b.q[n]));
}

/* Returns a product p of shorts as (p + p / 2^16 + 2^15) / 2^16, with what is below 2^16 left in
 * the low half. */
GN_OPERATION vector_u lanes_vector_scaled(vector_u product)
{
    return product + (product >> 16) + 0x8000u;
}

GN_OPERATION vector_i lanes_vector_scale_shorts(vector_u a, vector_u b)
{
    const vector_u low = lanes_vector_scaled((a & 0xFFFFu) * (b & 0xFFFFu));
    const vector_u high = lanes_vector_scaled((a >> 16) * (b >> 16));

    return (vector_i)(low >> 16 | (high & 0xFFFF0000u));
}

GN_OPERATION lanes_i lanes_i_scale_shorts(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_scale_shorts((vector_u)a.q[n], (vector_u)b.q[n]));
}

GN_OPERATION lanes_i lanes_i_shift_left(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, (vector_i)((vector_u)a.q[n] << (uint32_t)count));
}

GN_OPERATION lanes_i lanes_i_shift_right(lanes_i a, int count)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n] >> count);
}

GN_OPERATION lanes_i lanes_i_min(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_select((vector_i)(a.q[n] < b.q[n]), a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_max(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_select((vector_i)(a.q[n] > b.q[n]), a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_i_or(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n] | b.q[n]);
}

GN_OPERATION lanes_i lanes_i_and(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n] & b.q[n]);
}

GN_OPERATION lanes_i lanes_i_xor(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n] ^ b.q[n]);
}

GN_OPERATION lanes_m lanes_i_greater(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, (vector_i)(a.q[n] > b.q[n]));
}

GN_OPERATION lanes_m lanes_i_equal(lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_m, (vector_i)(a.q[n] == b.q[n]));
}

GN_OPERATION lanes_i lanes_i_select(lanes_m m, lanes_i a, lanes_i b)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_select(m.q[n], a.q[n], b.q[n]));
}

GN_OPERATION lanes_i lanes_m_as_int(lanes_m a)
{
    LANES_EACH_REGISTER(lanes_i, a.q[n]);
}

GN_OPERATION uint32_t lanes_i_sign_bits(lanes_i a)
{
    return lanes_vector_bits(a.q[0] >> 31, a.q[1] >> 31, a.q[2] >> 31, a.q[3] >> 31);
}

GN_OPERATION lanes_f lanes_to_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, __builtin_convertvector(a.q[n], vector_f));
}

GN_OPERATION lanes_i lanes_as_int(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, (vector_i)a.q[n]);
}

GN_OPERATION lanes_f lanes_as_float(lanes_i a)
{
    LANES_EACH_REGISTER(lanes_f, (vector_f)a.q[n]);
}

/* The bits of 255, 2^23 and 2^31. As integers they have the order of the floats. */
#define LANE_BITS_255 0x437F0000
#define LANE_BITS_2_23 0x4B000000
#define LANE_BITS_2_31 0x4F000000

/* C leaves conversions out of range undefined, so these lanes convert 0. */
GN_OPERATION vector_i lanes_vector_truncate(vector_f a)
{
    const vector_i bits = (vector_i)a;
    const vector_i outside = (vector_i)((bits & INT32_MAX) >= LANE_BITS_2_31);

    return __builtin_convertvector((vector_f)(bits & ~outside), vector_i) | (outside & INT32_MIN);
}

GN_OPERATION lanes_i lanes_truncate(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_truncate(a.q[n]));
}

/* From 2^23 on, floats are integers. Between 2^23 and 2^24 the last place is 1, so adding 2^23
 * rounds. */
GN_OPERATION vector_i lanes_vector_round(vector_f a)
{
    const vector_i bits = (vector_i)a;
    const vector_i magnitude = bits & INT32_MAX;
    const vector_i outside = (vector_i)(magnitude >= LANE_BITS_2_31);
    const vector_i broken = (vector_i)(magnitude < LANE_BITS_2_23);
    const vector_f rounder = (vector_f)((broken & LANE_BITS_2_23) | (bits & INT32_MIN));
    const vector_f rounded = ((vector_f)(bits & ~outside) + rounder) - rounder;

    return __builtin_convertvector(rounded, vector_i) | (outside & INT32_MIN);
}

GN_OPERATION lanes_i lanes_round(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_round(a.q[n]));
}

GN_OPERATION vector_f lanes_vector_floor(vector_f a)
{
    const vector_i bits = (vector_i)a;
    const vector_i broken = (vector_i)((bits & INT32_MAX) < LANE_BITS_2_23);
    const vector_f t = __builtin_convertvector(
        __builtin_convertvector((vector_f)(bits & broken), vector_i), vector_f);
    const vector_f one = lanes_vector_splat(1.0f);
    const vector_f below = t - (vector_f)((vector_i)(t > a) & (vector_i)one);

    return lanes_vector_f_select(broken, below, a);
}

GN_OPERATION lanes_f lanes_floor(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, lanes_vector_floor(a.q[n]));
}

/* Returns the integers below; INT32_MIN where a is NaN or out of range. */
GN_OPERATION vector_i lanes_vector_below(vector_f a)
{
    const vector_i bits = (vector_i)a;
    const vector_i outside = (vector_i)((bits & INT32_MAX) >= LANE_BITS_2_31);
    const vector_f inside = (vector_f)(bits & ~outside);
    const vector_i truncated = __builtin_convertvector(inside, vector_i);
    const vector_i is_above = (vector_i)(__builtin_convertvector(truncated, vector_f) > inside);

    return (truncated + is_above) | (outside & INT32_MIN);
}

GN_OPERATION lanes_i lanes_vectors_floor_to_int(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_below(a.q[n]));
}

GN_OPERATION lanes_f lanes_quad_left(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, LANES_SHUFFLE(a.q[n], a.q[n], 0, 0, 2, 2));
}

GN_OPERATION lanes_f lanes_quad_right(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, LANES_SHUFFLE(a.q[n], a.q[n], 1, 1, 3, 3));
}

GN_OPERATION lanes_f lanes_quad_lower(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n & 2]);
}

GN_OPERATION lanes_f lanes_quad_upper(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n | 1]);
}

#include "lanes_vectors_memory.h"

#endif
